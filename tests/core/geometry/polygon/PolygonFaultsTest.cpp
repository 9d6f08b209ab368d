#include "core/geometry/polygon/PolygonFaults.h"

#include "core/base/Random.h"
#include "core/geometry/polygon/RingArrangement.h"
#include "core/geometry/predicates/Predicates.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

using namespace rubble;

namespace {

using Kind = PolygonFaultKind;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The only fault of a polygon.
PolygonFault onlyFault(const Polygon& polygon) {
    const std::vector<PolygonFault> faults = polygonFaults(polygon);
    if (faults.size() == 1) return faults[0];
    return {Kind::NotFinite, {}, {}, {}, "not one fault but " + std::to_string(faults.size())};
}

using FaultPlace = std::array<int, 5>;  // kind, first ring and point, second ring and point

FaultPlace placeOf(const PolygonFault& fault) {
    return {static_cast<int>(fault.kind), fault.first.ring, fault.first.point, fault.second.ring, fault.second.point};
}

/// Brute-force oracle for contacts, in integers.
class LatticeOracle {
public:
    explicit LatticeOracle(const Polygon& polygon) : m_rings{polygon.outer} {
        m_rings.insert(m_rings.end(), polygon.holes.begin(), polygon.holes.end());
    }

    std::set<FaultPlace> contacts() const {
        std::set<FaultPlace> found;
        for (const RingPoint a : all())
            for (const RingPoint b : all()) {
                if (std::array{a.ring, a.point} < std::array{b.ring, b.point}) {
                    if (at(a) == at(b)) found.insert(place(Kind::Touching, a, b));
                    if (edgesCross(a, b)) found.insert(place(Kind::Crossing, a, b));
                }
                if (liesInside(at(a), b)) found.insert(place(Kind::Touching, a, b));
            }
        return meetingOnce(found);
    }

    /// The number of rings around a ring without contacts, and whether the outline is one of them.
    std::pair<int, bool> nesting(int ring) const {
        int around = 0;
        bool isInOutline = false;
        for (int other = 0; other < std::ssize(m_rings); ++other) {
            if (other == ring || !isAround(other, m_rings[ring][0])) continue;
            ++around;
            isInOutline = isInOutline || other == 0;
        }
        return {around, isInOutline};
    }

private:
    static FaultPlace place(Kind kind, RingPoint a, RingPoint b) {
        return {static_cast<int>(kind), a.ring, a.point, b.ring, b.point};
    }
    std::vector<RingPoint> all() const {
        std::vector<RingPoint> places;
        for (int ring = 0; ring < std::ssize(m_rings); ++ring)
            for (int point = 0; point < std::ssize(m_rings[ring]); ++point) places.push_back({ring, point});
        return places;
    }
    Vec2 at(RingPoint place) const { return m_rings[place.ring][place.point]; }
    Vec2 endOf(RingPoint edge) const {
        const Ring& ring = m_rings[edge.ring];
        return ring[(edge.point + 1) % std::ssize(ring)];
    }
    static long long turn(Vec2 a, Vec2 b, Vec2 c) {
        const auto whole = [](double value) { return static_cast<long long>(value); };
        const long long value = whole(b.x - a.x) * whole(c.y - a.y) - whole(b.y - a.y) * whole(c.x - a.x);
        return value > 0 ? 1 : value < 0 ? -1 : 0;
    }
    bool liesInside(Vec2 point, RingPoint edge) const {
        const Vec2 from = at(edge), to = endOf(edge);
        const Vec2 toFrom = from - point, toTo = to - point;
        return turn(from, to, point) == 0 && toFrom.x * toTo.x + toFrom.y * toTo.y < 0.0;
    }
    bool edgesCross(RingPoint a, RingPoint b) const {
        return turn(at(a), endOf(a), at(b)) * turn(at(a), endOf(a), endOf(b)) < 0 &&
               turn(at(b), endOf(b), at(a)) * turn(at(b), endOf(b), endOf(a)) < 0;
    }
    bool isAround(int ring, Vec2 point) const {
        bool isInside = false;
        for (int i = 0; i < std::ssize(m_rings[ring]); ++i) {
            const Vec2 from = at({ring, i}), to = endOf({ring, i});
            if ((from.y <= point.y) != (to.y <= point.y) && (turn(from, to, point) > 0) == (to.y > from.y))
                isInside = !isInside;
        }
        return isInside;
    }
    /// Of several coinciding corners, only pairs with the first are listed.
    std::set<FaultPlace> meetingOnce(const std::set<FaultPlace>& found) const {
        std::set<FaultPlace> kept;
        for (const FaultPlace& fault : found) {
            const RingPoint a{fault[1], fault[2]}, b{fault[3], fault[4]};
            const bool isMeeting = fault[0] == static_cast<int>(Kind::Touching) && at(a) == at(b);
            const auto isEarlier = [&](RingPoint place) {
                return std::array{place.ring, place.point} < std::array{a.ring, a.point} && at(place) == at(a);
            };
            const std::vector<RingPoint> places = all();
            if (!isMeeting || std::none_of(places.begin(), places.end(), isEarlier)) kept.insert(fault);
        }
        return kept;
    }

