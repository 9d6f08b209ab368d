#pragma once

#include "core/base/Result.h"

#include <QByteArray>
#include <QImage>
#include <QString>

namespace rubble {

/// The format in which a picture is written to a path, by its suffix: "png" or "jpg"; empty for another suffix.
QByteArray pictureFormat(const QString& path);

/// Encodes a picture in the format of a path and writes it atomically.
///
/// Errors: BadInput for another suffix; Limit if it cannot be encoded; those of writeFileAtomically().
Status writePicture(const QString& path, const QImage& picture);

}  // namespace rubble
