#pragma once

#include "core/base/Result.h"
#include "core/fracture/sampling/GreyImage.h"

#include <QImage>
#include <QString>

#include <memory>

namespace rubble {

/// Converts an image to luminance and opacity: 16 bits per pixel if it has more than 8, otherwise 8; exact for grey
/// images. Opaque images get no opacity channel.
GreyImage greyImageOf(const QImage& picture);
/// Converts a grey image for display.
QImage pictureOf(const GreyImage& image);

/// Loads an image file in any format that Qt reads.
///
/// Errors: BadInput if it cannot be read, or is wider or higher than GreyImage::kMaxSide.
Result<std::shared_ptr<const GreyImage>> loadGreyImage(const QString& path);

}  // namespace rubble