    std::vector<Ring> m_rings;
};

double logBetween(Random& random, double least, double most) { return least * std::pow(most / least, random.unit()); }

/// An outline of about 1 m near one of the limits of narrowFeatures(): sharp, flat, with a short edge, or with a short
/// edge at a sharp corner.
Ring narrowConvexRing(Random& random, int kind) {
    const double wide = 0.2 + random.unit(), tiny = logBetween(random, 1e-15, 1e-11);
    switch (kind) {
        case 0: return {{0.0, 0.0}, {1.0, 0.0}, {1.0, logBetween(random, 1e-6, 1e-3)}};
        case 1: return {{0.0, 0.0}, {1.0, 0.0}, {1.0, tiny}, {0.0, tiny * (0.2 + random.unit())}};
        case 2: return {{tiny, 0.0}, {1.0, 0.0}, {1.0, wide}, {0.0, wide}, {0.0, tiny}};
        default: {
            const double side = logBetween(random, 1e-12, 1e-8), sine = logBetween(random, 1e-6, 1e-1);
            return {{0.0, 0.0}, {1.0, 0.0}, {0.9, 0.7 * sine}, {side, side * sine}};
        }
    }
}

}  // namespace

class PolygonFaultsTest : public QObject {
    Q_OBJECT
private slots:
    void validPolygonsHaveNoFaults() {
        for (const Polygon& polygon : {unitSquare(), squareRing(), lShape()}) {
            QVERIFY(polygonFaults(polygon).empty());
            Polygon turned = polygon;
            turned.outer = reversed(turned.outer);
            QVERIFY(polygonFaults(turned).empty());
        }
    }
    void collinearCornersAreAllowed() { QVERIFY(polygonFaults({{{0, 0}, {1, 0}, {2, 0}, {2, 2}}, {}}).empty()); }
    void reportsEveryNonFinitePoint() {
        const std::vector<PolygonFault> faults = polygonFaults({{{0, 0}, {1, kNan}, {1, 1}, {-kInfinity, 1}}, {}});
        QCOMPARE(faults.size(), std::size_t{2});
        QCOMPARE(faults[0].message, std::string("Point 1 of the outline is not a finite number: (1, nan)."));
        QCOMPARE(faults[1].message, std::string("Point 3 of the outline is not a finite number: (-inf, 1)."));
        QVERIFY(faults[1].kind == Kind::NotFinite && faults[1].where == Vec2(0.0, 0.0));
    }
    void reportsPointsOutOfRange() {
        const PolygonFault fault = onlyFault({{{0, 0}, {1e61, 0}, {1, 1}}, {}});
        QVERIFY(fault.kind == Kind::OutOfRange);
        QCOMPARE(fault.message,
                 std::string("Point 1 of the outline is out of range: (1e+61, 0); a coordinate is zero or from 1e-60 "
                             "to 1e+60."));
        QVERIFY(onlyFault({{{0, 0}, {1, 1e-61}, {1, 1}}, {}}).kind == Kind::OutOfRange);
    }
    void reportsTooFewPoints() {
        QCOMPARE(onlyFault({}).message, std::string("The outline needs at least 3 points but has 0."));
        QCOMPARE(onlyFault({{{1, 1}}, {}}).message, std::string("The outline needs at least 3 points but has 1."));
        Polygon polygon = unitSquare();
        polygon.holes = {{}, {{0.5, 0.5}, {0.6, 0.6}}};
        const std::vector<PolygonFault> faults = polygonFaults(polygon);
        QCOMPARE(faults.size(), std::size_t{2});
        QCOMPARE(faults[1].message, std::string("Hole 1 needs at least 3 points but has 2."));
        QVERIFY(faults[1].kind == Kind::TooFewPoints && faults[1].first == (RingPoint{2, 0}));
    }
    void reportsRepeatedPoints() {
        const PolygonFault inside = onlyFault({{{0, 0}, {1, 0}, {1, 0}, {1, 1}}, {}});
        QVERIFY(inside.kind == Kind::RepeatedPoint && inside.first == (RingPoint{0, 1}));
        QCOMPARE(inside.message, std::string("Points 1 and 2 of the outline are equal: (1, 0)."));
        const PolygonFault closed = onlyFault({{{0, 0}, {1, 0}, {1, 1}, {0, 0}}, {}});
        QVERIFY(closed.kind == Kind::RepeatedPoint && closed.second == (RingPoint{0, 0}));
        QCOMPARE(closed.message, std::string("The last point of the outline, point 3, repeats its first: (0, 0)."));
    }
    void reportsRingsOfZeroArea() {
        QCOMPARE(onlyFault({{{0, 0}, {1, 1}, {3, 3}}, {}}).message,
                 std::string("The outline encloses no area: all its points lie on one line."));
        // One ulp from the line is an area.
        QVERIFY(polygonFaults({{{0, 0}, {3, 3}, {1, std::nextafter(1.0, 2.0)}}, {}}).empty());
    }
    void reportsCrossings() {
        const PolygonFault bowTie = onlyFault({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}});
        QVERIFY(bowTie.kind == Kind::Crossing && bowTie.where == Vec2(0.5, 0.5));
        QCOMPARE(bowTie.message, std::string("The outline crosses itself between points 0 and 2, at (0.5, 0.5)."));
        Polygon polygon = unitSquare();
        polygon.holes = {rectangle({0.5, 0.25}, {1.5, 0.75})};
        const std::vector<PolygonFault> faults = polygonFaults(polygon);
        QCOMPARE(faults.size(), std::size_t{2});
        QCOMPARE(faults[0].message,
                 std::string("The outline after its point 1 crosses hole 0 after its point 0, at (1, 0.25)."));
        polygon.holes = {rectangle({0.1, 0.1}, {0.5, 0.5}), rectangle({0.4, 0.3}, {0.8, 0.4})};
        QVERIFY(polygonFaults(polygon)[0].message.starts_with("Hole 0 after its point 1 crosses hole 1 after its"));
    }
    void reportsTouches() {
        const PolygonFault onEdge = onlyFault({{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}, {}});
        QVERIFY(onEdge.kind == Kind::Touching && onEdge.where == Vec2(1.0, 0.0));
        QCOMPARE(onEdge.message,
                 std::string("The outline touches itself: point 3 lies on the edge from point 0 to 1, at (1, 0)."));
        const PolygonFault pinch = onlyFault({{{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}, {}});
        QCOMPARE(pinch.message, std::string("The outline touches itself: points 1 and 4 meet, at (1, 1)."));
        Polygon polygon = unitSquare();
        polygon.holes = {{{1, 0.5}, {0.5, 0.75}, {0.5, 0.25}}};
        QCOMPARE(onlyFault(polygon).message,
                 std::string("Point 0 of hole 0 lies on the edge from point 1 to 2 of the outline, at (1, 0.5)."));
        polygon.holes = {{{1, 1}, {0.5, 0.75}, {0.75, 0.5}}};
        QCOMPARE(onlyFault(polygon).message,
                 std::string("The outline touches hole 0: points 2 and 0 meet, at (1, 1)."));
    }
    void spikesAreTouches() {
        const PolygonFault outwards = onlyFault({{{0, 0}, {1, 0}, {2, 0}, {1, 0}, {1, 1}}, {}});
        QVERIFY(outwards.kind == Kind::Touching && outwards.first == (RingPoint{0, 1}));
        const PolygonFault back = onlyFault({{{0, 0}, {2, 0}, {1, 0}, {1, 1}}, {}});
        QCOMPARE(back.message,
                 std::string("The outline touches itself: point 2 lies on the edge from point 0 to 1, at (1, 0)."));
    }
    void reportsHolesOutside() {
        Polygon polygon = unitSquare();
        polygon.holes = {rectangle({2, 2}, {3, 3}), rectangle({0.2, 0.2}, {0.8, 0.8}), rectangle({-9, -9}, {9, 9})};
        const std::vector<PolygonFault> faults = polygonFaults(polygon);
        QCOMPARE(faults.size(), std::size_t{2});
        QVERIFY(faults[0].kind == Kind::HolesOverlap);  // hole 2 contains everything
        QCOMPARE(faults[0].message, std::string("Hole 0 lies inside hole 2."));
        QCOMPARE(faults[1].message, std::string("Hole 2 lies outside the outline."));
        QVERIFY(faults[1].kind == Kind::HoleOutside && faults[1].first == (RingPoint{3, 0}));
    }
    void reportsHolesInHoles() {
        Polygon polygon = unitSquare();
        polygon.holes = {rectangle({0.4, 0.4}, {0.6, 0.6}), rectangle({0.2, 0.2}, {0.8, 0.8})};
        QCOMPARE(onlyFault(polygon).message, std::string("Hole 0 lies inside hole 1."));
    }
    void holeEqualToTheOutlineTouchesEverywhere() {
        Polygon polygon = unitSquare();
        polygon.holes = {polygon.outer};
        const std::vector<PolygonFault> faults = polygonFaults(polygon);
        QCOMPARE(faults.size(), std::size_t{4});
        QCOMPARE(faults[0].message, std::string("The outline touches hole 0: points 0 and 0 meet, at (0, 0)."));
    }
    void returnsAtMostTheLimit() {
        // Every second edge of a random ring crosses about a third of the others.
        Random random(5);
        Ring ring(200);
        for (Vec2& point : ring) point = {random.unit(), random.unit()};
        QCOMPARE(polygonFaults({ring, {}}).size(), std::size_t{64});
        QCOMPARE(polygonFaults({ring, {}}, 3).size(), std::size_t{3});
        QCOMPARE(polygonFaults({Ring(100, Vec2(kNan, 0)), {}}, 3).size(), std::size_t{3});
    }
    void validatedReturnsCanonicalWindingOrTheFirstFault() {
        Polygon polygon = squareRing();
        polygon.outer = reversed(polygon.outer);
        QCOMPARE(validated(polygon)->outer, (Ring{{0, 4}, {0, 0}, {4, 0}, {4, 4}}));
        QVERIFY(validated({{{0, 0}, {1, kNan}, {1, 1}}, {}}).error().code == ErrorCode::BadInput);
        QVERIFY(validated({}).error().code == ErrorCode::BadInput);
        QVERIFY(validated({{{0, 0}, {1, 0}, {1, 0}, {1, 1}}, {}}).error().code == ErrorCode::BadInput);
        QVERIFY(validated({{{0, 0}, {1, 0}, {2, 0}}, {}}).error().code == ErrorCode::Degenerate);
        const Result<Polygon> bowTie = validated({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}});
        QVERIFY(bowTie.error().code == ErrorCode::Crossing);
        QCOMPARE(bowTie.error().message,
                 std::string("The outline crosses itself between points 0 and 2, at (0.5, 0.5)."));
        polygon = unitSquare();
        polygon.holes = {rectangle({2, 2}, {3, 3})};
        QVERIFY(validated(polygon).error().code == ErrorCode::Crossing);
    }
    void reportsNarrowFeatures() {
        const auto message = [](const Polygon& polygon) {
            const Result<Polygon> valid = validated(polygon);
            return valid ? std::string() : valid.error().message;
        };
        const double least = 0x1p-42;  // 2^-44 of an extent of 4
        const auto notched = [](double y) { return Polygon{{{0, 0}, {4, 0}, {4, 4}, {2, y}, {0, 4}}, {}}; };
        QCOMPARE(message(notched(least)),
                 std::string("Point 3 of the outline is nearer than 2.3e-13 m to the edge from "
                             "point 0 to 1 of the outline, at (2, 2.2737367544323206e-13): "
                             "move it away or leave it out."));
        QCOMPARE(message(notched(1.01 * least)), std::string());
        const auto cut = [](double x) { return Polygon{{{0, 0}, {4, 0}, {4, 4}, {x, 4}, {0, 4}}, {}}; };
        QCOMPARE(message(cut(least)), std::string("Points 3 and 4 of the outline are nearer than 2.3e-13 m, at "
                                                  "(2.2737367544323206e-13, 4): leave one of them out."));
        QCOMPARE(message(cut(1.01 * least)), std::string());
        const auto spike = [](double y) { return Polygon{{{0, 0}, {4, 0}, {4, y}}, {}}; };
        QVERIFY(message(spike(1e-4)).starts_with("The outline is too sharp at its point 0, at (0, 0): its edges must"));
        QCOMPARE(message(spike(3e-4)), std::string());
        Polygon holed{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {rectangle({least / 2.0, 1.0}, {2.0, 2.0})}};
        QVERIFY(
            message(holed).starts_with("Point 0 of hole 0 is nearer than 2.3e-13 m to the edge from point 3 to 0 "
                                       "of the outline, at (1.13"));
    }
    /// The fast path of validated() for convex outlines must agree with narrowFeatures() near the limits.
    void fastPathForConvexOutlinesAgreesWithTheGeneralOne() {
        Random random(17);
        std::array<int, 2> reported{};
        for (int round = 0; round < 20000; ++round) {
            const double turn = 2.0 * std::numbers::pi * random.unit();
            Polygon polygon{narrowConvexRing(random, round % 4), {}};
            if (round % 8 >= 4) {  // mirrored
                for (Vec2& point : polygon.outer) point.x = -point.x;
                std::ranges::reverse(polygon.outer);
            }
            for (Vec2& point : polygon.outer) {
                point = {std::cos(turn) * point.x - std::sin(turn) * point.y,
                         std::sin(turn) * point.x + std::cos(turn) * point.y};
            }
            if (!isSimpleAndConvex(polygon.outer)) continue;
            const bool isFaulty = narrowFault(polygon).has_value();
            QVERIFY(polygonFaults(polygon).empty());
            QVERIFY2(validated(polygon).hasValue() == !isFaulty, QByteArray::number(round));
            ++reported[isFaulty];
        }
        QVERIFY(reported[0] > 1000 && reported[1] > 1000);
    }
    void randomLatticePolygonsMatchTheOracle() {
        const std::uint64_t seed = 20240607;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        int sound = 0, touching = 0;
        for (int round = 0; round < 20000; ++round) {
            const std::uint64_t extent = 3 + random.below(8);
            Polygon polygon{randomLatticeRing(random, 8, extent), {}};
            for (std::uint64_t holes = random.below(3); holes > 0; --holes)
                polygon.holes.push_back(randomLatticeRing(random, 4, extent));
            const std::vector<PolygonFault> faults = polygonFaults(polygon, 1000);
            if (!faults.empty() && faults[0].kind <= Kind::ZeroArea) continue;  // covered by the tests above
            const LatticeOracle oracle(polygon);
            const std::set<FaultPlace> expected = oracle.contacts();
            if (expected.empty()) {
                verifyNesting(oracle, polygon, faults);
                ++sound;
                continue;
            }
            std::set<FaultPlace> found;
            for (const PolygonFault& fault : faults) found.insert(placeOf(fault));
            QVERIFY2(found == expected, qPrintable(QString("round %1").arg(round)));
            QCOMPARE(faults.size(), expected.size());
            touching += std::any_of(faults.begin(), faults.end(), [](auto& f) { return f.kind == Kind::Touching; });
        }
        QVERIFY(sound > 1000 && touching > 1000);  // the test reaches both
    }
    void comparisonsOfStarsGrowLikeNLogN() {
        const auto stars = [](int scale) {
            Polygon polygon{star(25000 * scale, 0.9 * 2.0, 2.0), {}};
            for (int i = 0; i < 100; ++i)
                polygon.holes.push_back(star(25 * scale, 0.9 * 0.09, 0.09, Vec2(i % 10 - 4.5, i / 10 - 4.5) * 0.2));
            return polygon;
        };
        Polygon polygon = stars(4);
        QVERIFY(polygonFaults(polygon).empty());
        verifyGrowth(comparisons(stars(1)), comparisons(polygon));
        std::swap(polygon.outer[100], polygon.outer[50000]);
        QVERIFY(!polygonFaults(polygon).empty());
    }
    void comparisonsOfCombOfLongDiagonalTeethGrowLikeNLogN() {
        // Every edge's box overlaps every other's: grids and box trees degrade here, the sweep does not.
        const auto comb = [](int teeth) {
            Ring ring;
            for (int i = 0; i < teeth; ++i) {
                ring.push_back({i * 1e-3, -i * 1e-3});
                ring.push_back({1000.0 + i * 1e-3 + 5e-4, 1000.0 - i * 1e-3 - 5e-4});
            }
            ring.push_back({0.0, -2000.0});
            return Polygon{ring, {}};
        };
        QVERIFY(polygonFaults(comb(20000)).empty());
        verifyGrowth(comparisons(comb(5000)), comparisons(comb(20000)));
    }

private:
    static std::size_t comparisons(const Polygon& polygon) {
        return ringArrangement(indexedCorners(polygon), 1).comparisons;
    }
    /// Of the comparisons for n and 4n corners: the ratio is 16 if they are quadratic.
    static void verifyGrowth(std::size_t before, std::size_t after) {
        qInfo("%zu, then %zu comparisons", before, after);
        QVERIFY(before > 0 && after < 6 * before);
    }
    static void verifyNesting(const LatticeOracle& oracle, const Polygon& polygon,
                              const std::vector<PolygonFault>& faults) {
        for (int ring = 1; ring <= std::ssize(polygon.holes); ++ring) {
            const auto [around, isInOutline] = oracle.nesting(ring);
            const auto isHere = [&](const PolygonFault& fault) { return fault.first.ring == ring; };
            const auto fault = std::find_if(faults.begin(), faults.end(), isHere);
            if (around == 0) QVERIFY(fault != faults.end() && fault->kind == Kind::HoleOutside);
            if (around == 1) QCOMPARE(fault == faults.end(), isInOutline);
        }
    }
};

RUBBLE_TEST(PolygonFaultsTest)
#include "PolygonFaultsTest.moc"
