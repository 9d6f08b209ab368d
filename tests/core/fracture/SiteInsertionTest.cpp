#include "core/fracture/SiteInsertion.h"

#include "core/base/Random.h"
#include "core/fracture/Verify.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

namespace {

constexpr std::uint32_t kThere = 2000;  // sites that are triangulated already
constexpr std::uint32_t kNew = 3000;

std::vector<Vec2> randomPoints(std::uint64_t seed, std::size_t count) {
    Random random(seed);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back({random.unit(), random.unit()});
    return points;
}

/// A triangulation of sites [0, kThere) with room for kNew more, and what is to be done.
struct Unfinished {
    Delaunay delaunay;
    InsertionWork work;
    SiteRange range{kThere / 2, kThere + kNew - 1};  // half of the plane, and the new sites
};
Unfinished unfinished() {
    Unfinished all{*triangulate(randomPoints(1, kThere)), {}};
    Delaunay& delaunay = all.delaunay;
    const Delaunay added = *triangulate(randomPoints(2, kNew));
    delaunay.sites.insert(delaunay.sites.end(), added.sites.begin(), added.sites.end());
    for (const std::uint32_t seed : added.seedOf) delaunay.seedOf.push_back(kThere + seed);
    delaunay.triangles.resize(2 * delaunay.sites.size() - 2);
    for (std::uint32_t site = kThere; site < kThere + kNew; ++site) all.work.sites.push_back(site);
    all.work.free = {{2 * kThere - 2, 2 * (kThere + kNew) - 2}};
    return all;
}

std::uint32_t firstOwned(const Unfinished& all) {
    std::uint32_t t = 0;
    while (!all.range.owns(all.delaunay.triangles[t])) ++t;
    return t;
}

}  // namespace

class SiteInsertionTest : public QObject {
    Q_OBJECT
private slots:
    void aRangeLeavesTheTrianglesOfOthersAlone() {
        Unfinished all = unfinished();
        const RawVector<Delaunay::Triangle> before = all.delaunay.triangles;
        const Triangulation triangulation(all.delaunay);
        insertSites(triangulation, all.range, firstOwned(all), all.work, {});
        QVERIFY(all.work.sites.size() > kNew / 3 && all.work.sites.size() < kNew);
        for (std::uint32_t t = 0; t < 2 * kThere - 2; ++t) {
            if (all.range.owns(before[t])) continue;
            QVERIFY(std::ranges::equal(all.delaunay.triangles[t].corner, before[t].corner));
        }
    }
    void whatARangeLeftIsInsertedAfterwards() {
        Unfinished all = unfinished();
        const Triangulation triangulation(all.delaunay);
        insertSites(triangulation, all.range, firstOwned(all), all.work, {});
        insertSites(triangulation, firstOwned(all), all.work, {});
        QVERIFY(all.work.sites.empty());
        std::vector<Vec2> seeds = randomPoints(1, kThere);
        std::ranges::copy(randomPoints(2, kNew), std::back_inserter(seeds));
        QCOMPARE(verifyDelaunay(all.delaunay, seeds).value_or(""), std::string());
    }
};

QTEST_APPLESS_MAIN(SiteInsertionTest)
#include "SiteInsertionTest.moc"
