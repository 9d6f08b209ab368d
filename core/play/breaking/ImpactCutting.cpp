#include "core/play/breaking/ImpactCutting.h"

#include "core/base/Assert.h"
#include "core/base/Random.h"
#include "core/fracture/sampling/PointNear.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {
namespace {

// Seeds near the impact keep a distance, so that fragments are not needles: more slender ones do not occur in brittle
// plates, spin faster than a step resolves, and all touch each other within the simulation's contact distance.
constexpr double kMaxSlenderness = 20.0;  // the asset's depth in distances
constexpr double kMinDistance = 2e-3;     // m: rounding decides how thinner fragments move
constexpr double kMinOfMean = 0.2;        // of the mean distance of all seeds, in a mesh, which has no depth
constexpr double kMeanDistance = 0.5;     // of the mean distance of all seeds at most: so many always have room
// Hulls of fragments of meshes take most of the time of a cut, which is made within a step: half as many do.
constexpr HullLimits kCutHulls{.splits = {.maxRatio = 1.2, .maxParts = 4, .candidates = 1}};
constexpr int kAttemptsPerRadius = 10;  // until the radius is widened
constexpr double kWidening = 1.1;
constexpr int kMaxWidenings = 200;  // from the smallest falloff radius to the largest outline

/// The mean distance of seeds of which each has a part of an area or a volume, m.
double meanDistance(const Asset& asset) {
    const double count = asset.cutAtImpact->fragments;
    if (const ClosedMesh* mesh = asset.mesh()) return std::cbrt(mesh->mass.volume / count);
    return std::sqrt(area(asset.prism().outline) / count);
}

/// The least distance of the seeds near the impact, m.
double leastDistance(const Asset& asset) {
    const double mean = meanDistance(asset);
    const double slenderest = asset.isPrism() ? asset.prism().depth / kMaxSlenderness : kMinOfMean * mean;
    return std::min(std::max(slenderest, kMinDistance), kMeanDistance * mean);
}

/// Places seeds whose density falls with the distance from a point, see pointNear(), and which keep a distance from
/// each other. `Area`: Polygon or SolidDomain; `Point`: Vec2 or Vec3.
template <class Area, class Point>
class DistantSeeds {
public:
    DistantSeeds(const Area& area, Point point, const Asset& asset, Random& random)
        : m_area(area),
          m_point(point),
          m_radius(asset.cutAtImpact->falloffRadius),
          m_distance(leastDistance(asset)),
          m_random(random) {}

    /// Adds a seed, within the falloff radius while there is room, else as near as there is. Not if the area is
    /// elsewhere.
    void add() {
        for (int widening = 0; widening < kMaxWidenings; ++widening) {
            for (int attempt = 0; attempt < kAttemptsPerRadius; ++attempt) {
                const std::optional<Point> position = pointNear(m_area, m_point, m_radius, m_random);
                if (!position) return;
                if (!isFree(*position)) continue;
                m_seeds.push_back(*position);
                return;
            }
            m_radius *= kWidening;
        }
    }
    const std::vector<Point>& seeds() const { return m_seeds; }

private:
    bool isFree(Point position) const {
        const auto isApart = [&](const Point& seed) {
            const Point offset = seed - position;
            return glm::dot(offset, offset) >= m_distance * m_distance;
        };
        return std::ranges::all_of(m_seeds, isApart);
    }

    const Area& m_area;
    Point m_point;
    double m_radius;    // m
    double m_distance;  // m
    Random& m_random;
    std::vector<Point> m_seeds;
};

/// Half of the seeds near a point.
template <class Area, class Point>
std::vector<Point> distantSeeds(const Area& area, Point point, const Asset& asset, Random& random) {
    DistantSeeds<Area, Point> near(area, point, asset, random);
    for (std::uint32_t k = 0; k < asset.cutAtImpact->fragments / 2; ++k) near.add();
    return near.seeds();
}

/// The same, as placed seeds.
Result<PlacedSeeds> seedsNear(const Asset& asset, Vec3 point, Random& random) {
    PlacedSeeds placed;
    const auto place = [&](Vec2 position, double height) {
        placed.seeds.push_back({static_cast<std::uint32_t>(placed.seeds.size()), position, height});
    };
    if (asset.isPrism()) {
        for (const Vec2 seed : distantSeeds(asset.prism().outline, Vec2(point), asset, random)) place(seed, 0.0);
        return placed;
    }
    const Result<SolidDomain> domain = SolidDomain::of(asset.mesh()->mesh);
    if (!domain) return domain.error();
    for (const Vec3 seed : distantSeeds(*domain, point, asset, random)) place(Vec2(seed), seed.z);
    return placed;
}

}  // namespace

Result<std::shared_ptr<const PlayAsset>> cutAtImpact(const Asset& asset, Vec3 point, std::uint64_t number,
                                                     const PlayAsset* uncut) {
    RUBBLE_ASSERT(asset.cutAtImpact.has_value());
    const std::uint64_t randomSeed = mixSeeds(asset.id, number);
    Random random(randomSeed);
    const std::uint32_t fragments = asset.cutAtImpact->fragments;
    Asset cut = asset;
    cut.fragmentLevels.clear();  // this and the next two: they refer to the pattern's fragments
    cut.fragmentThresholds.clear();
    cut.edits.clear();
    Result<PlacedSeeds> near = seedsNear(asset, point, random);
    if (!near) return near.error();
    const auto others = static_cast<std::uint32_t>(fragments - near->seeds.size());
    cut.pattern.layers = {{.id = 1, .randomSeed = randomSeed, .parameters = std::move(*near)},
                          {.id = 2, .randomSeed = randomSeed, .parameters = UniformScatter{.count = others}}};
    Result<Bake> baked = bake(cut, {}, {.hulls = kCutHulls, .whole = uncut ? uncut->bake.get() : nullptr});
    if (!baked) return baked.error();
    return playAsset(cut, std::make_shared<const Bake>(std::move(*baked)), {}, FindContacts::OnBreak,
                     uncut ? uncut->whole.shape : nullptr);
}

}  // namespace rubble
