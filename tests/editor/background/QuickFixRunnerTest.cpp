#include "editor/background/QuickFixRunner.h"

#include "core/asset/bake/AssetBakes.h"
#include "core/io/project/ProjectFile.h"
#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Combs.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

std::vector<Diagnostic> problemsIn(const Project& project, DiagnosticCode kind) {
    AssetBakes bakes;
    bakes[{2, 0}] = std::make_shared<const Bake>(*bake(project.assets[0]));
    std::vector<Diagnostic> problems = problemsOf(project, bakes);
    std::erase_if(problems, [&](const Diagnostic& problem) { return problem.code != kind; });
    return problems;
}

}  // namespace

class QuickFixRunnerTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_document = std::make_unique<Document>(test::combProject());
        m_runner = std::make_unique<QuickFixRunner>(*m_document);
        m_before = projectText(m_document->project());
        m_problems = problemsIn(m_document->project(), DiagnosticCode::ManyHulls);
        QCOMPARE(m_problems.size(), std::size_t{1});
    }
    void cleanup() {
        m_runner.reset();
        m_document.reset();
    }

    void slowFixRunsInTheBackgroundAndIsOneUndoStep() {
        QSignalSpy changes(m_runner.get(), &QuickFixRunner::changed);
        m_runner->start(m_problems, QuickFix::SplitFragment);
        QVERIFY(m_runner->isBusy());
        QCOMPARE(m_runner->fix(), QuickFix::SplitFragment);
        QCOMPARE(projectText(m_document->project()), m_before);
        QTRY_VERIFY_WITH_TIMEOUT(!m_runner->isBusy(), kPatience);
        QCOMPARE(changes.count(), 2);
        QCOMPARE(m_document->undoStack().count(), 1);
        QVERIFY(problemsIn(m_document->project(), DiagnosticCode::ManyHulls).empty());
        m_document->undoStack().undo();
        QCOMPARE(projectText(m_document->project()), m_before);
    }
    void cancelledFixChangesNothing() {
        m_runner->start(m_problems, QuickFix::SplitFragment);
        m_runner->cancel();
        QVERIFY(!m_runner->isBusy());
        QCOMPARE(messagesUntilIdle(), QStringList{"Split Fragment has no effect here."});
        QCOMPARE(projectText(m_document->project()), m_before);
        QCOMPARE(m_document->undoStack().count(), 0);
    }
    void documentChangeCancelsTheFix() {
        QSignalSpy messages(m_runner.get(), &QuickFixRunner::statusMessage);
        m_runner->start(m_problems, QuickFix::SplitFragment);
        Asset renamed = m_document->project().assets[0];
        renamed.name = "comb";
        m_document->push({.text = "Rename", .replacements = {Replacement<Asset>{2, renamed}}});
        QVERIFY(!m_runner->isBusy());
        QCOMPARE(messages.count(), 1);
        QCOMPARE(messages[0][0].toString(), QString("Split Fragment was cancelled: the project changed meanwhile."));
        QCOMPARE(messagesUntilIdle(), QStringList{"Split Fragment has no effect here."});
        QCOMPARE(m_document->undoStack().count(), 1);
        QVERIFY(m_document->project().assets[0].edits.empty());
    }
    void fastFixIsAppliedAtOnce() {
        m_runner->start(problemsIn(m_document->project(), DiagnosticCode::Sliver), QuickFix::Relax);
        QVERIFY(!m_runner->isBusy());
        QCOMPARE(m_document->undoStack().count(), 1);
    }
    void fixWithoutEffectIsReported() {
        QCOMPARE(messagesUntilIdle(), QStringList{"Split Fragment has no effect here."});
        QCOMPARE(m_document->undoStack().count(), 0);
    }

private:
    /// Runs a fix without problems on the same thread and returns all messages until it is finished: earlier fixes are
    /// finished then, too.
    QStringList messagesUntilIdle() {
        QSignalSpy messages(m_runner.get(), &QuickFixRunner::statusMessage);
        m_runner->start({}, QuickFix::SplitFragment);
        QStringList sentences;
        if (!QTest::qWaitFor([&] { return !m_runner->isBusy(); }, kPatience))
            sentences.append("The runner does not finish.");
        for (const QList<QVariant>& one : messages) sentences.append(one[0].toString());
        return sentences;
    }

    std::unique_ptr<Document> m_document;
    std::unique_ptr<QuickFixRunner> m_runner;
    std::vector<Diagnostic> m_problems;
    std::string m_before;
};

RUBBLE_TEST_WITH(QuickFixRunnerTest, QCoreApplication)
#include "QuickFixRunnerTest.moc"
