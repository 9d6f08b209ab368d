#include "editor/document/Selection.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

class SelectionTest : public QObject {
    Q_OBJECT
private slots:
    void subjectIsTheLastSelected() {
        const Project project = fullProject();
        Selection selection;
        QCOMPARE(selection.subject(), Part::Scene);
        selection.setAsset(3);
        QCOMPARE(selection.subject(), Part::Asset);
        selection.setMaterial(2);
        QCOMPARE(selection.subject(), Part::Material);
        selection.setAsset(3);  // active already
        QCOMPARE(selection.subject(), Part::Asset);
        selection.setInstances(project, {20});
        QCOMPARE(selection.subject(), Part::Instance);
        selection.setSeeds({{4, 0}});
        QCOMPARE(selection.subject(), Part::Asset);
        selection.setInstances(project, {20, 21});
        selection.setSubject(Part::Asset);
        selection.setInstances(project, {});
        QCOMPARE(selection.subject(), Part::Asset);  // instances were not selected
    }
    void subjectChangeIsEmittedOnce() {
        Selection selection;
        selection.setAsset(3);
        QSignalSpy reported(&selection, &Selection::subjectChanged);
        selection.setInstances(fullProject(), {21});  // activates its asset, too
        QCOMPARE(reported.count(), 1);
        QCOMPARE(selection.asset(), 9u);
    }
    void seedsAreThoseOfTheEnteredFragment() {
        Selection selection;
        selection.setAsset(3);
        selection.setSeeds({{4, 0}});
        selection.setEnteredFragment("4.0");
        QVERIFY(selection.seeds().empty());
        selection.setSeeds({{8, 1}});
        selection.toggleSeed({8, 2});
        QVERIFY((selection.fragments() == FragmentSelection{{{8, 1}, {8, 2}}, std::nullopt, "4.0"}));
        QSignalSpy reported(&selection, &Selection::seedsChanged);
        selection.setEnteredFragment({});
        QCOMPARE(reported.count(), 1);
        QVERIFY((selection.seeds() == Selection::Seeds{{4, 0}}));
        selection.setEnteredFragment("4.0");
        selection.setAsset(9);
        QVERIFY(selection.enteredFragment().empty());
    }
    void emptySelectionMakesTheSceneTheSubject() {
        Selection selection;
        selection.setInstances(fullProject(), {20});
        selection.setInstances(fullProject(), {});
        QCOMPARE(selection.subject(), Part::Scene);
        selection.setSubject(Part::Material);
        QCOMPARE(selection.subject(), Part::Scene);
    }
    void pruneRemovesMissingElements() {
        Project project = fullProject();
        Selection selection;
        selection.setMaterial(2);
        selection.setInstances(project, {20, 21});
        project.instances.erase(project.instances.begin());
        project.materials.pop_back();
        selection.prune(project);
        QCOMPARE(selection.instances(), std::set<Id>{21});
        QCOMPARE(selection.material(), 0u);
        QCOMPARE(selection.subject(), Part::Instance);
    }
};

RUBBLE_TEST_WITH(SelectionTest, QCoreApplication)
#include "SelectionTest.moc"
