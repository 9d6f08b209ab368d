#include "editor/document/UnrecordedEdits.h"

#include "core/asset/library/StarterProject.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/TestImages.h"

#include <QTest>

using namespace rubble;

namespace {

Changes changeOf(Part part, Id id) { return {.list = {{part, id, ChangeKind::Modified}}}; }

}  // namespace

class UnrecordedEditsTest : public QObject {
    Q_OBJECT
private slots:
    void elementsAreTakenOnceAsTheyAre() {
        Project project = starterProject();
        UnrecordedEdits edits;
        QVERIFY(edits.isEmpty());
        const Id wall = project.instances[0].id;
        edits.note(changeOf(Part::Instance, wall));
        edits.note(changeOf(Part::Instance, wall));
        edits.note(changeOf(Part::Shot, 99));
        project.instances[0].name = "renamed";
        const ProjectPart part = edits.take(project);
        QVERIFY(part.values.instances == project.instances && part.values.assets.empty());
        QVERIFY(part.removedShots == std::vector<Id>{99} && part.removedInstances.empty());
        QVERIFY(edits.isEmpty() && edits.take(project).values.instances.empty());
    }
    void replacedProjectsAreToBeWrittenWhole() {
        UnrecordedEdits edits;
        edits.note({.isEverything = true});
        QVERIFY(edits.isEverything() && !edits.isEmpty());
        edits.forget(starterProject());
        QVERIFY(edits.isEmpty());
    }
    void sameTexturesAreRecordedOnce() {
        Project project = starterProject();
        const Id id = project.assets[0].id;
        UnrecordedEdits edits;
        edits.forget(project);
        project.assets[0].texture = Texture{"a.png", std::make_shared<const EncodedImage>(imageOf(checkerPng())), {0}};
        for (const bool isKept : {false, true}) {
            edits.note(changeOf(Part::Asset, id));
            const ProjectPart part = edits.take(project);
            QCOMPARE(part.values.assets[0].texture.has_value(), !isKept);
            QCOMPARE(part.keptTextures.size(), std::size_t{isKept});
        }
        const Result<Project> replayed = [&] {
            ContentHash seal;
            edits.note(changeOf(Part::Asset, id));
            const std::string record = journalRecord(edits.take(project), seal);
            return rubble::replayed(project, {}, journalStart({}) + record);
        }();
        QVERIFY(replayed && *replayed == project);
    }
};

RUBBLE_TEST(UnrecordedEditsTest)
#include "UnrecordedEditsTest.moc"
