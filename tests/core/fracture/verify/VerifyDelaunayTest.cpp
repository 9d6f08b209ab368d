#include "core/fracture/verify/VerifyDelaunay.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <utility>

using namespace rubble;

namespace {

/// A wide rhombus and a copy of its first corner: the triangles share the edge between corners 1 and 3.
const std::vector<Vec2> kRhombus = {{0, 0}, {2, -1}, {4, 0}, {2, 1}, {0, 0}};

/// The fault that is found after a valid triangulation is damaged.
template <class Break>
std::string delaunayFaultAfter(Break breakIt) {
    Delaunay delaunay = triangulate(kRhombus).value();
    std::vector<Vec2> seeds = kRhombus;
    breakIt(delaunay, seeds);
    return verifyDelaunay(delaunay, seeds).value_or("");
}

std::uint32_t siteOf(const Delaunay& delaunay, std::uint32_t seed) {
    std::uint32_t site = 0;
    while (delaunay.seedOf[site] != seed) ++site;
    return site;
}

/// Moves a seed and its site, leaving the triangles as they are.
void move(Delaunay& delaunay, std::vector<Vec2>& seeds, std::uint32_t seed, Vec2 to) {
    seeds[seed] = delaunay.sites[siteOf(delaunay, seed)] = to;
}

}  // namespace

/// Each test damages a valid triangulation in one way, which must be found.
class VerifyDelaunayTest : public QObject {
    Q_OBJECT
private slots:
    void validTriangulationPasses() {
        QCOMPARE(delaunayFaultAfter([](Delaunay&, std::vector<Vec2>&) {}), std::string());
    }
    void missingSeedIsFound() {
        QCOMPARE(delaunayFaultAfter([](Delaunay& d, std::vector<Vec2>&) { d.duplicates.clear(); }),
                 std::string("Seed 4 is missing."));
        QCOMPARE(delaunayFaultAfter([](Delaunay& d, std::vector<Vec2>&) { d.seedOf.pop_back(); }),
                 std::string("The number of sites differs from the number of their seeds."));
    }
    void movedSiteIsFound() {
        const std::string fault =
            delaunayFaultAfter([](Delaunay& d, std::vector<Vec2>&) { d.sites[siteOf(d, 2)].x += 1e-15; });
        QVERIFY2(fault.find("is not where seed 2 is.") != fault.npos, fault.c_str());
    }
    void wrongDuplicatesAreFound() {
        QCOMPARE(delaunayFaultAfter([](Delaunay& d, std::vector<Vec2>&) {
                     d.duplicates[0] = {4, 1};
                 }),
                 std::string("Seeds 4 and 1 are not equal."));
        QCOMPARE(delaunayFaultAfter([](Delaunay& d, std::vector<Vec2>&) {
                     d.duplicates[0] = {4, 4};
                 }),
                 std::string("Seed 4 is not a duplicate of seed 4."));
    }
    void wrongTwinsAreFound() {
        const std::string fault = delaunayFaultAfter(
            [](Delaunay& d, std::vector<Vec2>&) { std::swap(d.triangles[0].twin[0], d.triangles[0].twin[1]); });
        QVERIFY2(fault.find("and its twin do not agree.") != fault.npos, fault.c_str());
    }
    void missingTriangleIsFound() {
        QCOMPARE(delaunayFaultAfter([](Delaunay& d, std::vector<Vec2>&) { d.triangles.pop_back(); }),
                 std::string("There are 5 triangles with ghosts instead of 6."));
    }
    void wrongDiagonalIsFound() {
        const std::string fault = delaunayFaultAfter([](Delaunay& d, std::vector<Vec2>& seeds) {
            move(d, seeds, 1, {2, -5});
            move(d, seeds, 3, {2, 5});
        });
        QVERIFY2(fault.find("lies in the circle of triangle") != fault.npos, fault.c_str());
    }
    void wrongTieBreakIsFound() {
        // A square: its diagonal must start at seed 0, but here it connects seeds 1 and 3.
        const std::string fault = delaunayFaultAfter([](Delaunay& d, std::vector<Vec2>& seeds) {
            move(d, seeds, 1, {2, -2});
            move(d, seeds, 3, {2, 2});
        });
        QVERIFY2(fault.find("lies in the circle of triangle") != fault.npos, fault.c_str());
    }
    void clockwiseTriangleIsFound() {
        const std::string fault = delaunayFaultAfter([](Delaunay& d, std::vector<Vec2>& seeds) {
            move(d, seeds, 2, {1, 0});
        });
        QVERIFY(!fault.empty());
    }
};

RUBBLE_TEST(VerifyDelaunayTest)
#include "VerifyDelaunayTest.moc"
