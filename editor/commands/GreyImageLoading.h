#pragma once

#include "core/io/media/GreyImageFile.h"

#include <QImage>
#include <QString>

namespace rubble {

/// Converts an image to luminance and opacity: 16 bits per pixel if it has more than 8, otherwise 8; exact for grey
/// images. Opaque images get no opacity channel.
GreyImage greyImageOf(const QImage& picture);
/// Converts a grey image for display.
QImage pictureOf(const GreyImage& image);

/// Loads a PNG, JPEG, BMP or PGM file; reduces it if it is larger than GreyImage::kMaxSide pixels a side.
///
/// Errors: those of loadDensityPicture().
Result<DensityPicture> loadPicture(const QString& path);

}  // namespace rubble
