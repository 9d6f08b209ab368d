#include "app/importer/AssimpValues.h"

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

Vec3 pointOf(const aiVector3D& point) { return {decimalOf(point.x), decimalOf(point.y), decimalOf(point.z)}; }

Mat4 matrixOf(const aiMatrix4x4& matrix) {
    Mat4 result;
    for (unsigned row = 0; row < 4; ++row)
        for (unsigned column = 0; column < 4; ++column)
            result[static_cast<int>(column)][static_cast<int>(row)] = decimalOf(matrix[row][column]);
    return result;
}

std::string nameOf(const aiString& source) {
    const std::string bytes = source.C_Str();
    const bool isText = isUtf8(bytes);
    std::string name;
    for (const char letter : bytes) {
        const auto code = static_cast<unsigned char>(letter);
        if (code < 0x20 || code == 0x7f) {
            name += ' ';
        } else if (code < 0x80 || isText) {
            name += letter;
        } else {
            name += static_cast<char>(0xc0 | code >> 6);
            name += static_cast<char>(0x80 | (code & 0x3f));
        }
    }
    return name;
}

}  // namespace rubble
