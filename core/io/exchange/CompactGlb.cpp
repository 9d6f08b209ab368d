#include "core/io/exchange/CompactGlb.h"

#include "core/base/Assert.h"
#include "core/io/exchange/GlbConstants.h"
#include "core/io/exchange/GlbContainer.h"
#include "core/io/exchange/GlbElements.h"
#include "core/io/json/VectorJson.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace rubble {
namespace {

constexpr std::size_t kMaxJoints = 65'536;  // of a skin: an index has 16 bits
constexpr double kLengthSteps = 1e7;        // of a metre, in the places of joints

template <class T>
T quantized(double value) {
    constexpr double kMost = std::numeric_limits<T>::max();
    return static_cast<T>(std::floor(std::clamp(value, -1.0, 1.0) * kMost + 0.5));
}

/// An array of the file: a view of the buffer, and the accessor with the same index.
struct View {
    std::uint64_t stride = 0;
    std::uint64_t count = 0;
    std::uint64_t target = 0;  // 0: neither vertices nor indices
    std::uint64_t offset = 0;  // of the compressed bytes
    std::uint64_t size = 0;
};

/// The vertices and triangles of parts that are drawn at once.
struct Batch {
    std::uint32_t material = 0;  // index in the file
    std::vector<std::array<std::int16_t, 4>> positions;
    std::vector<std::array<std::int8_t, 4>> normals;
    std::vector<std::array<std::uint16_t, 4>> joints;
    std::vector<std::array<std::uint8_t, 4>> weights;
    std::vector<std::array<std::uint16_t, 4>> colours;  // empty: texture coordinates
    std::vector<std::array<float, 2>> uvs;
    std::vector<std::uint32_t> indices;
    std::array<std::int16_t, 3> min{}, max{};  // of the positions
};

class CompactGlbWriter {
public:
    CompactGlbWriter(std::span<const MeshPart> parts, const MeshMaterials& materials)
        : m_parts(parts), m_materials(materials), m_scale(scaleOf(parts)) {
        for (const MeshMaterial& material : materials.outside) m_colours.push_back(colourOf(material));
        m_colours.push_back(colourOf(materials.inside));
    }

    Result<std::string> file(PartPlacement place, const std::string& name) {
        for (std::size_t first = 0; first < m_parts.size(); first += kMaxJoints) addMesh(first);
        addJointScales();
        std::uint64_t plainSize = 0;
        for (const View& view : m_views) plainSize += view.stride * view.count;
        std::string json = this->json(place, name, plainSize);
        std::string binary = std::move(m_binary);
        if (m_materials.image) binary += m_materials.image->bytes();
        if (std::max(json.size() + binary.size(), plainSize) > std::numeric_limits<std::uint32_t>::max() - 64) {
            return Error{ErrorCode::Limit,
                         std::to_string(m_parts.size()) +
                             " bodies exceed 4 GiB, the maximum of a GLB file; export one file per fragment."};
        }
        return glbContainer(std::move(json), std::move(binary));
    }

private:
    /// The largest coordinate of the parts, m: positions are parts of it.
    static double scaleOf(std::span<const MeshPart> parts) {
        double scale = 0.0;
        for (const MeshPart& part : parts) {
            for (const Vec3& position : part.mesh.positions) {
                for (int axis = 0; axis < 3; ++axis) scale = std::max(scale, std::abs(position[axis]));
            }
        }
        return scale > 0.0 ? static_cast<double>(static_cast<float>(scale)) : 1.0;
    }

    static std::array<std::uint16_t, 4> colourOf(const MeshMaterial& material) {
        const Vec3 colour = linearColour(material.colour);
        const auto part = [](double value) { return quantized<std::uint16_t>(value); };
        return {part(colour.x), part(colour.y), part(colour.z), part(material.opacity)};
    }

    bool hasColours() const { return !m_materials.image; }
    std::uint32_t insideMaterial() const { return static_cast<std::uint32_t>(m_materials.outside.size()); }

