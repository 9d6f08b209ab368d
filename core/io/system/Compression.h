#pragma once

#include "core/base/Result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace rubble {

/// Compresses bytes by zlib, as fast as it can.
std::string compressed(std::string_view bytes);

/// Returns the `size` bytes that `packed` was made of. Takes no memory for a size that cannot be.
///
/// Errors: BadInput for others, with what is wrong as part of a sentence: "its size is wrong".
Result<std::string> uncompressed(std::string_view packed, std::uint64_t size);

}  // namespace rubble
