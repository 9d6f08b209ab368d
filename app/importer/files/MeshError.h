#pragma once

#include "core/base/Result.h"

#include <stdexcept>
#include <string>

namespace rubble {

/// Why a file is not read, thrown by the importer's own readers: the end of a sentence that begins with the file's
/// name.
class MeshError : public std::runtime_error {
public:
    MeshError(ErrorCode code, const std::string& what) : std::runtime_error(what), m_code(code) {}
    ErrorCode code() const { return m_code; }

private:
    ErrorCode m_code;
};

/// Rejects a file in glTF that is invalid.
[[noreturn]] inline void failGltf(const std::string& what) {
    throw MeshError(ErrorCode::BadInput, "cannot be read as glTF: " + what);
}

}  // namespace rubble
