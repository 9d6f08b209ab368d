#include "core/base/image/PngEncoding.h"

#include <png.h>

#include <csetjmp>
#include <exception>
#include <vector>

namespace rubble {
namespace {

/// libpng's state while it encodes an image. Its errors jump back into encode().
class PngWriting {
public:
    PngWriting() : m_png(png_create_write_struct(PNG_LIBPNG_VER_STRING, this, keepMessage, ignore)) {
        if (m_png != nullptr) m_info = png_create_info_struct(m_png);
    }
    ~PngWriting() { png_destroy_write_struct(&m_png, &m_info); }
    PngWriting(const PngWriting&) = delete;
    PngWriting& operator=(const PngWriting&) = delete;

    /// Appends the file to `bytes`; false if that fails.
    bool encode(const PngPixels& image, PngEffort effort, std::string& bytes) {
        if (m_info == nullptr || setjmp(png_jmpbuf(m_png)) != 0) return false;
        png_set_write_fn(m_png, &bytes, append, nullptr);
        png_set_IHDR(m_png, m_info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                     image.opacities.empty() ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        if (effort == PngEffort::Quick) {
            png_set_compression_level(m_png, kQuickLevel);
            png_set_filter(m_png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
        }
        png_write_info(m_png, m_info);
        const std::size_t width = static_cast<std::size_t>(image.width);
        if (!image.opacities.empty()) m_row.resize(4 * width);
        for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
            const std::uint8_t* pixels = image.colours.data() + 3 * width * y;
            for (std::size_t k = 0; k < m_row.size(); ++k)
                m_row[k] = k % 4 == 3 ? image.opacities[width * y + k / 4] : pixels[k / 4 * 3 + k % 4];
            png_write_row(m_png, m_row.empty() ? pixels : m_row.data());
        }
        png_write_end(m_png, m_info);
        return true;
    }
    std::string message() const { return m_message.empty() ? "out of memory" : m_message; }

private:
    static constexpr int kQuickLevel = 2;

    static void append(png_structp png, png_bytep bytes, std::size_t count) {
        try {
            static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
            return;
        } catch (const std::exception&) {  // must not pass through libpng
        }
        png_error(png, "out of memory");
    }
    [[noreturn]] static void keepMessage(png_structp png, png_const_charp message) {
        static_cast<PngWriting*>(png_get_error_ptr(png))->m_message = message;
        png_longjmp(png, 1);
    }
    static void ignore(png_structp, png_const_charp) {}

    png_structp m_png;
    png_infop m_info = nullptr;
    std::string m_message;
    std::vector<std::uint8_t> m_row;  // of an image with opacities
};

}  // namespace

Result<std::string> encodedPng(const PngPixels& pixels, PngEffort effort) {
    std::string bytes;
    PngWriting writing;
    if (!writing.encode(pixels, effort, bytes)) {
        return Error{ErrorCode::Limit, "The image could not be encoded as PNG: " + writing.message() + "."};
    }
    return bytes;
}

}  // namespace rubble
