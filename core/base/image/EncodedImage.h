#pragma once

#include "core/base/Result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace rubble {

enum class ImageType { Png, Jpeg };

/// The content of a PNG or JPEG file, unchanged. Its frame and the checksums of PNG are checked, its pixels are not
/// decoded.
class EncodedImage {
public:
    /// Errors, as the end of a sentence that begins with the name of the image: Unsupported if it is neither PNG nor a
    /// JPEG in RGB; Limit above kMaxImageBytes or kMaxImageSide; BadInput if it is truncated, damaged or has no pixels.
    /// Source: W3C, "Portable Network Graphics", 2003; ITU-T T.81, "JPEG", annex B.
    static Result<EncodedImage> of(std::string bytes);

    ImageType type() const { return m_type; }
    std::uint32_t width() const { return m_width; }
    std::uint32_t height() const { return m_height; }
    const std::string& bytes() const { return m_bytes; }
    /// "image/png" or "image/jpeg"
    std::string_view mediaType() const;
    /// ".png" or ".jpg"
    std::string_view suffix() const;
    /// "512 × 512", pixels.
    std::string sizeText() const;
    bool operator==(const EncodedImage& other) const { return m_bytes == other.m_bytes; }

private:
    EncodedImage(ImageType type, std::uint32_t width, std::uint32_t height, std::string bytes)
        : m_type(type), m_width(width), m_height(height), m_bytes(std::move(bytes)) {}

    ImageType m_type;
    std::uint32_t m_width, m_height;
    std::string m_bytes;
};

}  // namespace rubble
