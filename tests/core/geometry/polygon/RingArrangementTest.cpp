#include "core/geometry/polygon/RingArrangement.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

namespace {

using ContactKind = BoundaryContact::Kind;

constexpr std::size_t kAll = 1000;

RingArrangement arrangementOf(const Polygon& polygon, std::size_t maxContacts = kAll) {
    return ringArrangement(indexedCorners(polygon), maxContacts);
}

/// Squares in squares: ring k lies within ring parent[k].
Polygon randomNest(Random& random, std::vector<std::uint32_t>& parent) {
    struct Square {
        Vec2 low;
        double size;
        int children = 0;
    };
    std::vector<Square> squares{{{0.0, 0.0}, 1024.0}};
    Polygon polygon{rectangle({0, 0}, {1024, 1024}), {}};
    parent = {kNone};
    for (int k = 0; k < 12; ++k) {
        const auto around = static_cast<std::uint32_t>(random.below(squares.size()));
        Square& outer = squares[around];
        if (outer.children == 4 || outer.size < 8.0) continue;
        // In a quarter that no other square is in.
        const double quarter = outer.size / 2.0;
        const Vec2 low = outer.low + quarter * Vec2(outer.children % 2, outer.children / 2) + Vec2(quarter / 4.0);
        ++outer.children;
        squares.push_back({low, quarter / 2.0});
        polygon.holes.push_back(rectangle(low, low + Vec2(quarter / 2.0)));
        parent.push_back(around);
    }
    return polygon;
}

}  // namespace

class RingArrangementTest : public QObject {
    Q_OBJECT
private slots:
    void ringsKnowTheRingAroundThem() {
        const Polygon nested{rectangle({0, 0}, {9, 9}),
                             {rectangle({1, 1}, {5, 5}), rectangle({2, 2}, {3, 3}), rectangle({6, 6}, {8, 8})}};
        const RingArrangement found = arrangementOf(nested);
        QVERIFY(found.contacts.empty());
        QVERIFY(!found.hasEdgeIntersection);
        QCOMPARE(found.parent, (std::vector<std::uint32_t>{kNone, 0, 1, 0}));
    }
    void contactsOfEachKindAreFound() {
        const Polygon square{rectangle({0, 0}, {4, 4}), {}};
        const auto contactsWith = [&](const Ring& ring) { return arrangementOf({square.outer, {ring}}).contacts; };
        using Contacts = std::vector<BoundaryContact>;
        QCOMPARE(contactsWith({{0, 0}, {2, 1}, {1, 2}}), (Contacts{{0, 4, ContactKind::CornersMeet}}));
        QCOMPARE(contactsWith({{0, 2}, {1, 1}, {1, 3}}), (Contacts{{4, 3, ContactKind::CornerOnEdge}}));
        QCOMPARE(contactsWith({{1, 1}, {5, 2}, {1, 3}}),
                 (Contacts{{1, 4, ContactKind::EdgesCross}, {1, 5, ContactKind::EdgesCross}}));
    }
    void sharedCornerIsNoIntersectionOfEdges() {
        const RingArrangement corner = arrangementOf({rectangle({0, 0}, {4, 4}), {{{0, 0}, {2, 1}, {1, 2}}}});
        QVERIFY(!corner.hasEdgeIntersection);
        QVERIFY(corner.parent.empty());
        QVERIFY(arrangementOf({rectangle({0, 0}, {4, 4}), {{{0, 2}, {1, 1}, {1, 3}}}}).hasEdgeIntersection);
    }
    void oneContactIsFoundForALimitOfOne() {
        Ring zigzag{{0, 0}};
        for (int k = 0; k < 20; ++k) zigzag.push_back({k + 1.0, k % 2 == 0 ? 2.0 : -2.0});
        zigzag.push_back({22.0, 0.0});
        const Polygon crossed{zigzag, {}};  // by its last edge, in each of the nineteen between two peaks
        QCOMPARE(arrangementOf(crossed).contacts.size(), std::size_t{19});
        const RingArrangement limited = arrangementOf(crossed, 1);
        QVERIFY(!limited.contacts.empty());
        QVERIFY(limited.hasEdgeIntersection);
    }
    void nestsOfSquaresAreFoundAgain() {
        for (std::uint64_t number = 1; number <= 300; ++number) {
            Random random(number);
            std::vector<std::uint32_t> parent;
            const Polygon nest = randomNest(random, parent);
            const RingArrangement found = arrangementOf(nest);
            QVERIFY2(found.contacts.empty(), qPrintable(QString("random seed %1").arg(number)));
            QVERIFY2(found.parent == parent, qPrintable(QString("random seed %1").arg(number)));
        }
    }
};

RUBBLE_TEST(RingArrangementTest)
#include "RingArrangementTest.moc"
