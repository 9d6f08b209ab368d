// Tests editor/workspace/Workspace.cpp: what is derived from a document, where that is replaced or closed meanwhile.
#include "editor/workspace/Workspace.h"

#include "tests/support/TestProgram.h"
#include "tests/support/editor/BakedAssets.h"
#include "tests/support/play/MortarPortal.h"

#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

/// The portal with its mortar and a test of ten seconds.
Project testedPortal() {
    Project project = test::mortarPortal();
    project.playTests = {{.id = project.nextId++,
                          .name = "stands",
                          .duration = 10.0,
                          .expectations = {{ExpectationKind::StandsUntouched, project.instances[0].id, 10.0}}}};
    return project;
}

/// An open project that is tested and audited, while its problems and the joints of its mortar are looked for.
struct BusyWorkspace {
    QTemporaryDir folder;
    Workspace workspace{testedPortal(), folder.path()};

    BusyWorkspace() {
        test::bakeAll(workspace.project(), workspace.bakes());
        workspace.playTests().run({workspace.project().playTests[0].id});
        workspace.swapAudits().audit(workspace.project().instances[0].asset);
        workspace.problems().invalidate();
        workspace.mortars().invalidate();
    }
    bool isBusy() {
        return workspace.playTests().isPending() && workspace.swapAudits().isPending() &&
               workspace.problems().isPending() && workspace.mortars().isPending();
    }
};

}  // namespace

class WorkspaceTest : public QObject {
    Q_OBJECT
private slots:
    void closesWhileResultsAreComputed() {
        BusyWorkspace busy;
        QVERIFY(busy.isBusy());
    }
    void anotherProjectReplacesWhatIsBeingComputed() {
        BusyWorkspace busy;
        QVERIFY(busy.isBusy());
        Workspace& workspace = busy.workspace;
        QTRY_VERIFY_WITH_TIMEOUT(workspace.mortars().isCurrent(), kPatience);
        const Id mortar = workspace.project().mortars[0].id;
        QVERIFY(workspace.mortars().find(mortar) != nullptr);
        workspace.document().replace(testedPortal());
        QVERIFY(workspace.mortars().find(mortar) == nullptr && workspace.problems().all().empty());
        QCOMPARE(workspace.playTests().state(), DerivedState::State::Idle);
        QCOMPARE(workspace.swapAudits().state(), DerivedState::State::Idle);
        QTRY_VERIFY_WITH_TIMEOUT(workspace.mortars().isCurrent() && workspace.problems().isCurrent(), kPatience);
        QVERIFY(workspace.mortars().find(mortar) != nullptr);
        QVERIFY(workspace.playTests().value().empty());
    }
};

RUBBLE_TEST_WITH(WorkspaceTest, QCoreApplication)
#include "WorkspaceTest.moc"
