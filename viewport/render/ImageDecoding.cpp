#include "viewport/render/ImageDecoding.h"

#include <cstddef>
#include <cstdio>

#include <jpeglib.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>

namespace rubble {
namespace {

constexpr std::uint32_t kLongest = 4096;  // pixels

std::size_t sizeOf(const EncodedImage& image) { return std::size_t{3} * image.width() * image.height(); }

/// Removes the opacity, in place.
void dropOpacity(std::vector<std::uint8_t>& pixels) {
    for (std::size_t from = 0, to = 0; from < pixels.size(); from += 4, to += 3)
        for (std::size_t k = 0; k < 3; ++k) pixels[to + k] = pixels[from + k];
    pixels.resize(pixels.size() / 4 * 3);
}

bool decodePng(const EncodedImage& image, std::vector<std::uint8_t>& pixels) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    const std::string& bytes = image.bytes();
    if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) return false;
    png.format = PNG_FORMAT_RGBA;  // without opacity, libpng would blend with a background
    const bool isSize = png.width == image.width() && png.height == image.height();
    if (isSize) pixels.resize(PNG_IMAGE_SIZE(png));
    const bool isRead = isSize && png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr) != 0;
    png_image_free(&png);
    if (isRead) dropOpacity(pixels);
    return isRead;
}

/// Decodes a JPEG file with libjpeg, which reports errors by longjmp(): functions that call setjmp() have no variables.
class JpegReader {
public:
    JpegReader() {
        m_jpeg.err = jpeg_std_error(&m_errors);
        m_errors.error_exit = [](j_common_ptr jpeg) { std::longjmp(of(jpeg).m_failure, 1); };
        m_errors.output_message = [](j_common_ptr) {};
        m_progress.progress_monitor = &JpegReader::limitScans;
        m_jpeg.client_data = this;
    }
    ~JpegReader() { jpeg_destroy_decompress(&m_jpeg); }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;

    bool decode(const EncodedImage& image, std::vector<std::uint8_t>& pixels) {
        if (setjmp(m_failure) != 0) return false;
        jpeg_create_decompress(&m_jpeg);
        m_jpeg.progress = &m_progress;
        jpeg_mem_src(&m_jpeg, reinterpret_cast<const unsigned char*>(image.bytes().data()), image.bytes().size());
        jpeg_read_header(&m_jpeg, TRUE);
        m_jpeg.out_color_space = JCS_RGB;
        if (m_jpeg.image_width != image.width() || m_jpeg.image_height != image.height()) return false;
        jpeg_start_decompress(&m_jpeg);
        while (m_jpeg.output_scanline < m_jpeg.output_height) {
            m_row = pixels.data() + std::size_t{3} * m_jpeg.output_width * m_jpeg.output_scanline;
            jpeg_read_scanlines(&m_jpeg, &m_row, 1);
        }
        jpeg_finish_decompress(&m_jpeg);
        return true;
    }

private:
    static constexpr int kMaxScans = 100;  // a progressive file has some ten; each takes the time of an image

    static JpegReader& of(j_common_ptr jpeg) { return *static_cast<JpegReader*>(jpeg->client_data); }
    static void limitScans(j_common_ptr jpeg) {
        if (of(jpeg).m_jpeg.input_scan_number > kMaxScans) std::longjmp(of(jpeg).m_failure, 1);
    }

    jpeg_decompress_struct m_jpeg{};
    jpeg_error_mgr m_errors{};
    jpeg_progress_mgr m_progress{};
    std::jmp_buf m_failure{};
    JSAMPROW m_row = nullptr;
};

/// Halves both sides: each pixel is the mean of four, or of those that there are.
DecodedImage halved(const DecodedImage& image) {
    DecodedImage half{std::max(image.width / 2, 1u), std::max(image.height / 2, 1u), {}};
    half.pixels.reserve(std::size_t{3} * half.width * half.height);
    for (std::uint32_t y = 0; y < half.height; ++y) {
        for (std::uint32_t x = 0; x < half.width; ++x) {
            for (std::uint32_t k = 0; k < 3; ++k) {
                std::uint32_t sum = 2;
                for (const std::uint32_t row : {2 * y, std::min(2 * y + 1, image.height - 1)})
                    for (const std::uint32_t column : {2 * x, std::min(2 * x + 1, image.width - 1)})
                        sum += image.pixels[3 * (std::size_t{row} * image.width + column) + k];
                half.pixels.push_back(static_cast<std::uint8_t>(sum / 4));
            }
        }
    }
    return half;
}

}  // namespace

std::optional<DecodedImage> decoded(const EncodedImage& image, std::uint32_t longest) {
    DecodedImage result{image.width(), image.height(), {}};
    if (image.type() == ImageType::Png) {
        if (!decodePng(image, result.pixels)) return std::nullopt;
    } else {
        result.pixels.resize(sizeOf(image));
        if (!JpegReader().decode(image, result.pixels)) return std::nullopt;
    }
    while (std::max(result.width, result.height) > std::min(longest, kLongest)) result = halved(result);
    return result;
}

}  // namespace rubble
