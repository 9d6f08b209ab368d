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
const QByteArrayList kFormats{"png", "jpeg", "jpg", "bmp", "pbm", "pgm", "ppm"};

bool hasMoreThan8Bits(const QImage& picture) {
    switch (picture.format()) {
        case QImage::Format_Grayscale16:
        case QImage::Format_RGBX64:
        case QImage::Format_RGBA64:
        case QImage::Format_RGBA64_Premultiplied: return true;
        default: return false;
    }
}

/// With the weights of qGray().
std::uint32_t luminanceOf(QRgba64 colour) {
    return (colour.red() * 11u + colour.green() * 16u + colour.blue() * 5u) / 32u;
}

}  // namespace

GreyImage greyImageOf(const QImage& picture) {
    GreyImage image{.width = static_cast<std::uint32_t>(picture.width()),
                    .height = static_cast<std::uint32_t>(picture.height()),
                    .bits = hasMoreThan8Bits(picture) ? 16u : 8u};
    const std::uint32_t step = 65535u / image.white();  // between two grey values, in 16 bits
    const QImage wide = picture.convertToFormat(QImage::Format_RGBA64);
    for (int y = 0; y < wide.height(); ++y) {
        const auto* row = reinterpret_cast<const QRgba64*>(wide.constScanLine(y));
        for (int x = 0; x < wide.width(); ++x) {
            image.grey.push_back(static_cast<std::uint16_t>(luminanceOf(row[x]) / step));
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

Result<std::shared_ptr<const GreyImage>> readGreyImage(std::string_view bytes, const QString& name) {
    const auto fault = [](const QString& sentence) { return Error{ErrorCode::BadInput, sentence.toStdString()}; };
    QBuffer buffer;
    buffer.setData(bytes.data(), static_cast<int>(bytes.size()));
    QImageReader reader(&buffer);
    if (!kFormats.contains(reader.format()))
        return fault(GreyImageLoadingTexts::tr("%1 is not a PNG, JPEG, BMP or PGM picture. Save it as PNG.").arg(name));
    constexpr int kMaxSide = GreyImage::kMaxSide;
    if (const QSize size = reader.size(); size.width() > kMaxSide || size.height() > kMaxSide) {
        return fault(
            GreyImageLoadingTexts::tr("%1 is too large: %2 × %3 pixels. Scale it down to at most %4 pixels a side.")
                .arg(name, QString::number(size.width()), QString::number(size.height()), QString::number(kMaxSide)));
    }
    const QImage picture = reader.read();
    if (picture.isNull())
        return fault(GreyImageLoadingTexts::tr("%1 cannot be read as a picture: %2.").arg(name, reader.errorString()));
    if (std::max(picture.width(), picture.height()) > kMaxSide)
        return fault(GreyImageLoadingTexts::tr("%1 is too large. Scale it down to at most %2 pixels a side.")
                         .arg(name, QString::number(kMaxSide)));
    return std::make_shared<const GreyImage>(greyImageOf(picture));
}

Result<std::shared_ptr<const GreyImage>> loadGreyImage(const QString& path) {
    const Result<std::string> bytes = readFile(toPath(path));  // refuses pipes and devices, for which Qt would wait
    if (!bytes) return bytes.error();
    return readGreyImage(*bytes, fileNameText(path));
}

}  // namespace rubble
