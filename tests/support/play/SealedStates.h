#pragma once

#include "core/base/Hash.h"

#include <cstring>
#include <string>
#include <string_view>

#include <zlib.h>

// State files apart: see docs/formats/state.md.

namespace rubble::test {

inline constexpr std::size_t kStateHeader = 37, kStateChecksum = 16;  // bytes
inline constexpr std::size_t kStateSize = 29;                         // place of the size of the fields

/// Bytes with the checksum that fits them.
inline std::string sealedState(std::string bytes) {
    const ContentHash hash = contentHash(bytes);
    bytes.append(reinterpret_cast<const char*>(&hash), sizeof(hash));
    return bytes;
}

/// The fields of a state file.
inline std::string fieldsOf(const std::string& bytes) {
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data() + kStateSize, sizeof(size));
    std::string fields(size, '\0');
    uLongf length = size;
    uncompress(reinterpret_cast<Bytef*>(fields.data()), &length,
               reinterpret_cast<const Bytef*>(bytes.data() + kStateHeader),
               bytes.size() - kStateHeader - kStateChecksum);
    return fields;
}

/// A state file with other fields, and a size and checksum that fit them.
inline std::string withFields(std::string_view bytes, const std::string& fields) {
    std::string made(bytes.substr(0, kStateHeader));
    const std::uint64_t size = fields.size();
    std::memcpy(made.data() + kStateSize, &size, sizeof(size));
    uLongf length = compressBound(size);
    std::string packed(length, '\0');
    compress2(reinterpret_cast<Bytef*>(packed.data()), &length, reinterpret_cast<const Bytef*>(fields.data()), size, 1);
    return sealedState(made + packed.substr(0, length));
}

}  // namespace rubble::test
