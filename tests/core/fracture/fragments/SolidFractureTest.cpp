// Tests core/fracture/fragments/SolidFracture.cpp, core/fracture/fragments/FragmentName.cpp and
// core/fracture/verify/VerifySolidFragments.cpp.
#include "core/fracture/fragments/SolidFracture.h"

#include "core/fracture/fragments/FragmentName.h"
#include "core/fracture/solid/SolidCut.h"
#include "core/fracture/verify/VerifySolidFragments.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

#include <functional>

using namespace rubble;
using namespace rubble::test;

namespace {

Fragments fragmentsOf(const TriangleMesh& mesh, const std::vector<Vec3>& seeds, int threads = 1) {
    TaskContext task;
    task.threads = threads;
    return *solidFragments(*cutSolid(mesh, seeds, task), {}, task);
}

std::string faultOf(const Fragments& fragments, const TriangleMesh& mesh) {
    return verifySolidFragments(fragments, mesh).value_or("");
}

/// A cube of 2 m in two halves.
Fragments halves() { return fragmentsOf(cubes({{0, 0, 0}, {1, 0, 0}}), {{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}}); }

}  // namespace

class SolidFractureTest : public QObject {
    Q_OBJECT
private slots:
    void halvesAreOneFragmentEach() {
        const Fragments all = halves();
        QCOMPARE(all.count(), 2u);
        QVERIFY(all.solid() && !all.extruded() && !all[0].extruded());
        QVERIFY(std::abs(all[0].volume() - 1.0) < 1e-12);
        QVERIFY(glm::distance(all[1].offset(), Vec3(1.5, 0.5, 0.5)) < 1e-12);
        QCOMPARE(all[0].mass().centre, Vec3(0.0));
        QVERIFY(all[0].isConvex());
        QCOMPARE(all[0].seed(), 0u);
        QCOMPARE(all[0].partOfCell(), kNone);
        QVERIFY(std::abs(all[0].aspectRatio() - 1.0) < 1e-9);
        QCOMPARE(all[0].contacts().size(), 1u);
        QCOMPARE(all[0].contacts()[0].fragment, 1u);
        QVERIFY(std::abs(all[1].contacts()[0].area - 1.0) < 1e-12);
        QCOMPARE(all[0].hulls()[0].vertices.size(), 8u);
    }
    void namesHaveSeedAndPart() {
        const std::vector<SeedId> ids{{7, 2}, {7, 5}};
        const Fragments all = halves();
        QCOMPARE(fragmentName(all[1], ids), std::string("7.5"));
        QCOMPARE(cellId(all[0], ids), (SeedId{7, 2}));
        // A U whose legs are in one cell.
        const TriangleMesh u = cubes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}});
        const Fragments parts = fragmentsOf(u, {{1.5, 2.0, 0.5}, {1.5, 0.0, 0.5}});
        QCOMPARE(parts.count(), 3u);
        QCOMPARE(fragmentName(parts[0], ids), std::string("7.2.0"));
        QCOMPARE(fragmentName(parts[1], ids), std::string("7.2.1"));
        QCOMPARE(fragmentName(parts[2], ids), std::string("7.5"));
    }
    void randomFragmentsAreValidOnAnyThreads() {
        for (int seed = 1; seed <= 6; ++seed) {
            const TriangleMesh mesh = seed % 2 == 0 ? torus(24, 16) : bumpySphere(20);
            const std::vector<Vec3> seeds = seedsInBox(mesh, 10 * seed, static_cast<std::uint64_t>(seed));
            const Fragments all = fragmentsOf(mesh, seeds), again = fragmentsOf(mesh, seeds, 4);
            QCOMPARE(QString::fromStdString(faultOf(all, mesh)), QString());
            QCOMPARE(again.count(), all.count());
            for (std::uint32_t k = 0; k < all.count(); ++k) {
                QCOMPARE(again[k].offset(), all[k].offset());
                QVERIFY(again[k].hulls() == all[k].hulls());
            }
        }
    }
    void faultsAreFound() {
        const TriangleMesh mesh = cubes({{0, 0, 0}, {1, 0, 0}});
        const auto faultAfter = [&](const std::function<void(SolidFragments&)>& change) {
            Fragments all = halves();
            change(std::get<SolidFragments>(all.parts));
            return faultOf(all, mesh);
        };
        QCOMPARE(faultAfter([](SolidFragments&) {}), std::string());
        QCOMPARE(faultAfter([](SolidFragments& all) { all.masses[0].volume *= 2.0; }),
                 std::string("Fragment 0 does not have the mass of its faces."));
        QCOMPARE(faultAfter([](SolidFragments& all) { all.masses[1].centre.x += 0.1; }),
                 std::string("Fragment 1 does not have the mass of its faces."));
        QCOMPARE(faultAfter([](SolidFragments& all) { all.hulls[0].clear(); }), std::string("Fragment 0 has no hull."));
        QCOMPARE(faultAfter([](SolidFragments& all) {
                     all.hulls[1] = {translated(all.hulls[1][0], {0.1, 0, 0})};
                 }),
                 std::string("Fragment 1 has a point outside its hulls."));
        QCOMPARE(faultAfter([](SolidFragments& all) { all.firstContact[2] = all.firstContact[1]; }),
                 std::string("Fragment 0 has a contact with fragment 1 that is not mutual."));
        QCOMPARE(verifySolidFragments(Fragments{}, mesh).value(),
                 std::string("The fragments are not those of a mesh."));
    }
    void cancelledTasksEnd() {
        TaskContext task;
        task.cancel.cancel();
        const TriangleMesh mesh = torus(24, 16);
        Result<Fragments> made = solidFragments(*cutSolid(mesh, seedsInBox(mesh, 20, 1)), {}, task);
        QCOMPARE(made.error().code, ErrorCode::Cancelled);
    }
};

RUBBLE_TEST(SolidFractureTest)
#include "SolidFractureTest.moc"
