#include "core/io/system/AtomicFile.h"
#include "editor/commands/GreyImageLoading.h"
#include "tests/attack/Format.h"
#include "tests/attack/Mutator.h"
#include "tests/support/files/FuzzedReaders.h"
#include "tests/support/files/PngChecksums.h"

#include <QBuffer>

#include <unistd.h>

#include <memory>

namespace rubble::attack {
namespace {

namespace fs = std::filesystem;

/// A small picture as a file of the given format: "png".
std::string encoded(QImage::Format pixels, const char* format) {
    constexpr int kSide = 24;
    QImage picture(kSide, kSide, pixels);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) picture.setPixelColor(x, y, QColor(x * 10, y * 10, 5 * (x + y)));
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!picture.save(&buffer, format)) qFatal("The sample cannot be written as %s.", format);
    return bytes.toStdString();
}

std::vector<std::string> samples() {
    return {encoded(QImage::Format_Grayscale8, "png"), encoded(QImage::Format_Grayscale16, "png"),
            encoded(QImage::Format_RGB32, "png"),      encoded(QImage::Format_ARGB32, "png"),
            encoded(QImage::Format_RGB32, "jpg"),      encoded(QImage::Format_RGB32, "bmp"),
            encoded(QImage::Format_RGB32, "ppm")};
}

Verdict checkPicture(const fs::path& folder, std::string_view bytes) {
    const fs::path file = folder / std::to_string(::getpid());
    if (!writeFileAtomically(file, bytes)) return {.fault = "The picture cannot be written."};
    const Result<DensityPicture> picture = loadPicture(QString::fromStdString(file.string()));
    fs::remove(file);
    if (!picture) return {.fault = test::errorFault(picture.error())};
    return {.isAccepted = true};
}

}  // namespace

std::vector<Format> formatsOf(const fs::path& /*importer*/, const fs::path& folder) {
    fs::create_directories(folder);
    const auto pictures = std::make_shared<const std::vector<std::string>>(samples());
    return {{.name = "Picture",
             .ending = ".png",
             .mutated =
                 [pictures](Random& random) {
                     const std::string bytes = mutatedBytes((*pictures)[random.below(pictures->size())], random);
                     const bool isSealed = bytes.starts_with("\x89PNG") && random.below(8) != 0;
                     return isSealed ? test::withPngChecksums(bytes) : bytes;
                 },
             .check = [folder](std::string_view bytes, Random&) { return checkPicture(folder, bytes); }}};
}

}  // namespace rubble::attack
