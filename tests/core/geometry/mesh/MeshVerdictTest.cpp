// Tests core/geometry/mesh/MeshVerdict.cpp, core/geometry/mesh/PreparedMesh.cpp, core/geometry/mesh/MeshTopology.cpp,
// core/geometry/mesh/MeshShells.cpp, core/geometry/mesh/MeshCrossings.cpp, core/geometry/mesh/TriangleTree.cpp and
// core/geometry/mesh/LatticeSurface.cpp.
#include "core/geometry/mesh/MeshVerdict.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/BrokenMeshes.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace rubble;
using namespace rubble::test;

namespace {

using Kind = MeshFindingKind;

using Note = std::pair<Kind, std::size_t>;

/// A mesh that is fit, with the notes that are expected.
struct NotedMesh {
    const char* name;
    TriangleMesh mesh;
    std::vector<Note> notes;
    std::uint32_t parts;
    std::size_t shells;
    double volume;
};

std::string textOf(const std::vector<MeshFinding>& findings) {
    std::string text;
    for (const MeshFinding& finding : findings)
        text += std::string(nameOf(finding.kind)) + ": " + finding.message + " ";
    return text;
}

/// A U whose legs, turned inward, meet in a square: one surface that touches itself.
TriangleMesh touchingU() {
    TriangleMesh mesh = cubes({{0, 0, 0},
                               {1, 0, 0},
                               {2, 0, 0},
                               {3, 0, 0},
                               {4, 0, 0},
                               {0, 0, 1},
                               {4, 0, 1},
                               {0, 0, 2},
                               {1, 0, 2},
                               {3, 0, 2},
                               {4, 0, 2}});
    for (Vec3& point : mesh.points)
        if (point.z >= 2.0 && (point.x == 2.0 || point.x == 3.0)) point.x = 2.5;
    return mesh;
}

Note touching(std::size_t count) { return {Kind::TouchingTriangles, count}; }

std::vector<NotedMesh> touchingMeshes() {
    return {
        {"boxes at a corner", together(unitBox(), boxAt(1, 1, 1)), {}, 2, 2, 2.0},
        {"boxes at an edge", together(unitBox(), boxAt(1, 1, 0)), {touching(4)}, 2, 2, 2.0},
        {"boxes at a face", together(unitBox(), boxAt(1, 0, 0)), {touching(16)}, 2, 2, 2.0},
        {"boxes at a part of a face", together(boxAt(0, 0, 0, 2), boxAt(2, 0.5, 0.5)), {touching(8)}, 2, 2, 9.0},
        {"one inside out",
         together(unitBox(), insideOut(boxAt(1, 0, 0))),
         {{Kind::TurnedShells, 1}, touching(16)},
         2,
         2,
         2.0},
        {"boxes that share an edge",
         cubes({{0, 0, 0}, {1, 1, 0}}),
         {{Kind::SeparatedPoints, 2}, touching(4)},
         2,
         2,
         2.0},
        {"boxes that share a corner", cubes({{0, 0, 0}, {1, 1, 1}}), {{Kind::SeparatedPoints, 1}}, 2, 2, 2.0},
        {"inside out at a shared edge",
         insideOut(cubes({{0, 0, 0}, {1, 1, 0}})),
         {{Kind::SeparatedPoints, 2}, {Kind::TurnedShells, 2}, touching(4)},
         2,
         2,
         2.0},
        {"chain at corners",
         cubes({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}),
         {{Kind::SeparatedPoints, 3}},
         4,
         4,
         4.0},
        {"legs that meet", touchingU(), {touching(16)}, 1, 1, 12.0},
    };
}

std::vector<NotedMesh> touchingCavities() {
    const TriangleMesh outer = boxAt(0, 0, 0, 3);
    return {
        {"box in a cavity that it fills",
         together(together(outer, insideOut(boxAt(1, 1, 1))), boxAt(1, 1, 1)),
         {touching(48)},
         2,
         3,
         27.0},
        {"box in the corner of a cavity",
         together(together(outer, insideOut(boxAt(0.5, 0.5, 0.5, 2))), boxAt(0.5, 0.5, 0.5)),
         {touching(24)},
         2,
         3,
         20.0},
        {"pyramid on a box",
         together(unitBox(), tetrahedron({0.2, 0.2, 1}, {0.2, 0.8, 1}, {0.8, 0.2, 1}, {0.3, 0.3, 1.5})),
         {touching(6)},
         2,
         2,
         1.03},
        {"edge on a box",
         together(unitBox(), tetrahedron({0.2, 0.2, 1}, {0.2, 0.8, 2}, {0.8, 0.8, 1}, {0.8, 0.2, 2})),
         {touching(4)},
         2,
         2,
         1.12},
        {"cavity at an edge",
         together(outer, insideOut(tetrahedron({0, 0, 1}, {0, 0, 2}, {1, 2, 1}, {2, 1, 1}))),
         {touching(4)},
         1,
         2,
         26.5},
    };
}

std::vector<NotedMesh> turnedMeshes() {
    TriangleMesh one = unitBox(), five = bumpySphere(12);
    std::swap(one.triangles[3][0], one.triangles[3][1]);
    const double volume = judgeMesh(five)->volume;
    for (const std::size_t t : {7, 8, 30, 31, 100}) std::swap(five.triangles[t][0], five.triangles[t][2]);
    const TriangleMesh hollow = together(boxAt(0, 0, 0, 3), insideOut(boxAt(1, 1, 1)));
    return {
        {"one triangle turned", one, {{Kind::TurnedTriangles, 1}}, 1, 1, 1.0},
        {"five triangles turned", five, {{Kind::TurnedTriangles, 5}}, 1, 1, volume},
        {"inside out", insideOut(unitBox()), {{Kind::TurnedShells, 1}}, 1, 1, 1.0},
        {"inside out but for one triangle",
         insideOut(one),
         {{Kind::TurnedTriangles, 1}, {Kind::TurnedShells, 1}},
         1,
         1,
         1.0},
        {"hollow and inside out", insideOut(hollow), {{Kind::TurnedShells, 2}}, 1, 2, 26.0},
        {"hollow", hollow, {}, 1, 2, 26.0},
        {"cavity beside a box", together(unitBox(), insideOut(boxAt(5, 0, 0))), {{Kind::TurnedShells, 1}}, 2, 2, 2.0},
        {"box in a cavity", together(hollow, boxAt(1.25, 1.25, 1.25, 0.5)), {}, 2, 3, 26.125},
    };
}

std::vector<NotedMesh> weldedMeshes() {
    TriangleMesh near = unshared(unitBox());
    near.points[4].x += 1e-6;
    // Closed by index only: the two pillars share places, not points, and have an edge without length each.
    const TriangleMesh pinched = together(unitBox(), boxAt(1, 1, 0));
    // The edge from (0, 0, 1) to (1, 0, 1) is two edges for the front, and a triangle without area closes the gap.
    const TriangleMesh junction =
        with(without(unitBox(), {5, 4}), {{0.5, 0, 1}}, {{0, 1, 8}, {1, 5, 8}, {0, 8, 4}, {4, 8, 5}});
    const TriangleMesh zero =
        with(without(unitBox(), {10, 11}), {{1, 1, 1}}, {{1, 3, 8}, {1, 8, 5}, {3, 7, 8}, {7, 5, 8}});
    return {
        {"own points", unshared(unitBox()), {{Kind::WeldedPoints, 28}}, 1, 1, 1.0},
        {"points nearby", near, {{Kind::WeldedPoints, 28}}, 1, 1, 1.0},
        {"closed by index", pinched, {{Kind::TouchingTriangles, 4}}, 2, 2, 2.0},
        {"corner twice", with(unitBox(), {}, {{3, 3, 5}, {1, 2, 2}}), {{Kind::DroppedTriangles, 2}}, 1, 1, 1.0},
        {"unused points", with(unitBox(), {{9, 9, 9}, {std::nan(""), 0, 0}}, {}), {}, 1, 1, 1.0},
        {"edge filled without area", junction, {{Kind::DegenerateTriangles, 1}}, 1, 1, 1.0},
        {"edge without length", zero, {{Kind::DegenerateTriangles, 2}}, 1, 1, 1.0},
        {"far away", transformed(unitBox(), Mat3(1.0), {4096, -8192, 1024}), {}, 1, 1, 1.0},
        {"needle", box({0, 0, 0}, {1, 1e-9, 1e-9}), {}, 1, 1, 1e-18},
        {"plate with fins of a millionth", box({0, 0, 0}, {1, 1e-5, 1}), {}, 1, 1, 1e-5},
    };
}

std::vector<NotedMesh> notedMeshes() {
    std::vector<NotedMesh> all;
    for (const auto& make : {touchingMeshes, touchingCavities, turnedMeshes, weldedMeshes}) {
        for (NotedMesh& mesh : make()) all.push_back(std::move(mesh));
    }
    return all;
}

}  // namespace

