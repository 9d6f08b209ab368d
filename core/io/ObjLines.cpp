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

}  // namespace

ObjLines::ObjLines(std::size_t expectedSize) { m_text.reserve(expectedSize); }

void ObjLines::makeRoom(std::size_t size) {
    if (m_at + size <= m_block.data() + m_block.size()) return;
    m_text.append(m_block.data(), m_at);
    m_at = m_block.data();
}

void ObjLines::addNamed(std::string_view keyword, std::string_view name) {
    makeRoom(m_block.size());  // empties it: names may be longer than any block
    m_text.append(keyword) += ' ';
    m_text.append(name) += '\n';
}

void ObjLines::add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    Written& written = m_written[slotOf(bits)];
    if (written.bits != bits || written.length == 0) {
        written.bits = bits;
        written.length = static_cast<std::uint32_t>(writeNumber(written.text, value) - written.text);
    }
    std::memcpy(m_at, written.text, sizeof written.text);
    m_at += written.length;
}

void ObjLines::addDecimals(double value) {
    auto units = static_cast<std::uint32_t>(std::abs(value) * kDecimalUnits + 0.5);
    if (value < 0.0 && units > 0) add('-');
    add(static_cast<char>('0' + units / static_cast<std::uint32_t>(kDecimalUnits)));
    units %= static_cast<std::uint32_t>(kDecimalUnits);
    if (units == 0) return;
    add('.');
    for (std::uint32_t k = kDecimals; k-- > 0; units /= 10) m_at[k] = static_cast<char>('0' + units % 10);
    m_at += kDecimals;
    while (m_at[-1] == '0') --m_at;
}

void ObjLines::addPosition(Vec3 position) {
    makeRoom(kLongestLine);
    add('v');
    for (int axis = 0; axis < 3; ++axis) {
        add(' ');
        add(position[axis]);
    }
    add('\n');
}

void ObjLines::addUv(Vec2 uv) {
    makeRoom(kLongestLine);
    add('v');
    add('t');
    for (int axis = 0; axis < 2; ++axis) {
        add(' ');
        add(uv[axis]);
    }
    add('\n');
}

void ObjLines::addNormal(Vec3 normal) {
    makeRoom(kLongestLine);
    add('v');
    add('n');
    for (int axis = 0; axis < 3; ++axis) {
        add(' ');
        addDecimals(normal[axis]);
    }
    add('\n');
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
    makeRoom(kLongestLine);
    add('f');
    add(' ');
    for (const MeshCorner corner : mesh.cornersOf(face)) {
        makeRoom(3 * kLongestIndexText);
        add(m_positionTexts[corner.position]);
        add(m_uvTexts[corner.uv]);
        add(m_normalTexts[face.normal]);
    }
    m_at[-1] = '\n';
}

std::string ObjLines::text() && {
    makeRoom(m_block.size() + 1);
    return std::move(m_text);
}

}  // namespace rubble
