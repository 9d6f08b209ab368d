#include "core/fracture/partition/PieceRings.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

PieceRing ring(std::initializer_list<std::uint32_t> points) {
    PieceRing corners;
    for (const std::uint32_t point : points) corners.push_back({point, 7});
    return corners;
}

/// The points of each part's rings, each ring starting at its lowest.
std::vector<std::vector<std::vector<std::uint32_t>>> numbersOf(const std::vector<PieceRings>& parts) {
    std::vector<std::vector<std::vector<std::uint32_t>>> numbers;
    for (const PieceRings& rings : parts) {
        auto& part = numbers.emplace_back();
        for (const PieceRing& corners : rings) {
            auto& points = part.emplace_back();
            for (const PieceCorner& corner : corners) points.push_back(corner.point);
            std::ranges::rotate(points, std::ranges::min_element(points));
        }
    }
    std::ranges::sort(numbers);
    return numbers;
}

using Numbers = std::vector<std::vector<std::vector<std::uint32_t>>>;

}  // namespace

class PieceRingsTest : public QObject {
    Q_OBJECT
private slots:
    void simpleRingsDoNotChange() {
        const std::vector<Vec2> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {1, 2}, {2, 2}};
        const auto parts = connectedParts({ring({0, 1, 2, 3}), ring({4, 5, 6})}, points);
        QCOMPARE(numbersOf(parts), (Numbers{{{0, 1, 2, 3}, {4, 5, 6}}}));
    }
    void ringsOfTwoCornersAreRemoved() {
        const std::vector<Vec2> points = {{0, 0}, {4, 0}, {4, 4}};
        QCOMPARE(numbersOf(connectedParts({ring({0, 1, 2}), ring({0, 2})}, points)), (Numbers{{{0, 1, 2}}}));
        QVERIFY(connectedParts({ring({0, 1})}, points).empty());
    }
    void figureEightIsTwoParts() {
        // Two squares that touch at point 2.
        const std::vector<Vec2> points = {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {0, 1}};
        QCOMPARE(numbersOf(connectedParts({ring({0, 1, 2, 3, 4, 5, 2, 6})}, points)),
                 (Numbers{{{0, 1, 2, 6}}, {{2, 3, 4, 5}}}));
    }
    void holeTouchingTheOuterRingInOnePointIsKept() {
        const std::vector<Vec2> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 2}, {2, 1}};
        const Numbers expected{{{0, 1, 2, 3}, {0, 4, 5}}};
        QCOMPARE(numbersOf(connectedParts({ring({0, 1, 2, 3}), ring({0, 4, 5})}, points)), expected);
        QCOMPARE(numbersOf(connectedParts({ring({0, 1, 2, 3, 0, 4, 5})}, points)), expected);
    }
    void holeTouchingTheOuterRingInTwoPointsDisconnectsIt() {
        const std::vector<Vec2> points = {{0, 0}, {4, 0}, {4, 2}, {4, 4}, {0, 4}, {0, 2}, {2, 1}, {2, 3}};
        QCOMPARE(numbersOf(connectedParts({ring({0, 1, 2, 3, 4, 5}), ring({5, 7, 2, 6})}, points)),
                 (Numbers{{{0, 1, 2, 6, 5}}, {{2, 3, 4, 5, 7}}}));
    }
    void cycleOfTouchingHolesCutsOutAPart() {
        // Two bracket-shaped holes that touch above and below a central square.
        const std::vector<Vec2> points = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {3, 1},
                                          {1, 3}, {3, 5}, {5, 3}, {2, 3}, {4, 3}};
        const auto parts = connectedParts({ring({0, 1, 2, 3}), ring({4, 5, 6, 8}), ring({4, 9, 6, 7})}, points);
        QCOMPARE(numbersOf(parts), (Numbers{{{0, 1, 2, 3}, {4, 5, 6, 7}}, {{4, 9, 6, 8}}}));
    }
    void holesBelongToTheEnclosingPart() {
        const std::vector<Vec2> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {8, 4}, {8, 8}, {4, 8},
                                          {5, 5}, {5, 6}, {6, 6}, {1, 1}, {1, 2}, {2, 2}};
        const auto parts =
            connectedParts({ring({0, 1, 2, 3}), ring({2, 4, 5, 6}), ring({7, 8, 9}), ring({10, 11, 12})}, points);
        QCOMPARE(numbersOf(parts), (Numbers{{{0, 1, 2, 3}, {10, 11, 12}}, {{2, 4, 5, 6}, {7, 8, 9}}}));
    }
    /// So large that a quadratic search for repeated points would exceed the time limit of any test.
    void millionsOfCornersAreOnePart() {
        constexpr std::uint32_t kHalf = 1'000'000;
        std::vector<Vec2> points;
        PieceRing corners;
        for (std::uint32_t k = 0; k < kHalf; ++k) points.push_back({static_cast<double>(k), 0.0});
        for (std::uint32_t k = kHalf; k-- > 0;) points.push_back({static_cast<double>(k), 1.0});
        for (std::uint32_t k = 0; k < 2 * kHalf; ++k) corners.push_back({k, 7});
        const auto parts = connectedParts({corners}, points);
        QCOMPARE(parts.size(), std::size_t{1});
        QCOMPARE(parts[0][0].size(), std::size_t{2 * kHalf});
    }
};

RUBBLE_TEST(PieceRingsTest)
#include "PieceRingsTest.moc"
