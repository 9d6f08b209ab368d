#include "core/fracture/cuts/CutSet.h"
#include "core/fracture/pattern/PatternCuts.h"
#include "core/fracture/pattern/PatternPartition.h"
#include "core/geometry/search/Box3.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace rubble;

namespace {

constexpr RadialCracks kRegular{.radius = 0.8, .rings = 4, .spokes = 12, .exponent = 1.0, .variation = 0.0};

const Polygon kPane{rectangle({-1.0, -1.0}, {1.0, 1.0}), {}};

Pattern patternOf(const RadialCracks& cracks, std::uint64_t randomSeed) {
    return {{{.id = 1, .randomSeed = randomSeed, .parameters = cracks}}};
}

CutSet cutsOn(const Polygon& outline, const RadialCracks& cracks, std::uint64_t randomSeed = 1) {
    return cutsOf(patternOf(cracks, randomSeed), outline).value();
}

/// The cosine of the angle between a cut and the direction outwards at its middle.
double outwardness(const CutSet& cuts, const CutEdge& edge) {
    const Vec2 from = cuts.points[edge.from], to = cuts.points[edge.to];
    return std::abs(glm::dot(glm::normalize(to - from), glm::normalize(from + to)));
}

/// The part of a circle that arcs of a ring of kRegular cover.
double coveredBy(const CutSet& cuts, int ring) {
    double covered = 0.0;
    for (const CutEdge& edge : cuts.edges) {
        const Vec2 from = cuts.points[edge.from], to = cuts.points[edge.to];
        const double radius = glm::length((from + to) / 2.0);
        if (outwardness(cuts, edge) > 0.5 || std::lround(radius / 0.2) != ring) continue;
        covered += std::abs(std::atan2(cross(from, to), glm::dot(from, to))) / (2.0 * std::numbers::pi);
    }
    return covered;
}

}  // namespace

class RadialCracksTest : public QObject {
    Q_OBJECT
private slots:
    void cracksRunOutwardsOrAlongRings() {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const CutSet cuts = cutsOn(kPane, kRegular, seed);
            for (const CutEdge& edge : cuts.edges) {
                const double outward = outwardness(cuts, edge);
                QVERIFY2(outward > 0.9 || outward < 0.3, QByteArray::number(outward));
            }
        }
    }
    void longCracksReachTheOutline() {
        const CutSet cuts = cutsOn(kPane, kRegular);
        for (std::uint32_t spoke = 0; spoke < kRegular.spokes; ++spoke) {
            const double angle = 2.0 * std::numbers::pi * spoke / kRegular.spokes;
            const Vec2 direction(std::cos(angle), std::sin(angle));
            double length = 0.0;  // of the cuts on this ray
            for (const CutEdge& edge : cuts.edges) {
                const Vec2 from = cuts.points[edge.from], to = cuts.points[edge.to];
                const bool isOnRay = std::abs(cross(direction, from)) + std::abs(cross(direction, to)) < 1e-9 &&
                                     glm::dot(direction, from) > 0.0;
                if (isOnRay) length += glm::distance(from, to);
            }
            QVERIFY2(length > std::numbers::sqrt2 - 0.2, QByteArray::number(length));  // from the hole to a corner
        }
    }
    void theHoleIsClosedAndRingsThinOutOutwards() {
        double inner = 0.0, outer = 0.0;
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const CutSet cuts = cutsOn(kPane, kRegular, seed);
            QVERIFY(std::abs(coveredBy(cuts, 1) - 1.0) < 1e-9);
            inner += coveredBy(cuts, 2) / 20.0;
            outer += coveredBy(cuts, 4) / 20.0;
        }
        // Of the sectors, 3/4 have an arc of the second ring, 1/4 one of the fourth.
        QVERIFY2(std::abs(inner - 0.75) < 0.1 && std::abs(outer - 0.25) < 0.1,
                 qPrintable(QString("%1 %2").arg(inner).arg(outer)));
    }
    void shortCracksStartOnArcs() {
        const CutSet cuts = cutsOn(kPane, kRegular);
        std::vector<int> degrees(cuts.points.size());
        for (const CutEdge& edge : cuts.edges) ++degrees[edge.from], ++degrees[edge.to];
        for (std::size_t k = 0; k < degrees.size(); ++k) {
            const bool isOutside = containment(kPane, cuts.points[k]) == Containment::Outside;
            QVERIFY2(isOutside ? degrees[k] == 1 : degrees[k] >= 2, QByteArray::number(degrees[k]));
        }
        const auto beyond = std::ranges::count(degrees, 1);
        QVERIFY2(beyond > kRegular.spokes, QByteArray::number(static_cast<int>(beyond)));  // short ones, too
    }
    void noCrackIsLoose() {
        for (std::uint64_t seed = 0; seed < 30; ++seed) {
            RadialCracks cracks =
                RadialCracks::defaultsFor(boxOf(boundsOf(kPane.outer).min, boundsOf(kPane.outer).max));
            cracks.variation = static_cast<double>(seed % 3) / 2.0;
            cracks.centre = {0.03 * static_cast<double>(seed), -0.2};
            const Result<PatternStages> stages = patternStages(patternOf(cracks, seed), kPane);
            QVERIFY(stages);
            QVERIFY(stages->partition.diagnostics.empty());
            QVERIFY(stages->partition.pieceCount() > 2 * cracks.spokes);
        }
    }
    void randomSeedDecides() {
        QVERIFY(cutsOn(kPane, kRegular, 1).points == cutsOn(kPane, kRegular, 1).points);
        QVERIFY(cutsOn(kPane, kRegular, 1).points != cutsOn(kPane, kRegular, 2).points);
    }
};

RUBBLE_TEST(RadialCracksTest)
#include "RadialCracksTest.moc"
