#include "viewport/video/ContactSheetPage.h"

#include <algorithm>
#include <array>
#include <string>

namespace rubble {
namespace {

constexpr int kGap = 8;    // pixels between images, and around them
constexpr int kPixel = 3;  // scale of the bitmap font
constexpr int kDigitWidth = 3, kDigitHeight = 5;

/// The bitmap of each digit: rows from top to bottom, three bits each, the highest is the leftmost.
constexpr std::array<std::array<std::uint8_t, kDigitHeight>, 10> kDigits{{{7, 5, 5, 5, 7},
                                                                          {2, 6, 2, 2, 7},
                                                                          {7, 1, 7, 4, 7},
                                                                          {7, 1, 3, 1, 7},
                                                                          {5, 5, 7, 1, 1},
                                                                          {7, 4, 7, 1, 7},
                                                                          {7, 4, 7, 5, 7},
                                                                          {7, 1, 2, 2, 2},
                                                                          {7, 5, 7, 5, 7},
                                                                          {7, 5, 7, 1, 7}}};

/// An image to paint on; `grey` from 0 to 255.
class Page {
public:
    Page(int width, int height, std::uint8_t grey) : m_image{width, height, {}} {
        m_image.pixels.assign(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), grey);
    }

    void fill(int x, int y, int width, int height, std::uint8_t grey) {
        for (int row = y; row < y + height; ++row) std::fill_n(at(x, row), 3 * width, grey);
    }
    void place(int x, int y, const Image& image) {
        for (int row = 0; row < image.height; ++row) {
            std::copy_n(image.pixels.begin() + 3 * std::ptrdiff_t{row} * image.width, 3 * image.width, at(x, y + row));
        }
    }
    /// Draws a number, dark on a light plate or inverted.
    void number(int x, int y, std::uint32_t number, Theme theme) {
        const std::string digits = std::to_string(number);
        const auto count = static_cast<int>(digits.size());
        const std::uint8_t plate = theme == Theme::Dark ? 20 : 245, ink = theme == Theme::Dark ? 235 : 25;
        fill(x, y, (count * (kDigitWidth + 1) + 1) * kPixel, (kDigitHeight + 2) * kPixel, plate);
        for (int k = 0; k < count; ++k) {
            const auto& rows = kDigits[static_cast<std::size_t>(digits[static_cast<std::size_t>(k)] - '0')];
            for (int cell = 0; cell < kDigitWidth * kDigitHeight; ++cell) {
                const int column = cell % kDigitWidth, row = cell / kDigitWidth;
                if (!(rows[static_cast<std::size_t>(row)] >> (kDigitWidth - 1 - column) & 1)) continue;
                fill(x + (k * (kDigitWidth + 1) + 1 + column) * kPixel, y + (row + 1) * kPixel, kPixel, kPixel, ink);
            }
        }
    }
    Image finished() && { return std::move(m_image); }

private:
    std::vector<std::uint8_t>::iterator at(int x, int y) {
        return m_image.pixels.begin() + 3 * (std::ptrdiff_t{y} * m_image.width + x);
    }
    Image m_image;
};

}  // namespace

Image contactSheetPage(const std::vector<NumberedImage>& images, Theme theme) {
    int width = 1, height = 1;
    for (const NumberedImage& numbered : images) {
        if (numbered.image) width = numbered.image->width, height = numbered.image->height;
    }
    const auto count = static_cast<int>(images.size());
    int columns = 1;
    while (columns * columns < count) ++columns;
    const int rows = (count + columns - 1) / columns;
    Page page(columns * (width + kGap) + kGap, rows * (height + kGap) + kGap, theme == Theme::Dark ? 40 : 220);
    for (int k = 0; k < count; ++k) {
        const int x = kGap + k % columns * (width + kGap), y = kGap + k / columns * (height + kGap);
        const NumberedImage& numbered = images[static_cast<std::size_t>(k)];
        if (numbered.image) page.place(x, y, *numbered.image);
        page.number(x, y, numbered.number, theme);
    }
    return std::move(page).finished();
}

}  // namespace rubble
