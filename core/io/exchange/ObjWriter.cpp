#include "core/io/exchange/ObjWriter.h"

#include <cmath>

namespace rubble {
namespace {

constexpr std::size_t kMaxLineLength = 8 + 3 * (kMaxNumberLength + 1);  // of a line of numbers
constexpr std::uint32_t kDecimals = 7;
constexpr double kDecimalUnits = 1e7;

/// Writes a value rounded to seven decimals.
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

void ObjWriter::addNamed(std::string_view keyword, std::string_view name) {
    m_text.append(keyword);
    m_text.append(' ');
    m_text.append(name);
    m_text.append('\n');
}

void ObjWriter::addPosition(Vec3 position) {
    char* at = m_text.reserve(kMaxLineLength);
    *at++ = 'v';
    for (int axis = 0; axis < 3; ++axis) {
        *at++ = ' ';
        at = m_numbers.write(at, position[axis]);
    }
    *at++ = '\n';
    m_text.setEnd(at);
}

void ObjWriter::addUv(Vec2 uv) {
    char* at = m_text.reserve(kMaxLineLength);
    *at++ = 'v';
    *at++ = 't';
    for (int axis = 0; axis < 2; ++axis) {
        *at++ = ' ';
        at = m_numbers.write(at, uv[axis]);
    }
    *at++ = '\n';
    m_text.setEnd(at);
}

void ObjWriter::addNormal(Vec3 normal) {
    char* at = m_text.reserve(kMaxLineLength);
    *at++ = 'v';
    *at++ = 'n';
    for (int axis = 0; axis < 3; ++axis) {
        *at++ = ' ';
        at = writeDecimals(at, normal[axis]);
    }
    *at++ = '\n';
    m_text.setEnd(at);
}

/// Prepares the texts of the next `count` indices after `last`, each followed by `end`.
void ObjWriter::writeIndices(std::vector<IndexText>& texts, std::size_t count, std::uint32_t& last, char end) {
    texts.resize(count);
    for (IndexText& index : texts) {
        char* behind = writeInteger(index.text, ++last);
        *behind++ = end;
        index.length = static_cast<std::uint8_t>(behind - index.text);
    }
}

void ObjWriter::beginFaces(const Mesh& mesh) {
    writeIndices(m_positionTexts, mesh.positions.size(), m_positions, '/');
    writeIndices(m_uvTexts, mesh.uvs.size(), m_uvs, '/');
    writeIndices(m_normalTexts, mesh.normals.size(), m_normals, ' ');
}

void ObjWriter::addFace(const Mesh& mesh, const MeshFace& face) {
    const IndexText normal = m_normalTexts[face.normal];
    char* at = m_text.reserve(kMaxLineLength);
    *at++ = 'f';
    *at++ = ' ';
    for (const MeshCorner corner : mesh.cornersOf(face)) {
        m_text.setEnd(at);
        at = m_text.reserve(kMaxCornerLength);
        at = write(at, m_positionTexts[corner.position]);
        at = write(at, m_uvTexts[corner.uv]);
        at = write(at, normal);
    }
    at[-1] = '\n';
    m_text.setEnd(at);
}

}  // namespace rubble
