// Tests core/asset/import/SolidFit.cpp and core/asset/import/ImportedSolid.cpp.
#include "core/asset/import/SolidFit.h"

#include "core/asset/bake/Bake.h"
#include "core/asset/checks/VerifyProject.h"
#include "core/asset/import/AssetImport.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/TestImages.h"
#include "tests/support/geometry/BrokenMeshes.h"
#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/SolidShapes.h"
#include "tests/support/geometry/Solids.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

namespace {

SourceScene sceneOf(const std::vector<TriangleMesh>& meshes) {
    SourceScene scene{.materials = {{"Stone"}}};
    for (const TriangleMesh& mesh : meshes) {
        SourceObject& object = scene.objects.emplace_back();
        object.name = "Object " + std::to_string(scene.objects.size());
        object.points = mesh.points;
        for (const auto& triangle : mesh.triangles) object.triangles.push_back({triangle, {}, 0});
    }
    return scene;
}

ImportOutcome imported(const SourceScene& scene, const ImportOptions& options = {}, Project project = {}) {
    ImportOutcome outcome = importedInto(std::move(project), scene, "file", options, {}).value();
    if (const auto fault = verifyProject(outcome.project)) qFatal("%s", fault->c_str());
    return outcome;
}

QString faultOf(const TriangleMesh& mesh, const ImportOptions& options = {}) {
    const ImportOutcome outcome = imported(sceneOf({mesh}), options);
    return outcome.rejected.empty() ? QString() : QString::fromStdString(outcome.rejected[0].error.message);
}

TriangleMesh ball() { return test::bumpySphere(12); }
TriangleMesh wall() { return prismSolid(unitSquare(), 0.5); }
TriangleMesh hollowBox() { return joined(test::boxAt(0, 0, 0, 3), test::insideOut(test::boxAt(1, 1, 1))); }
/// Two balls in one another.
TriangleMesh crossing() { return joined(ball(), placed(ball(), {{0.7, 0.0, 0.0}})); }
TriangleMesh at(const TriangleMesh& mesh, Vec3 position) { return placed(mesh, {position}); }

}  // namespace

class SolidFitTest : public QObject {
    Q_OBJECT
private slots:
    void frameIsTheCentreOfTheBox() {
        const TriangleMesh mesh = test::box({2.0, 4.0, -1.0}, {3.0, 8.0, 5.0});
        const SolidTrial trial = fittedSolid(mesh, {}).value();
        QVERIFY(trial.solid && !trial.problem && trial.notes.empty());
        QVERIFY(trial.solid->position == Vec3(2.5, 6.0, 2.0));
        QVERIFY(trial.solid->mesh->bounds.min == Vec3(-0.5, -2.0, -3.0));
        QVERIFY(trial.solid->mesh->bounds.max == Vec3(0.5, 2.0, 3.0));
        QCOMPARE(trial.solid->mesh->mass.volume, 24.0);
        QCOMPARE(trial.solid->mesh->mesh.triangles, mesh.triangles);
    }
    void pointsOfNoTriangleMoveNothing() {
        TriangleMesh mesh = test::unitBox();
        mesh.points.emplace_back(100.0, 0.0, 0.0);
        QVERIFY(fittedSolid(mesh, {})->solid->position == Vec3(0.5, 0.5, 0.5));
    }
    void partsAndCavitiesAreCounted() {
        const SolidTrial trial = fittedSolid(joined(hollowBox(), test::boxAt(9, 0, 0)), {}).value();
        QCOMPARE(trial.solid->parts, 2u);
        QCOMPARE(trial.solid->cavities, 1u);
        QCOMPARE(trial.solid->mesh->mass.volume, 27.0);
    }
    void problemIsMarkedInTheWorld() {
        const TriangleMesh open = test::without(test::boxAt(10, 0, 0), {0});
        const SolidTrial trial = fittedSolid(open, {}).value();
        QVERIFY(!trial.solid);
        QCOMPARE(trial.problem->edges.size(), std::size_t{3});
        QCOMPARE(trial.problem->triangles.size(), std::size_t{3});
        const auto [from, to] = trial.problem->edges[0];
        QVERIFY(glm::distance(trial.problem->place, (from + to) / 2.0) < 1e-12);
        QVERIFY(trial.problem->place.x >= 10.0);
        QVERIFY(
            QString::fromStdString(trial.problem->message).startsWith("3 edges have one face only, the first at (1"));
    }
    void whatWasDoneIsNoted() {
        const SolidTrial trial = fittedSolid(at(test::insideOut(test::unitBox()), {5.0, 0.0, 0.0}), {}).value();
        QCOMPARE(trial.notes.size(), std::size_t{1});
        QVERIFY(QString::fromStdString(trial.notes[0])
                    .startsWith("1 shell of the mesh is inside out and is turned, at (5"));
    }
    void judgingIsCancelled() {
        const TaskContext context;
        context.cancel.cancel();
        QVERIFY(fittedSolid(ball(), context).error().code == ErrorCode::Cancelled);
    }

