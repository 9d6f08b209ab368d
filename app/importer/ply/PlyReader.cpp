#include "app/importer/ply/PlyReader.h"

#include "app/importer/files/AssimpValues.h"
#include "app/importer/files/MeshError.h"
#include "app/importer/files/PolygonTriangles.h"
#include "app/importer/files/Rounding.h"
#include "app/importer/ply/PlyHeader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <optional>

namespace rubble {
namespace {

[[noreturn]] void failPly(const std::string& what) {
    throw MeshError(ErrorCode::BadInput, "cannot be read as PLY: " + what);
}

/// A number as programs mean it: files have single precision.
double single(double value) { return decimalOf(static_cast<float>(value)); }

/// The values after the header, one after the other.
class PlyValues {
public:
    PlyValues(std::string_view bytes, PlyEncoding encoding) : m_bytes(bytes), m_encoding(encoding) {}

    /// Returns the next value; nothing at the end of the file or if it is not a number.
    std::optional<double> next(PlyType type) { return m_encoding == PlyEncoding::Ascii ? word() : number(type); }
    std::size_t remainingBytes() const { return m_bytes.size(); }
    /// Whether there was no next value because the file ends.
    bool isAtEnd() const { return m_bytes.empty() || m_encoding != PlyEncoding::Ascii; }

private:
    std::optional<double> word() {
        constexpr std::string_view kSpaces = " \t\r\n";
        m_bytes.remove_prefix(std::min(m_bytes.find_first_not_of(kSpaces), m_bytes.size()));
        const std::size_t length = std::min(m_bytes.find_first_of(kSpaces), m_bytes.size());
        const char* end = m_bytes.data() + length;
        double value = 0.0;
        const auto read = std::from_chars(m_bytes.data() + (m_bytes.starts_with('+') ? 1 : 0), end, value);
        if (read.ec != std::errc{} || read.ptr != end) return std::nullopt;
        m_bytes.remove_prefix(length);
        return value;
    }
    std::optional<double> number(PlyType type) {
        switch (type) {
            case PlyType::Int8: return value<std::int8_t>();
            case PlyType::Uint8: return value<std::uint8_t>();
            case PlyType::Int16: return value<std::int16_t>();
            case PlyType::Uint16: return value<std::uint16_t>();
            case PlyType::Int32: return value<std::int32_t>();
            case PlyType::Uint32: return value<std::uint32_t>();
            case PlyType::Float32: return value<float>();
            case PlyType::Float64: return value<double>();
        }
        return std::nullopt;
    }
    template <class Number>
    std::optional<double> value() {
        std::array<char, sizeof(Number)> bytes;
        if (m_bytes.size() < bytes.size()) return std::nullopt;
        std::ranges::copy(m_bytes.substr(0, bytes.size()), bytes.begin());
        const bool isLittle = std::endian::native == std::endian::little;
        if (isLittle != (m_encoding == PlyEncoding::LittleEndian)) std::ranges::reverse(bytes);
        m_bytes.remove_prefix(bytes.size());
        return static_cast<double>(std::bit_cast<Number>(bytes));
    }

    std::string_view m_bytes;
    PlyEncoding m_encoding;
};

struct PlyFace {
    std::vector<std::uint32_t> corners;
    std::vector<double> uvs;  // u and v of each corner, or none
};

struct PlyMesh {
    std::vector<Vec3> points;
    std::vector<Vec2> uvs;  // of each point, or none
    std::vector<PlyFace> faces;
};

/// What a property means.
enum class Role { None, X, Y, Z, U, V, Corners, CornerUvs, Strip };

Role roleOf(const PlyElement& element, const PlyProperty& property) {
    struct Meaning {
        std::string_view element, property;
        Role role;
    };
    constexpr std::array<Meaning, 16> kMeanings{{{"vertex", "x", Role::X},
                                                 {"vertex", "y", Role::Y},
                                                 {"vertex", "z", Role::Z},
                                                 {"vertex", "u", Role::U},
                                                 {"vertex", "s", Role::U},
                                                 {"vertex", "tx", Role::U},
                                                 {"vertex", "texture_u", Role::U},
                                                 {"vertex", "v", Role::V},
                                                 {"vertex", "t", Role::V},
                                                 {"vertex", "ty", Role::V},
                                                 {"vertex", "texture_v", Role::V},
                                                 {"face", "vertex_index", Role::Corners},
                                                 {"face", "vertex_indices", Role::Corners},
                                                 {"face", "texcoord", Role::CornerUvs},
                                                 {"tristrips", "vertex_index", Role::Strip},
                                                 {"tristrips", "vertex_indices", Role::Strip}}};
    for (const Meaning& meaning : kMeanings) {
        const bool isList = meaning.role >= Role::Corners;
        if (element.name == meaning.element && property.name == meaning.property &&
            isList == property.listSize.has_value())
            return meaning.role;
    }
    return Role::None;
}

bool isWhole(double value) { return value >= 0.0 && value == std::floor(value); }

/// Reads the elements after the header.
class PlyElements {
public:
    PlyElements(const PlyHeader& header, std::string_view file)
        : m_header(header), m_values(file.substr(header.size), header.encoding) {}

