#include "core/io/animation/AnimatedScene.h"

#include "core/asset/mesh/FragmentMesh.h"
#include "core/asset/mesh/RoughCuts.h"
#include "core/io/exchange/PackBuilder.h"
#include "core/play/scene/Projectile.h"

#include <algorithm>
#include <map>
#include <set>

namespace rubble {
namespace {

/// The hull of a plain projectile as a mesh without texture coordinates.
Mesh hullMesh(const Polytope& hull) {
    Mesh mesh{.positions = hull.vertices, .uvs = {Vec2(0.0)}};
    for (std::size_t k = 0; k < hull.faces.size(); ++k) {
        mesh.normals.push_back(hull.planes[k].normal);
        mesh.faces.push_back({.firstCorner = static_cast<std::uint32_t>(mesh.corners.size()),
                              .cornerCount = static_cast<std::uint32_t>(hull.faces[k].size()),
                              .normal = static_cast<std::uint32_t>(k)});
        for (const std::uint32_t vertex : hull.faces[k]) mesh.corners.push_back({vertex, 0});
    }
    return mesh;
}

double radiusOf(const Mesh& mesh) {
    double radius = 0.0;
    for (const Vec3& position : mesh.positions) radius = std::max(radius, glm::length(position));
    return radius;
}

/// Makes the meshes of one asset.
struct AssetMeshes {
    AssetMeshes(const Asset& asset, const Bake& baked) : mesher(asset), cuts(baked, asset), bake(baked) {}

    Mesh meshOf(std::uint32_t fragment) const {
        if (fragment == kNone) return mesher.wholeMesh(bake);
        return mesher.fragmentMesh(bake.fragment(fragment), cuts.cornersOf(fragment));
    }

    FragmentMesher mesher;
    RoughCuts cuts;
    const Bake& bake;
    std::vector<std::uint32_t> materials;
};

class SceneMaker {
public:
    SceneMaker(const std::string& name, const Project& project, const SessionTracks& tracks)
        : m_project(project),
          m_scene{
              .name = identifierOf(meshName(name)), .frameLength = tracks.frameLength, .lastFrame = tracks.lastFrame} {}

    void add(const SolidTrack& track) {
        const std::uint32_t mesh = meshOf(track);
        m_scene.nodes.push_back({.name = nameOf(track),
                                 .mesh = mesh,
                                 .poses = reducedPoses(track.poses, m_radii[mesh], kAnimationTolerance),
                                 .sizes = track.sizes});
    }

    AnimatedScene scene() && { return std::move(m_scene); }

private:
    std::string nameOf(const SolidTrack& track) {
        const PackNames names{.folder = meshName(track.origin)};
        std::string name = identifierOf(names.folder) + "_thrown";  // without an ending that an importer acts upon
        if (track.asset != nullptr) {
            name = track.fragment == kNone ? wholeBodyName(names)
                                           : fragmentBodyName(names, track.asset->bake->fragmentId(track.fragment));
        }
        return uniqueName(name, m_names);
    }

    std::uint32_t addMesh(Mesh mesh, std::vector<std::uint32_t> materials) {
        m_radii.push_back(radiusOf(mesh));
        m_scene.meshes.push_back({std::move(mesh), std::move(materials)});
        return static_cast<std::uint32_t>(m_scene.meshes.size() - 1);
    }

    std::uint32_t meshOf(const SolidTrack& track) {
        if (track.asset == nullptr) return meshOf(*track.hull);
        const auto [known, isNew] = m_meshOf.try_emplace({track.asset.get(), track.fragment}, 0);
        if (isNew) {
            const AssetMeshes& meshes = meshesOf(*track.asset);
            known->second = addMesh(meshes.meshOf(track.fragment), meshes.materials);
        }
        return known->second;
    }
    std::uint32_t meshOf(const Polytope& hull) {
        const auto known = std::ranges::find_if(m_hulls, [&](const auto& one) { return *one.first == hull; });
        if (known != m_hulls.end()) return known->second;
        const std::uint32_t material = addMaterial({{"projectile", kProjectileColour}, 0});
        m_hulls.emplace_back(&hull, addMesh(hullMesh(hull), {material, material}));
        return m_hulls.back().second;
    }

    const AssetMeshes& meshesOf(const PlayAsset& played) {
        const auto known = m_assets.find(&played);
        if (known != m_assets.end()) return known->second;
        const Asset& asset = *findAsset(m_project, played.bake->asset);
        AssetMeshes& meshes = m_assets.try_emplace(&played, asset, *played.bake).first->second;
        const MeshMaterials materials = meshMaterials(asset, materialsOf(m_project, asset));
        const std::uint32_t image = materials.image ? addImage({materials.imageFile, materials.image}) : 0;
        for (const MeshMaterial& material : materials.outside)
            meshes.materials.push_back(addMaterial({material, image}));
        meshes.materials.push_back(addMaterial({materials.inside, image}));
        return meshes;
    }

    std::uint32_t addMaterial(const AnimatedMaterial& material) {
        const auto known = std::ranges::find(m_scene.materials, material);
        if (known == m_scene.materials.end()) m_scene.materials.push_back(material);
        return static_cast<std::uint32_t>(std::ranges::find(m_scene.materials, material) - m_scene.materials.begin());
    }
    std::uint32_t addImage(GlbImage image) {
        const auto known =
            std::ranges::find_if(m_scene.images, [&](const GlbImage& one) { return *one.image == *image.image; });
        const auto index = static_cast<std::uint32_t>(known - m_scene.images.begin());
        if (known == m_scene.images.end()) m_scene.images.push_back(std::move(image));
        return index;
    }

    const Project& m_project;
    AnimatedScene m_scene;
    std::vector<double> m_radii;  // of the meshes, m
    std::set<std::string> m_names;
    std::map<const PlayAsset*, AssetMeshes> m_assets;
    std::map<std::pair<const PlayAsset*, std::uint32_t>, std::uint32_t> m_meshOf;
    std::vector<std::pair<const Polytope*, std::uint32_t>> m_hulls;
};

}  // namespace

Result<AnimatedScene> animatedScene(const std::string& name, const Project& project, const SessionTracks& tracks,
                                    const TaskContext& task) {
    SceneMaker maker(name, project, tracks);
    for (const SolidTrack& track : tracks.solids) {
        if (task.isCancelled()) return TaskContext::cancelled();
        maker.add(track);
    }
    return std::move(maker).scene();
}

}  // namespace rubble
