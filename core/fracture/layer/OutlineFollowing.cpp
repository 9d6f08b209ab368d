#include "core/fracture/layer/OutlineFollowing.h"

#include "core/fracture/sampling/PairIndex.h"
#include "core/fracture/sampling/ScatterArea.h"
#include "core/fracture/sampling/SeedGrid.h"
#include "core/geometry/polygon/ContainmentIndex.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rubble {
namespace {

constexpr int kDarts = 8;                            // per tile, where seeds keep a minimum distance
constexpr double kMaxTile = kMaxPairNumber / 2 - 1;  // from the first tile, in each direction

bool isMovedByHand(const LayerContext& context, std::uint32_t index) {
    return std::ranges::binary_search(context.overrides, index, {}, &SeedOverride::index);
}

/// The mean of the inverse density at seeds that follow it, which is the inverse of its mean over the area.
double meanInverse(const SeedDensity& density, std::span<const Vec2> positions) {
    double sum = 0.0, count = 0.0;
    for (const Vec2 position : positions) {
        const double at = density(position);
        if (at > 0.0) sum += 1.0 / at, ++count;
    }
    return count > 0.0 ? sum / count : 0.0;
}

struct Tile {
    std::uint32_t index;
    Vec2 corner;
};

/// The square tiles that overlap a box, ascending by index.
Result<std::vector<Tile>> tilesOver(const Box2& box, Vec2 origin, double side, const LayerContext& context,
                                    std::size_t room) {
    const Vec2 from = glm::floor((box.min - origin) / side), to = glm::floor((box.max - origin) / side);
    const Vec2 farthest = glm::max(glm::abs(from), glm::abs(to));
    const Vec2 count = to - from + Vec2(1.0);
    if (!(std::max(farthest.x, farthest.y) <= kMaxTile) || !(count.x * count.y <= static_cast<double>(room)))
        return tooManySeeds(context);
    std::vector<Tile> tiles;
    for (double row = from.y; row <= to.y; ++row) {
        for (double column = from.x; column <= to.x; ++column) {
            const std::uint32_t index = pairIndex(zigzag(static_cast<int>(column)), zigzag(static_cast<int>(row)));
            tiles.push_back({index, origin + side * Vec2(column, row)});
        }
    }
    std::ranges::sort(tiles, {}, &Tile::index);
    return tiles;
}

}  // namespace

Status followOutline(const LayerContext& context, std::size_t first, ScatterDomain domain, SeedSet& seeds,
                     const AddedSeeds& added) {
    const std::size_t count = seeds.size() - first;
    if (!context.scatteredIn || count == 0) return success();
    const Polygon from = ScatterArea::domain(*context.scatteredIn, domain),
                  to = ScatterArea::domain(context.outline, domain);
    const ContainmentIndex before(from), now(to);
    const double inverse = added.density ? meanInverse(added.density, std::span(seeds.positions).subspan(first)) : 0.0;
    std::optional<SeedGrid> taken;
    if (added.minimumDistance > 0.0) {
        taken.emplace(boundsOf(to.outer), added.minimumDistance);
        for (std::size_t seed = first; seed < seeds.size(); ++seed) taken->add(seeds.positions[seed]);
    }
    std::vector<bool> isRemoved(count);
    for (std::size_t k = 0; k < count; ++k) {
        isRemoved[k] = now.of(seeds.positions[first + k]) == Containment::Outside &&
                       !isMovedByHand(context, seeds.ids[first + k].index);
    }
    seeds.remove(first, isRemoved);

    const double side = std::sqrt(area(from) / static_cast<double>(count));
    const Result<std::vector<Tile>> tiles =
        tilesOver(boundsOf(to.outer), boundsOf(from.outer).min, side, context, kMaxSeeds - seeds.size());
    if (!tiles) return tiles.error();
    std::size_t round = 0;
    for (const Tile& tile : *tiles) {
        if (context.isCancelledAt(round++)) return TaskContext::cancelled();
        const std::uint32_t index = kFirstAddedSeed + tile.index;
        Random random = context.randomOf(index);
        for (int dart = 0; dart < (taken ? kDarts : 1); ++dart) {
            const double x = random.unit(), y = random.unit();
            const Vec2 point = tile.corner + side * Vec2(x, y);
            if (now.of(point) != Containment::Inside || before.of(point) != Containment::Outside) continue;
            if (added.density && random.unit() >= added.density(point) * inverse) continue;
            if (taken && !taken->isFree(point)) continue;
            if (taken) taken->add(point);
            seeds.add({context.layerId, index}, point, false);
            break;
        }
    }
    return success();
}

}  // namespace rubble
