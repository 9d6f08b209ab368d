#include "core/fracture/delaunay/SiteInsertion.h"

#include "core/base/Random.h"
#include "core/fracture/verify/VerifyDelaunay.h"
#include "core/geometry/predicates/Predicates.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>

Q_DECLARE_METATYPE(rubble::Vec2)

using namespace rubble;

namespace {

constexpr std::uint32_t kInserted = 2000;  // sites that are triangulated already
constexpr std::uint32_t kNew = 3000;

std::vector<Vec2> randomPoints(std::uint64_t seed, std::size_t count) {
    Random random(seed);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back({random.unit(), random.unit()});
    return points;
}

/// A triangulation of sites [0, kInserted) with room for kNew more, and the remaining work.
struct Unfinished {
    Delaunay delaunay;
    InsertionWork work;
    SiteRange range{kInserted / 2, kInserted + kNew - 1};  // half of the plane, and the new sites
};
Unfinished unfinished() {
    Unfinished all{*triangulate(randomPoints(1, kInserted)), {}};
    Delaunay& delaunay = all.delaunay;
    const Delaunay added = *triangulate(randomPoints(2, kNew));
    delaunay.sites.insert(delaunay.sites.end(), added.sites.begin(), added.sites.end());
    for (const std::uint32_t seed : added.seedOf) delaunay.seedOf.push_back(kInserted + seed);
    delaunay.triangles.resize(2 * delaunay.sites.size() - 2);
    for (std::uint32_t site = kInserted; site < kInserted + kNew; ++site) all.work.sites.push_back(site);
    all.work.free = {{2 * kInserted - 2, 2 * (kInserted + kNew) - 2}};
    return all;
}

std::uint32_t firstOwned(const Unfinished& all) {
    std::uint32_t t = 0;
    while (!all.range.owns(all.delaunay.triangles[t])) ++t;
    return t;
}

/// Points on a circle, up to rounding, and its centre.
std::vector<Vec2> pointsOnCircle(std::uint64_t seed, std::size_t count, Vec2 centre, double scale) {
    std::vector<Vec2> points = {centre};
    for (const Vec2 point : randomPoints(seed, count)) {
        const Vec2 offset = point - Vec2{0.5, 0.5};
        points.push_back(centre + offset * (scale / std::hypot(offset.x, offset.y)));
    }
    return points;
}

/// The exact sign of the in-circle determinant, or for a ghost of the side of the hull edge.
int exactConflict(const Delaunay& delaunay, std::array<std::uint32_t, 3> corner, Vec2 p) {
    const auto ghost = std::ranges::find(corner, kGhost);
    if (ghost != corner.end()) std::ranges::rotate(corner, ghost);
    const Vec2 second = delaunay.sites[corner[1]], third = delaunay.sites[corner[2]];
    if (ghost != corner.end()) return orient2dExact(second, third, p);
    return inCircleExact(delaunay.sites[corner[0]], second, third, p);
}

}  // namespace

class SiteInsertionTest : public QObject {
    Q_OBJECT
private slots:
    void rangeChangesOnlyItsOwnTriangles() {
        Unfinished all = unfinished();
        const UninitializedVector<Delaunay::Triangle> before = all.delaunay.triangles;
        Triangulation triangulation(all.delaunay, 2 * kInserted - 2);
        insertSites(triangulation, all.range, firstOwned(all), all.work, {});
        QVERIFY(all.work.sites.size() > kNew / 3 && all.work.sites.size() < kNew);
        for (std::uint32_t t = 0; t < 2 * kInserted - 2; ++t) {
            if (all.range.owns(before[t])) continue;
            QVERIFY(std::ranges::equal(all.delaunay.triangles[t].corner, before[t].corner));
        }
    }
    void remainingSitesAreInsertedAfterwards() {
        Unfinished all = unfinished();
        Triangulation triangulation(all.delaunay, 2 * kInserted - 2);
        insertSites(triangulation, all.range, firstOwned(all), all.work, {});
        insertSites(triangulation, firstOwned(all), all.work, {});
        QVERIFY(all.work.sites.empty());
        std::vector<Vec2> seeds = randomPoints(1, kInserted);
        std::ranges::copy(randomPoints(2, kNew), std::back_inserter(seeds));
        QCOMPARE(verifyDelaunay(all.delaunay, seeds).value_or(""), std::string());
    }
    void planeSignIsExactBeyondTheBound_data() {
        QTest::addColumn<Vec2>("centre");
        QTest::addColumn<double>("scale");
        QTest::newRow("a unit circle about zero") << Vec2{0.0, 0.0} << 1.0;
        QTest::newRow("a small one far away") << Vec2{1e6, -3e6} << 1e-7;
        QTest::newRow("a few steps of the coordinates wide") << Vec2{1e6, 1e6} << 1e-9;
    }
    void planeSignIsExactBeyondTheBound() {
        QFETCH(Vec2, centre);
        QFETCH(double, scale);
        Delaunay delaunay = *triangulate(pointsOnCircle(3, 200, centre, scale));
        const auto count = static_cast<std::uint32_t>(delaunay.triangles.size());
        const Triangulation triangulation(delaunay, count);
        int sure = 0;
        for (std::uint32_t t = 0; t < count; ++t) {
            for (const Vec2 site : delaunay.sites) {
                const double depth = triangulation.planes[t].depth(triangulation.lifted(site));
                if (std::abs(depth) <= triangulation.inCircleBound) continue;
                QCOMPARE(depth > 0.0 ? 1 : -1,
                         exactConflict(delaunay, std::to_array(delaunay.triangles[t].corner), site));
                ++sure;
            }
        }
        QVERIFY(sure > 0);
    }
};

RUBBLE_TEST(SiteInsertionTest)
#include "SiteInsertionTest.moc"
