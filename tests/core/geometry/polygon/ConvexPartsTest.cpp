// Tests core/geometry/polygon/ConvexParts.cpp, core/geometry/polygon/HalfEdgeTriangles.cpp and
// core/geometry/polygon/IndexedCorners.cpp.
#include "core/geometry/polygon/ConvexParts.h"

#include "core/base/Random.h"
#include "core/geometry/polygon/HalfEdgeTriangles.h"
#include "core/geometry/polygon/IndexedCorners.h"
#include "core/geometry/polygon/PolygonFaults.h"
#include "core/geometry/predicates/Predicates.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/Polyomino.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

using namespace rubble;

namespace {

using DirectedEdges = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

std::vector<std::uint32_t> lowestOfEqualCorners(const IndexedCorners& corners) {
    std::map<std::pair<double, double>, std::uint32_t> first;
    std::vector<std::uint32_t> lowest;
    for (std::uint32_t corner = 0; corner < corners.cornerCount(); ++corner)
        lowest.push_back(
            first.emplace(std::pair{corners.points[corner].x, corners.points[corner].y}, corner).first->second);
    return lowest;
}

/// Verifies that parts are convex, cover the polygon and add no vertices; empty if so.
std::string faultOf(const Polygon& polygon, const IndexLoops& parts) {
    const IndexedCorners corners = indexedCorners(polygon);
    const std::vector<std::uint32_t> lowest = lowestOfEqualCorners(corners);
    DirectedEdges edges;
    double sum = 0.0;
    for (const std::vector<std::uint32_t>& part : parts) {
        Ring ring;
        for (std::size_t i = 0; i < part.size(); ++i) {
            if (part[i] >= corners.cornerCount()) return "a corner that is not the polygon's";
            ring.push_back(corners.points[part[i]]);
            ++edges[{lowest[part[i]], lowest[part[(i + 1) % part.size()]]}];
        }
        if (ring.size() < 3 || !isConvex(ring) || !(signedArea(ring) > 0.0)) return "a part that is not convex";
        sum += signedArea(ring);
    }
    const double whole = area(polygon);
    if (std::abs(sum - whole) > 1e-12 * signedArea(polygon.outer)) return "areas that do not sum up";
    for (std::uint32_t corner = 0; corner < corners.cornerCount(); ++corner) {
        const auto edge = edges.find({lowest[corner], lowest[corners.next[corner]]});
        if (edge == edges.end() || edge->second != 1) return "an edge of the polygon that is not there once";
        edges.erase(edge);
    }
    for (const auto& [edge, count] : edges)
        if (count != 1 || !edges.contains({edge.second, edge.first})) return "an inner edge without its opposite";
    return {};
}

/// Whether every inner edge is locally Delaunay.
bool isConstrainedDelaunay(const Polygon& polygon, const IndexLoops& parts) {
    const IndexedCorners corners = indexedCorners(polygon);
    const std::vector<std::uint32_t> lowest = lowestOfEqualCorners(corners);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> apex;
    for (const auto& part : parts)
        for (std::size_t i = 0; i < 3; ++i)
            apex[{lowest[part[i]], lowest[part[(i + 1) % 3]]}] = lowest[part[(i + 2) % 3]];
    const auto at = [&](std::uint32_t corner) { return corners.points[corner]; };
    for (const auto& [edge, corner] : apex) {
        const auto other = apex.find({edge.second, edge.first});
        if (other != apex.end() && inCircle(at(edge.first), at(edge.second), at(corner), at(other->second)) > 0)
            return false;
    }
    return true;
}

/// Verifies the triangles and the convex parts of a valid polygon; empty if correct.
std::string faultOf(const Polygon& polygon) {
    const Result<IndexLoops> cut = triangles(polygon);
    const Result<IndexLoops> parts = convexParts(polygon);
    if (!cut || !parts) return cut ? parts.error().message : cut.error().message;
    std::size_t count = polygon.outer.size() - 2;
    for (const Ring& hole : polygon.holes) count += hole.size() + 2;
    if (polygonFaults(polygon).empty() && cut->size() != count)
        return std::to_string(cut->size()) + " triangles, not " + std::to_string(count);
    if (!isConstrainedDelaunay(polygon, *cut)) return "triangles that are not Delaunay";
    if (parts->size() > cut->size()) return "more parts than triangles";
    const std::string fault = faultOf(polygon, *cut);
    return fault.empty() ? faultOf(polygon, *parts) : fault;
}

/// The convex hull, counter-clockwise (Andrew 1979).
Ring hullOf(std::vector<Vec2> points) {
    std::ranges::sort(points, {}, [](Vec2 point) { return std::pair(point.x, point.y); });
    Ring hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t first = hull.size();
        for (const Vec2 point : points) {
            while (hull.size() >= first + 2 && orient2d(hull[hull.size() - 2], hull.back(), point) <= 0)
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();
        std::ranges::reverse(points);
    }
    return hull;
}

Ring randomStar(Random& random, std::uint64_t corners, Vec2 centre, double radius) {
    Ring ring;
    for (std::uint64_t i = 0; i < corners; ++i) {
        const double angle =
            2.0 * std::numbers::pi * (static_cast<double>(i) + random.unit()) / static_cast<double>(corners);
        ring.push_back(centre + Vec2(std::cos(angle), std::sin(angle)) * radius * random.between(0.2, 1.0));
    }
    return ring;
}

/// A big star with a grid of small stars as holes.
Polygon starWithHoles(Random& random, std::uint64_t corners, int holesAcross, std::uint64_t holeCorners) {
    Polygon polygon{randomStar(random, corners, {0, 0}, 10.0), {}};
    const double pitch = 2.0 / holesAcross;  // the holes fill a square of side 2; inside a star of radius 2
    for (int i = 0; i < holesAcross * holesAcross; ++i) {
        const Vec2 centre = Vec2(i % holesAcross, i / holesAcross) * pitch + Vec2(pitch / 2.0 - 1.0);
        polygon.holes.push_back(randomStar(random, holeCorners, centre, 0.45 * pitch));
    }
    return withCanonicalWinding(std::move(polygon));
}

/// The face with every loop between two visits of a point as a separate ring.
Polygon splitAtRepeatedPoints(const Polygon& face) {
    std::vector<Ring> loops;
    const auto part = [&](const Ring& ring) {
        Ring open;
        for (const Vec2 point : ring) {
            const auto first = std::find(open.begin(), open.end(), point);
            if (first != open.end()) {
                loops.emplace_back(first, open.end());
                open.erase(first, open.end());
            }
            open.push_back(point);
        }
        loops.push_back(open);
    };
    part(face.outer);
    for (const Ring& hole : face.holes) part(hole);
    Polygon polygon;
    for (const Ring& loop : loops) {
        if (signedArea(loop) > 0.0)
            polygon.outer = loop;
        else
            polygon.holes.push_back(loop);
    }
    return polygon;
}

bool isSoundButForPinches(const Polygon& polygon) {
    for (const PolygonFault& fault : polygonFaults(polygon)) {
        if (fault.kind != PolygonFaultKind::Touching || fault.message.find("meet") == std::string::npos) return false;
    }
    return true;
}

}  // namespace

