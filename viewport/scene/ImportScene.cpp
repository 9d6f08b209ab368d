#include "viewport/scene/ImportScene.h"

#include "core/asset/ImportedSolid.h"
#include "core/geometry/ConvexHull.h"
#include "core/geometry/OutlineShapes.h"
#include "viewport/scene/AssetModel.h"
#include "viewport/scene/SurfacePiece.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr BodyLook kMeshLook{.outside = 0xc4c9d1, .inside = 0xb07a6a};
constexpr BodyLook kArrowLook{.outside = 0xff8c1a};

// Of the prism's greatest extent.
constexpr double kArrowBeyond = 0.3;  // each cap
constexpr double kArrowWidth = 0.014;
constexpr double kHeadLength = 0.07, kHeadWidth = 0.05;
constexpr int kArrowSides = 16;

void addBody(RenderScene& scene, const Pose& pose, const BodyLook& look) {
    scene.motions.push_back(drawnPose(pose, scene.origin));
    scene.looks.push_back(look);
    scene.picks.emplace_back();
}

void addBatch(RenderScene& scene, SceneBatch batch, const Pose& pose, const BodyLook& look) {
    batch.firstBodies = {static_cast<std::uint32_t>(scene.motions.size())};
    for (std::uint32_t piece = 0; piece < batch.geometry->pieceCount(); ++piece) addBody(scene, pose, look);
    scene.batches.push_back(std::move(batch));
}

/// A cone along z, from a ring to its tip.
Polytope arrowHead(double width, double base, double tip) {
    std::vector<Vec3> points{{0.0, 0.0, tip}};
    for (const Vec2 corner : regularPolygonOutline(kArrowSides, width).outer) points.emplace_back(corner, base);
    return convexHull(points).value();
}

/// Through the prism along its z, in its frame.
std::shared_ptr<const SceneGeometry> arrowOf(const FoundPrism& prism) {
    const Vec2 size = boundsOf(prism.outline.outer).size();
    const double extent = std::max({size.x, size.y, prism.depth});
    const double end = prism.depth / 2.0 + kArrowBeyond * extent, base = end - kHeadLength * extent;
    const auto geometry = std::make_shared<SceneGeometry>();
    const Ring shaft = regularPolygonOutline(kArrowSides, kArrowWidth * extent).outer;
    addPiece(*geometry, std::vector{extruded(shaft, -end, base), arrowHead(kHeadWidth * extent, base, end)});
    return geometry;
}

/// The prism as hulls are drawn: over a body that has nothing of its own to show.
void addPrism(RenderScene& scene, const FoundPrism& prism) {
    const AssetModel model = modelOf({.prism = {prism.outline, prism.depth}}, nullptr, {});
    if (model.pieces.empty()) return;
    const auto nothing = std::make_shared<SceneGeometry>();
    nothing->boxes = model.geometry->boxes;
    const Vec3 middle = prism.pose.position + prism.pose.orientation * model.pieces.front().offset;
    addBatch(scene, {nothing, model.geometry, {}}, {middle, prism.pose.orientation}, {});
    addBatch(scene, {arrowOf(prism), nullptr, {}}, prism.pose, kArrowLook);
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

RenderScene importScene(const SourceModel& model, const FoundPrism* prism) {
    RenderScene scene{.origin = model.origin};
    addBatch(scene, {model.geometry, nullptr, {}}, {.position = model.origin}, kMeshLook);
    scene.groundHeight = boundsOf(scene).min.y;
    if (prism != nullptr) addPrism(scene, *prism);
    return scene;
}

}  // namespace rubble
