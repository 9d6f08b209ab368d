#include "app/importer/files/AssimpValues.h"

#include "core/base/Utf8.h"

#include <array>
#include <charconv>
#include <cmath>

namespace rubble {

double decimalOf(float value) {
    if (!std::isfinite(value)) return static_cast<double>(value);
    std::array<char, 32> text;
    const char* end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    double result = 0.0;
    std::from_chars(text.data(), end, result);
    return result;
}

double srgbFromLinear(double linear) {
    const double value = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    return std::round(1e3 * value) / 1e3;
}

Vec3 pointOf(const aiVector3D& point) { return {decimalOf(point.x), decimalOf(point.y), decimalOf(point.z)}; }

Mat4 matrixOf(const aiMatrix4x4& matrix) {
    Mat4 result;
    for (unsigned row = 0; row < 4; ++row)
        for (unsigned column = 0; column < 4; ++column)
            result[static_cast<int>(column)][static_cast<int>(row)] = decimalOf(matrix[row][column]);
    return result;
}

std::string lineOf(std::string_view bytes) {
    const bool isText = isUtf8(bytes);
    std::string line;
    for (const char letter : bytes) {
        const auto code = static_cast<unsigned char>(letter);
        if (code < 0x20 || code == 0x7f) {
            line += ' ';
        } else if (code < 0x80 || isText) {
            line += letter;
        } else {
            line += static_cast<char>(0xc0 | code >> 6);
            line += static_cast<char>(0x80 | (code & 0x3f));
        }
    }
    return line;
}

std::string nameOf(const aiString& source) { return lineOf(source.C_Str()); }

std::string excerptOf(std::string_view bytes) {
    constexpr std::size_t kMaxLength = 150;  // bytes; a message with two excerpts and a file name is not cut
    std::string line = lineOf(bytes);
    if (line.size() <= kMaxLength) return line;
    line.resize(kMaxLength);
    while (!isUtf8(line)) line.pop_back();
    return line + "\u2026";
}

}  // namespace rubble
