#include "core/base/Random.h"
#include "core/geometry/mesh/MeshWelding.h"
#include "core/geometry/mesh/SolidMesh.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/Solids.h"

#include <QTest>

using namespace rubble;

namespace {

constexpr double kSolidTolerance = 1e-5;

std::string solidFault(const TriangleMesh& mesh) { return errorText(orientedSolid(mesh, kSolidTolerance)); }

/// Unit cubes that share points.
TriangleMesh weldedCubes(const std::vector<Vec3>& places) {
    TriangleMesh mesh;
    for (const Vec3 place : places) mesh = joined(mesh, placed(prismSolid(unitSquare(), 1.0), {place}));
    return welded(mesh)->mesh;
}

}  // namespace

class SolidMeshTest : public QObject {
    Q_OBJECT
private slots:
    void solidIsUnchanged() {
        const Result<SolidMesh> solid = orientedSolid(prismSolid(squareRing(), 0.5), kSolidTolerance);
        QVERIFY(solid.hasValue());
        QVERIFY(solid->flipped.empty());
        QVERIFY(std::abs(solid->volume - 6.0) < 1e-12);
    }
    void trianglesAreFlippedOutwardAndListed() {
        TriangleMesh box = prismSolid(unitSquare(), 1.0);
        const auto right = box.triangles;
        std::swap(box.triangles[3][0], box.triangles[3][1]);
        std::swap(box.triangles[7][0], box.triangles[7][1]);
        const Result<SolidMesh> solid = orientedSolid(box, kSolidTolerance);
        QCOMPARE(solid->flipped, (std::vector<std::uint32_t>{3, 7}));
        QVERIFY(std::abs(solid->volume - 1.0) < 1e-12);
        for (auto& triangle : box.triangles) std::swap(triangle[0], triangle[1]);
        QCOMPARE(orientedSolid(box, kSolidTolerance)->flipped.size(), std::size_t{10});
    }
    void faultsAreCounted() {
        TriangleMesh box = prismSolid(unitSquare(), 1.0);
        QCOMPARE(solidFault(joined(box, placed(box, {{3, 0, 0}}))), "The mesh consists of 2 disconnected parts.");
        TriangleMesh doubled = box;
        doubled.triangles.push_back(box.triangles[0]);
        QCOMPARE(solidFault(doubled), "The mesh is not manifold: 3 edges have more than two faces.");
        box.triangles.pop_back();
        QCOMPARE(solidFault(box), "The mesh is not closed: 3 edges have one face only.");
        QCOMPARE(solidFault({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}),
                 "The mesh encloses no volume.");
    }
    void partsSharingOnlyAPointAreRejected() {
        const TriangleMesh one{
            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
            {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 5, 4}, {0, 4, 6}, {0, 6, 5}, {4, 5, 6}}};
        QCOMPARE(solidFault(one), "The mesh consists of parts that touch only at single points.");
    }
    void projectivePlaneIsNotOrientable() {
        const TriangleMesh plane{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}},
                                 {{0, 1, 2},
                                  {0, 2, 3},
                                  {0, 3, 4},
                                  {0, 4, 5},
                                  {0, 5, 1},
                                  {1, 2, 4},
                                  {2, 3, 5},
                                  {3, 4, 1},
                                  {4, 5, 2},
                                  {5, 1, 3}}};
        QCOMPARE(solidFault(plane), "The mesh is not orientable: its faces cannot all be oriented the same way.");
    }
    void partsAreNumberedByTheirFirstTriangle() {
        const TriangleMesh box = prismSolid(unitSquare(), 1.0);
        const std::vector<std::uint32_t> parts = connectedParts(joined(box, placed(box, {{3, 0, 0}})));
        QCOMPARE(parts.size(), std::size_t{24});
        QCOMPARE(parts[11], 0u);
        QCOMPARE(parts[12], 1u);
    }
    void solidsThatTouchAreParts() {
        const auto counts = [](const TriangleMesh& mesh) {
            std::vector<std::uint32_t> triangles;
            for (const std::uint32_t part : solidParts(mesh)) {
                triangles.resize(std::max<std::size_t>(triangles.size(), part + 1), 0);
                ++triangles[part];
            }
            return triangles;
        };
        using Counts = std::vector<std::uint32_t>;
        for (const Vec3 next : {Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(1, 0, 0)}) {
            TriangleMesh two = weldedCubes({{0, 0, 0}, next});
            QCOMPARE(counts(two), (Counts{12, 12}));
            for (auto& triangle : two.triangles) std::swap(triangle[0], triangle[1]);  // inside out
            QCOMPARE(counts(two), (Counts{12, 12}));
        }
        // A face too many leaves the whole as it is, and so do windings that contradict each other.
        TriangleMesh two = weldedCubes({{0, 0, 0}, {1, 1, 0}});
        two.triangles.push_back(two.triangles[0]);
        QCOMPARE(counts(two), (Counts{25}));
        TriangleMesh doubled = prismSolid(unitSquare(), 1.0);
        const std::vector<std::array<std::uint32_t, 3>> outside = doubled.triangles;
        for (const auto& [a, b, c] : outside) doubled.triangles.push_back({b, a, c});
        QCOMPARE(counts(doubled), (Counts{24}));
    }
    /// Cubes at random places of a grid, each a part wherever it touches others.
    void everyCubeOfAGridIsAPart() {
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            Random random(seed);
            std::vector<Vec3> places;
            for (int x = 0; x < 4; ++x)
                for (int y = 0; y < 4; ++y)
                    for (int z = 0; z < 4; ++z)
                        if (random.below(seed % 2 == 0 ? 2 : 4) == 0) places.emplace_back(x, y, z);
            if (seed == 0) {
                places.clear();
                for (int k = 0; k < 64; ++k)  // all edges of the inner ones are shared
                    if ((k + k / 4 + k / 16) % 2 == 0) places.emplace_back(k % 4, k / 4 % 4, k / 16);
            }
            if (places.empty()) continue;
            const std::vector<std::uint32_t> parts = solidParts(weldedCubes(places));
            for (std::uint32_t i = 0; i < parts.size(); ++i)
                QVERIFY2(parts[i] == i / 12, qPrintable(QString("seed %1, triangle %2").arg(seed).arg(i)));
        }
    }
};

RUBBLE_TEST(SolidMeshTest)
#include "SolidMeshTest.moc"