    void addMesh(std::size_t first) {
        std::vector<Batch> batches;
        const std::size_t end = std::min(first + kMaxJoints, m_parts.size());
        for (std::size_t part = first; part < end; ++part) {
            GlbBuffer buffer;
            for (const GlbPrimitive& primitive : buffer.add(m_parts[part].mesh)) {
                const bool isInside = primitive.material == GlbBuffer::kInside;
                const std::uint32_t material = isInside ? insideMaterial() : primitive.material;
                add(buffer, primitive, static_cast<std::uint16_t>(part - first), material,
                    batchOf(batches, hasColours() ? 0 : material));
            }
        }
        std::vector<std::pair<std::uint32_t, std::uint64_t>>& primitives = m_meshes.emplace_back();
        for (const Batch& batch : batches) {
            primitives.emplace_back(batch.material, m_views.size());
            m_bounds.push_back({batch.min, batch.max});
            addArray(batch.positions, gltf::kArrayBuffer);
            addArray(batch.normals, gltf::kArrayBuffer);
            addArray(batch.joints, gltf::kArrayBuffer);
            addArray(batch.weights, gltf::kArrayBuffer);
            hasColours() ? addArray(batch.colours, gltf::kArrayBuffer) : addArray(batch.uvs, gltf::kArrayBuffer);
            addIndices(batch);
        }
    }

    static Batch& batchOf(std::vector<Batch>& batches, std::uint32_t material) {
        const auto found = std::ranges::find(batches, material, &Batch::material);
        if (found != batches.end()) return *found;
        Batch& batch = batches.emplace_back();
        batch.material = material;
        batch.min.fill(std::numeric_limits<std::int16_t>::max());
        batch.max.fill(std::numeric_limits<std::int16_t>::lowest());
        return batch;
    }

    void add(const GlbBuffer& buffer, const GlbPrimitive& primitive, std::uint16_t joint, std::uint32_t material,
             Batch& batch) const {
        const auto base = static_cast<std::uint32_t>(batch.positions.size());
        const std::array<std::uint16_t, 4> colour = m_colours[material];
        for (std::uint32_t k = primitive.firstVertex; k < primitive.firstVertex + primitive.vertexCount; ++k) {
            std::array<std::int16_t, 4> position{};
            std::array<std::int8_t, 4> normal{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                position[axis] = quantized<std::int16_t>(buffer.positions()[k][axis] / m_scale);
                normal[axis] = quantized<std::int8_t>(buffer.normals()[k][axis]);
                batch.min[axis] = std::min(batch.min[axis], position[axis]);
                batch.max[axis] = std::max(batch.max[axis], position[axis]);
            }
            batch.positions.push_back(position);
            batch.normals.push_back(normal);
            batch.joints.push_back({joint, 0, 0, 0});
            batch.weights.push_back({255, 0, 0, 0});
            hasColours() ? batch.colours.push_back(colour) : batch.uvs.push_back(buffer.uvs()[k]);
        }
        for (const std::uint32_t index : buffer.indices().subspan(primitive.firstIndex, primitive.indexCount))
            batch.indices.push_back(base + index);
    }

