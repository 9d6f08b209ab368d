#include "viewport/scene/SceneBuilder.h"

#include "core/asset/finish/AssetFinish.h"
#include "viewport/scene/BodyColours.h"
#include "viewport/scene/BondLines.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

bool isSameBake(const std::shared_ptr<const Bake>& a, const std::shared_ptr<const Bake>& b) {
    return a == b || (a && b && a->asset == b->asset && a->input == b->input);
}

/// Whether a model can be reused for an asset with a bake.
bool isModelOf(const AssetModel& model, const Asset& asset, std::uint32_t variant,
               const std::shared_ptr<const Bake>& bake, const SceneOptions& options) {
    return model.asset.id == asset.id && model.variant == variant && model.level == options.level &&
           isSameBake(model.bake, bake) && (bake || isSameShape(model.asset, asset)) &&
           model.asset.surface == asset.surface && model.asset.texture == asset.texture &&
           model.asset.insideUvScale == asset.insideUvScale &&
           model.asset.shaping.roughness == asset.shaping.roughness && (model.hulls || !options.hasHulls) &&
           (model.bonds || !needBonds(options) || !bake);
}

/// Assembles a scene from models.
class SceneAssembly {
public:
    SceneAssembly(const Project& project, const SceneOptions& options) : m_project(project), m_options(options) {
        m_scene.explodeFactor = options.explodeFactor;
    }

    void add(const AssetModel& model) {
        if (model.solids.empty()) return;
        m_scene.batches.push_back(batchOf(model, m_options));
        m_models.push_back(&model);
        if (m_options.asset != 0) return addInstance(model, 0, Pose{});
        for (const Instance& instance : m_project.instances) {
            if (variantOf(instance) == AssetVariant{model.asset.id, model.variant})
                addInstance(model, instance.id, instance.pose);
        }
    }

    RenderScene finished() {
        m_scene.restOffsets = std::make_shared<const std::vector<glm::vec4>>(std::move(m_restOffsets));
        colourBodies(m_scene, m_models, m_project, m_options.colouring);
        setMarks(m_scene, m_options.marks);
        explode();
        if (m_options.hasBonds) addBondLines(m_scene, m_models);
        return std::move(m_scene);
    }

private:
    void addInstance(const AssetModel& model, Id instance, const Pose& pose) {
        if (m_scene.poses.empty()) m_scene.origin = pose.position;
        m_scene.batches.back().firstBodies.push_back(static_cast<std::uint32_t>(m_scene.poses.size()));
        const Quat placed = instance != 0 ? pose.orientation : placedOrientation(m_project, model.asset.id);
        const auto up = static_cast<float>(courseUp(model.asset, placed));
        for (const ModelSolid& solid : model.solids) {
            const Vec3 position = pose.position + pose.orientation * solid.offset;
            m_scene.poses.push_back(renderPose({position, pose.orientation}, m_scene.origin));
            m_scene.appearances.emplace_back();
            m_restOffsets.emplace_back(glm::vec3(solid.offset), up);
            m_scene.picks.push_back({model.asset.id, instance, solid.fragment});
        }
    }

    /// Computes the explode offsets: away from the scene's centre, at ground height if there is a ground.
    void explode() {
        m_scene.explodeFactor = 0.0;
        const Box3 bounds = boundsOf(m_scene);
        m_scene.explodeFactor = m_options.explodeFactor;
        if (bounds.isEmpty()) return;
        m_scene.hasGround = m_options.asset != 0 || m_project.ground.isOn;
        m_scene.groundHeight = m_options.asset != 0 ? bounds.min.y : m_project.ground.height;
        Vec3 centre = bounds.centre();
        if (m_scene.hasGround) centre.y = std::min(m_scene.groundHeight, bounds.min.y);
        if (m_options.explodeFactor == 0.0) return;
        const glm::vec3 relativeCentre(centre - m_scene.origin);
        for (const RenderPose& pose : m_scene.poses) {
            m_scene.explodeOffsets.emplace_back(glm::vec3(pose.position) - relativeCentre, 0.0f);
        }
    }

    const Project& m_project;
    const SceneOptions& m_options;
    RenderScene m_scene;
    std::vector<glm::vec4> m_restOffsets;
    std::vector<const AssetModel*> m_models;  // one per batch
};

}  // namespace

RenderScene SceneBuilder::sceneOf(const Project& project, const AssetBakes& bakes, const SceneOptions& options) {
    std::vector<std::shared_ptr<const AssetModel>> models;
    for (const auto& [id, variant] : usedVariants(project)) {
        if (options.asset != 0 && AssetVariant{options.asset} != AssetVariant{id, variant}) continue;
        const Asset& asset = *findAsset(project, id);
        const auto found = bakes.find({id, variant});
        const std::shared_ptr<const Bake> bake = options.isWhole || found == bakes.end() ? nullptr : found->second;
        const auto known = std::ranges::find_if(
            m_models, [&](const auto& model) { return isModelOf(*model, asset, variant, bake, options); });
        if (known != m_models.end()) {
            models.push_back(*known);
            continue;
        }
        const auto made = std::make_shared<AssetModel>(modelOf(asset, bake, options));
        made->variant = variant;
        models.push_back(made);
    }
    m_models = std::move(models);
    SceneAssembly assembly(project, options);
    for (const auto& model : m_models) assembly.add(*model);
    RenderScene scene = assembly.finished();
    if (m_restOffsets == nullptr || *m_restOffsets != *scene.restOffsets) m_restOffsets = scene.restOffsets;
    scene.restOffsets = m_restOffsets;  // equal scenes are equal
    return scene;
}

RenderScene sceneOf(const Project& project, const AssetBakes& bakes, const SceneOptions& options) {
    return SceneBuilder().sceneOf(project, bakes, options);
}

}  // namespace rubble
