#include "app/importer/ply/PlyReader.h"

#include "app/importer/files/AssimpValues.h"
#include "app/importer/ply/PlyHeader.h"

#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <algorithm>
#include <array>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace rubble {
namespace {

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
    std::vector<aiVector3D> points;
    std::vector<aiVector3D> uvs;  // of each point, or none
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
        aiVector3D point, uv;
        PlyFace face;
        std::vector<double>& values = m_current;
        const auto has = [&](Role role) { return std::ranges::find(roles, role) != roles.end(); };
        for (std::size_t k = 0; k < roles.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            readValues(element, property, values);
            switch (roles[k]) {
                case Role::X: point.x = static_cast<float>(values[0]); break;
                case Role::Y: point.y = static_cast<float>(values[0]); break;
                case Role::Z: point.z = static_cast<float>(values[0]); break;
                case Role::U: uv.x = static_cast<float>(values[0]); break;
                case Role::V: uv.y = static_cast<float>(values[0]); break;
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
        if (!isWhole(size)) fail(element, "the size of a list is invalid in ");
        if (size > static_cast<double>(m_values.remainingBytes())) fail(element, "the file ends in ");
        values.resize(static_cast<std::size_t>(size));
        for (double& value : values) value = valueOf(element, property.type);
    }
    double valueOf(const PlyElement& element, PlyType type) {
        const std::optional<double> value = m_values.next(type);
        if (!value) fail(element, m_values.isAtEnd() ? "the file ends in " : "a number is invalid in ");
        return *value;
    }
    [[noreturn]] void fail(const PlyElement& element, const char* what) const {
        throw std::runtime_error(what + ('"' + excerptOf(element.name)) + "\" " + std::to_string(m_number) + " of " +
                                 std::to_string(element.count));
    }

    std::uint32_t indexOf(const PlyElement& element, double value) const {
        if (!isWhole(value) || value > 0xffffffff) fail(element, "the number of a point is invalid in ");
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

/// assimp triangulates polygons without checking their corners.
void checkCorners(const PlyMesh& mesh) {
    for (const PlyFace& face : mesh.faces)
        for (const std::uint32_t corner : face.corners)
            if (corner >= mesh.points.size())
                throw std::runtime_error("a face refers to point " + std::to_string(corner) + " of " +
                                         std::to_string(mesh.points.size()));
}

bool hasUvs(const PlyFace& face) { return !face.uvs.empty() && face.uvs.size() == 2 * face.corners.size(); }

/// Gives each corner of each face a point of its own, with the corner's texture coordinates.
PlyMesh withSeparateCorners(const PlyMesh& mesh) {
    PlyMesh separate;
    for (const PlyFace& face : mesh.faces) {
        PlyFace& copy = separate.faces.emplace_back();
        for (std::size_t k = 0; k < face.corners.size(); ++k) {
            copy.corners.push_back(static_cast<std::uint32_t>(separate.points.size()));
            separate.points.push_back(mesh.points[face.corners[k]]);
            const double* uv = hasUvs(face) ? &face.uvs[2 * k] : nullptr;
            separate.uvs.emplace_back(uv ? static_cast<float>(uv[0]) : 0.0f, uv ? static_cast<float>(uv[1]) : 0.0f,
                                      0.0f);
        }
    }
    return separate;
}

template <class Value>
Value* arrayOf(const std::vector<Value>& values) {
    auto* array = new Value[values.size()];
    std::ranges::copy(values, array);
    return array;
}

std::unique_ptr<aiMesh> meshOf(const PlyMesh& source) {
    auto mesh = std::make_unique<aiMesh>();
    mesh->mNumVertices = static_cast<unsigned>(source.points.size());
    mesh->mVertices = arrayOf(source.points);
    if (source.uvs.size() == source.points.size()) {
        mesh->mTextureCoords[0] = arrayOf(source.uvs);
        mesh->mNumUVComponents[0] = 2;
    }
    mesh->mNumFaces = static_cast<unsigned>(source.faces.size());
    mesh->mFaces = new aiFace[source.faces.size()];
    for (std::size_t k = 0; k < source.faces.size(); ++k) {
        mesh->mFaces[k].mNumIndices = static_cast<unsigned>(source.faces[k].corners.size());
        mesh->mFaces[k].mIndices = arrayOf(source.faces[k].corners);
    }
    return mesh;
}

std::string contentOf(const std::string& name, Assimp::IOSystem& files) {
    const std::unique_ptr<Assimp::IOStream> stream(files.Open(name, "rb"));
    if (!stream) throw std::runtime_error("it cannot be opened");
    std::string bytes(stream->FileSize(), '\0');
    bytes.resize(stream->Read(bytes.data(), 1, bytes.size()));
    return bytes;
}

}  // namespace

bool PlyReader::CanRead(const std::string& file, Assimp::IOSystem* files, bool /*checkSignature*/) const {
    return CheckMagicToken(files, file, "ply\n", 1) || CheckMagicToken(files, file, "ply\r", 1);
}

const aiImporterDesc* PlyReader::GetInfo() const {
    static constexpr aiImporterDesc kDescription{
        .mName = "PLY",
        .mAuthor = "",
        .mMaintainer = "",
        .mComments = "",
        .mFlags = aiImporterFlags_SupportTextFlavour | aiImporterFlags_SupportBinaryFlavour,
        .mMinMajor = 1,
        .mMinMinor = 0,
        .mMaxMajor = 1,
        .mMaxMinor = 0,
        .mFileExtensions = "ply"};
    return &kDescription;
}

void PlyReader::InternReadFile(const std::string& file, aiScene* scene, Assimp::IOSystem* files) {
    const std::string bytes = contentOf(file, *files);
    const Result<PlyHeader> header = readPlyHeader(bytes);
    if (!header) throw std::runtime_error(header.error().message);
    PlyMesh mesh = PlyElements(*header, bytes).read();
    checkCorners(mesh);
    if (std::ranges::any_of(mesh.faces, hasUvs)) mesh = withSeparateCorners(mesh);

    scene->mNumMeshes = scene->mNumMaterials = 1;
    scene->mMeshes = new aiMesh* [1] { meshOf(mesh).release() };
    scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
    const aiColor3D white(1.0f, 1.0f, 1.0f);
    scene->mMaterials[0]->AddProperty(&white, 1, AI_MATKEY_COLOR_DIFFUSE);
    scene->mRootNode = new aiNode;
    scene->mRootNode->mNumMeshes = 1;
    scene->mRootNode->mMeshes = new unsigned[1]{0};
}

}  // namespace rubble
