#include "viewport/render/ImageDecoding.h"

#include <cstddef>
#include <cstdio>

#include <jpeglib.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <utility>

namespace rubble {
namespace {

constexpr std::uint32_t kLongest = 4096;  // pixels

/// Takes the rows of an image from the top and makes one of a fraction of its size: each pixel is the mean of a square
/// of `factor` on each side. What is left at the right and at the bottom is dropped.
class RowReduction {
public:
    /// `channels`: bytes a pixel of the rows, of which the first three are kept.
    RowReduction(std::uint32_t width, std::uint32_t height, std::uint32_t factor, std::uint32_t channels)
        : m_factorX(std::min(factor, width)), m_factorY(std::min(factor, height)), m_channels(channels) {
        m_image = {width / m_factorX, height / m_factorY, {}};
        m_image.pixels.reserve(std::size_t{3} * m_image.width * m_image.height);
        m_sums.resize(std::size_t{3} * m_image.width);
    }

    void add(const std::uint8_t* row) {
        if (m_image.pixels.size() == m_image.pixels.capacity()) return;
        for (std::uint32_t x = 0; x < m_image.width; ++x) {
            for (std::uint32_t k = 0; k < m_factorX; ++k, row += m_channels)
                for (std::uint32_t c = 0; c < 3; ++c) m_sums[std::size_t{3} * x + c] += row[c];
        }
        if (++m_rows < m_factorY) return;
        const std::uint32_t count = m_factorX * m_factorY;
        for (std::uint32_t& sum : m_sums) {
            m_image.pixels.push_back(static_cast<std::uint8_t>((sum + count / 2) / count));
            sum = 0;
        }
        m_rows = 0;
    }

    DecodedImage finished() { return std::move(m_image); }

private:
    std::uint32_t m_factorX, m_factorY, m_channels;
    std::uint32_t m_rows = 0;  // in the sums
    std::vector<std::uint32_t> m_sums;
    DecodedImage m_image;
};

/// Decodes a PNG file row by row with libpng, which reports errors by longjmp(): functions that call setjmp() have no
/// variables. Interlaced images are decoded as a whole.
class PngReader {
public:
    explicit PngReader(const EncodedImage& image) : m_image(image) {}
    ~PngReader() { png_destroy_read_struct(&m_png, &m_info, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    bool decode(RowReduction& reduction) {
        m_png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, [](png_structp, png_const_charp) {});
        m_info = m_png != nullptr ? png_create_info_struct(m_png) : nullptr;
        if (m_info == nullptr || setjmp(png_jmpbuf(m_png)) != 0) return false;
        png_set_read_fn(m_png, this, &PngReader::read);
        png_read_info(m_png, m_info);
        if (png_get_image_width(m_png, m_info) != m_image.width() ||
            png_get_image_height(m_png, m_info) != m_image.height())
            return false;
        png_set_expand(m_png);
        png_set_scale_16(m_png);
        png_set_gray_to_rgb(m_png);
        png_set_add_alpha(m_png, 255, PNG_FILLER_AFTER);
        m_isInterlaced = png_set_interlace_handling(m_png) > 1;
        png_read_update_info(m_png, m_info);
        m_rowBytes = png_get_rowbytes(m_png, m_info);
        if (m_rowBytes != std::size_t{4} * m_image.width()) return false;
        m_pixels.resize(m_rowBytes * (m_isInterlaced ? m_image.height() : 1));
        if (m_isInterlaced) {
            for (m_row = 0; m_row < m_image.height(); ++m_row) m_rows.push_back(m_pixels.data() + m_row * m_rowBytes);
            png_read_image(m_png, m_rows.data());
        }
        for (m_row = 0; m_row < m_image.height(); ++m_row) {
            if (!m_isInterlaced) png_read_row(m_png, m_pixels.data(), nullptr);
            reduction.add(m_isInterlaced ? m_rows[m_row] : m_pixels.data());
        }
        return true;
    }

private:
    static void read(png_structp png, png_bytep to, std::size_t count) {
        auto& reader = *static_cast<PngReader*>(png_get_io_ptr(png));
        const std::string& bytes = reader.m_image.bytes();
        if (bytes.size() - reader.m_read < count) png_error(png, "truncated");
        std::copy_n(bytes.data() + reader.m_read, count, to);
        reader.m_read += count;
    }

    const EncodedImage& m_image;
    png_structp m_png = nullptr;
    png_infop m_info = nullptr;
    std::size_t m_read = 0;  // bytes
    std::size_t m_rowBytes = 0;
    std::size_t m_row = 0;
    bool m_isInterlaced = false;
    std::vector<std::uint8_t> m_pixels;
    std::vector<png_bytep> m_rows;
};

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

    /// `factor`: of the reduction, 1, 2, 4 or 8.
    bool decode(const EncodedImage& image, std::uint32_t factor, DecodedImage& result) {
        if (setjmp(m_failure) != 0) return false;
        jpeg_create_decompress(&m_jpeg);
        m_jpeg.progress = &m_progress;
        jpeg_mem_src(&m_jpeg, reinterpret_cast<const unsigned char*>(image.bytes().data()), image.bytes().size());
        jpeg_read_header(&m_jpeg, TRUE);
        m_jpeg.out_color_space = JCS_RGB;
        m_jpeg.scale_num = 1;
        m_jpeg.scale_denom = factor;
        if (m_jpeg.image_width != image.width() || m_jpeg.image_height != image.height()) return false;
        jpeg_start_decompress(&m_jpeg);
        result.width = m_jpeg.output_width;
        result.height = m_jpeg.output_height;
        result.pixels.resize(std::size_t{3} * result.width * result.height);
        while (m_jpeg.output_scanline < m_jpeg.output_height) {
            m_row = result.pixels.data() + std::size_t{3} * m_jpeg.output_width * m_jpeg.output_scanline;
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

/// The power of two that makes the sides no longer than `longest`.
std::uint32_t factorFor(const EncodedImage& image, std::uint32_t longest) {
    std::uint32_t factor = 1;
    while (std::max(image.width(), image.height()) / factor > std::min(longest, kLongest)) factor *= 2;
    return factor;
}

std::optional<DecodedImage> decodedPng(const EncodedImage& image, std::uint32_t factor) {
    RowReduction reduction(image.width(), image.height(), factor, 4);
    if (!PngReader(image).decode(reduction)) return std::nullopt;
    return reduction.finished();
}

/// libjpeg reduces by up to 8 itself, for which it decodes less.
std::optional<DecodedImage> decodedJpeg(const EncodedImage& image, std::uint32_t factor) {
    constexpr std::uint32_t kMaxScale = 8;
    DecodedImage scaled;
    if (!JpegReader().decode(image, std::min(factor, kMaxScale), scaled)) return std::nullopt;
    if (factor <= kMaxScale) return scaled;
    RowReduction reduction(scaled.width, scaled.height, factor / kMaxScale, 3);
    for (std::uint32_t y = 0; y < scaled.height; ++y)
        reduction.add(scaled.pixels.data() + std::size_t{3} * scaled.width * y);
    return reduction.finished();
}

}  // namespace

std::optional<DecodedImage> decoded(const EncodedImage& image, std::uint32_t longest) {
    const std::uint32_t factor = factorFor(image, longest);
    return image.type() == ImageType::Png ? decodedPng(image, factor) : decodedJpeg(image, factor);
}

}  // namespace rubble
