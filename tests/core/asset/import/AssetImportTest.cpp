// Tests core/asset/import/AssetImport.cpp and core/asset/import/ImportedSolid.cpp.
#include "core/asset/checks/VerifyProject.h"
#include "core/asset/import/AssetImport.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/Solids.h"

#include <QTest>

#include <algorithm>
#include <limits>

using namespace rubble;

namespace {

SourceObject objectOf(const std::string& name, const TriangleMesh& mesh, std::uint32_t material = 0) {
    SourceObject object{.name = name, .points = mesh.points};
    for (const auto& triangle : mesh.triangles) object.triangles.push_back({triangle, {}, material});
    return object;
}

TriangleMesh wallMesh() { return placed(prismSolid({rectangle({0, 0}, {2, 1}), {}}, 0.5), {{10, 0, 0}}); }
TriangleMesh gableMesh() { return prismSolid({{{-1, 0}, {1, 0}, {0, 1}}, {}}, 0.5); }

SourceScene sceneOf(std::vector<SourceObject> objects) {
    return {0.0, {{"Brick", {0.5, 0.2, 0.1}}, {"Slate", {0.1, 0.1, 0.1}}, {}}, std::move(objects)};
}

ImportOutcome imported(Project project, const SourceScene& scene, const ImportOptions& options = {}) {
    Result<ImportOutcome> outcome = importedInto(std::move(project), scene, "file", options, {});
    if (!outcome) qFatal("%s", outcome.error().message.c_str());
    if (verifyProject(outcome->project)) qFatal("%s", verifyProject(outcome->project)->c_str());
    return std::move(*outcome);
}

const ImportOptions kPrisms{.as = ImportShape::Prism};

QString importFault(const SourceScene& scene, const ImportOptions& options = kPrisms) {
    const Result<ImportOutcome> outcome = importedInto({}, scene, "file", options, {});
    if (!outcome) return QString::fromStdString(outcome.error().message);
    if (outcome->rejected.empty() || outcome->project != Project{}) return "";
    return QString::fromStdString(outcome->rejected[0].error.message);
}

}  // namespace

