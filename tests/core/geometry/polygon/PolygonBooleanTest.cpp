#include "core/geometry/polygon/PolygonBoolean.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

namespace {

constexpr int kSize = 8;  // of the lattice that random rectangles lie on

/// A rectangle with corners on the lattice.
Ring latticeRectangle(Random& random) {
    const auto x = static_cast<double>(random.below(kSize)), y = static_cast<double>(random.below(kSize));
    const Vec2 size(1.0 + static_cast<double>(random.below(4)), 1.0 + static_cast<double>(random.below(4)));
    return rectangle({x, y}, Vec2(x, y) + size);
}

bool contains(const Ring& rectangle, Vec2 point) {
    return point.x > rectangle[0].x && point.x < rectangle[2].x && point.y > rectangle[0].y && point.y < rectangle[2].y;
}

/// The square of the lattice with a hole of side 2.
Polygon board() { return {rectangle({0, 0}, {kSize, kSize}), {reversed(rectangle({3, 3}, {5, 5}))}}; }

/// The number of lattice cells whose centre fulfils a condition; the lattice is larger than the board.
template <class Condition>
double cellsWhere(Condition condition) {
    int count = 0;
    for (int x = 0; x < 2 * kSize; ++x)
        for (int y = 0; y < 2 * kSize; ++y) count += condition(Vec2(x + 0.5, y + 0.5)) ? 1 : 0;
    return count;
}

double areaWithin(const std::vector<Ring>& rings) {
    double sum = 0.0;
    for (const Ring& ring : rings) sum += signedArea(ring);
    return sum;
}

}  // namespace

class PolygonBooleanTest : public QObject {
    Q_OBJECT
private slots:
    void partsAreSortedByArea() {
        const std::vector<Ring> band{rectangle({0.25, -1.0}, {0.5, 2.0})};
        const std::vector<Polygon> parts = difference(unitSquare(), band);
        QCOMPARE(parts.size(), std::size_t{2});
        QCOMPARE(area(parts[0]), 0.5);
        QCOMPARE(area(parts[1]), 0.25);
    }
    void areaInsideBecomesAClockwiseHole() {
        const std::vector<Ring> window{rectangle({0.25, 0.25}, {0.75, 0.5})};
        const std::vector<Polygon> parts = difference(unitSquare(), window);
        QCOMPARE(parts.size(), std::size_t{1});
        QCOMPARE(parts[0].holes.size(), std::size_t{1});
        QCOMPARE(signedArea(parts[0].outer), 1.0);
        QCOMPARE(signedArea(parts[0].holes[0]), -0.125);
    }
    void nothingIsLeftUnderALargerArea() {
        const std::vector<Ring> all{rectangle({-1.0, -1.0}, {2.0, 2.0})};
        QVERIFY(difference(unitSquare(), all).empty());
        QVERIFY(differenceBoundary(unitSquare(), all[0]).empty());
    }
    void remainingCornersKeepTheirBits() {
        const Ring corners{{1000.1, 0.1}, {1003.7, 0.3}, {1003.3, 2.9}, {1000.3, 2.7}};
        const std::vector<Ring> bite{rectangle({1003.0, 1.0}, {1004.0, 2.0})};
        const std::vector<Polygon> parts = difference({corners, {}}, bite);
        QCOMPARE(parts.size(), std::size_t{1});
        QCOMPARE(parts[0].outer.size(), std::size_t{8});
        for (const Vec2 corner : corners) QVERIFY(std::ranges::count(parts[0].outer, corner) == 1);
    }
    void sharedEdgeDisappearsFromTheUnion() {
        const std::vector<Ring> both = unionBoundary(unitSquare(), rectangle({1.0, 0.0}, {2.0, 1.0}));
        QCOMPARE(both.size(), std::size_t{1});
        QCOMPARE(both[0].size(), std::size_t{6});  // corners of straight runs stay
        QCOMPARE(signedArea(both[0]), 2.0);
    }
    void areasAreThoseOfCountedCells() {
        for (std::uint64_t number = 1; number <= 500; ++number) {
            Random random(number);
            const std::string name = "random seed " + std::to_string(number);
            std::vector<Ring> removed(1 + random.below(4));
            for (Ring& ring : removed) ring = latticeRectangle(random);
            const auto isOnBoard = [](Vec2 cell) { return containment(board(), cell) == Containment::Inside; };
            const auto isRemoved = [&](Vec2 cell) {
                return std::ranges::any_of(removed, [&](const Ring& ring) { return contains(ring, cell); });
            };
            double left = 0.0, last = 1e308;
            for (const Polygon& part : difference(board(), removed)) {
                QVERIFY2(signedArea(part.outer) > 0.0 && area(part) <= last, name.c_str());
                last = area(part);
                left += last;
            }
            QVERIFY2(left == cellsWhere([&](Vec2 cell) { return isOnBoard(cell) && !isRemoved(cell); }), name.c_str());

            const auto isInFirst = [&](Vec2 cell) { return contains(removed[0], cell); };
            QVERIFY2(areaWithin(differenceBoundary(board(), removed[0])) ==
                         cellsWhere([&](Vec2 cell) { return isOnBoard(cell) && !isInFirst(cell); }),
                     name.c_str());
            QVERIFY2(areaWithin(unionBoundary(board(), removed[0])) ==
                         cellsWhere([&](Vec2 cell) { return isOnBoard(cell) || isInFirst(cell); }),
                     name.c_str());
        }
    }
};

RUBBLE_TEST(PolygonBooleanTest)
#include "PolygonBooleanTest.moc"
