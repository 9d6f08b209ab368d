#include "core/io/system/Compression.h"

#include "core/base/Assert.h"

#include <zlib.h>

namespace rubble {

std::string compressed(std::string_view bytes) {
    uLongf size = compressBound(bytes.size());
    std::string packed(size, '\0');
    const int done = compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_SPEED);
    RUBBLE_ASSERT(done == Z_OK);
    packed.resize(size);
    return packed;
}

Result<std::string> uncompressed(std::string_view packed, std::uint64_t size) {
    constexpr std::uint64_t kMaxFold = 1100;  // zlib compresses to no less than a 1032nd
    if (size > kMaxFold * packed.size()) return Error{ErrorCode::BadInput, "its size is wrong"};
    std::string bytes(size, '\0');
    uLongf length = size;
    uLong used = packed.size();
    const int done = uncompress2(reinterpret_cast<Bytef*>(bytes.data()), &length,
                                 reinterpret_cast<const Bytef*>(packed.data()), &used);
    if (done == Z_OK && length == size && used == packed.size()) return bytes;
    return Error{ErrorCode::BadInput, "its compressed part is damaged"};
}

}  // namespace rubble