class AssetImportTest : public QObject {
    Q_OBJECT
private slots:
    void objectsBecomeAssetsAtTheirPositions() {
        const Project project =
            imported({}, sceneOf({objectOf("Wall", wallMesh()), objectOf("Gable", gableMesh(), 1)})).project;
        QCOMPARE(project.assets.size(), std::size_t{2});
        QVERIFY((project.assets[0].prism() == Prism{{rectangle({-1, -0.5}, {1, 0.5}), {}}, 0.5}));
        QVERIFY(project.instances[0].pose.position == Vec3(11.0, 0.5, 0.0));
        QCOMPARE(project.instances[1].asset, project.assets[1].id);
        QCOMPARE(project.materials[1].name, std::string("Slate"));
        QCOMPARE(project.assets[1].material, project.materials[1].id);
        QCOMPARE(project.materials[0].outside.red, 0.5);
    }
    void equalObjectsBecomeInstancesWhereWanted() {
        const SourceScene scene = sceneOf({objectOf("Wall", wallMesh()), objectOf("Gable", gableMesh()),
                                           objectOf("Second", placed(wallMesh(), {{0.1, 3, 0.7}})),
                                           objectOf("Slate", placed(wallMesh(), {{0, 9, 0}}), 1)});
        const ImportOutcome merged = imported({}, scene, {.mergesEqual = true});
        QCOMPARE(merged.project.assets.size(), std::size_t{3});  // another material is another asset
        QCOMPARE(merged.project.instances.size(), std::size_t{4});
        QCOMPARE(merged.project.instances[2].asset, merged.project.instances[0].asset);
        QVERIFY(glm::distance(merged.project.instances[2].pose.position, Vec3(11.1, 3.5, 0.7)) < 1e-4);
        QCOMPARE(merged.assets[0].merged, std::size_t{1});
        QCOMPARE(merged.assets[0].notes.back(), std::string("1 equal mesh is an instance of it."));
        QCOMPARE(imported({}, scene).project.assets.size(), std::size_t{4});
    }
    void copiesOfAnObjectBecomeInstances() {
        SourceObject wall = objectOf("Wall", wallMesh());
        const double half = std::sqrt(0.5);
        wall.copies = {{{5.0, 0.0, 1.0}, {1.0, 0.0, 0.0, 0.0}}, {{0.0, 0.0, 0.0}, {half, 0.0, 0.0, half}}};
        const Project project = imported({}, sceneOf({wall})).project;
        QCOMPARE(project.assets.size(), std::size_t{1});
        QCOMPARE(project.instances.size(), std::size_t{3});
        QVERIFY(project.instances[1].pose.position == Vec3(16.0, 0.5, 1.0));
        QVERIFY(glm::distance(project.instances[2].pose.position, Vec3(-0.5, 11.0, 0.0)) < 1e-12);  // a quarter about z

        // In millimetres and z up: z of the file is y, and y is -z.
        wall.copies = {{{1000.0, 2000.0, 3000.0}, {half, 0.0, 0.0, half}}};
        const ImportOptions options{.metresPerUnit = 1e-3, .up = UpAxis::Z};
        const std::vector<Instance> both = imported({}, sceneOf({wall}), options).project.instances;
        QCOMPARE(both.size(), std::size_t{2});
        QVERIFY(glm::distance(both[0].pose.position, Vec3(0.011, 0.0, -0.0005)) < 1e-9);
        QVERIFY(glm::distance(both[1].pose.position, Vec3(0.9995, 3.0, -2.011)) < 1e-9);
        wall.copies = {{{2e5, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}}};
        QCOMPARE(importFault(sceneOf({wall})),
                 "\"Wall\": the position is (200011, 0.5, 0), but it must be from -100000 to 100000.");
    }
    void farMeshesAreReportedWithTheirPlace() {
        const auto fault = [&](Vec3 at, double scale) {
            SourceObject wall = objectOf("Wall", wallMesh());
            for (Vec3& point : wall.points) point = scale * point + at;
            return importFault(sceneOf({wall}));
        };
        QCOMPARE(fault({0.0, 0.0, -2e5}, 1.0),
                 "\"Wall\": The mesh lies far away from the origin, at (11, 0.5, -200000) m, "
                 "and positions go up to 100000 m; move it to the origin in the program "
                 "that made it.");
        QCOMPARE(fault({4e4, 0.0, 0.0}, 0.01),
                 "\"Wall\": The mesh lies far away from the origin, at (40000, 0.005, 0) m, "
                 "and its size of 22.9 mm is lost in single precision there; move it to "
                 "the origin in the program that made it.");
        QVERIFY(fault({2e6, 0.0, 0.0}, 1000.0)
                    .endsWith("; set its unit, or move it to the origin in the program that "
                              "made it."));
        QCOMPARE(fault({4e4, 0.0, 0.0}, 10.0), "");
    }
    void sizesOutOfRangeAreReportedWithWhatToDo() {
        SourceObject wall = objectOf("Wall", wallMesh());
        for (Vec3& point : wall.points) point = 2e4 * (point - Vec3(11.0, 0.5, 0.0));
        const std::string end = " is 40000 m, but it must be from 0.00001 to 10000 m. Choose another unit at import.";
        QCOMPARE(importFault(sceneOf({wall})).toStdString(), "\"Wall\": The width of the outline" + end);
        QCOMPARE(importFault(sceneOf({wall}), {.as = ImportShape::Solid}).toStdString(),
                 "\"Wall\": The size of the mesh along x" + end);
    }
    void greatestNextIdReusesIds() {
        Project project;
        project.nextId = std::numeric_limits<Id>::max() - 1;
        const ImportOutcome outcome =
            imported(project, sceneOf({objectOf("wall", wallMesh()), objectOf("gable", gableMesh(), 1)}));
        QCOMPARE(outcome.project.assets.size(), std::size_t{2});  // imported() verifies the project
    }
    void existingMaterialsAreReused() {
        Project project{.nextId = 3,
                        .materials = {{.id = 1, .name = "Slate"}, {.id = 2, .name = "Brick", .density = 1800}}};
        project = imported(project, sceneOf({objectOf("a", wallMesh(), 0), objectOf("b", wallMesh(), 2)})).project;
        QCOMPARE(project.materials.size(), std::size_t{2});
        QCOMPARE(project.assets[0].material, 2u);
        QCOMPARE(project.assets[1].material, 1u);  // without a name: the project's first
    }
    void thresholdsAreDerivedWhereTheStrengthIsKnown() {
        const Project project{.nextId = 2, .materials = {{.id = 1, .name = "Slate", .tensileStrength = 1e7}}};
        const ImportOutcome outcome =
            imported(project, sceneOf({objectOf("a", wallMesh(), 0), objectOf("b", wallMesh(), 1)}));
        QVERIFY(!outcome.project.assets[0].contactTime);
        QVERIFY(outcome.project.assets[1].contactTime);
    }
    /// Assets that differ in capitals only could not be exported side by side.
    void namesAreComparedWithoutCase() {
        const SourceScene scene = sceneOf({objectOf("wall", wallMesh()), objectOf("Wall", wallMesh())});
        const ImportOutcome outcome = imported({}, scene);
        QCOMPARE(outcome.project.assets[1].name, std::string("Wall 2"));
        QCOMPARE(outcome.project.instances[1].name, std::string("Wall 2"));
    }
    void takenNamesAreNumberedAndNoted() {
        const SourceScene scene = sceneOf({objectOf("Wall", wallMesh()), objectOf("Wall", wallMesh())});
        const ImportOutcome outcome = imported({}, scene);
        QCOMPARE(outcome.project.assets[1].name, std::string("Wall 2"));
        QCOMPARE(outcome.assets[1].notes.back(),
                 std::string("The name \"Wall\" is taken; the asset is named \"Wall 2\"."));
        QCOMPARE(imported({}, sceneOf({objectOf("", wallMesh())})).project.assets[0].name, std::string("file"));
    }
    void reimportReplacesPrismAndSurfaceOnly() {
        const SourceScene scene = sceneOf({objectOf("Wall", wallMesh())});
        Project before = imported({}, scene).project;
        before.assets[0].threshold = 7.0;
        before.assets[0].levels.push_back({});
        const ImportOutcome again = imported(before, sceneOf({objectOf("New", gableMesh(), 1)}), {.asset = "Wall"});
        QVERIFY(again.assets[0].isReplaced);
        Project expected = before;
        expected.assets[0].prism() = again.project.assets[0].prism();
        QVERIFY(again.project == expected);
        QCOMPARE(again.project.assets[0].prism().outline.outer.size(), std::size_t{3});
    }
    void newInstancesAreFixedAndUnbreakableIfWanted() {
        const ImportOutcome outcome =
            imported({}, sceneOf({objectOf("Wall", wallMesh())}), {.isFixed = true, .isUnbreakable = true});
        QVERIFY(outcome.project.instances[0].isFixed && outcome.project.instances[0].isUnbreakable);
        const ImportOutcome plain = imported({}, sceneOf({objectOf("Wall", wallMesh())}));
        QVERIFY(!plain.project.instances[0].isFixed && !plain.project.instances[0].isUnbreakable);
    }
    void unitAndUpAxisAreApplied() {
        const ImportOptions options{.metresPerUnit = 0.001, .up = UpAxis::Z};
        const ImportOutcome outcome = imported({}, sceneOf({objectOf("Wall", wallMesh())}), options);
        QCOMPARE(outcome.assets[0].prism->depth, 0.0005);
        QVERIFY(glm::distance(outcome.project.instances[0].pose.position, Vec3(0.011, 0.0, -0.0005)) < 1e-9);
        QCOMPARE(axisText(outcome.assets[0].prism->axis), std::string("y"));
        SourceScene inches = sceneOf({objectOf("Wall", wallMesh())});
        inches.metresPerUnit = 0.0254;
        QVERIFY(std::abs(imported({}, inches).assets[0].prism->depth - 0.0127) < 1e-9);
    }
    void unconnectedPartsBecomeSeparateAssets() {
        const TriangleMesh both = joined(wallMesh(), gableMesh());
        const ImportOutcome outcome = imported({}, sceneOf({objectOf("Set", both)}));
        QCOMPARE(outcome.project.assets.size(), std::size_t{2});
        QCOMPARE(outcome.assets[0].notes[0], std::string("The object has 2 unconnected parts, imported one by one."));
        QCOMPARE(importFault(sceneOf({objectOf("Set", both)}), {.asset = "Set"}),
                 QString("\"Set\" would have 2 parts; an asset has one."));
    }
    void partsThatTouchBecomeSeparateAssets() {
        const TriangleMesh cube = prismSolid(unitSquare(), 1.0);
        const ImportOutcome outcome = imported({}, sceneOf({objectOf("Set", joined(cube, placed(cube, {{1, 1, 0}})))}));
        QCOMPARE(outcome.project.assets.size(), std::size_t{2});
        QCOMPARE(outcome.assets[0].notes[0],
                 std::string("The object has 2 parts, some of which only touch, imported one by one."));
    }
    void onlyDuplicatesAreNumbered() {
        std::vector<SourceObject> objects;
        for (const char* name : {"Cube", "Cube", "Cube 2", "cube"})
            objects.push_back(
                objectOf(name, placed(wallMesh(), {{0.0, 3.0 * static_cast<double>(objects.size()), 0.0}})));
        objects[2].copies = {{{9.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}}};
        const Project project = imported({}, sceneOf(objects)).project;
        const auto namesOf = [](const auto& elements) {
            QStringList names;
            for (const auto& element : elements) names.append(QString::fromStdString(element.name));
            return names;
        };
        QCOMPARE(namesOf(project.assets), QStringList({"Cube", "Cube 3", "Cube 2", "cube 4"}));
        QCOMPARE(namesOf(project.instances), QStringList({"Cube", "Cube 3", "Cube 2", "Cube 2 2", "cube 4"}));
    }
    void roundedPrismIsImportedWithANote() {
        TriangleMesh mesh = placed(prismSolid(lShape(), 0.5), {{1, 2, 3}, glm::normalize(Quat(0.9, 0.2, 0.3, 0.1))});
        for (Vec3& point : mesh.points) point = glm::round(point * 1e3) / 1e3;
        SourceObject object = objectOf("Wall", mesh);
        QVERIFY(!importFault(sceneOf({object})).isEmpty());
        object.rounding = 0.867e-3;
        const ImportOutcome outcome = imported({}, sceneOf({object}));
        QCOMPARE(outcome.assets[0].tolerance, 0.867e-3);
        const QString note = QString::fromStdString(outcome.assets[0].notes[0]);
        QVERIFY2(note.startsWith("The file rounds points by up to 0.867 mm; the prism is fitted to them within 0."),
                 qPrintable(note));
        QVERIFY(std::abs(volumeOf(*outcome.assets[0].prism) - 1.5) < 1.5e-3);
        // Thinner, the rounding may be all that there is.
        for (Vec3& point : object.points) point *= 0.03;
        const QString fault = importFault(sceneOf({object}));
        QVERIFY2(fault.endsWith("; the file rounds points by up to 0.867 mm, too much to tell whether it is a prism: "
                                "export it with more decimals or finer quantization."),
                 qPrintable(fault));
    }
    void cavityIsRejected() {
        TriangleMesh hollow = prismSolid({rectangle({0, 0}, {1, 1}), {}}, 1.0);
        for (Vec3& point : hollow.points) point = 0.5 * point + Vec3(10.5, 0.25, 0.0);
        for (auto& triangle : hollow.triangles) std::swap(triangle[0], triangle[1]);
        TriangleMesh around = placed(prismSolid({rectangle({0, 0}, {2, 1}), {}}, 2.0), {{10, 0, 0}});
        QCOMPARE(importFault(sceneOf({objectOf("Box", joined(around, hollow))})),
                 QString("\"Box\": The mesh has a cavity: one of its 2 parts is inverted and lies within another."));
    }
    void nonPrismIsRejectedOrReplacedByItsFallback() {
        TriangleMesh mesh = prismSolid(lShape(), 0.5);
        for (std::size_t i = 6; i < 12; ++i) mesh.points[i] += Vec3(0.0032, 0, 0);
        const SourceScene scene = sceneOf({objectOf("Bent", mesh)});
        const QString shifted = "The top cap is shifted by 3.2 mm relative to the bottom, seen along the z axis.";
        QCOMPARE(importFault(scene), "\"Bent\": " + shifted);
        const ImportOutcome cap = imported({}, scene, {.fallback = PrismFallback::TopCap});
        QVERIFY(cap.assets[0].usesFallback);
        QCOMPARE(QString::fromStdString(cap.assets[0].notes[0]), "The top cap along z is used instead. " + shifted);
        QCOMPARE(area(cap.project.assets[0].prism().outline), 3.0);
        for (std::size_t i = 6; i < 12; ++i) mesh.points[i] += Vec3(0.5, 0, 0);
        const ImportOutcome wide =
            imported({}, sceneOf({objectOf("Bent", mesh)}), {.fallback = PrismFallback::Silhouette});
        QVERIFY(wide.assets[0].notes[0].ends_with(". The volume changes from 1.5 m³ to 2.003 m³."));
        const ImportOutcome shadow = imported({}, scene, {.fallback = PrismFallback::Silhouette});
        QVERIFY(std::abs(area(shadow.project.assets[0].prism().outline) - 3.0 - 2.0 * 0.0032) < 1e-6);
    }
    void onlyFallbacksThatWorkAreFound() {
        const auto fallbacks = [](const TriangleMesh& mesh, PrismAxis axis = PrismAxis::Thinnest) {
            const ImportOptions options{.as = ImportShape::Prism, .axis = axis, .findsFallbacks = true};
            return importedInto({}, sceneOf({objectOf("Object", mesh)}), "file", options, {})->rejected.at(0).fallbacks;
        };
        using enum PrismFallback;
        TriangleMesh leaning = prismSolid(lShape(), 0.5);
        for (std::size_t i = 6; i < 12; ++i) leaning.points[i] += Vec3(0.0032, 0, 0);
        QVERIFY((fallbacks(leaning) ==
                 std::vector<WorkingFallback>{{Silhouette, PrismAxis::Thinnest}, {TopCap, PrismAxis::Thinnest}}));
        // A pyramid has no face at its top.
        const TriangleMesh pyramid{{{0, 0, 0}, {2, 0, 0}, {0, 0, 2}, {0, 1, 0}},
                                   {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}}};
        const ImportOutcome refused = *importedInto({}, sceneOf({objectOf("Object", pyramid)}), "file",
                                                    {.as = ImportShape::Prism, .findsFallbacks = true}, {});
        const RejectedObject& object = refused.rejected.at(0);
        QVERIFY(std::abs(*object.volume - 2.0 / 3.0) < 1e-9);
        QVERIFY(std::abs(object.fallbacks.at(0).volume - 2.0) < 1e-6 && object.isReshapedBy(object.fallbacks[0]));
        QVERIFY((fallbacks(pyramid, PrismAxis::Y) == std::vector<WorkingFallback>{{Silhouette, PrismAxis::Y}}));
        for (const PrismAxis axis : {PrismAxis::Thinnest, PrismAxis::Z}) {
            QVERIFY((fallbacks(touchingInProjection(), axis) ==
                     std::vector<WorkingFallback>{{Silhouette, PrismAxis::X}, {TopCap, axis}}));
        }
        QVERIFY((fallbacks(touchingInProjection(), PrismAxis::Y) ==
                 std::vector<WorkingFallback>{{Silhouette, PrismAxis::Y}, {TopCap, PrismAxis::Z}}));
        const TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 1}}, {{0, 1, 2}, {0, 2, 3}}};
        QVERIFY(fallbacks(flat).empty());
        for (Vec3& point : leaning.points) point *= 1e7;  // larger than a project allows
        QVERIFY(fallbacks(leaning).empty());
    }
    void fallbackThatFailsIsReplacedByOneThatWorks() {
        const ImportOptions options{.fallback = PrismFallback::Silhouette, .findsFallbacks = true};
        const Result<ImportOutcome> outcome =
            importedInto({}, sceneOf({objectOf("Mesh", touchingInProjection())}), "file", options, {});
        const RejectedObject& rejected = outcome->rejected.at(0);
        QVERIFY(rejected.error.message.starts_with("\"Mesh\": Its silhouette cannot be used instead: "));
        QVERIFY((rejected.fallbacks == std::vector<WorkingFallback>{{PrismFallback::Silhouette, PrismAxis::X},
                                                                    {PrismFallback::TopCap, PrismAxis::Thinnest}}));
    }
    void flatMeshIsRejectedAsFlat() {
        const TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 1}}, {{0, 1, 2}, {0, 2, 3}}};
        for (const std::optional<PrismFallback>& fallback :
             {std::optional<PrismFallback>(), std::optional(PrismFallback::Silhouette)})
            QCOMPARE(importFault(sceneOf({objectOf("Sheet", flat)}), {.fallback = fallback}),
                     QString("\"Sheet\": The mesh is flat; an asset needs a depth."));
    }
    void failedFallbackIsNamed() {
        const TriangleMesh pyramid{{{0, 0, 0}, {2, 0, 0}, {0, 0, 2}, {0, 1, 0}},
                                   {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}}};
        QCOMPARE(
            importFault(sceneOf({objectOf("Roof", pyramid)}),
                        {.axis = PrismAxis::Y, .fallback = PrismFallback::TopCap}),
            QString(
                "\"Roof\": Its top cap cannot be used instead: The mesh has no flat face at the end of the y axis."));
    }
    void notesOfTheFileAreKept() {
        SourceScene scene = sceneOf({objectOf("Wall", wallMesh())});
        scene.notes = {"The file refers to another."};
        QCOMPARE(imported({}, scene).assets[0].notes.at(0), scene.notes[0]);
    }
    void rejectedObjectsDoNotBlockOthers() {
        TriangleMesh open = gableMesh();
        open.triangles.pop_back();
        const SourceObject wall = objectOf("Wall", wallMesh()), gable = objectOf("Gable", gableMesh(), 1);
        const ImportOutcome outcome = imported({}, sceneOf({wall, objectOf("Open", open), gable}), kPrisms);
        QVERIFY(outcome.project == imported({}, sceneOf({wall, gable})).project);
        QCOMPARE(outcome.assets.size(), std::size_t{2});
        QCOMPARE(outcome.rejected.size(), std::size_t{1});
        QCOMPARE(outcome.rejected[0].error.message,
                 std::string("\"Open\": The mesh is not closed: 3 edges have one face only."));
        const ImportOutcome parts = imported({}, sceneOf({objectOf("Set", joined(open, wallMesh()))}));
        QCOMPARE(parts.assets.size(), std::size_t{1});
        QCOMPARE(parts.rejected[0].error.code, ErrorCode::Degenerate);
    }
    void textureCoordinatesOutOfRangeAreRejected() {
        SourceObject wall = objectOf("Wall", wallMesh());
        wall.hasUvs = true;
        wall.triangles[0].uvs[0] = {2e9, 0.0};
        QVERIFY2(importFault(sceneOf({wall})).startsWith("\"Wall\": "), qPrintable(importFault(sceneOf({wall}))));
        QVERIFY(importFault(sceneOf({wall})).contains("2000000000"));
        wall.triangles[0].uvs[0] = {1e9, 0.0};
        QCOMPARE(importFault(sceneOf({wall})), QString());
    }
    void otherErrorsAreNamed() {
        const SourceScene scene = sceneOf({objectOf("Wall", wallMesh()), objectOf("Gable", gableMesh())});
        QCOMPARE(importFault(scene, {.asset = "Roof"}),
                 QString("The file has several objects and none named \"Roof\"; it has \"Wall\", \"Gable\"."));
        QCOMPARE(importFault(scene, {.metresPerUnit = 0.0}),
                 QString("The unit is 0 m; it must be from 0.000001 to 1000000."));
        const TaskContext context;
        context.cancel.cancel();
        QVERIFY(importedInto({}, scene, "file", {}, context).error().code == ErrorCode::Cancelled);
    }
    void invertedTrianglesAreFlippedAndNoted() {
        TriangleMesh mesh = gableMesh();
        std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
        const ImportOutcome outcome = imported({}, sceneOf({objectOf("Gable", mesh)}));
        QCOMPARE(outcome.assets[0].notes[0], std::string("The orientation of 1 inverted triangle was corrected."));
    }
};

RUBBLE_TEST(AssetImportTest)
#include "AssetImportTest.moc"
