#include "core/fracture/kinds/BlueNoise.h"

#include "core/base/MessageText.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/layer/OutlineFollowing.h"
#include "core/fracture/sampling/ScatterArea.h"
#include "core/fracture/sampling/SeedGrid.h"
#include "core/fracture/sampling/SolidVoidCells.h"
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
constexpr double kMinGapFractionInSolid = 1.0 / 32.0;

/// The largest unit in the last place of coordinates in the box.
double coarsestUlp(const Box2& box) {
    const Vec2 max = glm::max(glm::abs(box.min), glm::abs(box.max));
    return 0x1p-52 * std::max(max.x, max.y);
}

/// The same of a box in space.
double coarsestUlp(const Box3& box) {
    const Vec3 max = glm::max(glm::abs(box.min), glm::abs(box.max));
    return 0x1p-52 * std::max({max.x, max.y, max.z});
}

/// Dart throwing until there are enough seeds, in the plane or in space. The darts do not depend on `wanted`, so that a
/// greater count keeps the earlier seeds.
template <class Grid>
class DartThrowing {
public:
    DartThrowing(const EvaluatedLayer& layer, Grid grid, std::size_t wanted)
        : m_layer(layer), m_wanted(wanted), m_random(layer.random()), m_seeds(std::move(grid)) {}

    template <class Area>
    Status throwAnywhere(const Area& area) {
        int misses = 0;
        for (std::size_t round = 0; !isDone() && misses < kMaxMisses; ++round) {
            if (m_layer.isCancelledAt(round)) return TaskContext::cancelled();
            misses = keep(area.point(m_random)) ? 0 : misses + 1;
        }
        return success();
    }

    /// Throws into void cells, which are subdivided down to a side.
    template <class Voids>
    Status throwIntoGaps(Voids voids, double minSide) {
        while (!isDone() && !voids.isEmpty() && voids.side() > minSide) {
            if (const Status subdivided = voids.subdivide(m_seeds, m_layer.task); !subdivided) return subdivided;
            for (std::size_t dart = 0; dart < voids.size() && !isDone(); ++dart) {
                if (m_layer.isCancelledAt(dart)) return TaskContext::cancelled();
                if (const auto point = voids.dart(m_random)) keep(*point);
            }
        }
        return success();
    }

    /// Adds the seeds to those of the layers before.
    ///
    /// Errors: Limit if there are too many.
    Status addTo(SeedSet& seeds) const {
        if (m_seeds.size() > kMaxSeeds - seeds.size()) return tooManySeeds(m_layer);
        for (std::uint32_t index = 0; index < m_seeds.size(); ++index)
            seeds.add({m_layer.layerId, index}, m_seeds.points()[index], false);
        return success();
    }
    std::size_t size() const { return m_seeds.size(); }

private:
    bool isDone() const { return m_seeds.size() >= m_wanted; }
    bool keep(typename Grid::Point point) {
        const bool isFree = m_seeds.isFree(point);
        if (isFree) m_seeds.add(point);
        return isFree;
    }

    const EvaluatedLayer& m_layer;
    std::size_t m_wanted;
    Random m_random;
    Grid m_seeds;
};

Diagnostic noRoom(const BlueNoise& noise, const EvaluatedLayer& context, std::size_t found, std::size_t wanted) {
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

BlueNoise BlueNoise::defaultsFor(const Box3& bounds) {
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

    const Box2 box = boundsOf(filled.outer);
    DartThrowing darts(context, SeedGrid(box, minimumDistance), *wanted == 0 ? room + 1 : *wanted);
    if (const Status done = darts.throwAnywhere(*area); !done) return done;
    const double minSide = std::max(kMinGapFraction * minimumDistance, 4.0 * coarsestUlp(box));
    if (const Status done = darts.throwIntoGaps(VoidCells(filled), minSide); !done) return done;
    const std::size_t first = seeds.size();
    if (const Status added = darts.addTo(seeds); !added) return added;
    if (darts.size() < *wanted) seeds.diagnostics.push_back(noRoom(*this, context, darts.size(), *wanted));
    return followOutline(context, first, domain, seeds, {.minimumDistance = minimumDistance});
}

Status BlueNoise::applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const {
    const std::size_t room = kMaxSeeds - seeds.size();
    const SolidScatterDomain filled{context.domain, domain};
    const Result<std::uint32_t> wanted = seedsToAdd(count, filled.volume(), context, seeds);
    if (!wanted) return wanted.error();
    // Once no further seed fits, balls with the minimum distance as radius around all seeds cover the volume.
    const double minToFill = filled.volume() / (5.0 * minimumDistance * minimumDistance * minimumDistance);
    if (*wanted == 0 && minToFill > static_cast<double>(room)) return tooManySeeds(context);

    const Box3& box = context.domain.bounds();
    DartThrowing darts(context, SolidSeedGrid(box, minimumDistance), *wanted == 0 ? room + 1 : *wanted);
    if (const Status done = darts.throwAnywhere(filled); !done) return done;
    // Where spheres around seeds meet, no cell is covered by one of them; in thin shapes, few cells are there.
    const double thickness = 2.0 * filled.volume() / context.domain.surface().area();
    const double minSide = std::max({std::min(kMinGapFractionInSolid * minimumDistance, thickness),
                                     kMinGapFraction * minimumDistance, 4.0 * coarsestUlp(box)});
    if (const Status done = darts.throwIntoGaps(SolidVoidCells(filled), minSide); !done) return done;
    if (const Status added = darts.addTo(seeds); !added) return added;
    if (darts.size() < *wanted) seeds.diagnostics.push_back(noRoom(*this, context, darts.size(), *wanted));
    return success();
}

double BlueNoise::estimatedPieces(double area) const {
    constexpr double kJammedDensity = 0.7;  // seeds within a square of the minimum distance, when no more fit
    const double most = std::max(1.0, kJammedDensity * area / minimumDistance / minimumDistance);
    const bool isAsManyAsFit = count.by == CountBy::Number && count.amount == 0.0;
    return isAsManyAsFit ? most : std::min(most, count.in(area));
}

double BlueNoise::estimatedPiecesIn(const SolidDomain& solid) const {
    constexpr double kJammedDensity = 0.7;  // seeds within a cube of the minimum distance, when no more fit
    // Seeds at the surface keep others from half of the distance outside.
    const double volume = SolidScatterDomain{solid, domain}.volume(), distance = minimumDistance;
    const double room = volume + solid.surface().area() * distance / 2.0;
    const double most = std::max(1.0, kJammedDensity * room / distance / distance / distance);
    const bool isAsManyAsFit = count.by == CountBy::Number && count.amount == 0.0;
    return isAsManyAsFit ? most : std::min(most, count.in(volume, SeedSpace::Solid));
}

}  // namespace rubble
