#include "editor/document/Edit.h"

#include "core/asset/checks/VerifyProject.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

#include <limits>

using namespace rubble;

namespace {

Material named(Id id, const char* name) { return {.id = id, .name = name}; }

Project twoMaterials() {
    Project project;
    project.nextId = 5;
    project.materials = {named(1, "stone"), named(3, "brick")};
    return project;
}

}  // namespace

class EditTest : public QObject {
    Q_OBJECT
private slots:
    void swappingTwiceRestoresTheProject() {
        Project project = twoMaterials();
        Edit edit{.replacements = {Replacement<Material>{1, std::nullopt}, Replacement<Material>{2, named(2, "glass")},
                                   Replacement<Material>{3, named(3, "tile")}}};
        const Changes changes = applyEdit(project, edit);
        QCOMPARE(project.materials, (std::vector{named(2, "glass"), named(3, "tile")}));
        QVERIFY((changes.list == std::vector<Change>{{Part::Material, 1, ChangeKind::Removed},
                                                     {Part::Material, 2, ChangeKind::Added},
                                                     {Part::Material, 3, ChangeKind::Modified}}));
        QVERIFY(changes.touches(Part::Material, 2) && !changes.touches(Part::Material, 4));
        applyEdit(project, edit);
        QVERIFY(project == twoMaterials());
    }
    void allocatedIdsAreConsecutiveAndRestored() {
        Project project = twoMaterials();
        Edit edit;
        QCOMPARE(edit.allocateId(project), Id{5});
        QCOMPARE(edit.allocateId(project), Id{6});
        applyEdit(project, edit);
        QCOMPARE(project.nextId, Id{7});
        applyEdit(project, edit);
        QCOMPARE(project.nextId, Id{5});
    }
    void greatestNextIdReusesIds() {
        Project project = twoMaterials();
        project.nextId = std::numeric_limits<Id>::max() - 1;
        Edit edit;
        QCOMPARE(edit.allocateId(project), std::numeric_limits<Id>::max() - 1);
        for (const Id id : {2u, 4u, 5u}) {
            QCOMPARE(edit.allocateId(project), id);
            edit.replacements.push_back(Replacement<Material>{id, named(id, id == 2   ? "glass"
                                                                            : id == 4 ? "ice"
                                                                                      : "wood")});
        }
        applyEdit(project, edit);
        QCOMPARE(project.nextId, std::numeric_limits<Id>::max());
        QVERIFY(!verifyProject(project));
    }
    void mergedEditKeepsTheOldestValue() {
        Project project = twoMaterials();
        Edit first{.replacements = {Replacement<Material>{1, named(1, "slate")}}};
        Edit second{
            .replacements = {Replacement<Material>{1, named(1, "marble")}, Replacement<Material>{3, named(3, "tile")}}};
        applyEdit(project, first);
        applyEdit(project, second);
        merge(first, std::move(second));
        applyEdit(project, first);
        QVERIFY(project == twoMaterials());
    }
    void equalValuesAreNoChange() {
        QVERIFY(isNoChange(twoMaterials(), {.replacements = {Replacement<Material>{1, named(1, "stone")}}}));
        QVERIFY(isNoChange(twoMaterials(), {.replacements = {Replacement<Material>{2, std::nullopt}}}));
        QVERIFY(!isNoChange(twoMaterials(), {.replacements = {Replacement<Material>{1, std::nullopt}}}));
        QVERIFY(!isNoChange(twoMaterials(), {.replacements = {}, .nextId = Id{6}}));
    }
};

RUBBLE_TEST(EditTest)
#include "EditTest.moc"
