#include "core/geometry/search/MergedBoxes.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

namespace {

Box3 cube(double x, double y, double z, double side) { return {{x, y, z}, {x + side, y + side, z + side}}; }

bool overlap(const Box3& a, const Box3& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
           b.min.z <= a.max.z;
}

/// The same by the definition: joins any two that overlap until there are none.
std::vector<Box3> mergedByPairs(std::vector<Box3> boxes) {
    for (std::size_t a = 0; a < boxes.size(); ++a) {
        for (std::size_t b = a + 1; b < boxes.size(); ++b) {
            if (!overlap(boxes[a], boxes[b])) continue;
            boxes[a].include(boxes[b]);
            boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(b));
            return mergedByPairs(boxes);
        }
    }
    return boxes;
}

}  // namespace

class MergedBoxesTest : public QObject {
    Q_OBJECT
private slots:
    void overlappingAndTouchingBoxesAreMerged() {
        QVERIFY(mergedBoxes({cube(0, 0, 0, 2), cube(1, 1, 1, 2)}) == std::vector{cube(0, 0, 0, 3)});
        QVERIFY(mergedBoxes({cube(0, 0, 0, 1), cube(1, 0, 0, 1)}) == (std::vector{Box3{{0, 0, 0}, {2, 1, 1}}}));
    }
    void boxesApartAlongAnyAxisStayAndAreSorted() {
        const std::vector<Box3> apart{cube(0, 0, 0, 1), cube(0, 0, 2, 1), cube(0, 2, 0, 1), cube(2, 0, 0, 1)};
        QVERIFY(mergedBoxes({apart[3], apart[1], apart[2], apart[0]}) == apart);
    }
    void mergedBoxOverlapsFurtherOnes() {
        // The box around the first two reaches the third, which neither does.
        const Box3 third = cube(2.5, 0, 0, 0.25);
        const std::vector<Box3> merged =
            mergedBoxes({third, {{0, 0, 0}, {3, 0.5, 0.5}}, {{0, 0.5, 0}, {0.5, 3, 3}}, cube(9, 9, 9, 1)});
        QVERIFY(merged == (std::vector{Box3{{0, 0, 0}, {3, 3, 3}}, cube(9, 9, 9, 1)}));
        QVERIFY(mergedBoxes({{{0, 0, 0}, {3, 0.5, 0.5}}, {{0, 0.5, 0}, {0.5, 3, 3}}, cube(2, 2, 2, 0.5)}).size() == 1);
    }
    void emptyBoxesAreDropped() {
        QVERIFY(mergedBoxes({}).empty());
        QVERIFY(mergedBoxes({Box3{}, cube(0, 0, 0, 1), Box3{}}) == std::vector{cube(0, 0, 0, 1)});
    }
    void randomBoxesAreMergedAsByPairs() {
        Random random(1);
        for (int round = 0; round < 100; ++round) {
            std::vector<Box3> boxes;
            for (int k = 0; k < 40; ++k) {
                boxes.push_back(
                    cube(random.between(0, 9), random.between(0, 9), random.between(0, 9), random.between(0.1, 2)));
            }
            const std::vector<Box3> merged = mergedBoxes(boxes);
            std::ranges::reverse(boxes);
            QVERIFY(merged == mergedBoxes(boxes));
            std::vector<Box3> byPairs = mergedBoxes(mergedByPairs(boxes));  // sorts them
            QVERIFY(merged == byPairs);
            QCOMPARE(mergedByPairs(boxes).size(), merged.size());
        }
    }
};

RUBBLE_TEST(MergedBoxesTest)
#include "MergedBoxesTest.moc"
