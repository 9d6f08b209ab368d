#include "core/io/exchange/PackBuilder.h"

#include "core/asset/strength/FragmentThresholds.h"
#include "core/asset/strength/Threshold.h"
#include "core/base/Assert.h"
#include "core/base/Parallel.h"
#include "core/base/Version.h"
#include "core/geometry/hull/InsetHull.h"
#include "core/physics/solver/SpeedThresholds.h"
#include "core/play/damage/InstanceDamage.h"
#include "core/structure/capacity/BondCapacities.h"
#include "core/structure/clusters/ClusterLevels.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// Returns the widest gap between the fragments of a body, m; 0: there is none.
double widestGap(const Bake& bake) {
    double widest = 0.0;
    for (const BakedFracture& fracture : bake.fractures) widest = std::max(widest, fracture.fragments.gap);
    return widest;
}

/// Returns the volume that the gap takes from the fragments of a body, m³.
double lostVolume(const BakedFracture& fracture, double volume) {
    double left = 0.0;
    for (std::uint32_t k = 0; k < fracture.fragments.count(); ++k) left += fracture.fragments[k].volume();
    return std::max(0.0, volume - left);
}

PackBounds packBoundsOf(std::span<const Polytope> hulls) {
    if (hulls.empty()) return {};
    PackBounds bounds{.min = hulls[0].vertices[0], .max = hulls[0].vertices[0], .thinnest = thinnestWidth(hulls[0])};
    for (const Polytope& hull : hulls) {
        bounds.thinnest = std::min(bounds.thinnest, thinnestWidth(hull));
        for (const Vec3& vertex : hull.vertices) {
            bounds.min = glm::min(bounds.min, vertex);
            bounds.max = glm::max(bounds.max, vertex);
            bounds.radius = std::max(bounds.radius, glm::length(vertex));
        }
    }
    return bounds;
}

}  // namespace

std::vector<PackSurface> packSurfaces(const Asset& asset, const AssetMaterials& material) {
    const MeshMaterials materials = meshMaterials(asset, material);
    std::vector<PackSurface> surfaces;
    const auto add = [&](const MeshMaterial& one, bool isInside) {
        surfaces.push_back({.name = one.name,
                            .isInside = isInside,
                            .colour = one.colour,
                            .opacity = one.opacity,
                            .roughness = one.roughness(),
                            .texture = one.isTextured ? materials.imageFile : std::string()});
    };
    for (const MeshMaterial& one : materials.outside) add(one, false);
    add(materials.inside, true);
    return surfaces;
}

PackNames packNames(const Asset& asset) { return {asset.name, asset.name, 0, meshName(asset.name)}; }

std::string identifierOf(std::string name) {
    for (char& letter : name) {
        if (letter == '-' || letter == '.' || letter == ' ') letter = '_';
    }
    return name;
}

std::string wholeBodyName(const PackNames& names) { return identifierOf(names.folder) + "_whole"; }

std::string fragmentBodyName(const PackNames& names, std::string_view fragmentId) {
    std::string name = identifierOf(names.folder) + "_f";
    for (const char letter : pathOfId(fragmentId)) {
        switch (letter) {
            case '.': name += '_'; break;
            case '/': name += "__"; break;
            case '+': name += 'x'; break;
            default: name += letter;
        }
    }
    return name;
}

PackBuilder::PackBuilder(const PackInput& input, const TaskContext& task)
    : m_input(input), m_threshold(thresholdOf(input.asset, input.material.own)), m_bonds(input.bake.fractures.size()) {
    forEachIndex(m_bonds.size(), task.threads, [&](std::size_t k) {
        const BakedFracture& fracture = m_input.bake.fractures[k];
        m_bonds[k] = bondsOf(fracture);
    });
}

Pack PackBuilder::header(std::span<const PackMeshFile> meshes) const {
    const auto& [bake, asset, material, names, settings, orientation] = m_input;
    const PackHashes hashes = packHashes(asset, material, names, settings, meshes);
    Pack pack;
    pack.generator = std::string("Rubble ") + programVersion();
    pack.asset = asset.id;
    pack.names = names;
    pack.gap = widestGap(bake);
    pack.hash = hashes.all.hex();
    pack.physicsHash = hashes.physics.hex();
    pack.threshold = m_threshold;
    pack.breaking = {asset.breakAs, settings.rule, asset.cutAtImpact, double{kMinImpactSpeed},
                     double{kMinRestitutionSpeed}};
    pack.inset = settings.inset;
    pack.materials = {material.own};
    if (&material.own != &material.inside) {
        pack.materials.push_back(material.inside);
        pack.insideMaterial = 1;
    }
    pack.surfaces = packSurfaces(asset, material);
    pack.debris = settings.debris;
    pack.meshes.assign(meshes.begin(), meshes.end());
    return pack;
}

