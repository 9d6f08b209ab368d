#pragma once

#include "core/geometry/Mesh.h"
#include "core/io/NumberText.h"

#include <array>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// The lines of an OBJ file while it is written. Made for speed: a line is put together in a small block that stays in
/// the processor's cache, and a number that was written lately is copied, since a fragment's front and back have the
/// same corners and its caps' texture coordinates are often those corners too.
class ObjLines {
public:
    /// `expectedSize` of the text, in bytes: room is made once.
    explicit ObjLines(std::size_t expectedSize);

    /// The line "keyword name".
    void addNamed(std::string_view keyword, std::string_view name);
    void addPosition(Vec3 position);
    void addUv(Vec2 uv);
    /// With seven decimals, more than a float's: a direction has no far away.
    void addNormal(Vec3 normal);
    /// The faces that follow belong to the mesh whose positions, texture coordinates and normals were added last.
    void beginFaces(const Mesh& mesh);
    void addFace(const Mesh& mesh, const MeshFace& face);

    std::string text() &&;

private:
    static constexpr std::size_t kLongestIndexText = 12;  // "4294967295/" and one to spare
    static constexpr std::size_t kLongestCorner = 3 * kLongestIndexText;
    /// The text of a double that was written lately.
    struct Written {
        std::uint64_t bits = 0;
        std::uint32_t length = 0;
        char text[kLongestNumberText];
    };
    /// "12/"
    struct IndexText {
        char text[kLongestNumberText];
        std::uint32_t length = 0;
    };

    // Those that write give the end of what they wrote: a local pointer stays in a register, a member would not.
    char* room(std::size_t size);
    char* write(char* at, double value);
    static char* write(char* at, const IndexText& index) {
        std::memcpy(at, index.text, kLongestIndexText);
        return at + index.length;
    }
    static void number(std::vector<IndexText>& texts, std::size_t count, std::uint32_t& last, char end);

    std::string m_text;
    std::array<char, 8192> m_block;
    char* m_at = m_block.data();
    std::array<Written, 256> m_written;
    std::uint32_t m_positions = 0;  // in the file so far, as OBJ counts them
    std::uint32_t m_uvs = 0;
    std::uint32_t m_normals = 0;
    std::vector<IndexText> m_positionTexts;  // of the mesh whose faces are written
    std::vector<IndexText> m_uvTexts;
    std::vector<IndexText> m_normalTexts;
};

}  // namespace rubble
