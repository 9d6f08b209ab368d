// Tests core/fracture/planes/SolidSection.cpp and core/fracture/planes/SectionPlane.cpp.
#include "core/fracture/planes/SolidSection.h"

#include "core/base/Stopwatch.h"
#include "core/fracture/solid/SolidCut.h"
#include "core/geometry/mesh/SolidMesh.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <numbers>

using namespace rubble;
using namespace rubble::test;

namespace {

std::shared_ptr<const SolidPartition> partitionOf(const TriangleMesh& mesh, const std::vector<Vec3>& seeds) {
    Result<SolidPartition> partition = cutSolid(mesh, seeds);
    return std::make_shared<const SolidPartition>(partition ? std::move(*partition) : SolidPartition());
}

double areaOf(const std::vector<Polygon>& polygons) {
    double sum = 0.0;
    for (const Polygon& polygon : polygons) sum += area(polygon);
    return sum;
}

Vec3 randomDirection(Random& random) {
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    return Vec3(x, y, random.between(-1, 1)) + Vec3(0.0, 0.0, 1e-3);
}

using EdgeCounts = std::map<std::array<double, 4>, int>;  // forward less backward, from the smaller end

void count(const std::vector<Polygon>& polygons, int sign, EdgeCounts& counts) {
    for (const Polygon& polygon : polygons) {
        for (const auto& [from, to] : edgesOf(polygon)) {
            if (from == to) continue;
            const bool isForward = lexicographicLess(from, to);
            const Vec2 low = isForward ? from : to, high = isForward ? to : from;
            counts[{low.x, low.y, high.x, high.y}] += isForward ? sign : -sign;
        }
    }
}

/// What is wrong with a section: edges of fragments that are neither common, bit for bit, nor of the outline; areas.
/// Counts the edges without a counterpart.
std::string sectionFault(const SolidSection& section, double size, int& lonely) {
    EdgeCounts counts;
    count(section.outline, -1, counts);
    double sum = 0.0;
    for (const SolidSection::Part& part : section.parts) {
        count(part.polygons, 1, counts);
        sum += part.area;
        if (std::abs(part.area - areaOf(part.polygons)) > 0.0) return "The area of a part is not that of its polygons.";
        for (const Polygon& polygon : part.polygons) {
            if (signedArea(polygon.outer) <= 0.0) return "A polygon is not counter-clockwise.";
        }
    }
    // Loops without area, as triangles without area in the plane leave them, are in one of both only.
    Vec2 open(0.0);
    double doubleArea = 0.0;
    for (const auto& [edge, balance] : counts) {
        const Vec2 from(edge[0], edge[1]), to(edge[2], edge[3]);
        open += static_cast<double>(balance) * (to - from);
        doubleArea += balance * cross(from, to);
        if (balance != 0) ++lonely;
    }
    if (glm::length(open) > 1e-13 || std::abs(doubleArea) > 1e-13) return "An edge has one side.";
    if (std::abs(sum - section.area) > 1e-12 * std::max(section.area, size * size * 1e-3)) {
        return "The areas differ by " + std::to_string(sum / section.area - 1.0);
    }
    return {};
}

/// The integral of the areas of sections, by the midpoint rule.
double volumeBySections(const SolidSlicer& slicer, int count) {
    const double step = (slicer.maxHeight() - slicer.minHeight()) / count;
    double sum = 0.0;
    for (int k = 0; k < count; ++k) sum += step * slicer.at(slicer.minHeight() + (k + 0.5) * step).area;
    return sum;
}

}  // namespace

