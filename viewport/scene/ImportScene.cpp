#include "viewport/scene/ImportScene.h"

#include "core/asset/import/ImportedSolid.h"
#include "core/geometry/hull/ConvexHull.h"
#include "core/geometry/polygon/OutlineShapes.h"
#include "viewport/scene/AssetModel.h"
#include "viewport/scene/SurfaceGeometry.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr BodyAppearance kMeshAppearance{.outside = 0xc4c9d1, .inside = 0xb07a6a};
constexpr BodyAppearance kArrowAppearance{.outside = 0xff8c1a};

// Relative to the prism's largest extent.
constexpr double kArrowOverhang = 0.3;  // beyond each cap
constexpr double kArrowWidth = 0.014;
constexpr double kHeadLength = 0.07, kHeadWidth = 0.05;
constexpr int kArrowSides = 16;

void addBody(RenderScene& scene, const Pose& pose, const BodyAppearance& appearance) {
    scene.poses.push_back(renderPose(pose, scene.origin));
    scene.appearances.push_back(appearance);
    scene.picks.emplace_back();
}

void addBatch(RenderScene& scene, SceneBatch batch, const Pose& pose, const BodyAppearance& appearance) {
    batch.firstBodies = {static_cast<std::uint32_t>(scene.poses.size())};
    for (std::uint32_t solid = 0; solid < batch.geometry->solidCount(); ++solid) addBody(scene, pose, appearance);
    scene.batches.push_back(std::move(batch));
}

/// A cone along z; nothing if it is too small or too large for the predicates of hulls.
std::vector<Polytope> arrowHead(double width, double base, double tip) {
    std::vector<Vec3> points{{0.0, 0.0, tip}};
    for (const Vec2 corner : regularPolygonOutline(kArrowSides, width).outer) points.emplace_back(corner, base);
    Result<Polytope> hull = convexHull(points);
    return hull ? std::vector{std::move(*hull)} : std::vector<Polytope>();
}

/// An arrow through the prism along its z axis, in its frame.
std::shared_ptr<const SceneGeometry> arrowOf(const PrismFit& prism) {
    const Vec2 size = boundsOf(prism.outline.outer).size();
    const double extent = std::max({size.x, size.y, prism.depth});
    const double end = prism.depth / 2.0 + kArrowOverhang * extent, base = end - kHeadLength * extent;
    const auto geometry = std::make_shared<SceneGeometry>();
    const Ring shaft = regularPolygonOutline(kArrowSides, kArrowWidth * extent).outer;
    std::vector<Polytope> parts = arrowHead(kHeadWidth * extent, base, end);
    parts.push_back(extruded(shaft, -end, base));
    addSolid(*geometry, parts);
    return geometry;
}

/// Adds the prism as the hull of a body without geometry.
void addPrism(RenderScene& scene, const PrismFit& prism) {
    const AssetModel model = modelOf({.shape = Prism{prism.outline, prism.depth}}, nullptr, {});
    if (model.solids.empty()) return;
    const auto noGeometry = std::make_shared<SceneGeometry>();
    noGeometry->boxes = model.geometry->boxes;
    const Vec3 centre = prism.pose.position + prism.pose.orientation * model.solids.front().offset;
    addBatch(scene, {noGeometry, model.geometry, {}}, {centre, prism.pose.orientation}, {});
    addBatch(scene, {arrowOf(prism), nullptr, {}}, prism.pose, kArrowAppearance);
}

}  // namespace

SourceModel sourceModel(const SourceScene& scene, double metresPerUnit, UpAxis up) {
    std::vector<TriangleMesh> meshes;
    Box3 bounds;
    for (const SourceObject& object : scene.objects) {
        meshes.push_back(meshInWorld(object, metresPerUnit, up));
        for (const Vec3 point : meshes.back().points) bounds.include(point);
    }
    SourceModel model{bounds.isEmpty() ? Vec3(0.0) : bounds.centre(), nullptr};
    const auto geometry = std::make_shared<SceneGeometry>();
    for (TriangleMesh& mesh : meshes) {
        for (Vec3& point : mesh.points) point -= model.origin;
        addSurface(*geometry, mesh);
    }
    model.geometry = geometry;
    return model;
}

RenderScene importScene(const SourceModel& model, const PrismFit* prism) {
    RenderScene scene{.origin = model.origin};
    addBatch(scene, {model.geometry, nullptr, {}}, {.position = model.origin}, kMeshAppearance);
    scene.groundHeight = boundsOf(scene).min.y;
    if (prism != nullptr) addPrism(scene, *prism);
    return scene;
}

}  // namespace rubble
