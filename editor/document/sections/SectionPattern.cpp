#include "editor/document/sections/SectionPattern.h"

#include "core/asset/project/AssetShape.h"
#include "editor/document/EnteredFragment.h"

#include <algorithm>
#include <bit>
#include <map>
#include <unordered_map>
#include <utility>

namespace rubble {

namespace {

/// Points by their bits, which neighbours share.
struct PointBits {
    std::uint64_t x = 0, y = 0;
    explicit PointBits(Vec2 point)
        : x(std::bit_cast<std::uint64_t>(point.x)), y(std::bit_cast<std::uint64_t>(point.y)) {}
    bool operator==(const PointBits&) const = default;
};
struct PointHash {
    std::size_t operator()(const PointBits& bits) const { return bits.x * 0x9E3779B97F4A7C15u ^ (bits.y >> 3); }
};

/// Makes a partition of the polygons of a section.
class SectionPartition {
public:
    SectionPartition(const SolidSection& section, const SolidPartition& solid, std::span<const std::uint32_t> seedOf)
        : m_solid(solid), m_seedOf(seedOf) {
        m_partition.ringsOfPiece.push_back(0);
        m_partition.cornersOfRing.push_back(0);
        for (const SolidSection::Part& part : section.parts) {
            for (const Polygon& polygon : part.polygons) addPiece(polygon, part.fragment);
        }
        findNeighbours();
    }

    Partition result(std::size_t seeds) && {
        m_partition.pieceOfSeed.assign(seeds, kNone);
        for (std::uint32_t piece = m_partition.pieceCount(); piece-- > 0;) {
            const std::uint32_t seed = m_partition.seedOfPiece[piece];
            if (seed != kNone) m_partition.pieceOfSeed[seed] = piece;
        }
        return std::move(m_partition);
    }

private:
    void addPiece(const Polygon& polygon, std::uint32_t fragment) {
        m_partition.seedOfPiece.push_back(m_seedOf.empty() ? kNone : m_seedOf[fragment]);
        m_partition.partOfCell.push_back(m_solid.partOfFragment[fragment]);
        addRing(polygon.outer);
        for (const Ring& hole : polygon.holes) addRing(hole);
        m_partition.ringsOfPiece.push_back(static_cast<std::uint32_t>(m_partition.cornersOfRing.size() - 1));
    }

    void addRing(const Ring& ring) {
        for (const Vec2 corner : ring) {
            const auto [at, isNew] =
                m_points.try_emplace(PointBits(corner), static_cast<std::uint32_t>(m_partition.points.size()));
            if (isNew) m_partition.points.push_back(corner);
            m_partition.corners.push_back(at->second);
        }
        m_partition.cornersOfRing.push_back(static_cast<std::uint32_t>(m_partition.corners.size()));
    }

    void findNeighbours() {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> pieces;  // of directed edges
        m_partition.neighbours.assign(m_partition.corners.size(), kNone);
        for (std::uint32_t piece = 0; piece < m_partition.pieceCount(); ++piece) {
            forEachEdge(m_partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t) {
                pieces[{from, to}] = piece;
            });
        }
        std::size_t corner = 0;
        for (std::uint32_t piece = 0; piece < m_partition.pieceCount(); ++piece) {
            forEachEdge(m_partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t) {
                const auto behind = pieces.find({to, from});
                if (behind != pieces.end()) m_partition.neighbours[corner] = behind->second;
                ++corner;
            });
        }
    }

    const SolidPartition& m_solid;
    const std::span<const std::uint32_t> m_seedOf;  // in the section, of each fragment
    std::unordered_map<PointBits, std::uint32_t, PointHash> m_points;
    Partition m_partition;
};

/// The seeds of the fragments of a section, in its axes, ascending; sets the seed of each fragment.
Seeds seedsIn(const SolidSection& section, const BakedFracture& fracture, std::vector<std::uint32_t>& seedOf) {
    const SolidPartition& solid = fracture.fragments.solid()->partition;
    Seeds seeds;
    if (fracture.seeds.ids.empty()) return seeds;
    seedOf.assign(solid.fragmentCount(), kNone);
    std::uint32_t last = kNone;
    for (const SolidSection::Part& part : section.parts) {
        const std::uint32_t seed = solid.seedOfFragment[part.fragment];
        if (seed != last) {
            const Vec3 position = fracture.seeds.at(seed);
            seeds.positions.push_back(section.plane.inPlane(position));
            seeds.heights.push_back(section.plane.heightOf(position));
            seeds.ids.push_back(fracture.seeds.ids[seed]);
            last = seed;
        }
        seedOf[part.fragment] = static_cast<std::uint32_t>(seeds.ids.size() - 1);
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
    std::vector<std::uint32_t> seedOf;
    pattern->seeds = seedsIn(section, fracture, seedOf);
    pattern->partition = SectionPartition(section, solid.partition, seedOf).result(pattern->seeds.positions.size());
    for (const SolidSection::Part& part : section.parts)
        pattern->volumes.insert(pattern->volumes.end(), part.polygons.size(), volumes[part.fragment]);
    pattern->otherOutlines.assign(std::make_move_iterator(outlines.begin() + 1),
                                  std::make_move_iterator(outlines.end()));
    pattern->section = section.plane;
    return pattern;
}

}  // namespace rubble
