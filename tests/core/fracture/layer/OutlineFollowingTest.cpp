#include "core/fracture/layer/OutlineFollowing.h"

#include "core/fracture/pattern/Pattern.h"
#include "core/fracture/pattern/PatternKind.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>
#include <map>

using namespace rubble;

namespace {

using Positions = std::map<SeedId, Vec2>;

Positions seedsIn(const LayerParameters& parameters, const Polygon& outline, std::optional<Polygon> scatteredIn) {
    const Pattern pattern{
        {{.id = 3, .randomSeed = 7, .parameters = parameters, .scatteredIn = std::move(scatteredIn)}}};
    const Result<Seeds> seeds = seedsOf(pattern, outline);
    if (!seeds) qFatal("%s", seeds.error().message.c_str());
    Positions positions;
    for (std::size_t k = 0; k < seeds->ids.size(); ++k) positions.emplace(seeds->ids[k], seeds->positions[k]);
    return positions;
}

/// A square of side 4.
Polygon wall() { return {rectangle({0.0, 0.0}, {4.0, 4.0}), {}}; }

/// The kinds that fill an outline, with parameters for a square of side 4.
std::vector<LayerParameters> fillingKinds() {
    auto image = std::make_shared<GreyImage>(GreyImage{.width = 2, .height = 1, .bits = 8, .grey = {0, 128}});
    return {UniformScatter{.count = 60},
            UniformScatter{.count = {CountBy::Density, 5.0}},
            BlueNoise{.minimumDistance = 0.5},
            Clusters{.clusters = 6, .seedsPerCluster = 8, .radius = 0.6},
            ImpactScatter{.centre = {1.0, 1.0}, .count = 60, .radius = 0.8, .falloff = 2.0},
            DensityImage{.count = 60, .image = image},
            JitteredGrid{.columns = 6, .rows = 5, .jitter = 0.8},
            JitteredGrid{.cells = GridCells::Size, .cellWidth = 0.7, .cellHeight = 0.6},
            HexagonalLattice{.spacing = 0.6}};
}

QString nameOf(const LayerParameters& parameters) { return QString(kindOf(parameters).caption); }

}  // namespace

class OutlineFollowingTest : public QObject {
    Q_OBJECT
private slots:
    void seedsAwayFromAMovedCornerStay() {
        for (const Vec2 corner : {Vec2{3.0, 3.0}, Vec2{5.0, 5.5}}) {
            Polygon moved = wall();
            moved.outer[2] = corner;
            for (const LayerParameters& kind : fillingKinds()) {
                const Positions before = seedsIn(kind, wall(), {}), after = seedsIn(kind, moved, wall());
                std::size_t kept = 0;
                for (const auto& [id, position] : before) {
                    const bool isInside = containment(moved, position) == Containment::Inside;
                    QVERIFY2(after.contains(id) == isInside, qPrintable(nameOf(kind)));
                    QVERIFY(!isInside || after.at(id) == position);
                    kept += isInside;
                }
                QVERIFY(kept > before.size() / 2);
                for (const auto& [id, position] : after) QVERIFY(containment(moved, position) == Containment::Inside);
            }
        }
    }
    void grownOutlineGetsSeedsOfTheSameDensity() {
        const Polygon grown{rectangle({0.0, 0.0}, {8.0, 4.0}), {}};
        for (const LayerParameters& kind : fillingKinds()) {
            if (std::holds_alternative<ImpactScatter>(kind) || std::holds_alternative<DensityImage>(kind)) continue;
            const auto before = static_cast<double>(seedsIn(kind, wall(), {}).size());
            const auto after = static_cast<double>(seedsIn(kind, grown, wall()).size());
            QVERIFY2(after > 1.6 * before && after < 2.4 * before,
                     qPrintable(QString("%1: %2, %3").arg(nameOf(kind)).arg(before).arg(after)));
        }
    }
    void addedSeedsStayWhenTheOutlineGrowsFurther() {
        const Polygon grown{rectangle({0.0, 0.0}, {8.0, 4.0}), {}}, more{rectangle({-3.0, 0.0}, {8.0, 6.0}), {}};
        for (const LayerParameters& kind : fillingKinds()) {
            const Positions before = seedsIn(kind, grown, wall()), after = seedsIn(kind, more, wall());
            for (const auto& [id, position] : before) {
                if (std::holds_alternative<BlueNoise>(kind) && position.x > 4.0 && position.y > 3.0) continue;
                QVERIFY2(after.contains(id) && after.at(id) == position, qPrintable(nameOf(kind)));
            }
        }
    }
    void addedSeedsKeepTheMinimumDistance() {
        const Polygon grown{rectangle({0.0, 0.0}, {8.0, 4.0}), {}};
        const Positions seeds = seedsIn(BlueNoise{.minimumDistance = 0.5}, grown, wall());
        for (const auto& [id, position] : seeds) {
            for (const auto& [other, place] : seeds) QVERIFY(id == other || glm::distance(position, place) >= 0.5);
        }
    }
    void seedsFartherFromAnImpactAreSparser() {
        const Polygon grown{rectangle({0.0, 0.0}, {8.0, 4.0}), {}};
        const LayerParameters impact = ImpactScatter{.centre = {1.0, 1.0}, .count = 400, .radius = 0.8, .falloff = 2.0};
        const std::size_t before = seedsIn(impact, wall(), {}).size(), after = seedsIn(impact, grown, wall()).size();
        QVERIFY(after > before && after < before + before / 4);
    }
    void seedsMovedByHandStayOutside() {
        Pattern pattern{{{.id = 3, .parameters = UniformScatter{.count = 20}, .scatteredIn = wall()}}};
        const Polygon half{rectangle({0.0, 0.0}, {2.0, 4.0}), {}};
        const Seeds all = *seedsOf(pattern, wall());
        std::uint32_t outside = 0;
        while (all.positions[outside].x < 2.0) ++outside;
        pattern.layers[0].overrides = {{.index = outside, .position = {3.0, 3.0}}};
        const Seeds seeds = *seedsOf(pattern, half);
        QVERIFY(std::ranges::find(seeds.positions, Vec2(3.0, 3.0)) != seeds.positions.end());
        QVERIFY(seeds.diagnostics.empty());
    }
    void invalidEarlierOutlineIsRefused() {
        const Polygon crossing{{{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}}, {}};
        const Result<Seeds> seeds =
            seedsOf({{{.id = 3, .parameters = UniformScatter{}, .scatteredIn = crossing}}}, wall());
        QVERIFY(!seeds && seeds.error().code == ErrorCode::BadInput);
    }
};

RUBBLE_TEST(OutlineFollowingTest)
#include "OutlineFollowingTest.moc"
