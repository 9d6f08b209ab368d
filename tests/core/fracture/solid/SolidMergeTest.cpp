// Tests core/fracture/solid/SolidMerge.cpp, core/fracture/solid/SolidContacts.cpp and
// core/fracture/solid/SolidPartition.cpp.
#include "core/fracture/solid/SolidMerge.h"

#include "core/fracture/solid/SolidContacts.h"
#include "core/fracture/solid/SolidCut.h"
#include "core/fracture/verify/VerifySolidPartition.h"
#include "core/geometry/mesh/SolidMesh.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/SolidCells.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>

using namespace rubble;
using namespace rubble::test;

namespace {

/// What verifySolidPartition() finds but for nearest seeds, which merged fragments do not keep.
std::string mergeFault(const SolidPartition& partition, const TriangleMesh& mesh, const std::vector<Vec3>& seeds) {
    const std::string fault = verifySolidPartition(partition, mesh, seeds).value_or("");
    return fault.find("nearer to another seed") == std::string::npos ? fault : std::string();
}

std::vector<std::uint32_t> themselves(const SolidPartition& partition) {
    std::vector<std::uint32_t> receivers(partition.fragmentCount());
    std::iota(receivers.begin(), receivers.end(), 0u);
    return receivers;
}

}  // namespace

class SolidMergeTest : public QObject {
    Q_OBJECT
private slots:
    void contactsAreThoseOfTheCommonFaces() {
        const TriangleMesh cube = cubes({{0, 0, 0}});
        const SolidPartition halves = cellsOf(cube, {{0.25, 0.5, 0.5}, {0.75, 0.5, 0.5}});
        const std::vector<SolidContact> contacts = contactsOf(halves);
        QCOMPARE(contacts.size(), 1u);
        const SolidContact& contact = contacts[0];
        QCOMPARE(contact.first, 0u);
        QCOMPARE(contact.second, 1u);
        QVERIFY(std::abs(contact.area - 1.0) < 1e-12);
        QVERIFY(glm::length(halves.origin + contact.centroid - Vec3(0.5)) < 1e-12);
        QVERIFY(glm::length(contact.normal - Vec3(1, 0, 0)) < 1e-12);
        QVERIFY(std::abs(contact.moments[1][1] - 1.0 / 12.0) < 1e-12);
        QVERIFY(std::abs(contact.moments[0][0]) < 1e-12 && std::abs(contact.moments[1][2]) < 1e-12);
    }
    /// The area vectors of a fragment's contacts and of its outside sum up to zero, as those of any closed surface.
    void contactsCloseTheFragments() {
        const TriangleMesh mesh = bumpySphere(24);
        const SolidPartition partition = cellsOf(mesh, seedsInBox(mesh, 40, 1));
        std::vector<Vec3> sums(partition.fragmentCount(), Vec3(0.0));
        for (const SolidContact& contact : contactsOf(partition)) {
            sums[contact.first] += contact.area * contact.normal;
            sums[contact.second] -= contact.area * contact.normal;
        }
        for (std::uint32_t f = 0; f < partition.faces.size(); ++f) {
            if (partition.faces[f].behind != kNone) continue;
            for (const auto& [a, b, c] : partition.trianglesOf(f)) {
                const Vec3 p = partition.points[a];
                sums[partition.faces[f].fragment] += glm::cross(partition.points[b] - p, partition.points[c] - p) / 2.0;
            }
        }
        for (const Vec3 sum : sums) QVERIFY(glm::length(sum) < 1e-12);
    }
    void mergedFragmentsAreStillAPartition() {
        const TriangleMesh mesh = torus(30, 12);
        const std::vector<Vec3> seeds = seedsInBox(mesh, 40, 2);
        const SolidPartition partition = cellsOf(mesh, seeds);
        std::vector<std::uint32_t> receivers = themselves(partition);
        for (const SolidContact& contact : contactsOf(partition)) {
            if (receivers[contact.first] == contact.first && receivers[contact.second] == contact.second &&
                contact.first % 3 == 0) {
                receivers[contact.second] = contact.first;
            }
        }
        // A receiver is not merged itself.
        for (std::uint32_t& receiver : receivers) receiver = receivers[receiver];
        const SolidPartition merged = mergedFragments(partition, receivers);
        QVERIFY(merged.fragmentCount() < partition.fragmentCount());
        QVERIFY(merged.faces.size() < partition.faces.size());
        QCOMPARE(mergeFault(merged, mesh, seeds), std::string());
    }
    void nothingChangesWhereNothingIsMerged() {
        const TriangleMesh mesh = bumpySphere(12);
        const SolidPartition partition = cellsOf(mesh, seedsInBox(mesh, 10, 3));
        const SolidPartition same = mergedFragments(partition, themselves(partition));
        QCOMPARE(same.triangles, partition.triangles);
        QCOMPARE(same.seedOfFragment, partition.seedOfFragment);
        QCOMPARE(same.partOfFragment, partition.partOfFragment);
        QCOMPARE(same.fragmentOfSeed, partition.fragmentOfSeed);
    }
    void allInOneIsTheMesh() {
        const TriangleMesh mesh = bumpySphere(12);
        const SolidPartition partition = cellsOf(mesh, seedsInBox(mesh, 10, 3));
        const SolidPartition one = mergedFragments(partition, std::vector<std::uint32_t>(partition.fragmentCount(), 0));
        QCOMPARE(one.fragmentCount(), 1u);
        QVERIFY(std::abs(one.volumes[0] - signedVolume(mesh)) < 1e-12);
        QVERIFY(std::ranges::all_of(one.faces, [](const auto& face) { return face.behind == kNone; }));
    }
    void smallFragmentsGoToTheLargestFace() {
        const TriangleMesh mesh = bumpySphere(24);
        const std::vector<Vec3> seeds = seedsInBox(mesh, 100, 4);
        const SolidPartition partition = cellsOf(mesh, seeds);
        const double limit = 0.02;
        std::vector<std::uint32_t> gone;
        const SolidPartition merged = withoutSmallFragments(partition, limit, &gone);
        QCOMPARE(merged.fragmentCount() + gone.size(), std::size_t(partition.fragmentCount()));
        for (const double volume : merged.volumes) QVERIFY(volume >= limit);
        QCOMPARE(mergeFault(merged, mesh, seeds), std::string());
        QCOMPARE(withoutSmallFragments(partition, 0.0).fragmentCount(), partition.fragmentCount());
        QCOMPARE(withoutSmallFragments(partition, 1e9).fragmentCount(), 1u);
    }
    void partsOfOneSeedAreNumbered() {
        // A U: the cell of the seed between the legs falls into one part in each.
        const TriangleMesh u = cubes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}});
        const SolidPartition partition = cellsOf(u, {{1.5, 0.4, 0.5}, {1.5, 1.6, 0.5}});
        QCOMPARE(partition.seedOfFragment, (std::vector<std::uint32_t>{0, 1, 1}));
        QCOMPARE(partition.partOfFragment, (std::vector<std::uint32_t>{kNone, 0, 1}));
    }
};

RUBBLE_TEST(SolidMergeTest)
#include "SolidMergeTest.moc"
