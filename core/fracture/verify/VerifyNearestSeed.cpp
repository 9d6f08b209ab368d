#include "core/fracture/verify/VerifyNearestSeed.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rubble {
namespace {

constexpr double kDistanceTolerance = 1e-9;    // of the pieces' diagonal
constexpr double kDistanceRounding = 0x1p-50;  // of a distance: the rounding error of a difference of two

double distanceBetween(Vec2 a, Vec2 b) { return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y)); }

/// An implicit k-d tree: the median divides a range, by x and y in turn.
class SeedTree {
public:
    explicit SeedTree(std::vector<Vec2> seeds) : m_seeds(std::move(seeds)) { sort(0, m_seeds.size(), 0); }

    /// Whether some seed is nearer to the point than `distance`.
    bool isNearerThan(Vec2 point, double distance) const { return isNearerIn(0, m_seeds.size(), 0, point, distance); }

private:
    void sort(std::size_t begin, std::size_t end, int axis) {
        if (end - begin < 2) return;
        const auto at = [this](std::size_t index) { return m_seeds.begin() + static_cast<std::ptrdiff_t>(index); };
        const std::size_t middle = begin + (end - begin) / 2;
        std::nth_element(at(begin), at(middle), at(end), [axis](Vec2 a, Vec2 b) { return a[axis] < b[axis]; });
        sort(begin, middle, 1 - axis);
        sort(middle + 1, end, 1 - axis);
    }

    bool isNearerIn(std::size_t begin, std::size_t end, int axis, Vec2 point, double distance) const {
        if (begin == end) return false;
        const std::size_t middle = begin + (end - begin) / 2;
        if (distanceBetween(m_seeds[middle], point) < distance) return true;
        const double beyond = point[axis] - m_seeds[middle][axis];
        if (beyond < distance && isNearerIn(begin, middle, 1 - axis, point, distance)) return true;
        return -beyond < distance && isNearerIn(middle + 1, end, 1 - axis, point, distance);
    }

    std::vector<Vec2> m_seeds;
};

Box2 boundsOfCorners(const Partition& partition) {
    Box2 box;
    for (const std::uint32_t corner : partition.corners) box.include(partition.points[corner]);
    return box;
}

/// Whether no seed is nearer to the piece's corners than its own, up to `tolerance`. Relative to the partition's
/// origin.
bool isNearestToOwn(const Partition& partition, std::uint32_t piece, Vec2 own, const SeedTree& seeds,
                    double tolerance) {
    const std::uint32_t begin = partition.cornersOfRing[partition.ringsOfPiece[piece]];
    const std::uint32_t end = partition.cornersOfRing[partition.ringsOfPiece[piece + 1]];
    for (std::uint32_t corner = begin; corner < end; ++corner) {
        const Vec2 point = partition.points[partition.corners[corner]];
        const double distance = distanceBetween(own, point);
        if (seeds.isNearerThan(point, distance - tolerance - kDistanceRounding * distance)) return false;
    }
    return true;
}

}  // namespace

std::optional<std::string> verifyNearestSeed(const Partition& partition, std::span<const Vec2> seeds) {
    std::vector<Vec2> positions(seeds.begin(), seeds.end());
    for (Vec2& position : positions) position -= partition.origin;
    const SeedTree tree(positions);
    const double tolerance = kDistanceTolerance * boundsOfCorners(partition).diagonal();
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        const std::uint32_t seed = partition.seedOfPiece[piece];
        if (seed == kNone || isNearestToOwn(partition, piece, positions[seed], tree, tolerance)) continue;
        return "Piece " + std::to_string(piece) + " has a corner that is nearer to another seed than to seed " +
               std::to_string(seed) + ".";
    }
    return std::nullopt;
}

}  // namespace rubble
