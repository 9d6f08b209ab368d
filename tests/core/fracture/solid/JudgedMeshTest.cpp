// Tests that meshes which core/geometry/mesh/MeshVerdict.cpp finds fit are cut by core/fracture/solid/SolidCut.cpp.
#include "core/fracture/solid/SolidCut.h"
#include "core/fracture/solid/SolidHulls.h"
#include "core/fracture/verify/VerifySolidPartition.h"
#include "core/geometry/hull/SimplifiedHull.h"
#include "core/geometry/mesh/MeshVerdict.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/CutFault.h"
#include "tests/support/geometry/BrokenMeshes.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace rubble;
using namespace rubble::test;

namespace {

/// A box or a ball whose points are at random places of a lattice: it crosses, touches or folds back onto itself.
TriangleMesh tangle(Random& random) {
    TriangleMesh mesh = random.below(2) == 0 ? box(Vec3(0.0), Vec3(1.0)) : bumpySphere(4);
    const double most = 1.0 + double(random.below(4));
    for (Vec3& point : mesh.points) {
        for (int k = 0; k < 3; ++k) point[k] = std::round(4.0 * point[k] + random.between(-most, most));
    }
    return mesh;
}

/// Whether a mesh of faces of the tetrahedra into which the cubes of a grid are divided, or of larger ones, is solid
/// once or not at all in each of them.
bool isSolidOnceAtMost(const TriangleMesh& mesh) {
    const Box3 box = boundsOf(mesh);
    for (double x = box.min.x; x < box.max.x; ++x) {
        for (double y = box.min.y; y < box.max.y; ++y) {
            for (double z = box.min.z; z < box.max.z; ++z) {
                std::array<int, 3> axes{0, 1, 2};
                do {  // a point in each of the six tetrahedra
                    constexpr std::array<double, 3> kFractions{0.83, 0.47, 0.19};
                    const Vec3 inside(kFractions[axes[0]], kFractions[axes[1]], kFractions[axes[2]]);
                    const int number = windingNumber(mesh, Vec3(x, y, z) + inside);
                    if (number < 0 || number > 1) return false;
                } while (std::next_permutation(axes.begin(), axes.end()));
            }
        }
    }
    return true;
}

}  // namespace

