#include "core/fracture/kinds/BlueNoise.h"

#include "core/base/MessageText.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/layer/OutlineFollowing.h"
#include "core/fracture/sampling/ScatterArea.h"
#include "core/fracture/sampling/SeedGrid.h"
#include "core/fracture/sampling/VoidCells.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kDefaultDistanceFraction = 0.15;  // of the outline's diameter: the minimum distance in a new layer

constexpr std::array kBlueNoiseParameters{
    parameter<&BlueNoise::minimumDistance>({.name = "minimumDistance",
                                            .caption = "Distance",
                                            .hint = "Minimum distance between seeds",
                                            .quantity = Quantity::Length,
                                            .range = kAboveZero,
                                            .sliderRange = {0.005, 2.0, true}}),
    parameter<&BlueNoise::count>({.name = "count",
                                  .caption = "Maximum count",
                                  .hint = "Number of seeds; 0: as many as fit",
                                  .range = {0.0, kMaxSeeds}}),
    parameter<&BlueNoise::domain>(kDomainParameter),
};

/// After this many consecutive misses about a hundredth of the area is free; the void cells find it.
constexpr int kMaxMisses = 100;
/// Void cells are subdivided to this fraction of the minimum distance; smaller gaps are ignored.
constexpr double kMinGapFraction = 1e-3;

/// The largest unit in the last place of coordinates in the box.
double coarsestUlp(const Box2& box) {
    const Vec2 max = glm::max(glm::abs(box.min), glm::abs(box.max));
    return 0x1p-52 * std::max(max.x, max.y);
}

/// Dart throwing until there are enough seeds. The darts do not depend on `wanted`, so that a greater count keeps the
/// earlier seeds.
class DartThrowing {
public:
    DartThrowing(const BlueNoise& noise, const LayerContext& context, const Polygon& domain, std::size_t wanted)
        : m_noise(noise),
          m_context(context),
          m_domain(domain),
          m_wanted(wanted),
          m_random(context.random()),
          m_seeds(boundsOf(domain.outer), noise.minimumDistance) {}

    Status throwAnywhere(const ScatterArea& area) {
        int misses = 0;
        for (std::size_t round = 0; !isDone() && misses < kMaxMisses; ++round) {
            if (m_context.isCancelledAt(round)) return TaskContext::cancelled();
            misses = keep(area.point(m_random)) ? 0 : misses + 1;
        }
        return success();
    }

    Status throwIntoGaps() {
        VoidCells voids(m_domain);
        const double minSide =
            std::max(kMinGapFraction * m_noise.minimumDistance, 4.0 * coarsestUlp(boundsOf(m_domain.outer)));
        while (!isDone() && !voids.isEmpty() && voids.side() > minSide) {
            if (const Status subdivided = voids.subdivide(m_seeds, m_context.task); !subdivided) return subdivided;
            for (std::size_t dart = 0; dart < voids.size() && !isDone(); ++dart) {
                if (m_context.isCancelledAt(dart)) return TaskContext::cancelled();
                if (const std::optional<Vec2> point = voids.dart(m_random)) keep(*point);
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

Diagnostic noRoom(const BlueNoise& noise, const LayerContext& context, std::size_t found, std::size_t wanted) {
    return diagnostic(DiagnosticCode::NoRoom, {.layer = context.layerId},
                      context.name() + " found room for " + std::to_string(found) + " of " + std::to_string(wanted) +
                          " seeds at a distance of " + messageText(noise.minimumDistance) + " m.",
                      static_cast<double>(found));
}

}  // namespace

constinit const LayerKind BlueNoise::kKind{.name = "blueNoise",
                                           .caption = "Blue noise",
                                           .hint = "Random seeds with a minimum distance",
                                           .icon = "layer-blue-noise",
                                           .summary = "{minimumDistance} apart",
                                           .role = LayerRole::Scatters,
                                           .parameters = kBlueNoiseParameters,
                                           .isRandom = true,
                                           .fillsOutline = true};

BlueNoise BlueNoise::defaultsFor(const Box2& bounds) {
    return BlueNoise{.minimumDistance = kDefaultDistanceFraction * bounds.diagonal()};
}

Status BlueNoise::apply(const LayerContext& context, SeedSet& seeds) const {
    const std::size_t room = kMaxSeeds - seeds.size();
    const Polygon filled = ScatterArea::domain(context.scatterOutline(), domain);
    const Result<std::uint32_t> wanted = seedsToAdd(count, filled, context, seeds);
    if (!wanted) return wanted.error();
    const Result<ScatterArea> area = ScatterArea::of(filled);
    if (!area) return area.error();
    // Once no further seed fits, discs with the minimum distance as radius around all seeds cover the area.
    const double minToFill = area->area() / (4.0 * minimumDistance * minimumDistance);
    if (*wanted == 0 && minToFill > static_cast<double>(room)) return tooManySeeds(context);

    DartThrowing darts(*this, context, filled, *wanted == 0 ? room + 1 : *wanted);
    if (const Status done = darts.throwAnywhere(*area); !done) return done;
    if (const Status done = darts.throwIntoGaps(); !done) return done;
    const std::vector<Vec2>& found = darts.seeds();
    if (found.size() > room) return tooManySeeds(context);
    const std::size_t first = seeds.size();
    for (std::uint32_t index = 0; index < found.size(); ++index) {
        seeds.add({context.layerId, index}, found[index], false);
    }
    if (found.size() < *wanted) seeds.diagnostics.push_back(noRoom(*this, context, found.size(), *wanted));
    return followOutline(context, first, domain, seeds, {.minimumDistance = minimumDistance});
}

double BlueNoise::estimatedPieces(double area) const {
    constexpr double kJammedDensity = 0.7;  // seeds within a square of the minimum distance, when no more fit
    const double most = std::max(1.0, kJammedDensity * area / minimumDistance / minimumDistance);
    const bool isAsManyAsFit = count.by == CountBy::Number && count.amount == 0.0;
    return isAsManyAsFit ? most : std::min(most, count.in(area));
}

}  // namespace rubble