    void whatIsNoPrismBecomesASolid() {
        const ImportOutcome outcome = imported(sceneOf({wall(), at(ball(), {10.0, 0.0, 0.0})}));
        QCOMPARE(outcome.assets.size(), std::size_t{2});
        QVERIFY(outcome.assets[0].prism && !outcome.assets[0].solid);
        QVERIFY(outcome.project.assets[0].isPrism());
        const ImportedAsset& made = outcome.assets[1];
        QVERIFY(made.solid && !made.prism && !made.usesFallback);
        QVERIFY(made.solid->whyNoPrism.starts_with("The mesh "));
        const Asset& asset = outcome.project.assets[1];
        QVERIFY(asset.mesh() == made.solid->mesh.get());
        QVERIFY(!asset.surface && !asset.texture);
        const Instance& instance = outcome.project.instances[1];
        QVERIFY(instance.pose.position == made.solid->position);
        QVERIFY(std::abs(instance.pose.position.x - 10.0) < 0.2);
        QVERIFY((instance.pose.orientation == Quat(1.0, 0.0, 0.0, 0.0)));
    }
    void prismsAreTheSameAsWithoutSolids() {
        const SourceScene scene = sceneOf({wall(), at(prismSolid(lShape(), 0.7), {0.0, 9.0, 0.0})});
        QVERIFY(imported(scene).project == imported(scene, {.as = ImportShape::Prism}).project);
    }
    void importedSolidIsFractured() {
        const ImportOutcome outcome = imported(sceneOf({ball()}));
        QVERIFY(bake(outcome.project.assets[0]).hasValue());
    }
    void fallbackStillMakesPrisms() {
        const ImportOutcome outcome = imported(sceneOf({ball()}), {.fallback = PrismFallback::Silhouette});
        QVERIFY(outcome.assets[0].prism && outcome.assets[0].usesFallback);
    }
    void objectWithACavityIsOneSolid() {
        const ImportOutcome outcome = imported(sceneOf({hollowBox()}));
        QCOMPARE(outcome.assets.size(), std::size_t{1});
        QCOMPARE(outcome.assets[0].solid->cavities, 1u);
        QVERIFY(QString::fromStdString(outcome.assets[0].solid->whyNoPrism).startsWith("The mesh has a cavity"));
        QCOMPARE(faultOf(hollowBox(), {.as = ImportShape::Prism}),
                 "\"Object 1\": The mesh has a cavity: one of its 2 parts is inverted and lies within another.");
    }
    void partsAreSplitUnlessASolidIsWanted() {
        const SourceScene scene = sceneOf({joined(wall(), at(ball(), {9.0, 0.0, 0.0}))});
        const ImportOutcome split = imported(scene);
        QCOMPARE(split.assets.size(), std::size_t{2});
        QVERIFY(split.assets[0].prism && split.assets[1].solid);
        QCOMPARE(split.assets[1].notes.at(0), std::string("The object has 2 unconnected parts, imported one by one."));
        const ImportOutcome whole = imported(scene, {.as = ImportShape::Solid});
        QCOMPARE(whole.assets.size(), std::size_t{1});
        QCOMPARE(whole.assets[0].solid->parts, 2u);
        QVERIFY(whole.assets[0].solid->whyNoPrism.empty());
    }
    void unitAndUpAxisAreAppliedToSolids() {
        const TriangleMesh mesh = test::box({1000.0, 2000.0, 3000.0}, {2000.0, 4000.0, 6000.0});
        const ImportOptions options{.metresPerUnit = 1e-3, .up = UpAxis::Z, .as = ImportShape::Solid};
        const ImportOutcome outcome = imported(sceneOf({mesh}), options);
        QVERIFY(glm::distance(outcome.project.instances[0].pose.position, Vec3(1.5, 4.5, -3.0)) < 1e-12);
        QVERIFY(std::abs(outcome.assets[0].solid->mesh->mass.volume - 6.0) < 1e-9);
    }
    void copiesOfASolidAreInstances() {
        SourceScene scene = sceneOf({ball()});
        scene.objects[0].copies = {{{0.0, 5.0, 0.0}, {1.0, 0.0, 0.0, 0.0}}};
        const Project project = imported(scene).project;
        QCOMPARE(project.instances.size(), std::size_t{2});
        QVERIFY(std::abs(project.instances[1].pose.position.y - project.instances[0].pose.position.y - 5.0) < 1e-12);
    }
    void equalSolidsAreMergedUnlessRotated() {
        const double half = std::sqrt(0.5);
        const SourceScene scene =
            sceneOf({ball(), at(ball(), {5.0, 1.0, 0.3}), placed(ball(), {{9.0, 0.0, 0.0}, {half, 0.0, half, 0.0}})});
        const ImportOutcome outcome = imported(scene, {.mergesEqual = true});
        QCOMPARE(outcome.project.assets.size(), std::size_t{2});
        QCOMPARE(outcome.project.instances.size(), std::size_t{3});
        QCOMPARE(outcome.assets[0].notes.back(), std::string("1 equal mesh is an instance of it."));
        QCOMPARE(imported(scene).project.assets.size(), std::size_t{3});
    }
    void reimportReplacesTheShapeOnly() {
        Project before = imported(sceneOf({wall()})).project;
        before.assets[0].threshold = 7.0;
        const ImportOutcome solid = imported(sceneOf({ball()}), {.asset = "Object 1"}, before);
        QVERIFY(solid.assets[0].isReplaced && solid.project.assets[0].mesh());
        Project expected = before;
        expected.assets[0].shape = solid.project.assets[0].shape;
        QVERIFY(solid.project == expected);
        const ImportOutcome again = imported(sceneOf({wall()}), {.asset = "Object 1"}, solid.project);
        QVERIFY(again.project == before);
    }
    void lostTextureIsNoted() {
        SourceScene scene = sceneOf({ball()});
        scene.materials[0].image = 0;
        scene.images = {{"stone.png", imageOf(checkerPng())}};
        const std::vector<std::string> notes = imported(scene).assets[0].notes;
        const auto isLost = [](const std::string& note) { return note.starts_with("The texture "); };
        const auto lost = std::ranges::find_if(notes, isLost);
        QVERIFY2(lost != notes.end(), notes.at(0).c_str());
        QCOMPARE(*lost, std::string("The texture \"stone.png\" is not imported: only prisms keep textures."));
    }