    PlyMesh read() {
        for (const PlyElement& element : m_header.elements) {
            if (element.properties.empty()) continue;  // takes no bytes, however many there are
            std::vector<Role> roles;
            for (const PlyProperty& property : element.properties) roles.push_back(roleOf(element, property));
            for (m_number = 1; m_number <= element.count; ++m_number) readOne(element, roles);
        }
        return std::move(m_mesh);
    }

private:
    void readOne(const PlyElement& element, const std::vector<Role>& roles) {
        Vec3 point{0.0};
        Vec2 uv{0.0};
        PlyFace face;
        std::vector<double>& values = m_current;
        const auto has = [&](Role role) { return std::ranges::find(roles, role) != roles.end(); };
        for (std::size_t k = 0; k < roles.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            readValues(element, property, values);
            switch (roles[k]) {
                case Role::X: point.x = single(values[0]); break;
                case Role::Y: point.y = single(values[0]); break;
                case Role::Z: point.z = single(values[0]); break;
                case Role::U: uv.x = single(values[0]); break;
                case Role::V: uv.y = single(values[0]); break;
                case Role::Corners: face.corners = indicesOf(element, values); break;
                case Role::CornerUvs: face.uvs = values; break;
                case Role::Strip: addStrip(element, values); break;
                case Role::None: break;
            }
        }
        if (element.name == "vertex") m_mesh.points.push_back(point);
        if (has(Role::U)) m_mesh.uvs.push_back(uv);
        if (!face.corners.empty()) m_mesh.faces.push_back(std::move(face));
    }

    /// Reads the value of a property, or its list of values.
    void readValues(const PlyElement& element, const PlyProperty& property, std::vector<double>& values) {
        const double size = property.listSize ? valueOf(element, *property.listSize) : 1.0;
        if (!isWhole(size)) failIn(element, "the size of a list is invalid in ");
        if (size > static_cast<double>(m_values.remainingBytes())) failIn(element, "the file ends in ");
        values.resize(static_cast<std::size_t>(size));
        for (double& value : values) value = valueOf(element, property.type);
    }
    double valueOf(const PlyElement& element, PlyType type) {
        const std::optional<double> value = m_values.next(type);
        if (!value) failIn(element, m_values.isAtEnd() ? "the file ends in " : "a number is invalid in ");
        return *value;
    }
    [[noreturn]] void failIn(const PlyElement& element, const char* what) const {
        failPly(what + ('"' + excerptOf(element.name)) + "\" " + std::to_string(m_number) + " of " +
                std::to_string(element.count));
    }

    std::uint32_t indexOf(const PlyElement& element, double value) const {
        if (!isWhole(value) || value > 0xffffffff) failIn(element, "the number of a point is invalid in ");
        return static_cast<std::uint32_t>(value);
    }
    std::vector<std::uint32_t> indicesOf(const PlyElement& element, const std::vector<double>& values) const {
        std::vector<std::uint32_t> indices;
        for (const double value : values) indices.push_back(indexOf(element, value));
        return indices;
    }
    /// Each number after two is a triangle with them; every second one is flipped. -1 starts a new strip.
    void addStrip(const PlyElement& element, const std::vector<double>& values) {
        std::vector<std::uint32_t> strip;
        for (const double value : values) {
            if (value == -1.0) {
                strip.clear();
                continue;
            }
            strip.push_back(indexOf(element, value));
            const std::size_t count = strip.size();
            if (count < 3) continue;
            std::vector<std::uint32_t> corners(strip.end() - 3, strip.end());
            if (count % 2 == 0) std::swap(corners[0], corners[1]);
            m_mesh.faces.push_back({std::move(corners), {}});
        }
    }

    const PlyHeader& m_header;
    PlyValues m_values;
    PlyMesh m_mesh;
    std::uint64_t m_number = 0;     // of the element being read
    std::vector<double> m_current;  // values of the property being read
};

bool hasUvs(const PlyFace& face) { return !face.uvs.empty() && face.uvs.size() == 2 * face.corners.size(); }

/// Adds the triangles of faces to an object that has their points. Texture coordinates of corners, where a face has
/// any, replace those of points.
void addFaces(const PlyMesh& mesh, SourceObject& object) {
    const bool hasCornerUvs = std::ranges::any_of(mesh.faces, hasUvs);
    const bool hasPointUvs = !hasCornerUvs && mesh.uvs.size() == mesh.points.size();
    object.hasUvs = hasCornerUvs || hasPointUvs;
    std::vector<Vec3> polygon;
    for (const PlyFace& face : mesh.faces) {
        polygon.clear();
        for (const std::uint32_t corner : face.corners) polygon.push_back(mesh.points[corner]);
        if (polygon.size() < 3) continue;
        for (const auto& corners : polygonTriangles(polygon)) {
            if (object.triangles.size() == kMaxTriangles)
                throw MeshError(ErrorCode::Limit, "contains more than " + std::to_string(kMaxTriangles) + " triangles");
            SourceTriangle& triangle = object.triangles.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t corner = corners[k];
                triangle.points[k] = face.corners[corner];
                if (hasPointUvs) triangle.uvs[k] = mesh.uvs[triangle.points[k]];
                if (hasUvs(face)) triangle.uvs[k] = {single(face.uvs[2 * corner]), single(face.uvs[2 * corner + 1])};
            }
        }
    }
}

}  // namespace

SourceScene readPly(std::string_view bytes) {
    const Result<PlyHeader> header = readPlyHeader(bytes);
    if (!header) failPly(header.error().message);
    PlyMesh mesh = PlyElements(*header, bytes).read();
    for (const PlyFace& face : mesh.faces)
        for (const std::uint32_t corner : face.corners)
            if (const std::size_t count = mesh.points.size(); corner >= count)
                failPly("a face refers to point " + std::to_string(corner) + " of " + std::to_string(count));
    SourceScene scene;
    scene.materials.push_back({.name = {}, .colour = Vec3(1.0)});
    SourceObject object;
    addFaces(mesh, object);
    if (object.triangles.empty()) return scene;
    RoundingMeter rounding;
    rounding.add(mesh.points);
    object.rounding = displacementBy(rounding.step(), Mat4(1.0));
    object.points = std::move(mesh.points);
    scene.objects.push_back(std::move(object));
    return scene;
}

}  // namespace rubble
