#include "core/geometry/polygon/OutlineCleaning.h"

#include "core/base/Random.h"
#include "core/geometry/predicates/SegmentDistance.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

using namespace rubble;

namespace {

constexpr double kCleaningTolerance = 1e-6;  // m

/// A square, or a shape of five corners, whose edges have `count` further corners each, off by up to `noise` m.
Ring subdivided(Random& random, int edges, int count, double noise) {
    Ring corners{{0.0, 0.0}, {3.0, 0.5}, {3.5, 3.0}, {1.0, 4.0}, {-1.0, 2.0}};
    corners.resize(static_cast<std::size_t>(edges));
    Ring ring;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec2 from = corners[k], to = corners[(k + 1) % corners.size()];
        for (int i = 0; i < count; ++i) {
            const Vec2 off(random.between(-noise, noise), random.between(-noise, noise));
            ring.push_back(from + (to - from) * (static_cast<double>(i) / count) + (i > 0 ? off : Vec2(0.0)));
        }
    }
    return ring;
}

/// The same, by looking at each corner of a run again for each corner that is added.
Ring simplyCleaned(const Ring& ring, double tolerance) {
    Ring corners = ring;
    const auto distance = [&](Vec2 point) { return glm::distance(point, ring[0]); };
    std::rotate(corners.begin(), std::ranges::max_element(corners, {}, distance), corners.end());
    const auto corner = [&](std::size_t i) { return corners[i % corners.size()]; };
    Ring kept{corners[0]};
    std::size_t start = 0;
    for (std::size_t end = 2; end <= corners.size(); ++end) {
        bool isStraight = true;
        for (std::size_t i = start + 1; i < end; ++i)
            isStraight = isStraight && distanceToSegment(corner(i), corner(start), corner(end)) <= tolerance;
        if (isStraight) continue;
        start = end - 1;
        kept.push_back(corners[start]);
    }
    return kept.size() < 3 ? Ring() : kept;
}

}  // namespace

class OutlineCleaningTest : public QObject {
    Q_OBJECT
private slots:
    void cornersAreThoseOfASimpleSearch() {
        Random random(20261123);
        std::size_t removed = 0;
        for (int round = 0; round < 2000; ++round) {
            const double noise = kCleaningTolerance * std::array{0.0, 1e-6, 0.3, 0.9, 1.5, 100.0}[round % 6];
            const Ring ring = subdivided(random, 3 + round % 3, 1 + static_cast<int>(random.below(40)), noise);
            const Ring cleaned = withoutCollinearCorners(ring, kCleaningTolerance);
            QCOMPARE(cleaned, simplyCleaned(ring, kCleaningTolerance));
            removed += ring.size() - cleaned.size();
        }
        QVERIFY(removed > 10000);
    }
    void workIsLinearInTheCornersOfAStraightRun() {
        Random random(4);
        for (const double noise : {0.0, 1e-3 * kCleaningTolerance, 0.2 * kCleaningTolerance}) {
            for (const int count : {1000, 16000}) {
                const Ring ring = subdivided(random, 4, count, noise);
                std::size_t visited = 0;
                QVERIFY(withoutCollinearCorners(ring, kCleaningTolerance, &visited).size() < 10);
                QVERIFY2(visited < 32 * ring.size(), qPrintable(QString::number(visited)));
            }
        }
    }
};

RUBBLE_TEST(OutlineCleaningTest)
#include "OutlineCleaningTest.moc"