class MeshVerdictTest : public QObject {
    Q_OBJECT
private slots:
    void sentencesNameCountAndPlace() {
        const auto sentence = [](const TriangleMesh& mesh) { return judgeMesh(mesh)->findings[0].message; };
        QCOMPARE(sentence(sheet(1, 1)), std::string("4 edges have one face only, the first at (0.5, 0, 0)."));
        QCOMPARE(sentence(together(unitBox(), boxAt(0.5, 0.5, 0.5))),
                 std::string("Shells 0 and 1 overlap: triangles 2 and 17 cross at (0.75, 0.5, 1)."));
        QCOMPARE(sentence(insideOut(unitBox())),
                 std::string("1 shell of the mesh is inside out and is turned, at (0.333333, 0.666667, 0)."));
    }
    /// A mesh is judged in its own frame; places are in the world.
    void placesAreRelativeToTheOrigin() {
        const Vec3 origin{10.0, 20.0, 30.0};
        for (const TriangleMesh& mesh : {sheet(1, 1), together(unitBox(), boxAt(0.5, 0.5, 0.5)), insideOut(unitBox()),
                                         unshared(unitBox()), together(unitBox(), boxAt(1.0, 1.0, 1.0))}) {
            const std::vector<MeshFinding> local = judgeMesh(mesh)->findings;
            const std::vector<MeshFinding> findings = judgeMesh(mesh, {}, origin)->findings;
            QCOMPARE(findings.size(), local.size());
            for (std::size_t k = 0; k < findings.size(); ++k) {
                QVERIFY(glm::distance(findings[k].place, origin + local[k].place) < 1e-9);
                QVERIFY(findings[k].message != local[k].message);
            }
        }
    }
    void edgesAreMarked() {
        const MeshFinding fault = judgeMesh(without(unitBox(), {0}))->findings[0];
        QCOMPARE(fault.triangles, (std::vector<std::uint32_t>{0, 6, 8}));
        QCOMPARE(fault.edges, (std::vector<std::array<std::uint32_t, 2>>{{0, 3}, {3, 2}, {2, 0}}));
    }
    void longListsAreCut() {
        const MeshFinding fault = judgeMesh(unshared(transformed(sheet(120, 1), Mat3(1.0))))->findings[0];
        QCOMPARE(fault.count, std::size_t{242});
        const MeshFinding many = judgeMesh(sheet(6000, 1))->findings[0];
        QCOMPARE(many.count, std::size_t{12002});
        QCOMPARE(many.edges.size(), kMaxMarked);
    }