class JudgedMeshTest : public QObject {
    Q_OBJECT
private slots:
    void randomSolidsAreFitAndCut() {
        int cut = 0;
        for (std::uint64_t seed = 0; cut < 1'000; ++seed) {
            Random random(seed);
            const TriangleMesh mesh = randomLatticeMesh(random, false);
            if (mesh.triangles.empty()) continue;
            const Result<MeshVerdict> verdict = judgeMesh(mesh);
            QVERIFY2(verdict && verdict->isFit(), qPrintable(QString("seed %1").arg(seed)));
            const std::string fault = cutFault(verdict->mesh, seedsInBox(mesh, 1 + int(random.below(12)), seed));
            QVERIFY2(fault.empty(), qPrintable(QString("seed %1: ").arg(seed) + fault.c_str()));
            ++cut;
        }
    }
    /// Solids of a grid, or of a coarser one, lie upon each other at random: all that meets meets in points, edges and
    /// faces. Where they do not overlap, they are cut.
    void twoSolidsAreFitIfTheyDoNotOverlap() {
        int fit = 0, overlapping = 0;
        for (std::uint64_t seed = 0; fit + overlapping < 2'000; ++seed) {
            Random random(seed);
            const TriangleMesh first = randomLatticeMesh(random, false), second = randomLatticeMesh(random, false);
            if (first.triangles.empty() || second.triangles.empty()) continue;
            const double scale = random.below(2) == 0 ? 1.0 : 2.0, x = double(random.below(3)) - 1.0;
            const double y = double(random.below(3)) - 1.0, z = double(random.below(3)) - 1.0;
            const TriangleMesh both = together(first, transformed(second, Mat3(scale), {x, y, z}));
            const Result<MeshVerdict> verdict = judgeMesh(both);
            const QString name = QString("seed %1: ").arg(seed);
            QVERIFY2(verdict && verdict->isFit() == isSolidOnceAtMost(both), qPrintable(name));
            if (!verdict->isFit()) {
                QCOMPARE(nameOf(verdict->findings[0].kind), nameOf(MeshFindingKind::OverlappingShells));
                ++overlapping;
                continue;
            }
            ++fit;
            const std::string fault = cutFault(verdict->mesh, seedsInBox(both, 1 + int(random.below(8)), seed));
            QVERIFY2(fault.empty(), qPrintable(name + fault.c_str()));
        }
        QVERIFY2(fit > 500 && overlapping > 200, qPrintable(QString("%1 %2").arg(fit).arg(overlapping)));
    }
    void whatIsFitIsCut() {
        int fit = 0;
        for (std::uint64_t seed = 0; seed < 3'000; ++seed) {
            Random random(seed);
            const TriangleMesh mesh = tangle(random);
            const Result<MeshVerdict> verdict = judgeMesh(mesh);
            QVERIFY(verdict);
            if (!verdict->isFit()) continue;
            ++fit;
            const std::string fault = cutFault(verdict->mesh, seedsInBox(mesh, 1 + int(random.below(8)), seed));
            QVERIFY2(fault.empty(), qPrintable(QString("seed %1: ").arg(seed) + fault.c_str()));
        }
        QVERIFY2(fit > 100, qPrintable(QString::number(fit)));
    }
    /// What is fit has hulls that hold each fragment but for details, whatever folds in it.
    void whatIsFitHasHulls() {
        for (std::uint64_t seed = 0; seed < 3'000; ++seed) {
            Random random(seed);
            const TriangleMesh mesh = tangle(random);
            const Result<MeshVerdict> verdict = judgeMesh(mesh);
            if (!verdict->isFit()) continue;
            const Result<SolidPartition> partition = cutSolid(verdict->mesh, seedsInBox(mesh, 3, seed));
            QVERIFY(partition);
            const Result<std::vector<std::vector<Polytope>>> hulls = fragmentHulls(*partition);
            QVERIFY2(hulls, qPrintable(QString("seed %1").arg(seed)));
            for (std::uint32_t k = 0; k < partition->fragmentCount(); ++k) {
                const TriangleMesh fragment = meshOf(*partition, k);
                for (const Vec3 point : fragment.points) {
                    const bool isHeld = std::ranges::any_of((*hulls)[k], [&](const Polytope& hull) {
                        const double error = maxCollisionError(hull.vertices.size(), boundsOf(fragment).diagonal());
                        return std::ranges::all_of(hull.planes, [&](const Plane& plane) {
                            return glm::dot(plane.normal, point) <= plane.offset + error + 1e-8;
                        });
                    });
                    QVERIFY2(isHeld, qPrintable(QString("seed %1, fragment %2").arg(seed).arg(k)));
                }
            }
        }
    }
    /// What is not fit is not to be cut; where it is nevertheless, that ends, with an error or with something.
    void whatIsNotFitEnds() {
        int refused = 0;
        for (std::uint64_t seed = 0; seed < 3'000; ++seed) {
            Random random(seed);
            const TriangleMesh mesh = tangle(random);
            if (judgeMesh(mesh)->isFit()) continue;
            const Result<SolidPartition> partition = cutSolid(mesh, seedsInBox(mesh, 1 + int(random.below(8)), seed));
            if (partition) continue;
            QCOMPARE(partition.error().code, ErrorCode::Degenerate);
            ++refused;
        }
        QVERIFY2(refused > 50, qPrintable(QString::number(refused)));
    }
    void partsThatShareAnEdgeOrCornerAreCut() {
        for (const TriangleMesh& mesh : {cubes({{0, 0, 0}, {1, 1, 0}}), cubes({{0, 0, 0}, {1, 1, 1}}),
                                         insideOut(cubes({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}}))}) {
            const Result<MeshVerdict> verdict = judgeMesh(mesh);
            QVERIFY(verdict && verdict->isFit());
            QCOMPARE(cutFault(verdict->mesh, seedsInBox(mesh, 12, 3)), std::string());
            const Result<SolidPartition> one = cutSolid(verdict->mesh, std::vector{Vec3(0.1)});
            QVERIFY(one);
            QCOMPARE(one->fragmentCount(), verdict->partCount);
        }
    }
    /// A junction in an edge that a triangle without area closes.
    void trianglesWithoutAreaAreCut() {
        const TriangleMesh mesh = with(without(box(Vec3(0.0), Vec3(1.0)), {5, 4}), {{0.5, 0, 1}},
                                       {{0, 1, 8}, {1, 5, 8}, {0, 8, 4}, {4, 8, 5}});
        const Result<MeshVerdict> verdict = judgeMesh(mesh);
        QVERIFY(verdict && verdict->isFit());
        for (const int count : {1, 2, 5, 20}) {
            const std::string fault = cutFault(verdict->mesh, seedsInBox(mesh, count, 4));
            QVERIFY2(fault.empty(), qPrintable(QString("%1 seeds: ").arg(count) + fault.c_str()));
        }
    }
};

RUBBLE_TEST(JudgedMeshTest)
#include "JudgedMeshTest.moc"
