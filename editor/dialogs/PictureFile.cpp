#include "editor/dialogs/PictureFile.h"

#include "core/io/system/AtomicFile.h"
#include "editor/document/FilePath.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImageWriter>

namespace rubble {

namespace {

constexpr int kJpegQuality = 95;  // of 100: no visible loss

}  // namespace

QByteArray pictureFormat(const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == "png") return "png";
    return suffix == "jpg" || suffix == "jpeg" ? "jpg" : QByteArray();
}

Status writePicture(const QString& path, const QImage& picture) {
    const QByteArray format = pictureFormat(path);
    if (format.isEmpty()) return Error{ErrorCode::BadInput, "Pictures are saved as .png or .jpg."};
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    QImageWriter writer(&bytes, format);
    if (format == "jpg") writer.setQuality(kJpegQuality);
    if (!writer.write(picture)) {
        return Error{ErrorCode::Limit, "The picture could not be encoded: " + writer.errorString().toStdString() + '.'};
    }
    return writeFileAtomically(toPath(path), bytes.data().toStdString());
}

}  // namespace rubble
