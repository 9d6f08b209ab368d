#include "core/fracture/kinds/WeightedLloyd.h"

#include "tests/support/TestProgram.h"
#include "tests/support/fracture/LayerSeeds.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <glm/geometric.hpp>

using namespace rubble;

namespace {

Seeds seedsAfter(std::vector<LayerParameters> layers, const Polygon& outline) {
    Pattern pattern;
    for (LayerParameters& layer : layers) {
        const auto id = static_cast<std::uint32_t>(pattern.layers.size()) + 1;
        pattern.layers.push_back({.id = id, .randomSeed = 5, .parameters = std::move(layer)});
    }
    return *seedsOf(pattern, outline);
}

/// The mean distance of seeds from a point, m.
double spreadAround(Vec2 centre, const Seeds& seeds) {
    double sum = 0.0;
    for (const Vec2 position : seeds.positions) sum += glm::distance(position, centre);
    return sum / static_cast<double>(seeds.positions.size());
}

}  // namespace

class WeightedLloydTest : public QObject {
    Q_OBJECT
private slots:
    void withoutADensitySeedsMoveToCentroids() {
        const UniformScatter scatter{.count = 30};
        for (const Polygon& outline : {unitSquare(), squareRing()}) {
            const Seeds weighted = seedsAfter({scatter, WeightedLloyd{.rounds = 2}}, outline);
            const Seeds plain = seedsAfter({scatter, LloydRelaxation{.rounds = 2}}, outline);
            QCOMPARE(weighted.positions.size(), plain.positions.size());
            for (std::size_t k = 0; k < plain.positions.size(); ++k)
                QVERIFY(glm::distance(weighted.positions[k], plain.positions[k]) < 1e-12);
        }
    }
    void seedsStayDenseAroundAnImpact() {
        // Plain relaxation spreads them evenly.
        const ImpactScatter impact{.centre = {1.0, 1.0}, .count = 60, .radius = 1.0};
        const Polygon outline{rectangle({0, 0}, {4, 4}), {}};
        const double scattered = spreadAround({1.0, 1.0}, seedsAfter({impact}, outline));
        const double weighted = spreadAround({1.0, 1.0}, seedsAfter({impact, WeightedLloyd{.rounds = 20}}, outline));
        const double even = spreadAround({1.0, 1.0}, seedsAfter({impact, LloydRelaxation{.rounds = 20}}, outline));
        QVERIFY2(weighted < 0.8 * even, qPrintable(QString("%1, %2").arg(weighted).arg(even)));
        QVERIFY2(even > 1.2 * scattered, qPrintable(QString("%1, %2").arg(scattered).arg(even)));
    }
    void zeroRoundsChangeNothing() {
        const UniformScatter scatter{.count = 10};
        QCOMPARE(seedsAfter({scatter, WeightedLloyd{.rounds = 0}}, unitSquare()).positions,
                 seedsAfter({scatter}, unitSquare()).positions);
    }
};

RUBBLE_TEST(WeightedLloydTest)
#include "WeightedLloydTest.moc"
