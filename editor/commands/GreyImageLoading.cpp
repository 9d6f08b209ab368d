#include "editor/commands/GreyImageLoading.h"

#include "core/io/system/AtomicFile.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImageReader>

#include <algorithm>

namespace rubble {

namespace {

struct GreyImageLoadingTexts {
    Q_DECLARE_TR_FUNCTIONS(GreyImageLoading)
};

/// Formats of pixels alone. A vector picture could name other files, which Qt would open.
const QByteArrayList kFormats{"jpeg", "jpg", "bmp", "pbm", "pgm", "ppm"};

bool hasMoreThan8Bits(const QImage& picture) {
    switch (picture.format()) {
        case QImage::Format_Grayscale16:
        case QImage::Format_RGBX64:
        case QImage::Format_RGBA64:
        case QImage::Format_RGBA64_Premultiplied: return true;
        default: return false;
    }
}

Status checkSize(QSize size, const std::string& name) {
    return checkPictureSize(name, static_cast<std::uint64_t>(std::max(size.width(), 0)),
                            static_cast<std::uint64_t>(std::max(size.height(), 0)));
}

/// Decodes a picture other than PNG, which core/io reads.
Result<GreyImage> decodedByQt(const std::string& bytes, const std::string& name) {
    const QString shownName = QString::fromStdString(name);
    const auto fault = [](const QString& sentence) { return Error{ErrorCode::BadInput, sentence.toStdString()}; };
    QByteArray data = QByteArray::fromStdString(bytes);
    QBuffer buffer(&data);
    QImageReader reader(&buffer);
    if (!kFormats.contains(reader.format()))
        return fault(
            GreyImageLoadingTexts::tr("\"%1\" is not a PNG, JPEG, BMP or PGM picture. Save it as PNG.").arg(shownName));
    if (const Status checked = checkSize(reader.size(), name); !checked) return checked.error();
    const QImage picture = reader.read();
    if (picture.isNull())
        return fault(
            GreyImageLoadingTexts::tr("\"%1\" cannot be read as a picture: %2.").arg(shownName, reader.errorString()));
    if (const Status checked = checkSize(picture.size(), name); !checked) return checked.error();
    return greyImageOf(picture);
}

}  // namespace

GreyImage greyImageOf(const QImage& picture) {
    GreyImage image{.width = static_cast<std::uint32_t>(picture.width()),
                    .height = static_cast<std::uint32_t>(picture.height()),
                    .bits = hasMoreThan8Bits(picture) ? 16u : 8u};
    const std::uint32_t step = 65535u / image.white();  // between two grey values, in 16 bits
    for (int y = 0; y < picture.height(); ++y) {
        const QImage wide = picture.copy(0, y, picture.width(), 1).convertToFormat(QImage::Format_RGBA64);
        const auto* row = reinterpret_cast<const QRgba64*>(wide.constScanLine(0));
        for (int x = 0; x < wide.width(); ++x) {
            const std::uint32_t grey = luminanceOf(row[x].red(), row[x].green(), row[x].blue());
            image.grey.push_back(static_cast<std::uint16_t>(grey / step));
            image.opacity.push_back(static_cast<std::uint16_t>(row[x].alpha() / step));
        }
    }
    const bool isOpaque = std::ranges::all_of(image.opacity, [&](auto value) { return value == image.white(); });
    if (isOpaque) image.opacity.clear();
    return image;
}

QImage pictureOf(const GreyImage& image) {
    QImage picture(static_cast<int>(image.width), static_cast<int>(image.height), QImage::Format_ARGB32);
    const auto byteOf = [&](std::uint16_t value) { return static_cast<int>(value * 255u / image.white()); };
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const std::size_t pixel = static_cast<std::size_t>(y) * image.width + static_cast<std::size_t>(x);
            const int grey = byteOf(image.grey[pixel]);
            const int opacity = image.opacity.empty() ? 255 : byteOf(image.opacity[pixel]);
            picture.setPixel(x, y, qRgba(grey, grey, grey, opacity));
        }
    }
    return picture;
}

Result<DensityPicture> loadPicture(const QString& path) {
    const std::filesystem::path file = toPath(path);
    const Result<std::string> bytes = readFile(file);  // refuses pipes and devices, for which Qt would wait
    if (!bytes) return bytes.error();
    const std::string name = file.filename().string();
    Result<GreyImage> image = isPng(*bytes) ? greyImageOfPng(*bytes, name) : decodedByQt(*bytes, name);
    if (!image) return image.error();
    return densityPictureOf(std::move(*image), name);
}

}  // namespace rubble
