#include "core/base/image/EncodedImage.h"

#include "core/base/limits/ImageLimits.h"

#include <zlib.h>

#include <algorithm>
#include <optional>

namespace rubble {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n"sv, kJpegStart = "\xff\xd8\xff"sv;

struct ImageSize {
    std::uint32_t width = 0, height = 0;
    bool isPrint = false;  // CMYK, or more than 8 bits per channel, as files for print have
};

std::uint32_t bigEndian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
    return value;
}

/// The checksum of a chunk's name and content.
std::uint32_t checksumOf(std::string_view bytes) {
    return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

/// Walks the chunks of a PNG file from its header to its end; nothing if it is truncated or a checksum is wrong.
std::optional<ImageSize> pngSize(std::string_view bytes) {
    constexpr std::size_t kLength = 4, kName = 4, kChecksum = 4, kHeaderSize = 13;
    std::optional<ImageSize> size;
    bytes.remove_prefix(kPngSignature.size());
    while (bytes.size() >= kLength + kName + kChecksum) {
        const std::size_t length = bigEndian(bytes.substr(0, kLength));
        const std::string_view name = bytes.substr(kLength, kName), content = bytes.substr(kLength + kName);
        if (content.size() < length + kChecksum) return std::nullopt;
        if (checksumOf(bytes.substr(kLength, kName + length)) != bigEndian(content.substr(length, kChecksum)))
            return std::nullopt;
        if (!size && (name != "IHDR" || length != kHeaderSize)) return std::nullopt;
        if (!size) size = ImageSize{bigEndian(content.substr(0, 4)), bigEndian(content.substr(4, 4))};
        if (name == "IEND") return size;
        bytes = content.substr(length + kChecksum);
    }
    return std::nullopt;
}

/// Whether a marker begins a frame, whose header has the size of the image.
bool isFrame(unsigned marker) {
    constexpr unsigned kTables = 0xc4, kReserved = 0xc8, kArithmetic = 0xcc;
    return marker >= 0xc0 && marker <= 0xcf && marker != kTables && marker != kReserved && marker != kArithmetic;
}

/// Walks the segments of a JPEG file up to its frame header, and requires a scan and an end behind it; nothing without.
std::optional<ImageSize> jpegSize(std::string_view bytes) {
    constexpr std::size_t kFrameSize = 10;  // up to the number of channels
    constexpr char kBits = 8, kMaxChannels = 3;
    bytes.remove_prefix(2);
    while (bytes.size() >= 4 && bytes[0] == '\xff') {
        const unsigned marker = static_cast<unsigned char>(bytes[1]);
        if (marker == 0xff) {  // fill
            bytes.remove_prefix(1);
            continue;
        }
        const std::size_t length = bigEndian(bytes.substr(2, 2));
        if (length < 2 || bytes.size() < 2 + length) return std::nullopt;
        if (isFrame(marker)) {
            const bool isWhole = length + 2 >= kFrameSize && bytes.rfind("\xff\xd9"sv) != std::string_view::npos &&
                                 bytes.find("\xff\xda"sv) != std::string_view::npos;
            if (!isWhole) return std::nullopt;
            return ImageSize{bigEndian(bytes.substr(7, 2)), bigEndian(bytes.substr(5, 2)),
                             bytes[4] != kBits || bytes[9] > kMaxChannels};
        }
        bytes.remove_prefix(2 + length);
    }
    return std::nullopt;
}

std::string textOf(std::uint32_t width, std::uint32_t height) {
    return std::to_string(width) + " × " + std::to_string(height);
}

}  // namespace

Result<EncodedImage> EncodedImage::of(std::string bytes) {
    const bool isPng = bytes.starts_with(kPngSignature);
    if (!isPng && !bytes.starts_with(kJpegStart))
        return Error{ErrorCode::Unsupported, "is neither PNG nor JPEG; save it as one of them"};
    if (bytes.size() > kMaxImageBytes)
        return Error{ErrorCode::Limit, "is larger than " + std::to_string(kMaxImageBytes >> 20) +
                                           " MiB; scale it down, or save it as JPEG"};
    const std::optional<ImageSize> size = isPng ? pngSize(bytes) : jpegSize(bytes);
    if (!size) return Error{ErrorCode::BadInput, "is damaged or ends too early; save it again"};
    if (size->isPrint)
        return Error{ErrorCode::Unsupported, "has colours for print, such as CMYK; save it with RGB colours of 8 bits"};
    if (size->width == 0 || size->height == 0) return Error{ErrorCode::BadInput, "has no pixels; save it again"};
    if (std::max(size->width, size->height) > kMaxImageSide)
        return Error{ErrorCode::Limit, "has " + textOf(size->width, size->height) + " pixels; scale it down to " +
                                           std::to_string(kMaxImageSide) + " a side at most"};
    return EncodedImage(isPng ? ImageType::Png : ImageType::Jpeg, size->width, size->height, std::move(bytes));
}

std::string_view EncodedImage::mediaType() const { return m_type == ImageType::Png ? "image/png" : "image/jpeg"; }
std::string_view EncodedImage::suffix() const { return m_type == ImageType::Png ? ".png" : ".jpg"; }
std::string EncodedImage::sizeText() const { return textOf(m_width, m_height); }

}  // namespace rubble