    void sentenceSaysWhatIsWrong() {
        QCOMPARE(faultOf(test::without(ball(), {40})).left(60),
                 QString("\"Object 1\": It cannot be cut: 3 edges have one face only, the first at").left(60));
        TriangleMesh knot = ball();  // one point on the other side: closed, but it crosses itself
        knot.points[20] = -2.0 * knot.points[20];
        const QString fault = faultOf(knot);
        QVERIFY2(fault.startsWith("\"Object 1\": It cannot be cut: ") && fault.contains(" cross, "), qPrintable(fault));
        QVERIFY2(fault.contains("; it is not a prism either: the mesh has no flat cap"), qPrintable(fault));
        QVERIFY2(fault.count('.') > 0 && fault.endsWith('.') && !fault.contains(". "), qPrintable(fault));
        const QString both = faultOf(crossing(), {.as = ImportShape::Solid});
        QVERIFY2(both.startsWith("\"Object 1\": It cannot be cut: Shells 0 and 1 overlap"), qPrintable(both));
    }
    void rejectedSolidHasItsProblemAndFallbacks() {
        const SourceScene scene = sceneOf({test::without(ball(), {40})});
        const ImportOutcome outcome = imported(scene, {.findsFallbacks = true});
        QCOMPARE(outcome.rejected.at(0).problem->edges.size(), std::size_t{3});
        QVERIFY(!outcome.rejected[0].fallbacks.empty());
        const ImportOutcome solid = imported(scene, {.as = ImportShape::Solid, .findsFallbacks = true});
        QVERIFY(solid.rejected.at(0).problem && solid.rejected[0].fallbacks.empty());
        const ImportOutcome prism = imported(scene, {.as = ImportShape::Prism, .findsFallbacks = true});
        QVERIFY(!prism.rejected.at(0).problem && !prism.rejected[0].fallbacks.empty());
        QVERIFY(outcome.project == Project{});
    }
    void flatMeshesStayFlat() {
        QCOMPARE(faultOf(test::sheet(2, 2)), QString("\"Object 1\": The mesh is flat; an asset needs a depth."));
    }
    void tooLargeSolidsAreRejected() {
        const TriangleMesh huge = test::transformed(ball(), Mat3(1e6));
        QVERIFY2(faultOf(huge).startsWith("\"Object 1\": The size of the mesh "), qPrintable(faultOf(huge)));
    }
};

RUBBLE_TEST(SolidFitTest)
#include "SolidFitTest.moc"
