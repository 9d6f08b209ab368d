#pragma once

#include "app/importer/files/MeshFiles.h"
#include "app/importer/gltf/GltfDocument.h"

#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// The parts of a glTF file: the JSON text, and the binary chunk of a GLB file.
struct GltfChunks {
    std::string_view json;
    std::optional<std::string_view> binary;
};

/// Splits the bytes of a .gltf or .glb file, which must outlive the result.
///
/// Errors: throws MeshError; BadInput if a GLB file is truncated, Unsupported if it has another version than 2.
GltfChunks gltfChunks(std::string_view bytes);

/// The bytes that a glTF document refers to: in the GLB file, in data URIs and in files beside it. They are read where
/// they are first needed.
///
/// Errors: throws MeshError; Unsupported with the name of a file that is not read, BadInput for indices and sizes out
/// of range and damaged compressed bytes.
class GltfBuffers {
public:
    GltfBuffers(const GltfDocument& document, std::optional<std::string_view> binary, MeshFiles& files)
        : m_document(document),
          m_binary(binary),
          m_files(files),
          m_buffers(document.buffers.size()),
          m_unpacked(document.views.size()) {}

    /// The bytes of a view, decompressed.
    std::string_view view(std::uint32_t index);
    /// The bytes of a data URI, "data:application/octet-stream;base64,AAAA"; nothing if they are invalid.
    static std::optional<std::string> dataOf(std::string_view uri);

private:
    std::string_view buffer(std::uint32_t index);
    std::string contentOf(const std::string& uri) const;
    std::string_view bytesOf(std::uint32_t buffer, std::uint64_t offset, std::uint64_t size, const std::string& owner);

    const GltfDocument& m_document;
    std::optional<std::string_view> m_binary;
    MeshFiles& m_files;
    std::vector<std::optional<std::string>> m_buffers;
    std::vector<std::optional<std::string>> m_unpacked;
};

}  // namespace rubble
