#include "core/base/Random.h"
#include "core/fracture/solid/SolidCut.h"
#include "core/geometry/mesh/SolidMesh.h"
#include "tests/oracle/BoxCells.h"
#include "tests/oracle/ExactSolid.h"
#include "tests/oracle/SolidFault.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace rubble;
using namespace rubble::oracle;
using namespace rubble::test;

namespace {

/// Random points in a mesh's box on a lattice of 2⁻⁸ of it, all different.
std::vector<Vec3> latticeSeeds(const TriangleMesh& mesh, Random& random, std::uint64_t count) {
    const Box3 box = boundsOf(mesh);
    std::vector<Vec3> seeds;
    while (seeds.size() < count) {
        Vec3 seed(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const double place = static_cast<double>(random.below(257)) / 256.0;
            seed[axis] = std::round((box.min[axis] + (box.max[axis] - box.min[axis]) * place) * 0x1p12) * 0x1p-12;
        }
        if (std::ranges::find(seeds, seed) == seeds.end()) seeds.push_back(seed);
    }
    return seeds;
}

TriangleMesh block(int x, int y, int z) {
    std::set<std::array<int, 3>> filled;
    for (int k = 0; k < x * y * z; ++k) filled.insert({k % x, k / x % y, k / x / y});
    return cubes(filled);
}

TriangleMesh shapeL() { return cubes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 2, 0}}); }

/// A ball in a hollow ball.
TriangleMesh nestedBalls() {
    const TriangleMesh ball = bumpySphere(7);
    return together(together(ball, insideOut(transformed(ball, Mat3(0.5)))), transformed(ball, Mat3(0.25)));
}

/// The mesh of a random case, of at most 300 triangles.
TriangleMesh randomMesh(Random& random) {
    switch (random.below(6)) {
        case 0: return onCoarseLattice(bumpySphere(6 + static_cast<int>(random.below(7))));
        case 1: return onCoarseLattice(torus(8 + static_cast<int>(random.below(7)), 8));
        case 2: return onCoarseLattice(nestedBalls());
        case 3: return mengerSponge(1);
        case 4: return shapeL();
        default: return randomLatticeMesh(random, false);
    }
}

std::vector<Vec3> gridSeeds(int count, double size) {
    std::vector<Vec3> seeds;
    for (int k = 0; k < count * count * count; ++k) {
        seeds.push_back((Vec3(k % count, k / count % count, k / count / count) + 0.5) * (size / count));
    }
    return seeds;
}

/// The volumes of fragments sum up to that of the mesh, and each is that of its triangles, in rational numbers.
void expectExactVolumes(const TriangleMesh& mesh, const std::vector<Vec3>& seeds) {
    const Result<SolidPartition> partition = cutSolid(mesh, seeds);
    QVERIFY(partition);
    const double whole = exactVolume(mesh.points, mesh.triangles);
    double sum = 0.0;
    for (std::uint32_t fragment = 0; fragment < partition->fragmentCount(); ++fragment) {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (const SolidPartition::FaceSide& side : partition->facesOf(fragment)) {
            for (auto triangle : partition->trianglesOf(side.face)) {
                if (side.isReversed) std::swap(triangle[1], triangle[2]);
                triangles.push_back(triangle);
            }
        }
        const double exact = exactVolume(partition->points, triangles);
        QVERIFY(exact > 0.0);
        QVERIFY(std::abs(partition->volumes[fragment] - exact) <= 1e-13 * whole);
        sum += exact;
    }
    QVERIFY(std::abs(sum - whole) <= 1e-12 * whole);
}

}  // namespace

