#include "core/fracture/planes/SectionPieces.h"

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

/// Makes a partition of polygons that share the corners of their common edges.
class PieceBuilder {
public:
    PieceBuilder() {
        m_partition.ringsOfPiece.push_back(0);
        m_partition.cornersOfRing.push_back(0);
    }

    void add(const Polygon& polygon, std::uint32_t seed, std::uint32_t part) {
        m_partition.seedOfPiece.push_back(seed);
        m_partition.partOfCell.push_back(part);
        addRing(polygon.outer);
        for (const Ring& hole : polygon.holes) addRing(hole);
        m_partition.ringsOfPiece.push_back(static_cast<std::uint32_t>(m_partition.cornersOfRing.size() - 1));
    }

    Partition result(std::size_t seeds) && {
        findNeighbours();
        m_partition.pieceOfSeed.assign(seeds, kNone);
        for (std::uint32_t piece = m_partition.pieceCount(); piece-- > 0;) {
            const std::uint32_t seed = m_partition.seedOfPiece[piece];
            if (seed != kNone) m_partition.pieceOfSeed[seed] = piece;
        }
        return std::move(m_partition);
    }

private:
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

    std::unordered_map<PointBits, std::uint32_t, PointHash> m_points;
    Partition m_partition;
};

}  // namespace

SectionPieces sectionPieces(const SolidSection& section, const SolidPartition& partition, bool hasSeeds) {
    SectionPieces pieces;
    PieceBuilder builder;
    for (const SolidSection::Part& part : section.parts) {
        std::uint32_t seed = kNone;
        if (hasSeeds) {
            const std::uint32_t ofSolid = partition.seedOfFragment[part.fragment];
            if (pieces.seeds.empty() || pieces.seeds.back() != ofSolid) pieces.seeds.push_back(ofSolid);
            seed = static_cast<std::uint32_t>(pieces.seeds.size() - 1);
        }
        for (const Polygon& polygon : part.polygons)
            builder.add(polygon, seed, partition.partOfFragment[part.fragment]);
    }
    pieces.partition = std::move(builder).result(pieces.seeds.size());
    return pieces;
}

}  // namespace rubble
