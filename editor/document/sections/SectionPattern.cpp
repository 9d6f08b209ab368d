#include "editor/document/sections/SectionPattern.h"

#include "core/asset/project/AssetShape.h"
#include "core/fracture/planes/SectionPieces.h"
#include "editor/document/EnteredFragment.h"

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

/// The seeds whose cells are cut, in the section's axes.
Seeds seedsIn(const SolidSection& section, const BakedFracture& fracture, std::span<const std::uint32_t> cut) {
    Seeds seeds;
    for (const std::uint32_t seed : cut) {
        const Vec3 position = fracture.seeds.at(seed);
        seeds.positions.push_back(section.plane.inPlane(position));
        seeds.heights.push_back(section.plane.heightOf(position));
        seeds.ids.push_back(fracture.seeds.ids[seed]);
    }
    return seeds;
}

/// The outlines of a section, the largest first; the box of the mesh where there is none.
std::vector<Polygon> outlinesOf(const SolidSection& section, const SolidPartition& solid) {
    std::vector<Polygon> outlines = section.outline;
    std::ranges::stable_sort(outlines, [](const Polygon& a, const Polygon& b) { return area(a) > area(b); });
    if (!outlines.empty()) return outlines;
    Box2 box;
    for (const Vec3& point : solid.points) box.include(section.plane.inPlane(solid.origin + point));
    return {{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, {}}};
}

}  // namespace

std::shared_ptr<const BakedPattern> sectionPattern(const Asset& asset, const Bake& bake, const BakedFracture& fracture,
                                                   const SolidSection& section) {
    const SolidFragments& solid = *fracture.fragments.solid();
    auto pattern = std::make_shared<BakedPattern>();
    std::vector<Polygon> outlines = outlinesOf(section, solid.partition);
    Prism prism{std::move(outlines.front()), 1.0};
    if (fracture.parent != kNone) pattern->parent = bake.fragmentPath(fracture.parent);
    if (pattern->parent.empty()) {
        auto shown = std::make_shared<Asset>(asset);
        shown->shape = std::move(prism);
        pattern->asset = std::move(shown);
    } else {
        pattern->asset = std::make_shared<const Asset>(fragmentAsAsset(asset, pattern->parent, std::move(prism)));
    }
    std::vector<double> volumes(solid.partition.fragmentCount(), 0.0);  // of those that a gap leaves
    for (std::uint32_t k = 0; k < solid.count(); ++k) volumes[solid.numberInPartition(k)] = solid.masses[k].volume;
    SectionPieces pieces = sectionPieces(section, solid.partition, !fracture.seeds.ids.empty());
    pattern->seeds = seedsIn(section, fracture, pieces.seeds);
    pattern->partition = std::move(pieces.partition);
    for (const SolidSection::Part& part : section.parts)
        pattern->volumes.insert(pattern->volumes.end(), part.polygons.size(), volumes[part.fragment]);
    pattern->otherOutlines.assign(std::make_move_iterator(outlines.begin() + 1),
                                  std::make_move_iterator(outlines.end()));
    pattern->section = section.plane;
    return pattern;
}

}  // namespace rubble