/// Compares the cut of solids with CGAL's Nef polyhedra, in rational numbers, and with voro++.
class SolidOracleTest : public QObject {
    Q_OBJECT
private slots:
    /// RUBBLE_LONG: 200 cases, else a few.
    void randomCasesAgree() {
        const bool isLong = qEnvironmentVariableIsSet("RUBBLE_LONG");
        const int wanted = isLong ? 200 : 30;
        int compared = 0;
        for (std::uint64_t number = 0; compared < wanted; ++number) {
            Random random(number);
            const TriangleMesh mesh = randomMesh(random);
            if (!isNefMesh(mesh)) continue;
            const std::vector<Vec3> seeds = latticeSeeds(mesh, random, 1 + random.below(isLong ? 30 : 15));
            const std::optional<std::string> fault = solidFault(mesh, seeds);
            QVERIFY2(!fault, qPrintable(QString("case %1: ").arg(number) + fault.value_or("").c_str()));
            ++compared;
        }
    }
    void gridsInACubeAgree() {
        for (const int count : {2, 3}) {
            const std::optional<std::string> fault = solidFault(block(2, 2, 2), gridSeeds(count, 2.0));
            QVERIFY2(!fault, fault.value_or("").c_str());
        }
    }
    /// Bisectors lie in faces of the mesh.
    void mirroredSeedsAgree() {
        std::vector<Vec3> seeds;
        for (const Vec3 inside : {Vec3(0.5, 0.5, 0.5), Vec3(1.5, 0.25, 0.5), Vec3(0.25, 1.75, 0.75)}) {
            seeds.push_back(inside);
            for (int axis = 0; axis < 3; ++axis) {
                for (const double plane : {0.0, 1.0}) {
                    seeds.push_back(inside);
                    seeds.back()[axis] = 2.0 * plane - inside[axis];
                }
            }
        }
        const std::optional<std::string> fault = solidFault(shapeL(), seeds);
        QVERIFY2(!fault, fault.value_or("").c_str());
    }
    void seedsOnCornersAgree() {
        for (const TriangleMesh& mesh : {block(1, 1, 1), block(2, 1, 1), shapeL()}) {
            const std::optional<std::string> fault = solidFault(mesh, mesh.points);
            QVERIFY2(!fault, fault.value_or("").c_str());
        }
    }
    void volumesAreExact() {
        for (const TriangleMesh& mesh : {bumpySphere(48), torus(60, 30)}) {
            for (const int count : {10, 300}) expectExactVolumes(mesh, seedsInBox(mesh, count, 5));
        }
    }
    void cellsInABoxAgreeWithVoro() {
#ifdef RUBBLE_HAS_VORO
        const TriangleMesh box = block(1, 1, 1);
        const std::vector<Vec3> seeds = seedsInBox(box, 1000, 3);
        const Result<SolidPartition> partition = cutSolid(box, seeds);
        QVERIFY(partition);
        QCOMPARE(partition->fragmentCount(), 1000u);
        std::vector<std::map<std::uint32_t, double>> shared(seeds.size());
        for (std::uint32_t f = 0; f < partition->faces.size(); ++f) {
            const SolidPartition::Face& face = partition->faces[f];
            if (face.behind == kNone) continue;
            for (const auto& [a, b, c] : partition->trianglesOf(f)) {
                const Vec3 origin = partition->points[a];
                const Vec3 twice = glm::cross(partition->points[b] - origin, partition->points[c] - origin);
                shared[face.fragment][face.behind] += glm::length(twice) / 2.0;
                shared[face.behind][face.fragment] += glm::length(twice) / 2.0;
            }
        }
        const std::vector<BoxCell> cells = boxCells(boundsOf(box), seeds);
        for (std::uint32_t seed = 0; seed < seeds.size(); ++seed) {
            QCOMPARE(partition->seedOfFragment[seed], seed);
            QVERIFY(std::abs(partition->volumes[seed] - cells[seed].volume) < 1e-12);
            std::size_t found = 0;
            for (std::size_t k = 0; k < cells[seed].neighbours.size(); ++k) {
                const auto face = shared[seed].find(cells[seed].neighbours[k]);
                found += face != shared[seed].end();
                const double area = face != shared[seed].end() ? face->second : 0.0;
                QVERIFY(std::abs(area - cells[seed].areas[k]) < 1e-9);
            }
            QVERIFY(found == shared[seed].size());
        }
#else
        QSKIP("voro++ is absent.");
#endif
    }
};

RUBBLE_TEST(SolidOracleTest)
#include "SolidOracleTest.moc"