PackBody PackBuilder::body(const MassProperties& mass, std::uint32_t index, const std::vector<Polytope>& hulls) const {
    const Bake& bake = m_input.bake;
    const double density = m_input.material.own.density;
    PackBody body;
    body.volume = mass.volume;
    body.mass = density * mass.volume;
    body.inertia = density * mass.inertia;
    body.principal = principalInertia(body.inertia);
    body.bounds = packBoundsOf(hulls);
    for (const Polytope& hull : hulls) {
        InsetHull inset = insetHull(hull, m_input.settings.inset);
        body.hulls.push_back({std::move(inset.polytope), inset.inset, {}});
    }
    const BakedFracture* fracture = bake.fractureOf(index);
    if (fracture == nullptr) return body;
    body.firstChild = fracture->first;
    body.childCount = fracture->fragments.count();
    body.gap = fracture->fragments.gap;
    if (body.gap > 0.0) body.lostMass = density * lostVolume(*fracture, mass.volume);
    return body;
}

PackBody PackBuilder::whole() const {
    PackBody body = this->body(m_input.bake.whole, kNone, m_input.bake.wholeHulls);
    body.id = std::to_string(m_input.asset.id);
    body.name = wholeBodyName(m_input.names);
    body.offset = m_input.bake.whole.centre;
    body.threshold = m_threshold;
    return body;
}

PackBody PackBuilder::fragment(std::uint32_t index) const {
    const BakedFragment fragment = m_input.bake.fragment(index);
    PackBody body = this->body(fragment.solid.mass(), index, fragment.solid.hulls());
    body.id = m_input.bake.fragmentId(index);
    body.name = fragmentBodyName(m_input.names, body.id);
    body.parent = fragment.parent;
    body.level = fragment.level;
    body.offset = fragment.solid.offset();
    const std::uint32_t own = index - fragment.firstSibling;
    const std::vector<Bond>& bonds = m_bonds[m_input.bake.fractureContaining(index)];
    auto bond = std::ranges::lower_bound(bonds, own, {}, &Bond::first);
    for (const FragmentContact& contact : fragment.solid.contacts()) {
        PackNeighbour& neighbour = body.neighbours.emplace_back();
        neighbour.fragment = fragment.firstSibling + contact.fragment;
        neighbour.area = contact.area;
        if (contact.fragment < own) continue;
        RUBBLE_ASSERT(bond != bonds.end() && bond->first == own && bond->second == contact.fragment);
        neighbour.centroid = bond->centroid;
        neighbour.normal = bond->normal;
        ++bond;
    }
    if (body.childCount > 0) {
        const double scale = thresholdScaleOf(body.volume / m_input.bake.whole.volume);
        body.threshold = fragmentThreshold(m_input.asset, pathOfId(body.id), body.level).value_or(m_threshold * scale);
    }
    return body;
}

PackFracture PackBuilder::fracture(std::uint32_t index) const {
    const BakedFracture& baked = m_input.bake.fractures[index];
    const std::vector<Bond>& bonds = m_bonds[index];
    const std::vector<double> capacities =
        bondCapacities(m_input.asset, m_input.material.own, m_input.bake, index, bonds);
    const std::vector<ClusterLevel> levels = clusterLevels(m_input.asset, m_input.bake, index, bonds);
    PackFracture fracture{.fragment = baked.parent};
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        fracture.bonds.push_back(
            {.fragments = {baked.first + bonds[k].first, baked.first + bonds[k].second},
             .area = bonds[k].area,
             .centroid = bonds[k].centroid,
             .normal = bonds[k].normal,
             .capacity = std::isfinite(capacities[k]) ? std::optional(capacities[k]) : std::nullopt,
             .clusterLevel = levels.empty() ? 0u : levels[k]});
    }
    return fracture;
}

std::optional<PackBonding> PackBuilder::bonding() const {
    const Asset& asset = m_input.asset;
    const Bake& bake = m_input.bake;
    if (asset.breakAs != BreakAs::Bonded) return std::nullopt;
    PackBonding bonding{.falloffRadius = asset.bonding.radius,
                        .falloff = asset.bonding.falloff,
                        .damageFrom = asset.bonding.damageFrom,
                        .span = asset.bonding.span,
                        .collapseDelay = asset.bonding.collapseDelay,
                        .minimumIsland = asset.bonding.minimumIsland,
                        .bake = damageHash(asset, bake).hex()};
    for (std::uint32_t k = 0; k < bake.fractures.size(); ++k) {
        // A body of which there is one fragment only does not break.
        if (bake.fractures[k].fragments.count() >= 2) bonding.fractures.push_back(fracture(k));
    }
    const bool doesBreak = !bake.fractures.empty() && bake.fractures[0].fragments.count() >= 2;
    if (doesBreak) bonding.anchored = anchoredFragments(asset, bake, 0);
    return bonding;
}

Pack packOf(const PackInput& input, std::span<const PackMeshFile> meshes, const TaskContext& task) {
    const PackBuilder builder(input, task);
    Pack pack = builder.header(meshes);
    pack.whole = builder.whole();
    pack.fragments.resize(builder.fragmentCount());
    forEachIndex(pack.fragments.size(), task.threads,
                 [&](std::size_t k) { pack.fragments[k] = builder.fragment(static_cast<std::uint32_t>(k)); });
    pack.bonding = builder.bonding();
    return pack;
}

}  // namespace rubble
