#pragma once

#include "core/base/Result.h"
#include "core/fracture/GreyImage.h"

#include <QImage>
#include <QString>

#include <memory>

namespace rubble {

/// A picture's brightness and opacity as a density image takes them: with 16 bits a pixel where it has more than 8, exact for grey
/// pictures; of colours their luminance. Opacity is left out where nothing lets anything through.
GreyImage greyImageOf(const QImage& picture);
/// For people to look at.
QImage pictureOf(const GreyImage& image);

/// Reads a picture file: PNG, or what else Qt knows.
///
/// Errors: BadInput where it cannot be read, or is wider or higher than GreyImage::kMostSide.
Result<std::shared_ptr<const GreyImage>> loadGreyImage(const QString& path);

}  // namespace rubble