    /// Each triangle crosses most others: their number is not looked for.
    void manyCrossingsEndTheSearch() {
        TriangleMesh tangle = bumpySphere(60);
        Random random(1);
        for (Vec3& point : tangle.points) {
            const double x = random.unit(), y = random.unit();
            point = {x, y, random.unit()};
        }
        const Result<MeshVerdict> verdict = judgeMesh(tangle);
        QVERIFY(verdict && !verdict->isFit());
        QCOMPARE(nameOf(verdict->findings[0].kind), nameOf(Kind::Crossing));
        QVERIFY(verdict->findings[0].message.starts_with("More than 2"));
        QVERIFY(verdict->findings[0].count < 100'000);
        QVERIFY(verdict->findings[0].triangles.size() <= kMaxMarked);
    }

    /// A clean mesh comes back with the same bits.
    void cleanMeshesAreFit() {
        for (const TriangleMesh& mesh : {unitBox(), bumpySphere(24), torus(24, 12), cubes({{0, 0, 0}, {1, 0, 0}})}) {
            const Result<MeshVerdict> verdict = judgeMesh(mesh);
            QVERIFY(verdict && verdict->findings.empty() && verdict->isFit());
            QCOMPARE(verdict->shells.size(), std::size_t{1});
            QCOMPARE(verdict->partCount, 1u);
            QVERIFY(verdict->volume > 0.9);
            QCOMPARE(verdict->mesh.points, mesh.points);
            QCOMPARE(verdict->mesh.triangles, mesh.triangles);
        }
    }
    void notedMeshesAreFit_data() {
        QTest::addColumn<int>("index");
        const std::vector<NotedMesh> all = notedMeshes();
        for (std::size_t k = 0; k < all.size(); ++k) QTest::newRow(all[k].name) << int(k);
    }
    void notedMeshesAreFit() {
        QFETCH(int, index);
        const NotedMesh noted = notedMeshes()[std::size_t(index)];
        const Result<MeshVerdict> verdict = judgeMesh(noted.mesh);
        QVERIFY(verdict);
        QVERIFY2(verdict->isFit(), verdict->isFit() ? "" : verdict->findings[0].message.c_str());
        std::vector<Note> notes;
        for (const MeshFinding& finding : verdict->findings) {
            notes.push_back({finding.kind, finding.count});
            QVERIFY(finding.message.ends_with("."));
        }
        QVERIFY2(notes == noted.notes, textOf(verdict->findings).c_str());
        QCOMPARE(verdict->partCount, noted.parts);
        QCOMPARE(verdict->shells.size(), noted.shells);
        QVERIFY(std::abs(verdict->volume - noted.volume) < 1e-9);
        QCOMPARE(verdict->shellOf.size(), verdict->mesh.triangles.size());
        QCOMPARE(verdict->sources.size(), verdict->mesh.triangles.size());
        QVERIFY(judgeMesh(verdict->mesh)->isFit());
    }
    void cavitiesAreNested() {
        TriangleMesh mesh = insideOut(boxAt(1, 1, 1, 4));        // a cavity in
        mesh = together(mesh, boxAt(0, 0, 0, 6));                // a box,
        mesh = together(mesh, boxAt(2, 2, 2, 2));                // a box in the cavity,
        mesh = together(mesh, insideOut(boxAt(2.5, 2.5, 2.5)));  // with a cavity,
        mesh = together(mesh, boxAt(10, 0, 0));                  // and another box
        const Result<MeshVerdict> verdict = judgeMesh(mesh);
        QVERIFY(verdict && verdict->isFit());
        std::vector<std::uint32_t> around, part;
        std::vector<double> volumes;
        for (const MeshShell& shell : verdict->shells) {
            around.push_back(shell.around), part.push_back(shell.part);
            volumes.push_back(std::round(shell.volume));
        }
        QCOMPARE(around, (std::vector<std::uint32_t>{1, kNone, 0, 2, kNone}));
        QCOMPARE(part, (std::vector<std::uint32_t>{0, 0, 1, 1, 2}));
        QCOMPARE(volumes, (std::vector<double>{-64, 216, 8, -1, 1}));
        QCOMPARE(verdict->partCount, 3u);
    }
    void sameVerdictOnAnyThreads() {
        const TriangleMesh spheres =
            together(bumpySphere(100), transformed(bumpySphere(90), Mat3(1.0), Vec3(0.9, 0.2, 0.1)));
        for (const TriangleMesh& mesh :
             {spheres, together(bumpySphere(100), insideOut(transformed(bumpySphere(90), Mat3(0.5))))}) {
            const Result<MeshVerdict> first = judgeMesh(mesh);
            for (const int threads : {2, 3, 8}) {
                TaskContext task;
                task.threads = threads;
                const Result<MeshVerdict> other = judgeMesh(mesh, task);
                QVERIFY(first && other);
                QCOMPARE(textOf(other->findings), textOf(first->findings));
                QCOMPARE(other->mesh.triangles, first->mesh.triangles);
                QCOMPARE(other->shellOf, first->shellOf);
                QCOMPARE(other->volume, first->volume);
                for (std::size_t k = 0; k < first->findings.size(); ++k) {
                    QCOMPARE(other->findings[k].triangles, first->findings[k].triangles);
                    QCOMPARE(other->findings[k].place, first->findings[k].place);
                }
            }
        }
    }
    /// From whatever moment on.
    void isCancelled() {
        const TriangleMesh mesh = bumpySphere(80);
        TaskContext before;
        before.cancel.cancel();
        const Result<MeshVerdict> none = judgeMesh(mesh, before);
        QVERIFY(!none && none.error().code == ErrorCode::Cancelled);
        for (const double moment : {0.2, 0.3, 0.5, 0.55}) {
            TaskContext task;
            task.progress = [&](double fraction) {
                if (fraction >= moment) task.cancel.cancel();
            };
            const Result<MeshVerdict> verdict = judgeMesh(mesh, task);
            QVERIFY(!verdict && verdict.error().code == ErrorCode::Cancelled);
        }
    }
};

RUBBLE_TEST(MeshVerdictTest)
#include "MeshVerdictTest.moc"
