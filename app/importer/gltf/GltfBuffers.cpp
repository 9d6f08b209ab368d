#include "app/importer/gltf/GltfBuffers.h"

#include "app/importer/files/MeshError.h"
#include "app/importer/files/PercentEncoding.h"
#include "app/importer/gltf/Meshopt.h"
#include "core/io/text/Base64.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr std::size_t kHeaderSize = 12, kChunkHeaderSize = 8;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;

std::uint32_t integerAt(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
    return value;
}

std::string named(const char* what, std::uint32_t index) { return what + std::to_string(index) + "]"; }

/// Where the chunk behind one that ends at a position begins: there, or at the next multiple of four if a length lacks
/// its padding.
std::size_t nextChunk(std::string_view bytes, std::size_t end) {
    const bool isThere = end + kChunkHeaderSize <= bytes.size() && integerAt(bytes, end + 4) == kBinaryChunk;
    return isThere ? end : (end + 3) / 4 * 4;
}

}  // namespace

GltfChunks gltfChunks(std::string_view bytes) {
    if (!bytes.starts_with("glTF")) return {bytes, std::nullopt};
    if (bytes.size() < kHeaderSize) failGltf("the file ends in its header");
    if (const std::uint32_t version = integerAt(bytes, 4); version != 2)
        throw MeshError(ErrorCode::Unsupported,
                        "has version " + std::to_string(version) + " of GLB; export it as glTF 2.0");
    GltfChunks chunks;
    const std::size_t end = std::min<std::size_t>(integerAt(bytes, 8), bytes.size());
    for (std::size_t at = kHeaderSize; at + kChunkHeaderSize <= end;) {
        const std::size_t size = integerAt(bytes, at);
        const std::uint32_t kind = integerAt(bytes, at + 4);
        at += kChunkHeaderSize;
        if (size > bytes.size() - at) failGltf("the file ends in a chunk");
        if (kind == kJsonChunk && chunks.json.empty()) chunks.json = bytes.substr(at, size);
        if (kind == kBinaryChunk && !chunks.binary) chunks.binary = bytes.substr(at, size);
        at = nextChunk(bytes, at + size);
    }
    while (chunks.json.ends_with('\0')) chunks.json.remove_suffix(1);
    return chunks;
}

std::string_view GltfBuffers::view(std::uint32_t index) {
    if (index >= m_document.views.size())
        failGltf("it refers to buffer view " + std::to_string(index) + " of " +
                 std::to_string(m_document.views.size()));
    const GltfView& view = m_document.views[index];
    if (!view.meshopt) return bytesOf(view.buffer, view.offset, view.size, named("bufferViews[", index));
    std::optional<std::string>& bytes = m_unpacked[index];
    if (!bytes) {
        const GltfMeshopt& packed = *view.meshopt;
        bytes =
            meshoptDecoded(packed, bytesOf(packed.buffer, packed.offset, packed.size, named("bufferViews[", index)));
        if (!bytes) failGltf("the compressed bytes of " + named("bufferViews[", index) + " are damaged");
    }
    return *bytes;
}

std::optional<std::string> GltfBuffers::dataOf(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos) return std::nullopt;
    const std::string_view data = uri.substr(comma + 1);
    const std::string text = percentDecoded(data).value_or(std::string(data));
    return uri.substr(0, comma).ends_with(";base64") ? base64Decoded(text) : text;
}

std::string_view GltfBuffers::bytesOf(std::uint32_t index, std::uint64_t offset, std::uint64_t size,
                                      const std::string& owner) {
    const std::string_view bytes = buffer(index);
    if (offset > bytes.size() || size > bytes.size() - offset)
        failGltf(owner + " ends behind its buffer, which has " + std::to_string(bytes.size()) + " bytes");
    return bytes.substr(offset, size);
}

std::string_view GltfBuffers::buffer(std::uint32_t index) {
    if (index >= m_document.buffers.size())
        failGltf("it refers to buffer " + std::to_string(index) + " of " + std::to_string(m_document.buffers.size()));
    const GltfBuffer& buffer = m_document.buffers[index];
    if (!buffer.uri) {
        if (index > 0 || !m_binary) failGltf(named("buffers[", index) + " has no bytes");
        return *m_binary;
    }
    std::optional<std::string>& bytes = m_buffers[index];
    if (!bytes) {
        bytes = contentOf(*buffer.uri);
        if (bytes->size() < buffer.size)
            failGltf(named("buffers[", index) + " should have " + std::to_string(buffer.size) + " bytes, and has " +
                     std::to_string(bytes->size()));
    }
    return *bytes;
}

std::string GltfBuffers::contentOf(const std::string& uri) const {
    if (uri.starts_with("data:")) {
        std::optional<std::string> bytes = dataOf(uri);
        if (!bytes) failGltf("a data URI is invalid");
        return std::move(*bytes);
    }
    std::optional<std::string> bytes = m_files.content(uri);
    if (!bytes) throw MeshError(ErrorCode::Unsupported, refusalText(m_files.refused().back()));
    return std::move(*bytes);
}

}  // namespace rubble
