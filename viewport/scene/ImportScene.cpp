#include "viewport/scene/ImportScene.h"

#include "core/asset/import/ImportedSolid.h"
#include "core/geometry/hull/ConvexHull.h"
#include "core/geometry/polygon/OutlineShapes.h"
#include "viewport/scene/AssetModel.h"
#include "viewport/scene/SurfaceGeometry.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace rubble {
namespace {

constexpr BodyAppearance kMeshAppearance{.outside = 0xc4c9d1, .inside = 0xb07a6a};
constexpr BodyAppearance kArrowAppearance{.outside = 0xff8c1a};
constexpr BodyAppearance kProblemAppearance{.outside = 0xe8372c, .inside = 0xe8372c};
constexpr glm::vec4 kProblemLine{0.91f, 0.16f, 0.13f, 1.0f};  // sRGB
constexpr float kProblemRadius = 2.0f;                        // points

constexpr glm::vec4 kBoxColour{0.05f, 0.55f, 0.62f, 1.0f};  // sRGB
constexpr float kBoxRadius = 1.0f;                          // points

// Relative to the diagonal of all meshes.
constexpr double kProblemHeight = 4e-4;  // of red triangles above and below theirs
constexpr double kMaxFramed = 0.25;      // of what is marked and framed as a whole
constexpr double kSurroundings = 0.06;   // around the place of a problem

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

/// Adds the box around a closed mesh, which itself is drawn already.
void addClosedMesh(RenderScene& scene, const SolidFit& solid) {
    const auto inScene = [&](Vec3 point) { return glm::vec3(point + solid.position - scene.origin); };
    const Box3& box = solid.mesh->bounds;
    scene.boxes.push_back({glm::vec4(inScene(box.min), kBoxRadius), glm::vec4(inScene(box.max), 0.0f), kBoxColour});
}

double diagonalOf(const SourceModel& model) {
    Box3 all;
    for (const Box3& box : model.geometry->boxes) all.include(box);
    return all.isEmpty() ? 0.0 : all.diagonal();
}

/// The triangles of all problems, moved along their normals.
TriangleMesh markedTriangles(std::span<const MeshProblem> problems, Vec3 origin, double height) {
    TriangleMesh marked;
    for (const MeshProblem& problem : problems) {
        for (const auto& [a, b, c] : problem.triangles) {
            const Vec3 normal = glm::cross(b - a, c - a);
            const double length = glm::length(normal);
            const Vec3 shift = length > 0.0 ? height / length * normal : Vec3(0.0);
            const auto first = static_cast<std::uint32_t>(marked.points.size());
            for (const Vec3 corner : {a, b, c}) marked.points.push_back(corner - origin + shift);
            marked.triangles.push_back({first, first + 1, first + 2});
        }
    }
    return marked;
}

void addProblems(RenderScene& scene, std::span<const MeshProblem> problems, double diagonal) {
    const auto geometry = std::make_shared<SceneGeometry>();
    for (const double height : {kProblemHeight * diagonal, -kProblemHeight * diagonal}) {
        const TriangleMesh marked = markedTriangles(problems, scene.origin, height);
        if (!marked.triangles.empty()) addSurface(*geometry, marked);
    }
    addBatch(scene, {geometry, nullptr, {}}, {.position = scene.origin}, kProblemAppearance);
    const auto inScene = [&](Vec3 point) { return glm::vec3(point - scene.origin); };
    for (const MeshProblem& problem : problems) {
        for (const auto& [from, to] : problem.edges)
            scene.lines.push_back(
                {glm::vec4(inScene(from), kProblemRadius), glm::vec4(inScene(to), 0.0f), kProblemLine});
    }
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

RenderScene importScene(const SourceModel& model, const ImportOverlay& overlay) {
    RenderScene scene{.origin = model.origin};
    addBatch(scene, {model.geometry, nullptr, {}}, {.position = model.origin}, kMeshAppearance);
    scene.groundHeight = boundsOf(scene).min.y;
    if (overlay.prism != nullptr) addPrism(scene, *overlay.prism);
    if (overlay.solid != nullptr) addClosedMesh(scene, *overlay.solid);
    if (!overlay.problems.empty()) addProblems(scene, overlay.problems, diagonalOf(model));
    return scene;
}

Box3 surroundingsOf(const MeshProblem& problem, const SourceModel& model) {
    const double diagonal = diagonalOf(model);
    Box3 box;
    for (const auto& triangle : problem.triangles)
        for (const Vec3 corner : triangle) box.include(corner);
    for (const auto& edge : problem.edges)
        for (const Vec3 end : edge) box.include(end);
    if (box.isEmpty() || box.diagonal() > kMaxFramed * diagonal) box = {};
    box.include(problem.place - Vec3(kSurroundings * diagonal));
    box.include(problem.place + Vec3(kSurroundings * diagonal));
    return box;
}

}  // namespace rubble
