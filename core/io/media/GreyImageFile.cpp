#include "core/io/media/GreyImageFile.h"

#include "core/io/system/AtomicFile.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

namespace rubble {
namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

std::string pictureSizeText(std::uint64_t width, std::uint64_t height) {
    return std::to_string(width) + " × " + std::to_string(height);
}

/// Reads a PNG file with libpng, which reports errors by longjmp(): no function that calls setjmp() has variables.
class PngReader {
public:
    explicit PngReader(std::string_view bytes) : m_rest(bytes) {
        m_png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &PngReader::fail, &PngReader::ignore);
        if (m_png) m_info = png_create_info_struct(m_png);
        if (m_info) png_set_read_fn(m_png, this, &PngReader::copy);
    }
    ~PngReader() { png_destroy_read_struct(&m_png, &m_info, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    /// Reads what precedes the pixels. Returns false on an error.
    bool readHeader() {
        if (!m_info) return false;
        if (setjmp(png_jmpbuf(m_png))) return false;
        png_read_info(m_png, m_info);
        png_set_expand(m_png);  // palettes to colours, grey values of 1 to 4 bits to 8, a transparent colour to opacity
        png_set_interlace_handling(m_png);
        png_read_update_info(m_png, m_info);
        return true;
    }
    /// Reads the pixels. Returns false on an error.
    bool readPixels() {
        const std::size_t rowBytes = png_get_rowbytes(m_png, m_info);
        m_bytes.resize(rowBytes * height());
        for (std::size_t row = 0; row < height(); ++row) m_rows.push_back(m_bytes.data() + row * rowBytes);
        return readRows();
    }
    std::uint32_t width() const { return png_get_image_width(m_png, m_info); }
    std::uint32_t height() const { return png_get_image_height(m_png, m_info); }
    std::uint32_t bits() const { return png_get_bit_depth(m_png, m_info); }
    std::uint32_t channels() const { return png_get_channels(m_png, m_info); }
    /// The channels of all pixels, which have two bytes each, the higher one first, if bits() is 16.
    std::span<const png_byte> bytes() const { return m_bytes; }
    std::string error() const { return m_error.data(); }

private:
    static PngReader& of(void* reader) { return *static_cast<PngReader*>(reader); }
    static void fail(png_structp png, png_const_charp message) {
        std::array<char, kMaxMessage>& error = of(png_get_error_ptr(png)).m_error;
        std::strncpy(error.data(), message, error.size() - 1);
        png_longjmp(png, 1);
    }
    static void ignore(png_structp, png_const_charp) {}  // warnings
    static void copy(png_structp png, png_bytep to, std::size_t size) {
        std::string_view& rest = of(png_get_io_ptr(png)).m_rest;
        if (size > rest.size()) png_error(png, "the file ends too early");
        std::memcpy(to, rest.data(), size);
        rest.remove_prefix(size);
    }
    bool readRows() {
        if (setjmp(png_jmpbuf(m_png))) return false;
        png_read_image(m_png, m_rows.data());
        return true;
    }

    static constexpr std::size_t kMaxMessage = 200;
    std::string_view m_rest;  // not read yet
    std::array<char, kMaxMessage> m_error{"out of memory"};
    png_structp m_png = nullptr;
    png_infop m_info = nullptr;
    std::vector<png_byte> m_bytes;
    std::vector<png_bytep> m_rows;
};

/// The pixels of a picture as luminance and opacity.
GreyImage imageOf(const PngReader& png) {
    GreyImage image{.width = png.width(), .height = png.height(), .bits = png.bits()};
    const std::size_t valueBytes = image.bits / 8, channels = png.channels();
    const bool isColour = channels >= 3, hasOpacity = channels % 2 == 0;
    const std::span<const png_byte> bytes = png.bytes();
    const auto value = [&](std::size_t at) {
        return valueBytes == 1 ? std::uint32_t{bytes[at]} : std::uint32_t{bytes[2 * at]} << 8 | bytes[2 * at + 1];
    };
    const std::size_t values = bytes.size() / valueBytes;
    image.grey.reserve(values / channels);
    if (hasOpacity) image.opacity.reserve(values / channels);
    for (std::size_t at = 0; at < values; at += channels) {
        const std::uint32_t grey = isColour ? luminanceOf(value(at), value(at + 1), value(at + 2)) : value(at);
        image.grey.push_back(static_cast<std::uint16_t>(grey));
        if (hasOpacity) image.opacity.push_back(static_cast<std::uint16_t>(value(at + channels - 1)));
    }
    return image;
}

}  // namespace

bool isPng(std::string_view bytes) { return bytes.starts_with(kPngSignature); }

Status checkPictureSize(const std::string& name, std::uint64_t width, std::uint64_t height) {
    if (std::max(width, height) <= kMaxPictureSide) return success();
    return Error{ErrorCode::BadInput, '"' + name + "\" is too large: " + pictureSizeText(width, height) +
                                          " pixels. Scale it down to at most " + std::to_string(kMaxPictureSide) +
                                          " pixels a side."};
}

Result<GreyImage> greyImageOfPng(std::string_view bytes, const std::string& name) {
    PngReader png(bytes);
    const auto error = [&] {
        return Error{ErrorCode::BadInput, '"' + name + "\" cannot be read as a picture: " + png.error() + "."};
    };
    if (!png.readHeader()) return error();
    if (const Status checked = checkPictureSize(name, png.width(), png.height()); !checked) return checked.error();
    if (!png.readPixels()) return error();
    return imageOf(png);
}

DensityPicture densityPictureOf(GreyImage image, const std::string& name) {
    const std::uint32_t width = image.width, height = image.height;
    if (std::ranges::all_of(image.opacity, [&](auto value) { return value == image.white(); })) image.opacity.clear();
    image = reduced(std::move(image));
    std::string note;
    if (image.width != width || image.height != height) {
        note = '"' + name + "\" was reduced from " + pictureSizeText(width, height) + " to " +
               pictureSizeText(image.width, image.height) + " pixels.";
    }
    return {std::make_shared<const GreyImage>(std::move(image)), std::move(note)};
}

Result<DensityPicture> loadDensityPicture(const std::filesystem::path& path) {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) return bytes.error();
    const std::string name = path.filename().string();
    if (!isPng(*bytes)) return Error{ErrorCode::BadInput, '"' + name + "\" is not a PNG picture. Save it as PNG."};
    Result<GreyImage> image = greyImageOfPng(*bytes, name);
    if (!image) return image.error();
    return densityPictureOf(std::move(*image), name);
}

}  // namespace rubble
