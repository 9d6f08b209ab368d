#include "app/importer/gltf/Meshopt.h"

#include <meshoptimizer.h>

namespace rubble {
namespace {

constexpr std::size_t kMaxSize = std::size_t{512} << 20;  // bytes; the importer has 2 GiB

bool isIndexSize(std::size_t stride) { return stride == 2 || stride == 4; }

/// What the library asserts of its arguments.
bool isValid(const GltfMeshopt& packed) {
    if (std::uint64_t{packed.count} * packed.stride > kMaxSize) return false;
    if (packed.mode == "ATTRIBUTES") return packed.stride > 0 && packed.stride <= 256 && packed.stride % 4 == 0;
    if (packed.mode == "TRIANGLES") return isIndexSize(packed.stride) && packed.count % 3 == 0;
    return packed.mode == "INDICES" && isIndexSize(packed.stride);
}

bool isFilterValid(const GltfMeshopt& packed) {
    if (packed.filter == "NONE") return true;
    if (packed.mode != "ATTRIBUTES") return false;
    if (packed.filter == "OCTAHEDRAL") return packed.stride == 4 || packed.stride == 8;
    if (packed.filter == "QUATERNION") return packed.stride == 8;
    return packed.filter == "EXPONENTIAL";
}

int decode(const GltfMeshopt& packed, char* to, const unsigned char* from, std::size_t size) {
    if (packed.mode == "ATTRIBUTES") return meshopt_decodeVertexBuffer(to, packed.count, packed.stride, from, size);
    if (packed.mode == "TRIANGLES") return meshopt_decodeIndexBuffer(to, packed.count, packed.stride, from, size);
    return meshopt_decodeIndexSequence(to, packed.count, packed.stride, from, size);
}

void applyFilter(const GltfMeshopt& packed, char* bytes) {
    if (packed.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(bytes, packed.count, packed.stride);
    if (packed.filter == "QUATERNION") meshopt_decodeFilterQuat(bytes, packed.count, packed.stride);
    if (packed.filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes, packed.count, packed.stride);
}

}  // namespace

std::optional<std::string> meshoptDecoded(const GltfMeshopt& packed, std::string_view bytes) {
    if (!isValid(packed) || !isFilterValid(packed)) return std::nullopt;
    std::string result(std::size_t{packed.count} * packed.stride, '\0');
    const auto* from = reinterpret_cast<const unsigned char*>(bytes.data());
    if (decode(packed, result.data(), from, bytes.size()) != 0) return std::nullopt;
    applyFilter(packed, result.data());
    return result;
}

}  // namespace rubble
