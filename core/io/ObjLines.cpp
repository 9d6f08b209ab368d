#include "core/io/ObjLines.h"

#include <bit>
#include <cmath>

namespace rubble {
namespace {

constexpr std::size_t kLongestLine = 8 + 3 * (kLongestNumberText + 1);  // of numbers
constexpr std::uint32_t kDecimals = 7;
constexpr double kDecimalUnits = 1e7;

/// Where a number is remembered: its bits mixed by multiplication, the best of them last.
std::size_t slotOf(std::uint64_t bits) { return (bits * 0x9e3779b97f4a7c15u) >> 56; }

/// The value rounded to seven decimals.
char* writeDecimals(char* at, double value) {
    auto units = static_cast<std::uint32_t>(std::abs(value) * kDecimalUnits + 0.5);
    if (value < 0.0 && units > 0) *at++ = '-';
    *at++ = static_cast<char>('0' + units / static_cast<std::uint32_t>(kDecimalUnits));
    units %= static_cast<std::uint32_t>(kDecimalUnits);
    if (units == 0) return at;
    *at++ = '.';
    for (std::uint32_t k = kDecimals; k-- > 0; units /= 10) at[k] = static_cast<char>('0' + units % 10);
    at += kDecimals;
    while (at[-1] == '0') --at;
    return at;
}

}  // namespace

ObjLines::ObjLines(std::size_t expectedSize) { m_text.reserve(expectedSize); }

/// Where the next `size` characters go.
char* ObjLines::room(std::size_t size) {
    if (m_at + size > m_block.data() + m_block.size()) {
        m_text.append(m_block.data(), m_at);
        m_at = m_block.data();
    }
    return m_at;
}

char* ObjLines::write(char* at, double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    Written& written = m_written[slotOf(bits)];
    if (written.bits != bits || written.length == 0) {
        written.bits = bits;
        written.length = static_cast<std::uint32_t>(writeNumber(written.text, value) - written.text);
    }
    std::memcpy(at, written.text, sizeof written.text);
    return at + written.length;
}

void ObjLines::addNamed(std::string_view keyword, std::string_view name) {
    room(m_block.size() + 1);  // empties it: names may be longer than any block
    m_text.append(keyword) += ' ';
    m_text.append(name) += '\n';
}

void ObjLines::addPosition(Vec3 position) {
    char* at = room(kLongestLine);
    *at++ = 'v';
    for (int axis = 0; axis < 3; ++axis) {
        *at++ = ' ';
        at = write(at, position[axis]);
    }
    *at++ = '\n';
    m_at = at;
}

void ObjLines::addUv(Vec2 uv) {
    char* at = room(kLongestLine);
    *at++ = 'v';
    *at++ = 't';
    for (int axis = 0; axis < 2; ++axis) {
        *at++ = ' ';
        at = write(at, uv[axis]);
    }
    *at++ = '\n';
    m_at = at;
}

void ObjLines::addNormal(Vec3 normal) {
    char* at = room(kLongestLine);
    *at++ = 'v';
    *at++ = 'n';
    for (int axis = 0; axis < 3; ++axis) {
        *at++ = ' ';
        at = writeDecimals(at, normal[axis]);
    }
    *at++ = '\n';
    m_at = at;
}

/// Gives the numbers after `last` their texts, each with `end` behind it.
void ObjLines::number(std::vector<IndexText>& texts, std::size_t count, std::uint32_t& last, char end) {
    texts.resize(count);
    for (IndexText& index : texts) {
        char* behind = writeNumber(index.text, ++last);
        *behind++ = end;
        index.length = static_cast<std::uint8_t>(behind - index.text);
    }
}

void ObjLines::beginFaces(const Mesh& mesh) {
    number(m_positionTexts, mesh.positions.size(), m_positions, '/');
    number(m_uvTexts, mesh.uvs.size(), m_uvs, '/');
    number(m_normalTexts, mesh.normals.size(), m_normals, ' ');
}

void ObjLines::addFace(const Mesh& mesh, const MeshFace& face) {
    const IndexText normal = m_normalTexts[face.normal];
    char* at = room(kLongestLine);
    *at++ = 'f';
    *at++ = ' ';
    for (const MeshCorner corner : mesh.cornersOf(face)) {
        m_at = at;
        at = room(kLongestCorner);
        at = write(at, m_positionTexts[corner.position]);
        at = write(at, m_uvTexts[corner.uv]);
        at = write(at, normal);
    }
    at[-1] = '\n';
    m_at = at;
}

std::string ObjLines::text() && {
    room(m_block.size() + 1);  // empties it
    return std::move(m_text);
}

}  // namespace rubble
