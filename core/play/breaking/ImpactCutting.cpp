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
constexpr double kMeanDistance = 0.5;     // of the mean distance of all seeds at most: so many always have room
constexpr int kAttemptsPerRadius = 10;    // until the radius is widened
constexpr double kWidening = 1.1;
constexpr int kMaxWidenings = 200;  // from the smallest falloff radius to the largest outline

/// The least distance of the seeds near the impact, m.
double leastDistance(const Asset& asset) {
    const double areaOfFragment = area(asset.prism().outline) / asset.cutAtImpact->fragments;
    return std::min(std::max(asset.prism().depth / kMaxSlenderness, kMinDistance),
                    kMeanDistance * std::sqrt(areaOfFragment));
}

/// Places seeds whose density falls with the distance from a point, see pointNear(), and which keep a distance from
/// each other.
class DistantSeeds {
public:
    DistantSeeds(const Asset& asset, Vec2 point, Random& random)
        : m_outline(asset.prism().outline),
          m_point(point),
          m_radius(asset.cutAtImpact->falloffRadius),
          m_distance(leastDistance(asset)),
          m_random(random) {}

    /// Adds a seed, within the falloff radius while there is room, else as near as there is. Not if the outline is
    /// elsewhere.
    void add() {
        for (int widening = 0; widening < kMaxWidenings; ++widening) {
            for (int attempt = 0; attempt < kAttemptsPerRadius; ++attempt) {
                const std::optional<Vec2> position = pointNear(m_outline, m_point, m_radius, m_random);
                if (!position) return;
                if (!isFree(*position)) continue;
                m_seeds.push_back({static_cast<std::uint32_t>(m_seeds.size()), *position});
                return;
            }
            m_radius *= kWidening;
        }
    }
    std::vector<PlacedSeeds::Seed> take() { return std::move(m_seeds); }

private:
    bool isFree(Vec2 position) const {
        const auto isApart = [&](const PlacedSeeds::Seed& seed) {
            const Vec2 offset = seed.position - position;
            return glm::dot(offset, offset) >= m_distance * m_distance;
        };
        return std::ranges::all_of(m_seeds, isApart);
    }

    const Polygon& m_outline;
    Vec2 m_point;
    double m_radius;    // m
    double m_distance;  // m
    Random& m_random;
    std::vector<PlacedSeeds::Seed> m_seeds;
};

}  // namespace

Result<std::shared_ptr<const PlayAsset>> cutAtImpact(const Asset& asset, Vec2 point, std::uint64_t number) {
    RUBBLE_ASSERT(asset.cutAtImpact.has_value());
    const std::uint64_t randomSeed = mixSeeds(asset.id, number);
    Random random(randomSeed);
    const std::uint32_t fragments = asset.cutAtImpact->fragments;
    Asset cut = asset;
    cut.fragmentLevels.clear();  // this and the next two: they refer to the pattern's fragments
    cut.fragmentThresholds.clear();
    cut.edits.clear();
    DistantSeeds seeds(asset, point, random);
    for (std::uint32_t k = 0; k < fragments / 2; ++k) seeds.add();
    PlacedSeeds near{seeds.take()};
    const auto others = static_cast<std::uint32_t>(fragments - near.seeds.size());
    cut.pattern.layers = {{.id = 1, .randomSeed = randomSeed, .parameters = std::move(near)},
                          {.id = 2, .randomSeed = randomSeed, .parameters = UniformScatter{.count = others}}};
    Result<Bake> baked = bake(cut);
    if (!baked) return baked.error();
    return playAsset(cut, std::make_shared<const Bake>(std::move(*baked)), {}, FindContacts::OnBreak);
}

}  // namespace rubble
