#include "core/io/animation/UsdAnimation.h"

#include "core/base/Version.h"
#include "core/io/exchange/UsdSurface.h"

#include <algorithm>

namespace rubble {
namespace {

class AnimationLayer {
public:
    AnimationLayer(const AnimatedScene& scene, std::span<const std::string> imageFiles)
        : m_scene(scene),
          m_root(UsdNames().unique(scene.name)),
          m_usd(m_root, std::string("Rubble ") + programVersion(), UsdTimes{scene.lastFrame, 1.0 / scene.frameLength}) {
        m_usd.begin("Xform", m_root);
        m_usd.begin("Scope", m_names.unique("Materials"));
        UsdNames names;
        for (const AnimatedMaterial& one : scene.materials) {
            const std::string file = one.material.isTextured ? imageFiles[one.image] : std::string();
            m_materials.push_back(writeUsdMaterial(m_usd, names, one.material, file));
        }
        m_usd.end();
    }

    std::string text() && {
        for (const AnimatedNode& node : m_scene.nodes) addNode(node);
        m_usd.end();
        return std::move(m_usd).text();
    }

private:
    void addNode(const AnimatedNode& node) {
        m_usd.begin("Xform", m_names.unique(node.name));
        addVisibility(node.sizes);
        addPoses(node.poses);
        const auto isPartial = [](const SizeKey& key) { return key.size > 0.0f && key.size < 1.0f; };
        const bool isScaled = std::ranges::any_of(node.sizes, isPartial);
        if (isScaled) addSizes(node.sizes);
        if (isScaled)
            m_usd.setTexts("uniform token[] xformOpOrder", {"xformOp:translate", "xformOp:orient", "xformOp:scale"});
        else
            m_usd.setTexts("uniform token[] xformOpOrder", {"xformOp:translate", "xformOp:orient"});
        const AnimatedMesh& mesh = m_scene.meshes[node.mesh];
        std::vector<std::string> surfaces;
        for (const std::uint32_t material : mesh.materials) surfaces.push_back(m_materials[material]);
        writeUsdMesh(m_usd, "surface", mesh.mesh, surfaces);
        m_usd.end();
    }

    void addVisibility(const std::vector<SizeKey>& sizes) {
        if (sizes.size() == 1) return;
        m_usd.beginSamples("token visibility");
        bool isVisible = false;
        for (const SizeKey& key : sizes) {
            if (key.frame > 0 && isVisible == (key.size > 0.0f)) continue;
            isVisible = key.size > 0.0f;
            m_usd.addSample(key.frame, isVisible ? "\"inherited\"" : "\"invisible\"");
        }
        m_usd.endSamples();
    }

    void addPoses(const std::vector<PoseKey>& poses) {
        if (poses.size() == 1) {
            m_usd.setDoubles("double3 xformOp:translate", Vec3(poses[0].position));
            m_usd.setRotation("quatf xformOp:orient", Quat(poses[0].orientation));
            return;
        }
        m_usd.beginSamples("double3 xformOp:translate");
        for (const PoseKey& key : poses) m_usd.addSample(key.frame, Vec3(key.position));
        m_usd.endSamples();
        m_usd.beginSamples("quatf xformOp:orient");
        for (const PoseKey& key : poses) m_usd.addSample(key.frame, Quat(key.orientation));
        m_usd.endSamples();
    }

    /// Sizes change from one frame to the next, between which USD interpolates.
    void addSizes(const std::vector<SizeKey>& sizes) {
        m_usd.beginSamples("float3 xformOp:scale");
        float held = 1.0f;
        for (std::size_t k = 0; k < sizes.size(); ++k) {
            const SizeKey& key = sizes[k];
            if (key.size <= 0.0f) continue;  // invisible
            if (k > 0 && sizes[k - 1].frame + 1 < key.frame) m_usd.addSample(key.frame - 1, Vec3(double{held}));
            held = key.size;
            m_usd.addSample(key.frame, Vec3(double{held}));
        }
        m_usd.endSamples();
    }

    const AnimatedScene& m_scene;
    UsdNames m_names;
    std::string m_root;
    UsdWriter m_usd;
    std::vector<std::string> m_materials;  // paths
};

}  // namespace

std::string usdAnimation(const AnimatedScene& scene, std::span<const std::string> imageFiles) {
    return AnimationLayer(scene, imageFiles).text();
}

}  // namespace rubble
