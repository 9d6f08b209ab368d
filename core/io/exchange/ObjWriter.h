#pragma once

#include "core/geometry/mesh/Mesh.h"
#include "core/io/text/NumberTextCache.h"
#include "core/io/text/TextBuffer.h"

#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// Writes the lines of an OBJ file.
class ObjWriter {
public:
    /// Reserves memory for a text of `expectedSize` bytes.
    explicit ObjWriter(std::size_t expectedSize) : m_text(expectedSize) {}

    /// The line "keyword name".
    void addNamed(std::string_view keyword, std::string_view name);
    void addPosition(Vec3 position);
    void addUv(Vec2 uv);
    /// Writes seven decimals, which is more than the precision of a float.
    void addNormal(Vec3 normal);
    /// Starts the faces of the mesh whose positions, texture coordinates and normals were added last.
    void beginFaces(const Mesh& mesh);
    void addFace(const Mesh& mesh, const MeshFace& face);

    std::string text() && { return std::move(m_text).text(); }

private:
    static constexpr std::size_t kMaxIndexLength = 12;  // "4294967295/", rounded up
    static constexpr std::size_t kMaxCornerLength = 3 * kMaxIndexLength;
    /// An index with a slash: "12/".
    struct IndexText {
        char text[kMaxNumberLength];
        std::uint32_t length = 0;
    };

    // Functions that write return the end of the text: a local pointer stays in a register, a member would not.
    static char* write(char* at, const IndexText& index) {
        std::memcpy(at, index.text, kMaxIndexLength);
        return at + index.length;
    }
    static void writeIndices(std::vector<IndexText>& texts, std::size_t count, std::uint32_t& last, char end);

    TextBuffer m_text;
    NumberTextCache m_numbers;
    std::uint32_t m_positions = 0;  // in the file so far; OBJ counts from 1
    std::uint32_t m_uvs = 0;
    std::uint32_t m_normals = 0;
    std::vector<IndexText> m_positionTexts;  // of the current mesh
    std::vector<IndexText> m_uvTexts;
    std::vector<IndexText> m_normalTexts;
};

}  // namespace rubble
