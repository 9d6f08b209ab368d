#pragma once

#include "core/base/Result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

/// Returns the number of bytes of a value in a binary file.
std::size_t sizeOf(PlyType type);

/// A value of an element, or a list of values.
struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    std::optional<PlyType> listSize;  // of the number before a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

/// The header of a PLY file, which says what follows it.
struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::Ascii;
    std::vector<PlyElement> elements;
    std::size_t size = 0;  // bytes
};

/// Reads the header of a PLY file. Lines end with LF or CR LF.
///
/// Errors: BadInput, as the end of a sentence, with the line if one is invalid.
Result<PlyHeader> readPlyHeader(std::string_view file);

}  // namespace rubble