class SolidSectionTest : public QObject {
    Q_OBJECT
private slots:
    void planesMapBothWays() {
        Random random(1);
        for (int k = 0; k < 200; ++k) {
            const Vec3 point = randomDirection(random), normal = randomDirection(random);
            const SectionPlane plane = k < 3 ? axisPlane(k, 0.75) : planeThrough(point, 3.0 * normal);
            QVERIFY(std::abs(glm::length(plane.x) - 1.0) < 1e-15 && std::abs(glm::length(plane.y) - 1.0) < 1e-15);
            QVERIFY(std::abs(glm::dot(plane.x, plane.y)) < 1e-15);
            if (k >= 3) QVERIFY(glm::length(plane.normal() - glm::normalize(normal)) < 1e-14);
            QVERIFY(std::abs(plane.movedUp(2.0).heightOf(plane.origin) + 2.0) < 1e-14);
            const Vec2 drawn(random.between(-1, 1), random.between(-1, 1));
            QVERIFY(glm::length(plane.inPlane(plane.inSpace(drawn) + plane.normal()) - drawn) < 1e-14);
        }
        QCOMPARE(axisPlane(2, 0.75), (SectionPlane{{0, 0, 0.75}, {1, 0, 0}, {0, 1, 0}}));
        QCOMPARE(axisPlane(0, 0.75).normal(), Vec3(1, 0, 0));
        QCOMPARE(axisPlane(1, 0.75).normal(), Vec3(0, 1, 0));
    }
    void aCubeHasSquares() {
        const TriangleMesh cube = cubes({{0, 0, 0}});
        for (int axis = 0; axis < 3; ++axis) {
            const SolidSection section = sectionOf(cube, axisPlane(axis, 0.25));
            QCOMPARE(section.parts.size(), 1u);
            QVERIFY(std::abs(section.area - 1.0) < 1e-15);
            QCOMPARE(section.outline, section.parts[0].polygons);
            QCOMPARE(fragmentAt(section, {0.5, 0.5}), 0u);
            QCOMPARE(fragmentAt(section, {1.5, 0.5}), kNone);
        }
        // A hexagon: through the centre, across the diagonal.
        QVERIFY(std::abs(sectionOf(cube, planeThrough(Vec3(0.5), Vec3(1.0))).area - 0.75 * std::sqrt(3.0)) < 1e-14);
    }
    /// Points in the plane are above it: the section is that of a plane a little lower.
    void planesInFacesCutWhatIsBelow() {
        const TriangleMesh cube = cubes({{0, 0, 0}});
        QCOMPARE(sectionOf(cube, axisPlane(2, 0.0)).parts.size(), 0u);
        QCOMPARE(sectionOf(cube, axisPlane(2, 1.0)).area, 1.0);
        QCOMPARE(sectionOf(cube, axisPlane(2, 1.5)).parts.size(), 0u);
        const auto cubelets = partitionOf(cube, {{0.5, 0.5, 0.25}, {0.5, 0.5, 0.75}});
        const SolidSection between = sectionOf(*cubelets, axisPlane(2, 0.5));
        QCOMPARE(between.parts.size(), 1u);
        QCOMPARE(between.parts[0].fragment, 0u);
        QCOMPARE(between.area, 1.0);
        // Through an edge from below and from the side.
        QCOMPARE(sectionOf(cube, planeThrough(Vec3(1.0), Vec3(1.0, 1.0, 0.0))).area, 0.0);
        QVERIFY(std::abs(sectionOf(cube, planeThrough(Vec3(0.5), Vec3(1.0, 1.0, 0.0))).area - std::sqrt(2.0)) < 1e-14);
    }
    void aTorusHasRingsAndAHole() {
        const TriangleMesh mesh = torus(400, 200);
        const double pi = std::numbers::pi;
        const SolidSection flat = sectionOf(mesh, axisPlane(2, 0.1));
        QCOMPARE(flat.outline.size(), 1u);
        QCOMPARE(flat.outline[0].holes.size(), 1u);
        const double width = 2.0 * std::sqrt(0.16 - 0.01);
        QVERIFY(std::abs(flat.area / (2.0 * pi * width) - 1.0) < 1e-3);
        const SolidSection upright = sectionOf(mesh, axisPlane(0, 0.0));
        QCOMPARE(upright.outline.size(), 2u);
        QVERIFY(std::abs(upright.area / (2.0 * pi * 0.16) - 1.0) < 1e-3);
        QCOMPARE(fragmentAt(flat, {0.0, 0.0}), kNone);
        QCOMPARE(fragmentAt(flat, {1.0, 0.0}), 0u);
    }
    void areasIntegrateToTheVolume() {
        const TriangleMesh sponge = mengerSponge(1);
        QVERIFY(std::abs(volumeBySections(SolidSlicer(sponge, axisPlane(0, 0.0)), 6) - 20.0) < 1e-12);
        Random random(5);
        for (const TriangleMesh& mesh : {bumpySphere(24), torus(40, 16)}) {
            for (int k = 0; k < 10; ++k) {
                const SolidSlicer slicer(mesh, planeThrough(Vec3(0.3), randomDirection(random)));
                QVERIFY(std::abs(volumeBySections(slicer, 400) / signedVolume(mesh) - 1.0) < 1e-4);
            }
        }
    }
    void fragmentsAreFoundWhereTheirSeedIsNearest() {
        const TriangleMesh mesh = bumpySphere(24);
        const std::vector<Vec3> seeds = seedsInBox(mesh, 100, 3);
        const auto partition = partitionOf(mesh, seeds);
        Random random(4);
        int inside = 0;
        for (int k = 0; k < 20; ++k) {
            const SolidSection section = sectionOf(*partition, planeThrough(Vec3(0.1), randomDirection(random)));
            for (int j = 0; j < 50; ++j) {
                const Vec2 at(random.between(-1, 1), random.between(-1, 1));
                const std::uint32_t fragment = fragmentAt(section, at);
                if (fragment == kNone) continue;
                ++inside;
                const Vec3 point = section.plane.inSpace(at);
                const auto distance = [&](Vec3 seed) { return glm::length(seed - point); };
                QCOMPARE(seeds[partition->seedOfFragment[fragment]], std::ranges::min(seeds, {}, distance));
            }
        }
        QVERIFY(inside > 300);
    }
    void randomPlanesCutRight() {
        const std::vector<TriangleMesh> shapes = {bumpySphere(24), torus(40, 16), mengerSponge(1)};
        int lonely = 0;
        for (std::size_t shape = 0; shape < shapes.size(); ++shape) {
            const TriangleMesh& mesh = shapes[shape];
            const auto partition = partitionOf(mesh, seedsInBox(mesh, 80, shape));
            Random random(10 + shape);
            for (int k = 0; k < 100; ++k) {
                const Vec3 through =
                    k % 2 == 0 ? mesh.points[random.below(mesh.points.size())]
                               : partition->origin + partition->points[random.below(partition->points.size())];
                const SectionPlane plane =
                    k % 4 < 2 ? planeThrough(through, randomDirection(random)) : axisPlane(k % 3, through[k % 3]);
                const SolidSection section = sectionOf(*partition, plane);
                const std::string fault = sectionFault(section, boundsOf(mesh).diagonal(), lonely);
                QVERIFY2(fault.empty(), qPrintable(QString("%1, plane %2: ").arg(shape).arg(k) + fault.c_str()));
                const double whole = sectionOf(mesh, plane).area;
                QVERIFY(std::abs(section.area - whole) < 1e-10);
            }
        }
        QCOMPARE(lonely, 0);
    }
    /// RUBBLE_LONG: 20,000 cases, else 2,000.
    void planesThroughLatticePointsCutRight() {
        const int wanted = qEnvironmentVariableIsSet("RUBBLE_LONG") ? 20'000 : 2'000;
        int cut = 0, lonely = 0;
        for (std::uint64_t seed = 0; cut < wanted; ++seed) {
            Random random(seed);
            const TriangleMesh mesh = randomLatticeMesh(random, seed % 2 == 1);
            if (mesh.triangles.empty()) continue;
            const auto lattice = [&](double scale) {
                const double x = static_cast<double>(random.below(5)), y = static_cast<double>(random.below(5));
                return scale * Vec3(x, y, static_cast<double>(random.below(5)));
            };
            std::vector<Vec3> seeds(1 + random.below(8));
            for (Vec3& point : seeds) point = lattice(0.5);
            const auto partition = partitionOf(mesh, seeds);
            QVERIFY(partition->fragmentCount() > 0);
            const Vec3 direction = lattice(1.0) - Vec3(2.0, 2.0, 1.0);
            if (direction == Vec3(0.0)) continue;
            ++cut;
            const SolidSlicer slicer(partition, planeThrough(lattice(0.5), direction));
            for (const double height : {0.0, 0.25, 0.5}) {
                const SolidSection section = slicer.at(height);
                const std::string fault = sectionFault(section, 3.0, lonely);
                QVERIFY2(fault.empty(), qPrintable(QString("seed %1: ").arg(seed) + fault.c_str()));
                QVERIFY(std::abs(section.area - sectionOf(mesh, section.plane).area) < 1e-10);
            }
        }
        QVERIFY2(lonely * 200 <= cut, qPrintable(QString::number(lonely)));
    }
    void aThousandCellsOfALargeMeshAreFast() {
        const TriangleMesh mesh = bumpySphere(224);  // 100,000 triangles
        const auto partition = partitionOf(mesh, seedsInBox(mesh, 1000, 6));
        const SolidSlicer slicer(partition, axisPlane(2, 0.0));
        double slowest = 0.0;
        int lonely = 0;
        for (int k = 0; k < 40; ++k) {
            Stopwatch watch;
            const SolidSection section = slicer.at(-0.95 + 0.0475 * k);
            slowest = std::max(slowest, watch.lap());
            QVERIFY(sectionFault(section, 2.0, lonely).empty());
        }
        QCOMPARE(lonely, 0);
        qInfo("slowest section: %.2f ms", slowest);
        QVERIFY(slowest < 200.0);
    }
};

RUBBLE_TEST(SolidSectionTest)
#include "SolidSectionTest.moc"
