#include "editor/background/PlayTestRunner.h"

#include "editor/commands/ProjectEdits.h"
#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"

#include <QSignalSpy>

using namespace rubble;

namespace {

/// A block with a test that holds and one that does not.
Project testedBlock() {
    Project project = test::floatingBlock();
    const Id block = project.instances[0].id;
    project.playTests = {{.id = project.nextId++,
                          .name = "stands",
                          .duration = 0.5,
                          .expectations = {{ExpectationKind::StandsUntouched, block, 0.5}}},
                         {.id = project.nextId++,
                          .name = "breaks",
                          .duration = 0.5,
                          .expectations = {{ExpectationKind::Breaks, block, 0.0}}}};
    return project;
}

}  // namespace

class PlayTestRunnerTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_stage = std::make_unique<test::Stage>(testedBlock());
        m_file = std::make_unique<DocumentFile>(m_stage->document);
        m_runner = std::make_unique<PlayTestRunner>(m_stage->document, *m_file, m_stage->bakes);
    }
    void reportsEachOutcome() {
        const auto& tests = m_stage->document.project().playTests;
        m_runner->run({tests[0].id, tests[1].id});
        QVERIFY(m_runner->isPending());
        QTRY_VERIFY_WITH_TIMEOUT(!m_runner->isPending(), kPatience);
        QCOMPARE(m_runner->passedCount(), 1);
        QCOMPARE(m_runner->failedCount(), 1);
        QVERIFY(m_runner->outcomeOf(tests[0].id)->isPassed());
        QVERIFY(m_runner->outcomeOf(tests[1].id)->failedAt() > 0);
    }
    void documentChangeDiscardsOutcomes() {
        const PlayTest first = m_stage->document.project().playTests[0];
        m_runner->run({first.id});
        QTRY_VERIFY_WITH_TIMEOUT(!m_runner->isPending(), kPatience);
        PlayTest changed = first;
        changed.duration = 0.4;
        m_stage->document.push(modify("shorter", changed));
        QVERIFY(m_runner->outcomeOf(first.id) == nullptr);
    }
    void cancelledRunHasNoOutcome() {
        const auto& tests = m_stage->document.project().playTests;
        m_runner->run({tests[0].id});
        m_runner->cancel();
        QVERIFY(!m_runner->isPending());
        QCOMPARE(m_runner->passedCount() + m_runner->failedCount(), 0);
        m_runner->run({tests[1].id});  // after the cancelled one, on the same thread
        QTRY_VERIFY(!m_runner->isPending());
        QVERIFY(m_runner->outcomeOf(tests[0].id) == nullptr);
        QCOMPARE(m_runner->passedCount() + m_runner->failedCount(), 1);
    }
    void refusesToRunBeforeAssetsAreBaked() {
        m_stage->bakes.clear();
        const QSignalSpy messages(m_runner.get(), &PlayTestRunner::failed);
        m_runner->run({m_stage->document.project().playTests[0].id});
        QCOMPARE(messages.size(), 1);
        QVERIFY(!m_runner->isPending());
    }
    void failureIsReplayedUpToItsStep() {
        const PlayTest& failing = m_stage->document.project().playTests[1];
        m_stage->controller.replay(scriptOf(m_stage->document.project(), failing, 30));
        m_stage->settle();
        QCOMPARE(m_stage->controller.state(), PlayState::Paused);
        QCOMPARE(m_stage->step(), 30u);
        QCOMPARE(m_stage->controller.frame()->length, 30u);
    }

private:
    std::unique_ptr<test::Stage> m_stage;
    std::unique_ptr<DocumentFile> m_file;
    std::unique_ptr<PlayTestRunner> m_runner;
};

RUBBLE_TEST_WITH(PlayTestRunnerTest, QCoreApplication)
#include "PlayTestRunnerTest.moc"
