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
    return *solidFragments(*cutSolid(mesh, seeds, task), 0.0, {}, task);
}

std::string faultOf(const Fragments& fragments, const TriangleMesh& mesh) {
    return verifySolidFragments(fragments, mesh).value_or("");
}

/// A cube of 2 m in two halves.
Fragments halves() { return fragmentsOf(cubes({{0, 0, 0}, {1, 0, 0}}), {{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}}); }

/// A cube of 1 m in n³ cubes, less a gap.
Fragments grid(int n, double gap) {
    std::vector<Vec3> seeds;
    for (int k = 0; k < n * n * n; ++k) seeds.push_back((Vec3(k % n, k / n % n, k / n / n) + 0.5) / double(n));
    return *solidFragments(*cutSolid(cubes({{0, 0, 0}}), seeds), gap);
}

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
    void gapsAreTakenOffFragments() {
        const double gap = 0.1, width = 1.0 / 3.0;
        const Fragments all = grid(3, gap), before = grid(3, 0.0);
        QCOMPARE(all.count(), 27u);
        QCOMPARE(all.gap, gap);
        for (std::uint32_t k = 0; k < all.count(); ++k) {
            double volume = 1.0;
            for (const std::uint32_t place : {all[k].seed() % 3, all[k].seed() / 3 % 3, all[k].seed() / 9})
                volume *= width - (place == 1 ? gap : gap / 2.0);
            QVERIFY(std::abs(all[k].volume() - volume) < 1e-12);
            QCOMPARE(all[k].hulls().size(), 1u);
            QVERIFY(std::abs(massOf(all[k].hulls()[0]).volume - volume) < 1e-9);
            QCOMPARE(all[k].contacts().size(), before[k].contacts().size());
            for (std::size_t c = 0; c < all[k].contacts().size(); ++c)
                QCOMPARE(all[k].contacts()[c].area, before[k].contacts()[c].area);
        }
        const double left = 3.0 * width - 2.0 * gap;
        QVERIFY(std::abs(all.solid()->gapVolume - (1.0 - left * left * left)) < 1e-12);
        QCOMPARE(all.diagnostics.size(), 1u);
        QCOMPARE(all.diagnostics[0].code, DiagnosticCode::Gap);
        QCOMPARE(all.diagnostics[0].value, all.solid()->gapVolume);
        QCOMPARE(all.diagnostics[0].message, std::string("The gap between fragments takes 0.488 m³ from them."));
        QCOMPARE(faultOf(all, cubes({{0, 0, 0}})), std::string());
    }
    void fragmentsThatVanishAreOmitted() {
        const Fragments all = grid(3, 0.35);  // wider than those that have a neighbour on both sides
        QCOMPARE(all.count(), 8u);
        const double width = 1.0 / 3.0 - 0.175;
        for (std::uint32_t k = 0; k < 8; ++k) {
            const std::uint32_t corner = (k & 1 ? 2 : 0) + (k & 2 ? 6 : 0) + (k & 4 ? 18 : 0);
            QCOMPARE(all[k].seed(), corner);
            QVERIFY(std::abs(all[k].volume() - width * width * width) < 1e-12);
            QVERIFY(all[k].contacts().empty());
            QVERIFY(std::abs(all[k].offset().x - (k & 1 ? 1.0 - width / 2.0 : width / 2.0)) < 1e-9);
        }
        QCOMPARE(all.diagnostics.size(), 20u);
        QCOMPARE(all.diagnostics[0].code, DiagnosticCode::VanishedPiece);
        QCOMPARE(faultOf(all, cubes({{0, 0, 0}})), std::string());
    }
    void contactsAreThoseOfWhatRemains() {
        // Slices of a cube: a thin one vanishes, and what is on both sides of it does not touch.
        const std::vector<Vec3> seeds{{0.1, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.54, 0.5, 0.5}, {0.7, 0.5, 0.5}};
        const Fragments all = *solidFragments(*cutSolid(cubes({{0, 0, 0}}), seeds), 0.15);
        QCOMPARE(all.count(), 3u);
        QCOMPARE(all[1].seed(), 1u);
        QCOMPARE(all[2].seed(), 3u);
        QCOMPARE(all[0].contacts().size(), 1u);
        QCOMPARE(all[0].contacts()[0].fragment, 1u);
        QVERIFY(all[2].contacts().empty());
        QCOMPARE(faultOf(all, cubes({{0, 0, 0}})), std::string());
    }
    void gapsOfAnySizeAreSound() {
        for (const double gap : {1e-6, 1e-3, 0.02, 0.1, 0.3}) {
            for (const TriangleMesh& mesh : {bumpySphere(16), torus(24, 12), mengerSponge(1)}) {
                Result<Fragments> all = solidFragments(*cutSolid(mesh, seedsInBox(mesh, 40, 3)), gap);
                QVERIFY2(all, all ? "" : all.error().message.c_str());
                QCOMPARE(QString::fromStdString(faultOf(*all, mesh)), QString());
            }
        }
    }
    void wrongGapsAreFound() {
        const TriangleMesh mesh = cubes({{0, 0, 0}});
        Fragments all = grid(2, 0.05);
        all.gap = 0.1;
        QCOMPARE(faultOf(all, mesh), std::string("Fragment 0 is nearer to a common face than half the gap."));
        all.gap = 0.0;
        QCOMPARE(faultOf(all, mesh), std::string("The fragments are not shrunk as the gap requires."));
        all = grid(3, 0.35);
        std::swap(std::get<SolidFragments>(all.parts).remaining[0], std::get<SolidFragments>(all.parts).remaining[1]);
        QCOMPARE(faultOf(all, mesh), std::string("The fragments are not those of the partition in order."));
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
        Result<Fragments> made = solidFragments(*cutSolid(mesh, seedsInBox(mesh, 20, 1)), 0.0, {}, task);
        QCOMPARE(made.error().code, ErrorCode::Cancelled);
    }
};

RUBBLE_TEST(SolidFractureTest)
#include "SolidFractureTest.moc"