    template <class T>
    void addArray(const std::vector<T>& values, std::uint64_t target) {
        std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(values.size(), sizeof(T)));
        bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), values.data(), values.size(), sizeof(T)));
        addView(bytes, sizeof(T), values.size(), target);
    }
    void addIndices(const Batch& batch) {
        meshopt_encodeIndexVersion(1);  // the one that the extension reads
        std::vector<unsigned char> bytes(meshopt_encodeIndexBufferBound(batch.indices.size(), batch.positions.size()));
        bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), batch.indices.data(), batch.indices.size()));
        addView(bytes, sizeof(std::uint32_t), batch.indices.size(), gltf::kElementArrayBuffer);
    }
    void addView(const std::vector<unsigned char>& bytes, std::uint64_t stride, std::uint64_t count,
                 std::uint64_t target) {
        RUBBLE_ASSERT(!bytes.empty());
        m_views.push_back({stride, count, target, m_binary.size(), bytes.size()});
        m_binary.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        m_binary.resize((m_binary.size() + 3) / 4 * 4, '\0');
    }

    /// The inverse bind matrices, for all skins: they turn quantized positions into metres.
    void addJointScales() {
        const auto scale = static_cast<float>(m_scale);
        const std::array<float, 16> matrix{scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, 1};
        addArray(std::vector(std::min(m_parts.size(), kMaxJoints), matrix), 0);
    }

    std::string json(PartPlacement place, const std::string& name, std::uint64_t plainSize) const {
        JsonWriter json(JsonLayout::Compact, 4096 + 120 * m_parts.size());
        json.openObject();
        writeGlbAsset(json);
        for (const char* member : {"extensionsUsed", "extensionsRequired"}) {
            json.openArray(member);
            for (const char* extension : {"KHR_mesh_quantization", "EXT_meshopt_compression"}) json.text({}, extension);
            json.close();
        }
        writeNodes(json, place, name);
        writeMeshes(json, name);
        hasColours() ? writeColouredMaterial(json) : writeGlbMaterials(json, m_materials);
        writeGlbTextures(json, glbImages(m_materials), m_views.size());
        writeAccessors(json);
        writeViews(json);
        json.openArray("buffers");
        json.openObject();
        json.wholeNumber("byteLength", m_binary.size() + (m_materials.image ? m_materials.image->bytes().size() : 0));
        json.close();
        json.openObject();
        json.wholeNumber("byteLength", plainSize);
        json.openObject("extensions");
        json.openObject("EXT_meshopt_compression");
        json.boolean("fallback", true);
        json.close();
        json.close();
        json.close();
        json.close();
        json.close();
        return std::move(json).contents();
    }

    /// Nodes: the skeleton, whose children are the joints; these; then the meshes.
    void writeNodes(JsonWriter& json, PartPlacement place, const std::string& name) const {
        const std::uint64_t joints = m_parts.size();
        json.wholeNumber("scene", std::uint64_t{0});
        json.openArray("scenes");
        json.openObject();
        json.openArray("nodes");
        json.wholeNumber({}, std::uint64_t{0});
        for (std::uint64_t mesh = 0; mesh < m_meshes.size(); ++mesh) json.wholeNumber({}, 1 + joints + mesh);
        json.close();
        json.close();
        json.close();
        json.openArray("nodes");
        json.openObject();
        json.text("name", name);
        writeNumbers(json, "children", 1, joints);
        json.close();
        for (const MeshPart& part : m_parts) {
            json.openObject();
            json.text("name", part.name);
            if (place == PartPlacement::Assembled) writeVector(json, "translation", rounded(part.offset));
            json.close();
        }
        for (std::uint64_t mesh = 0; mesh < m_meshes.size(); ++mesh) {
            json.openObject();
            json.text("name", meshName(name, mesh));
            json.wholeNumber("mesh", mesh);
            json.wholeNumber("skin", mesh);
            json.close();
        }
        json.close();
        json.openArray("skins");
        for (std::uint64_t mesh = 0; mesh < m_meshes.size(); ++mesh) {
            const std::uint64_t first = mesh * kMaxJoints;
            json.openObject();
            json.wholeNumber("inverseBindMatrices", m_views.size() - 1);
            json.wholeNumber("skeleton", std::uint64_t{0});
            writeNumbers(json, "joints", 1 + first, std::min<std::uint64_t>(joints - first, kMaxJoints));
            json.close();
        }
        json.close();
    }

    static void writeNumbers(JsonWriter& json, const char* key, std::uint64_t first, std::uint64_t count) {
        json.openArray(key);
        for (std::uint64_t k = 0; k < count; ++k) json.wholeNumber({}, first + k);
        json.close();
    }
    static Vec3 rounded(Vec3 place) { return glm::round(place * kLengthSteps) / kLengthSteps + Vec3(0.0); }
    std::string meshName(const std::string& name, std::uint64_t mesh) const {
        return name + "_mesh" + (m_meshes.size() == 1 ? std::string() : std::to_string(mesh));
    }

    void writeMeshes(JsonWriter& json, const std::string& name) const {
        json.openArray("meshes");
        for (std::size_t mesh = 0; mesh < m_meshes.size(); ++mesh) {
            json.openObject();
            json.text("name", meshName(name, mesh));
            json.openArray("primitives");
            for (const auto& [material, view] : m_meshes[mesh]) {
                json.openObject();
                json.openObject("attributes");
                const std::array<const char*, 5> attributes{"POSITION", "NORMAL", "JOINTS_0", "WEIGHTS_0",
                                                            hasColours() ? "COLOR_0" : "TEXCOORD_0"};
                for (std::size_t k = 0; k < attributes.size(); ++k) json.wholeNumber(attributes[k], view + k);
                json.close();
                json.wholeNumber("indices", view + attributes.size());
                json.wholeNumber("material", std::uint64_t{material});
                json.close();
            }
            json.close();
            json.close();
        }
        json.close();
    }

    /// A white one, since the colours are at the vertices.
    void writeColouredMaterial(JsonWriter& json) const {
        const auto isTransparent = [](const MeshMaterial& one) { return one.opacity < 1.0; };
        const bool blends =
            isTransparent(m_materials.inside) || std::ranges::any_of(m_materials.outside, isTransparent);
        json.openArray("materials");
        json.openObject();
        json.text("name", m_materials.outside.front().name);
        json.openObject("pbrMetallicRoughness");
        json.wholeNumber("metallicFactor", std::uint64_t{0});
        json.number("roughnessFactor", m_materials.outside.front().roughness());
        json.close();
        if (blends) json.text("alphaMode", "BLEND");
        json.close();
        json.close();
    }

    void writeAccessors(JsonWriter& json) const {
        struct Kind {
            std::uint64_t component;
            bool isNormalized;
            const char* type;
        };
        const std::array<Kind, 6> kinds{
            {{gltf::kShort, true, "VEC3"},
             {gltf::kByte, true, "VEC3"},
             {gltf::kUnsignedShort, false, "VEC4"},
             {gltf::kUnsignedByte, true, "VEC4"},
             hasColours() ? Kind{gltf::kUnsignedShort, true, "VEC4"} : Kind{gltf::kFloat, false, "VEC2"},
             {gltf::kUnsignedInt, false, "SCALAR"}}};
        json.openArray("accessors");
        for (std::size_t view = 0; view < m_views.size(); ++view) {
            const bool isMatrix = view + 1 == m_views.size();
            const Kind& kind = isMatrix ? Kind{gltf::kFloat, false, "MAT4"} : kinds[view % kinds.size()];
            json.openObject();
            json.wholeNumber("bufferView", std::uint64_t{view});
            json.wholeNumber("componentType", kind.component);
            if (kind.isNormalized) json.boolean("normalized", true);
            json.wholeNumber("count", m_views[view].count);
            json.text("type", kind.type);
            if (!isMatrix && view % kinds.size() == 0) {
                const auto& [min, max] = m_bounds[view / kinds.size()];
                json.numbers("min", {double(min[0]), double(min[1]), double(min[2])});
                json.numbers("max", {double(max[0]), double(max[1]), double(max[2])});
            }
            json.close();
        }
        json.close();
    }

    void writeViews(JsonWriter& json) const {
        json.openArray("bufferViews");
        std::uint64_t plain = 0;  // in the buffer that there would be without compression
        for (const View& view : m_views) {
            json.openObject();
            json.wholeNumber("buffer", std::uint64_t{1});
            json.wholeNumber("byteOffset", plain);
            json.wholeNumber("byteLength", view.stride * view.count);
            if (view.target == gltf::kArrayBuffer) json.wholeNumber("byteStride", view.stride);
            if (view.target != 0) json.wholeNumber("target", view.target);
            json.openObject("extensions");
            json.openObject("EXT_meshopt_compression");
            json.wholeNumber("buffer", std::uint64_t{0});
            json.wholeNumber("byteOffset", view.offset);
            json.wholeNumber("byteLength", view.size);
            json.wholeNumber("byteStride", view.stride);
            json.wholeNumber("count", view.count);
            json.text("mode", view.target == gltf::kElementArrayBuffer ? "TRIANGLES" : "ATTRIBUTES");
            json.close();
            json.close();
            json.close();
            plain += view.stride * view.count;
        }
        if (m_materials.image) {
            json.openObject();
            json.wholeNumber("buffer", std::uint64_t{0});
            json.wholeNumber("byteOffset", m_binary.size());
            json.wholeNumber("byteLength", m_materials.image->bytes().size());
            json.close();
        }
        json.close();
    }

    std::span<const MeshPart> m_parts;
    const MeshMaterials& m_materials;
    double m_scale;
    std::vector<std::array<std::uint16_t, 4>> m_colours;  // by material in the file
    std::string m_binary;
    std::vector<View> m_views;
    std::vector<std::vector<std::pair<std::uint32_t, std::uint64_t>>> m_meshes;  // of primitives: material, first view
    std::vector<std::pair<std::array<std::int16_t, 3>, std::array<std::int16_t, 3>>> m_bounds;  // of primitives
};

}  // namespace

Result<std::string> compactGlbFile(std::span<const MeshPart> parts, const MeshMaterials& materials, PartPlacement place,
                                   const std::string& name) {
    RUBBLE_ASSERT(!parts.empty());
    return CompactGlbWriter(parts, materials).file(place, name);
}

}  // namespace rubble