class ConvexPartsTest : public QObject {
    Q_OBJECT
private slots:
    void convexPolygonIsOnePart() {
        QCOMPARE(*convexParts(unitSquare()), (IndexLoops{{0, 1, 2, 3}}));
        const Polygon withStraightCorner{{{0, 0}, {1, 0}, {2, 0}, {2, 2}}, {}};
        QCOMPARE(*convexParts(withStraightCorner), (IndexLoops{{0, 1, 2, 3}}));
    }
    void squareHasTwoTriangles() {
        QCOMPARE(triangles(unitSquare())->size(), std::size_t{2});
        QCOMPARE(faultOf(unitSquare()), std::string());
    }
    void lShapeHasTwoParts() {
        QCOMPARE(convexParts(lShape())->size(), std::size_t{2});
        QCOMPARE(triangles(lShape())->size(), std::size_t{4});
        QCOMPARE(faultOf(lShape()), std::string());
    }
    void squareRingHasFourParts() {
        QCOMPARE(triangles(squareRing())->size(), std::size_t{8});
        QCOMPARE(convexParts(squareRing())->size(), std::size_t{4});
        QCOMPARE(faultOf(squareRing()), std::string());
    }
    void shorterDiagonalIsUsed() {
        const Polygon kite{{{0, 0}, {4, -1}, {8, 0}, {4, 1}}, {}};
        QCOMPARE(*triangles(kite), (IndexLoops{{0, 1, 3}, {1, 2, 3}}));
    }
    /// Without four cocircular corners, the Delaunay triangulation is unique.
    void convexRingsAreDelaunay() {
        Random random(11);
        for (int round = 0; round < 2000; ++round) {
            std::vector<Vec2> points(3 + random.below(40));
            for (Vec2& point : points) point = {random.unit(), random.unit()};
            const Polygon polygon{hullOf(std::move(points)), {}};
            const Ring& ring = polygon.outer;
            const Result<IndexLoops> cut = triangles(polygon);
            QVERIFY(cut.hasValue());
            QCOMPARE(cut->size(), ring.size() - 2);
            QVERIFY(std::ranges::is_sorted(*cut));
            for (const std::vector<std::uint32_t>& part : *cut) {
                QCOMPARE(orient2d(ring[part[0]], ring[part[1]], ring[part[2]]), 1);
                QCOMPARE(std::ranges::min(part), part[0]);
                for (const Vec2 corner : ring)
                    QVERIFY(inCircle(ring[part[0]], ring[part[1]], ring[part[2]], corner) <= 0);
            }
        }
    }
    void collinearCornersAreKept() {
        Ring ring;  // a square of side 10 with a corner every metre, and a notch so that it is not convex
        for (int i = 0; i < 10; ++i) ring.push_back({i, 0});
        for (int i = 0; i < 10; ++i) ring.push_back({10, i});
        for (int i = 10; i > 0; --i) ring.push_back({i, 10});
        ring.push_back({0, 10});
        ring.push_back({5, 5});
        QCOMPARE(faultOf({ring, {}}), std::string());
        QCOMPARE(convexParts({ring, {}})->size(), std::size_t{2});
    }
    void sliversAreTriangulatedExactly() {
        // The notch is one ulp deep.
        const Polygon notched{{{0, 0}, {1, 0}, {1, 1}, {0.5, std::nextafter(1.0, 0.0)}, {0, 1}}, {}};
        QCOMPARE(convexParts(notched)->size(), std::size_t{2});
        const Polygon plank{{{0, 0}, {1, 0}, {1, 1e-3}, {0.5, 1e-18}, {0, 1e-3}}, {}};
        QCOMPARE(faultOf(plank), std::string());
    }
    void selfTouchingFaceIsTriangulated() {
        // Two squares that meet in (1, 1), joined by a frame: the hole's corner lies on the outer boundary.
        Polyomino cells(3, 3);
        for (int x = 0; x < 3; ++x)
            for (int y = 0; y < 3; ++y) cells.set(x, y, !(x == 1 && y == 1) && !(x == 2 && y == 2));
        const Polygon face = cells.componentAt(0, 0);
        QCOMPARE(face.outer.size(), std::size_t{16});
        QVERIFY(face.holes.empty() && !polygonFaults(face).empty());
        QCOMPARE(faultOf(face), std::string());
        const Polygon split = splitAtRepeatedPoints(face);  // the same as an outer ring and a hole that touch
        QCOMPARE(split.outer.size(), std::size_t{12});
        QCOMPARE(split.holes.size(), std::size_t{1});
        QCOMPARE(faultOf(split), std::string());
    }
    void invalidPolygonsAreRejectedWithTheirFault() {
        const auto message = [](const Polygon& polygon) {
            const Result<IndexLoops> parts = convexParts(polygon);
            if (parts || triangles(polygon)) return std::string("not refused");
            return parts.error().code == ErrorCode::Crossing ? parts.error().message : std::string("wrong code");
        };
        const std::string start = "The polygon cannot be decomposed into convex parts. ";
        QCOMPARE(message({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}}),
                 start + "The outline crosses itself between points 0 and 2, at (0.5, 0.5).");
        QCOMPARE(message({}), start + "The outline needs at least 3 points but has 0.");
        QCOMPARE(message({{{0, 0}, {1, 0}}, {}}), start + "The outline needs at least 3 points but has 2.");
        QCOMPARE(message({{{0, 0}, {1, 0}, {2, 0}}, {}}),
                 start + "The outline encloses no area: all its points lie on one line.");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(message({{{0, 0}, {1, nan}, {1, 1}}, {}}),
                 start + "Point 1 of the outline is not a finite number: (1, nan).");
        Polygon outside = unitSquare();
        outside.holes = {reversed(rectangle({2, 2}, {3, 3}))};
        QCOMPARE(message(outside), start + "Hole 0 lies outside the outline.");
        QCOMPARE(message({reversed(unitSquare().outer), {}}), start + "The winding of its rings is reversed.");
        Polygon wrongHole = squareRing();
        wrongHole.holes[0] = reversed(wrongHole.holes[0]);
        QCOMPARE(message(wrongHole), start + "The winding of its rings is reversed.");
        // Only convex corners, but winding number two.
        QVERIFY(
            message({{{0, -3}, {2, 3}, {-3, -1}, {3, -1}, {-2, 3}}, {}}).starts_with(start + "The outline crosses"));
        // A spike has no reflex corner either.
        QVERIFY(message({{{0, 0}, {2, 0}, {1, 0}, {0, 1}}, {}}).starts_with(start + "The outline touches itself"));
    }
    void randomStarsAreTriangulated() {
        Random random(logged(101));
        for (int round = 0; round < 1000; ++round) {
            const Polygon polygon{randomStar(random, 3 + random.below(30), {1e3, -1e3}, 1.0), {}};
            if (!polygonFaults(polygon).empty()) continue;
            QCOMPARE(faultOf(withCanonicalWinding(polygon)), std::string());
        }
    }
    void starsWithHolesAreTriangulated() {
        Random random(logged(102));
        for (int round = 0; round < 100; ++round) {
            const Polygon polygon = starWithHoles(random, 12 + random.below(50), 1 + round % 5, 3 + random.below(9));
            if (!polygonFaults(polygon).empty()) continue;
            QCOMPARE(faultOf(polygon), std::string());
        }
    }
    void latticePolygonsAreTriangulatedOrRejected() {
        Random random(logged(103));
        int cut = 0;
        for (int round = 0; round < 20000; ++round) {
            const std::uint64_t extent = 3 + random.below(8);
            Polygon polygon{randomLatticeRing(random, 8, extent), {}};
            for (std::uint64_t holes = random.below(3); holes > 0; --holes)
                polygon.holes.push_back(randomLatticeRing(random, 4, extent));
            polygon = withCanonicalWinding(std::move(polygon));
            const Result<IndexLoops> parts = convexParts(polygon);
            if (polygonFaults(polygon).empty()) {
                QCOMPARE(faultOf(polygon), std::string());
                ++cut;
            } else if (parts) {
                QVERIFY(isSoundButForPinches(polygon));
                QCOMPARE(faultOf(polygon, *parts), std::string());
            }
        }
        QVERIFY(cut > 1000);
    }
    void selfTouchingLatticeFacesAreTriangulated() {
        Random random(logged(104));
        int pinched = 0;
        for (int round = 0; round < 2000; ++round) {
            const int width = 3 + static_cast<int>(random.below(5)), height = 3 + static_cast<int>(random.below(5));
            Polyomino cells(width, height);
            for (int x = 0; x < width; ++x)
                for (int y = 0; y < height; ++y) cells.set(x, y, random.below(10) < 7);
            cells.set(0, 0, true);
            const Polygon face = cells.componentAt(0, 0);
            pinched += polygonFaults(face).empty() ? 0 : 1;
            QVERIFY2(faultOf(face).empty(), qPrintable(QString("round %1: %2").arg(round).arg(faultOf(face).c_str())));
            QCOMPARE(faultOf(splitAtRepeatedPoints(face)), std::string());
        }
        QVERIFY(pinched > 300);
    }
    void stepsGrowLikeNLogN() {
        Random random(logged(105));
        const Polygon small = starWithHoles(random, 1000, 20, 25), large = starWithHoles(random, 4000, 40, 25);
        const auto [sweep, flips] = stepsFor(small);  // 11,000 corners
        const auto [largeSweep, largeFlips] = stepsFor(large);
        qInfo("sweep: %zu, then %zu steps; Delaunay: %zu, then %zu tests", sweep, largeSweep, flips, largeFlips);
        QVERIFY(sweep > 0 && largeSweep < 6 * sweep);  // 16 times if quadratic
        QVERIFY(flips > 0 && largeFlips < 6 * flips);
        QCOMPARE(faultOf(small), std::string());
        QCOMPARE(faultOf(large), std::string());
    }

private:
    /// The steps of the sweep, and the edges tested by makeDelaunay().
    static std::pair<std::size_t, std::size_t> stepsFor(const Polygon& polygon) {
        const IndexedCorners corners = indexedCorners(polygon);
        std::size_t steps = 0;
        std::optional<HalfEdgeTriangles> triangles = linkTriangles(*sweepTriangulation(corners, &steps), corners);
        return {steps, makeDelaunay(*triangles, corners.points)};
    }
    static std::uint64_t logged(std::uint64_t seed) {
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        return seed;
    }
};

RUBBLE_TEST(ConvexPartsTest)
#include "ConvexPartsTest.moc"
