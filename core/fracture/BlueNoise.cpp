#include "core/base/MessageText.h"
#include "core/fracture/FreeSquares.h"
#include "core/fracture/PatternKind.h"
#include "core/fracture/ScatterArea.h"
#include "core/fracture/SeedGrid.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kUsualShare = 0.15;  // of the outline's diameter: how far a new layer keeps its seeds apart

constexpr std::array kParameters{
    parameter<&BlueNoise::minimumDistance>({.name = "minimumDistance",
                                            .caption = "Distance",
                                            .hint = "No two seeds are nearer to each other than this",
                                            .quantity = Quantity::Length,
                                            .range = kAboveZero,
                                            .usual = {0.005, 2.0, true}}),
    parameter<&BlueNoise::count>({.name = "count",
                                  .caption = "At most",
                                  .hint = "How many seeds; 0: as many as find room",
                                  .range = {0.0, kMostSeeds}}),
    parameter<&BlueNoise::domain>(kDomainParameter),
};

/// After this many darts in a row without a hit about a hundredth of the area is free: time to search for it.
constexpr int kMostMisses = 100;
/// Squares are quartered until they are this small against the minimum distance; a gap so small counts as no room.
constexpr double kLeastGap = 1e-3;

/// The width of a unit in the last place anywhere in the box.
double leastStep(const Box2& box) {
    const Vec2 farthest = glm::max(glm::abs(box.min), glm::abs(box.max));
    return 0x1p-52 * std::max(farthest.x, farthest.y);
}

/// Throws darts until enough have hit. The darts never depend on how many are wanted, so that more only go on.
class DartThrower {
public:
    DartThrower(const BlueNoise& noise, const LayerContext& context, const Polygon& domain, std::size_t wanted)
        : m_noise(noise),
          m_context(context),
          m_domain(domain),
          m_wanted(wanted),
          m_random(context.random()),
          m_seeds(boundsOf(domain.outer), noise.minimumDistance) {}

    Status throwAnywhere(const ScatterArea& area) {
        int misses = 0;
        for (std::size_t round = 0; !isDone() && misses < kMostMisses; ++round) {
            if (m_context.isCancelledAt(round)) return TaskContext::cancelled();
            misses = keep(area.point(m_random)) ? 0 : misses + 1;
        }
        return success();
    }

    Status throwIntoGaps() {
        FreeSquares squares(m_domain);
        const double least = std::max(kLeastGap * m_noise.minimumDistance, 4.0 * leastStep(boundsOf(m_domain.outer)));
        while (!isDone() && !squares.isEmpty() && squares.side() > least) {
            if (const Status quartered = squares.quarter(m_seeds, m_context.task); !quartered) return quartered;
            for (std::size_t dart = 0; dart < squares.size() && !isDone(); ++dart) {
                if (m_context.isCancelledAt(dart)) return TaskContext::cancelled();
                if (const std::optional<Vec2> point = squares.dart(m_random)) keep(*point);
            }
        }
        return success();
    }

    const std::vector<Vec2>& seeds() const { return m_seeds.points(); }

private:
    bool isDone() const { return m_seeds.size() >= m_wanted; }
    bool keep(Vec2 point) {
        const bool isFree = m_seeds.isFree(point);
        if (isFree) m_seeds.add(point);
        return isFree;
    }

    const BlueNoise& m_noise;
    const LayerContext& m_context;
    const Polygon& m_domain;
    std::size_t m_wanted;
    Random m_random;
    SeedGrid m_seeds;
};

Report noRoom(const BlueNoise& noise, const LayerContext& context, std::size_t found, std::size_t wanted) {
    return {ReportCode::NoRoom, kNone, context.layer.id, static_cast<double>(found),
            context.name() + " found room for " + std::to_string(found) + " of " + std::to_string(wanted) +
                " seeds at a distance of " + messageText(noise.minimumDistance) + " m."};
}

}  // namespace

constinit const PatternKind BlueNoise::kKind{.name = "blueNoise",
                                             .caption = "Blue noise",
                                             .hint = "Random seeds that keep their distance",
                                             .role = LayerRole::Scatters,
                                             .parameters = kParameters,
                                             .suitedTo = [](const Box2& bounds) -> LayerParameters {
                                                 return BlueNoise{.minimumDistance = kUsualShare * bounds.diagonal()};
                                             }};

Status BlueNoise::apply(const LayerContext& context, SeedSet& seeds) const {
    const std::size_t room = kMostSeeds - seeds.size();
    const Polygon filled = ScatterArea::domain(context.outline, domain);
    const Result<std::uint32_t> wanted = seedsToAdd(count, filled, context, seeds);
    if (!wanted) return wanted.error();
    const Result<ScatterArea> area = ScatterArea::of(filled);
    if (!area) return area.error();
    // However they are placed, discs of the minimum distance around all seeds cover the area once no more find room.
    const double leastToFill = area->area() / (4.0 * minimumDistance * minimumDistance);
    if (*wanted == 0 && leastToFill > static_cast<double>(room)) return tooManySeeds(context);

    DartThrower thrower(*this, context, filled, *wanted == 0 ? room + 1 : *wanted);
    if (const Status thrown = thrower.throwAnywhere(*area); !thrown) return thrown;
    if (const Status thrown = thrower.throwIntoGaps(); !thrown) return thrown;
    const std::vector<Vec2>& found = thrower.seeds();
    if (found.size() > room) return tooManySeeds(context);
    for (std::uint32_t index = 0; index < found.size(); ++index) {
        seeds.add({context.layer.id, index}, found[index], false);
    }
    if (found.size() < *wanted) seeds.reports.push_back(noRoom(*this, context, found.size(), *wanted));
    return success();
}

}  // namespace rubble
