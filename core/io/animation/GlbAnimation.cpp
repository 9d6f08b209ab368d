#include "core/io/animation/GlbAnimation.h"

#include "core/base/Assert.h"
#include "core/io/exchange/GlbConstants.h"
#include "core/io/exchange/GlbContainer.h"
#include "core/io/json/VectorJson.h"

#include <bit>
#include <limits>

namespace rubble {
namespace {

// Views of keys, behind those of the four arrays of meshes.
constexpr std::uint64_t kTimeView = 4, kVectorView = 5, kRotationView = 6;

/// A list of keys: where it starts in the arrays of keys.
struct KeyRange {
    std::uint64_t time = 0;   // the first of the times
    std::uint64_t value = 0;  // the first of the vectors; of poses, also of the rotations
    std::uint64_t count = 0;
};

/// The arrays of keys of all nodes.
struct KeyArrays {
    std::vector<float> times;                     // s
    std::vector<std::array<float, 3>> vectors;    // translations and scales
    std::vector<std::array<float, 4>> rotations;  // x y z w

    /// The view of the first image, behind those of the keys that there are.
    std::uint64_t firstImageView() const {
        return !rotations.empty() ? kRotationView + 1 : !times.empty() ? kVectorView + 1 : kTimeView;
    }
};

template <class T>
void appendFloats(std::string& bytes, const std::vector<T>& values) {
    static_assert(std::endian::native == std::endian::little);
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

class AnimationWriter {
public:
    explicit AnimationWriter(const AnimatedScene& scene) : m_scene(scene), m_json(JsonLayout::Compact) {}

    Result<std::string> file() {
        for (const AnimatedMesh& mesh : m_scene.meshes) m_primitives.push_back(m_buffer.add(mesh.mesh));
        for (const AnimatedNode& node : m_scene.nodes) addKeys(node);
        std::string binary;
        m_buffer.appendTo(binary);
        appendFloats(binary, m_keys.times);
        appendFloats(binary, m_keys.vectors);
        appendFloats(binary, m_keys.rotations);
        for (const GlbImage& image : m_scene.images) binary += image.image->bytes();
        writeJson();
        std::string json = std::move(m_json).contents();
        if (json.size() + binary.size() > std::numeric_limits<std::uint32_t>::max() - 64) {
            return Error{ErrorCode::Limit,
                         "The animation exceeds 4 GiB, the maximum of a GLB file; simulate fewer "
                         "steps, or record fewer of them."};
        }
        return glbContainer(std::move(json), std::move(binary));
    }

private:
    float timeOf(std::uint32_t frame) const { return static_cast<float>(m_scene.frameLength * frame); }
    static bool moves(const AnimatedNode& node) { return node.poses.size() > 1; }
    static bool changesSize(const AnimatedNode& node) { return node.sizes.size() > 1; }

    void addKeys(const AnimatedNode& node) {
        KeyRange poses{m_keys.times.size(), m_keys.vectors.size(), moves(node) ? node.poses.size() : 0};
        m_rotationOf.push_back(m_keys.rotations.size());
        for (std::size_t k = 0; k < poses.count; ++k) {
            const PoseKey& key = node.poses[k];
            m_keys.times.push_back(timeOf(key.frame));
            m_keys.vectors.push_back({key.position.x, key.position.y, key.position.z});
            m_keys.rotations.push_back({key.orientation.x, key.orientation.y, key.orientation.z, key.orientation.w});
        }
        KeyRange sizes{m_keys.times.size(), m_keys.vectors.size(), changesSize(node) ? node.sizes.size() : 0};
        for (std::size_t k = 0; k < sizes.count; ++k) {
            m_keys.times.push_back(timeOf(node.sizes[k].frame));
            m_keys.vectors.push_back({node.sizes[k].size, node.sizes[k].size, node.sizes[k].size});
        }
        m_poses.push_back(poses);
        m_sizes.push_back(sizes);
    }

    void writeJson() {
        m_json.openObject();
        writeGlbAsset(m_json);
        writeNodes();
        writeMeshes();
        m_json.openArray("materials");
        for (const AnimatedMaterial& one : m_scene.materials) writeGlbMaterial(m_json, one.material, one.image);
        m_json.close();
        writeGlbTextures(m_json, m_scene.images, m_keys.firstImageView());
        m_json.openArray("accessors");
        for (const std::vector<GlbPrimitive>& primitives : m_primitives) {
            for (const GlbPrimitive& primitive : primitives) writeGlbAccessors(m_json, primitive, m_buffer);
        }
        writeKeyAccessors();
        m_json.close();
        writeAnimation();
        GlbViews views(m_json);
        views.addArrays(m_buffer);
        if (!m_keys.times.empty()) {
            views.addBytes(m_keys.times.size() * sizeof(float));
            views.addBytes(m_keys.vectors.size() * 3 * sizeof(float));
        }
        if (!m_keys.rotations.empty()) views.addBytes(m_keys.rotations.size() * 4 * sizeof(float));
        for (const GlbImage& image : m_scene.images) views.addBytes(image.image->bytes().size());
        views.end();
        m_json.close();
    }

    void writeNodes() {
        writeGlbScene(m_json, m_scene.nodes.size(), m_scene.name);
        m_json.openArray("nodes");
        for (const AnimatedNode& node : m_scene.nodes) {
            const PoseKey& pose = node.poses.front();
            const double size = double{node.sizes.front().size};
            m_json.openObject();
            m_json.text("name", node.name);
            m_json.wholeNumber("mesh", std::uint64_t{node.mesh});
            writeVector(m_json, "translation", Vec3(pose.position));
            const glm::quat& rotation = pose.orientation;
            m_json.numbers("rotation",
                           {double{rotation.x}, double{rotation.y}, double{rotation.z}, double{rotation.w}});
            if (size != 1.0) m_json.numbers("scale", {size, size, size});
            m_json.close();
        }
        m_json.close();
    }

    void writeMeshes() {
        m_json.openArray("meshes");
        for (std::size_t mesh = 0; mesh < m_scene.meshes.size(); ++mesh) {
            m_json.openObject();
            m_json.openArray("primitives");
            const std::vector<std::uint32_t>& materials = m_scene.meshes[mesh].materials;
            for (const GlbPrimitive& primitive : m_primitives[mesh]) {
                const bool isInside = primitive.material == GlbBuffer::kInside;
                const std::uint32_t material = isInside ? materials.back() : materials[primitive.material];
                writeGlbPrimitive(m_json, m_accessorCount, material, m_buffer, false);
                m_accessorCount += 4;
            }
            m_json.close();
            m_json.close();
        }
        m_json.close();
    }

    /// Of each node that moves: times, translations, rotations; of each that appears or goes: times, scales.
    void writeKeyAccessors() {
        for (std::size_t node = 0; node < m_scene.nodes.size(); ++node) {
            const KeyRange& poses = m_poses[node];
            if (poses.count > 0) {
                writeTimes(poses);
                writeKeys(kVectorView, poses.value * 12, poses.count, "VEC3");
                writeKeys(kRotationView, m_rotationOf[node] * 16, poses.count, "VEC4");
            }
            const KeyRange& sizes = m_sizes[node];
            if (sizes.count > 0) {
                writeTimes(sizes);
                writeKeys(kVectorView, sizes.value * 12, sizes.count, "VEC3");
            }
        }
    }
    void writeTimes(const KeyRange& range) {
        openGlbAccessor(m_json, kTimeView, 4 * range.time, gltf::kFloat, range.count, "SCALAR");
        m_json.numbers("min", {double{m_keys.times[range.time]}});
        m_json.numbers("max", {double{m_keys.times[range.time + range.count - 1]}});
        m_json.close();
    }
    void writeKeys(std::uint64_t view, std::uint64_t offset, std::uint64_t count, const char* type) {
        openGlbAccessor(m_json, view, offset, gltf::kFloat, count, type);
        m_json.close();
    }

    void writeAnimation() {
        if (m_keys.times.empty()) return;
        m_json.openArray("animations");
        m_json.openObject();
        m_json.text("name", "simulation");
        m_json.openArray("channels");
        std::uint64_t sampler = 0;
        for (std::size_t node = 0; node < m_scene.nodes.size(); ++node) {
            if (m_poses[node].count > 0) {
                writeChannel(sampler++, node, "translation");
                writeChannel(sampler++, node, "rotation");
            }
            if (m_sizes[node].count > 0) writeChannel(sampler++, node, "scale");
        }
        m_json.close();
        m_json.openArray("samplers");
        std::uint64_t accessor = m_accessorCount;
        for (std::size_t node = 0; node < m_scene.nodes.size(); ++node) {
            if (m_poses[node].count > 0) {
                writeSampler(accessor, accessor + 1, "LINEAR");
                writeSampler(accessor, accessor + 2, "LINEAR");
                accessor += 3;
            }
            if (m_sizes[node].count > 0) {
                writeSampler(accessor, accessor + 1, "STEP");
                accessor += 2;
            }
        }
        m_json.close();
        m_json.close();
        m_json.close();
    }
    void writeChannel(std::uint64_t sampler, std::uint64_t node, const char* path) {
        m_json.openObject();
        m_json.wholeNumber("sampler", sampler);
        m_json.openObject("target");
        m_json.wholeNumber("node", node);
        m_json.text("path", path);
        m_json.close();
        m_json.close();
    }
    void writeSampler(std::uint64_t input, std::uint64_t output, const char* interpolation) {
        m_json.openObject();
        m_json.wholeNumber("input", input);
        m_json.text("interpolation", interpolation);
        m_json.wholeNumber("output", output);
        m_json.close();
    }

    const AnimatedScene& m_scene;
    JsonWriter m_json;
    GlbBuffer m_buffer;
    std::vector<std::vector<GlbPrimitive>> m_primitives;  // of each mesh
    KeyArrays m_keys;
    std::vector<KeyRange> m_poses, m_sizes;  // of each node
    std::vector<std::uint64_t> m_rotationOf;
    std::uint64_t m_accessorCount = 0;  // of meshes
};

}  // namespace

Result<std::string> glbAnimation(const AnimatedScene& scene) { return AnimationWriter(scene).file(); }

}  // namespace rubble
