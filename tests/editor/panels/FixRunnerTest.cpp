#include "editor/panels/FixRunner.h"

#include "core/asset/AssetBakes.h"
#include "core/io/ProjectFile.h"
#include "tests/support/Combs.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

constexpr int kPatience = 60000;  // ms, for baking on a busy machine

std::vector<Problem> problemsIn(const Project& project, ProblemKind kind) {
    AssetBakes bakes;
    bakes[{2, 0}] = std::make_shared<const Bake>(*bake(project.assets[0]));
    std::vector<Problem> problems = problemsOf(project, bakes);
    std::erase_if(problems, [&](const Problem& problem) { return problem.kind != kind; });
    return problems;
}

}  // namespace

class FixRunnerTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_document = std::make_unique<Document>(test::combProject());
        m_runner = std::make_unique<FixRunner>(*m_document);
        m_before = projectText(m_document->project());
        m_problems = problemsIn(m_document->project(), ProblemKind::ManyHulls);
        QCOMPARE(m_problems.size(), std::size_t{1});
    }
    void cleanup() {
        m_runner.reset();
        m_document.reset();
    }

    void cuttingApartGoesOnInTheBackgroundAndIsOneStep() {
        QSignalSpy changes(m_runner.get(), &FixRunner::changed);
        m_runner->start(m_problems, ProblemFix::CutApart);
        QVERIFY(m_runner->isBusy());
        QCOMPARE(m_runner->fix(), ProblemFix::CutApart);
        QCOMPARE(projectText(m_document->project()), m_before);
        QTRY_VERIFY_WITH_TIMEOUT(!m_runner->isBusy(), kPatience);
        QCOMPARE(changes.count(), 2);
        QCOMPARE(m_document->undoStack().count(), 1);
        QVERIFY(problemsIn(m_document->project(), ProblemKind::ManyHulls).empty());
        m_document->undoStack().undo();
        QCOMPARE(projectText(m_document->project()), m_before);
    }
    void nothingStaysOfWhatIsCancelled() {
        m_runner->start(m_problems, ProblemFix::CutApart);
        m_runner->cancel();
        QVERIFY(!m_runner->isBusy());
        QCOMPARE(whatIsSaidAfterAll(), QStringList{"Cut Apart changes nothing there."});
        QCOMPARE(projectText(m_document->project()), m_before);
        QCOMPARE(m_document->undoStack().count(), 0);
    }
    void whatChangesMeanwhileGoesFirst() {
        QSignalSpy said(m_runner.get(), &FixRunner::said);
        m_runner->start(m_problems, ProblemFix::CutApart);
        Asset renamed = m_document->project().assets[0];
        renamed.name = "comb";
        m_document->push({.text = "Rename", .swaps = {Swap<Asset>{2, renamed}}});
        QVERIFY(!m_runner->isBusy());
        QCOMPARE(said.count(), 1);
        QCOMPARE(said[0][0].toString(), QString("Cut Apart was given up: the project changed meanwhile."));
        QCOMPARE(whatIsSaidAfterAll(), QStringList{"Cut Apart changes nothing there."});
        QCOMPARE(m_document->undoStack().count(), 1);
        QVERIFY(m_document->project().assets[0].edits.empty());
    }
    void whatIsQuickIsDoneAtOnce() {
        m_runner->start(problemsIn(m_document->project(), ProblemKind::Sliver), ProblemFix::Relax);
        QVERIFY(!m_runner->isBusy());
        QCOMPARE(m_document->undoStack().count(), 1);
    }
    void whatChangesNothingIsTold() {
        QCOMPARE(whatIsSaidAfterAll(), QStringList{"Cut Apart changes nothing there."});
        QCOMPARE(m_document->undoStack().count(), 0);
    }

private:
    /// What is said until another fix, of nothing, has gone through the one thread: all that came before is over then.
    QStringList whatIsSaidAfterAll() {
        QSignalSpy said(m_runner.get(), &FixRunner::said);
        m_runner->start({}, ProblemFix::CutApart);
        QStringList sentences;
        if (!QTest::qWaitFor([&] { return !m_runner->isBusy(); }, kPatience)) sentences.append("It is busy for ever.");
        for (const QList<QVariant>& one : said) sentences.append(one[0].toString());
        return sentences;
    }

    std::unique_ptr<Document> m_document;
    std::unique_ptr<FixRunner> m_runner;
    std::vector<Problem> m_problems;
    std::string m_before;
};

QTEST_GUILESS_MAIN(FixRunnerTest)
#include "FixRunnerTest.moc"
