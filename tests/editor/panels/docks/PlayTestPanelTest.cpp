// Tests editor/panels/docks/PlayTestPanel.cpp, editor/panels/docks/PlayTestTree.cpp and
// editor/panels/docks/PlayTestForm.cpp.
#include "editor/panels/docks/PlayTestPanel.h"

#include "core/io/play/StateFile.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/panels/docks/PlayTestTree.h"
#include "editor/widgets/NumberField.h"
#include "editor/widgets/StateField.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/FailingWork.h"
#include "tests/support/editor/PlayStage.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>

using namespace rubble;

namespace {

/// A block with a test that holds and one that does not, and two saved throws.
Project testedBlock() {
    Project project = test::floatingBlock();
    const Id block = project.instances[0].id;
    project.shots = {{.id = project.nextId++, .name = "ball", .action = Throw{}},
                     {.id = project.nextId++, .name = "blast", .action = Blast{}}};
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

class PlayTestPanelTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_stage = std::make_unique<test::Stage>(testedBlock());
        m_file = std::make_unique<DocumentFile>(m_stage->document);
        m_runner = std::make_unique<PlayTestRunner>(m_stage->document, *m_file, m_stage->bakes);
        m_panel = std::make_unique<PlayTestPanel>(m_stage->document, *m_file, m_stage->controller, *m_runner);
        m_tree = m_panel->findChild<PlayTestTree*>();
        QVERIFY(m_tree);
    }
    void cleanup() {
        m_panel.reset();
        m_runner.reset();
        m_file.reset();
        m_stage.reset();
    }
    void testStartsFromAStateBesideTheProject() {
        const QTemporaryDir folder;
        QVERIFY(m_file->saveAs(folder.filePath("block.rubble")));
        Session session = test::sessionOf(m_stage->document.project());
        for (int step = 0; step < 30; ++step) session.step();
        QVERIFY(saveState(folder.filePath("later.rubblestate").toStdString(), session, StateKind::Whole));
        auto* field = m_panel->findChild<StateField*>();
        field->showPopup();
        field->hidePopup();
        QCOMPARE(field->count(), 2);
        field->setCurrentIndex(1);
        emit field->activated(1);
        QCOMPARE(m_stage->document.project().playTests[0].state, "later.rubblestate");
        const Id id = m_stage->document.project().playTests[0].id;
        m_runner->run({id});
        QTRY_VERIFY_WITH_TIMEOUT(!m_runner->isPending(), kPatience);
        QVERIFY(m_runner->outcomeOf(id) && m_runner->outcomeOf(id)->isPassed());
        m_panel->findChild<QToolButton*>("show-failure")->click();  // the test itself, as it has not failed
        m_stage->settle();
        QCOMPARE(m_stage->controller.frame()->step, std::uint64_t{30});
        QVERIFY(QFile::remove(folder.filePath("later.rubblestate")));
        const QSignalSpy status(m_panel.get(), &PlayTestPanel::statusMessage);
        m_runner->run({id});
        QTRY_VERIFY_WITH_TIMEOUT(!m_runner->isPending(), kPatience);
        QVERIFY(m_runner->outcomeOf(id) == nullptr);
        m_panel->findChild<QToolButton*>("show-failure")->click();
        QCOMPARE(status.size(), 2);  // of the run, and of the replay
        for (const QVariantList& message : status) QVERIFY(message[0].toString().startsWith("Test \"stands\": "));
        field->showPopup();
        field->hidePopup();
        QCOMPARE(field->currentText(), "later.rubblestate (missing)");
    }
    void treeListsTestsAndExpectations() {
        QCOMPARE(m_tree->topLevelItemCount(), 2);
        QCOMPARE(m_tree->topLevelItem(1)->text(0), "breaks");
        QCOMPARE(m_tree->topLevelItem(1)->child(0)->text(0), "block breaks");
        QCOMPARE(m_tree->test()->name, "stands");  // one is always selected
        QVERIFY(!m_tree->expectation());
    }
    void formShowsWhatIsSelected() {
        QVERIFY(field("Value")->parentWidget()->isHidden() || !field("Value")->isVisibleTo(m_panel.get()));
        m_tree->setCurrentItem(m_tree->topLevelItem(0)->child(0));
        QCOMPARE(m_tree->expectation(), std::optional<std::size_t>(0));
        QCOMPARE(name()->text(), "stands");
        QVERIFY(field("Value")->isVisibleTo(m_panel.get()));
        QCOMPARE(field("Value")->value(), 0.5);
        m_tree->setCurrentItem(m_tree->topLevelItem(1)->child(0));  // Breaks has no value
        QCOMPARE(name()->text(), "breaks");
        QVERIFY(!field("Value")->isVisibleTo(m_panel.get()));
    }
    void fieldsEditTheSelectedTest() {
        m_tree->select(tests()[1].id);
        name()->setText("falls");
        name()->setModified(true);
        emit name()->editingFinished();
        QCOMPARE(tests()[1].name, "falls");
        emit field("Duration")->edited(2.0);
        QCOMPARE(tests()[1].duration, 2.0);
        QCOMPARE(m_tree->test()->name, "falls");  // the selection is kept
        auto* shots = m_panel->findChild<QListWidget*>("shots");
        shots->item(1)->setCheckState(Qt::Checked);
        shots->item(0)->setCheckState(Qt::Checked);
        QCOMPARE(tests()[1].shots, (std::vector<Id>{shotIds()[0], shotIds()[1]}));
        shots->item(0)->setCheckState(Qt::Unchecked);
        QCOMPARE(tests()[1].shots, (std::vector<Id>{shotIds()[1]}));
        QCOMPARE(tests()[0], testedBlock().playTests[0]);
    }
    void instancesAreRemovedAtTheStart() {
        m_tree->select(tests()[1].id);
        const Id block = m_stage->document.project().instances[0].id;
        auto* removed = m_panel->findChild<QListWidget*>("removed");
        QCOMPARE(removed->count(), 1);
        removed->item(0)->setCheckState(Qt::Checked);
        QCOMPARE(tests()[1].removed, (std::vector<InstancePart>{{block, {}}}));
        QCOMPARE(removed->item(0)->checkState(), Qt::Checked);
        removed->item(0)->setCheckState(Qt::Unchecked);
        QCOMPARE(tests()[1].removed, std::vector<InstancePart>());
        PlayTest test = tests()[1];
        test.removed = {{block, {"5.1", "5.2"}}};
        QVERIFY(m_stage->document.push(modify("Change", std::move(test))));
        QCOMPARE(removed->item(0)->checkState(), Qt::PartiallyChecked);
        QVERIFY(removed->item(0)->text().startsWith("block ("));
    }
    void conditionChangesToItsDefaultValue() {
        m_tree->setCurrentItem(m_tree->topLevelItem(1)->child(0));
        auto* kind = combo("Condition");
        emit kind->activated(static_cast<int>(ExpectationKind::BreaksIntoAtLeast));
        const Expectation& changed = tests()[1].expectations[0];
        QCOMPARE(changed.kind, ExpectationKind::BreaksIntoAtLeast);
        QCOMPARE(changed.value, 2.0);
        emit combo("Instance")->activated(0);  // All Instances
        QCOMPARE(tests()[1].expectations[0].instance, Id{0});
    }
    void buttonsAddAndDelete() {
        button("Add Test")->click();
        QCOMPARE(tests().size(), std::size_t{3});
        QCOMPARE(m_tree->test()->id, tests()[2].id);
        const std::size_t expectations = tests()[2].expectations.size();
        button("Add Expectation")->click();
        QCOMPARE(tests()[2].expectations.size(), expectations + 1);
        m_tree->setCurrentItem(m_tree->topLevelItem(0)->child(0));
        button("Delete")->click();
        QVERIFY(tests()[0].expectations.empty());
        m_tree->select(tests()[0].id);
        button("Delete")->click();
        QCOMPARE(tests().size(), std::size_t{2});
        QCOMPARE(tests()[0].name, "breaks");
    }
    void withoutTestsNothingCanBeEdited() {
        for (int k = 0; k < 2; ++k) button("Delete")->click();
        QVERIFY(tests().empty());
        QVERIFY(m_tree->test() == nullptr);
        QVERIFY(!name()->isEnabled());
        for (const char* disabled : {"Run All", "Add Expectation", "Delete", "Replay"})
            QVERIFY2(!button(disabled)->isEnabled(), disabled);
        QVERIFY(button("Add Test")->isEnabled());
    }
    void resultsAreListedAndReplayed() {
        m_panel->runAll();
        QCOMPARE(m_panel->findChild<QToolButton*>("run-tests")->text(), "Cancel");
        QTRY_VERIFY(!m_runner->isPending());
        QCOMPARE(m_tree->topLevelItem(0)->text(1), "Passed");
        QCOMPARE(m_tree->topLevelItem(1)->text(1), "Failed");
        QVERIFY(!m_tree->topLevelItem(1)->child(0)->text(1).isEmpty());
        const QSignalSpy shown(m_panel.get(), &PlayTestPanel::showRequested);
        m_tree->select(tests()[1].id);
        button("Replay")->click();
        QCOMPARE(shown.count(), 1);
        QVERIFY(m_stage->controller.isInPlay());
    }
    void runThatFailsIsExplained() {
        auto* error = m_panel->findChild<QLabel*>("tests-error");
        QVERIFY(!error->isVisibleTo(m_panel.get()));
        PlayTest test = tests()[1];
        test.state = "gone.rubblestate";
        QVERIFY(m_stage->document.push(modify("Change", std::move(test))));
        m_panel->runAll();
        QTRY_VERIFY_WITH_TIMEOUT(!m_runner->isPending(), kPatience);
        QVERIFY(error->isVisibleTo(m_panel.get()));
        QVERIFY2(error->text().startsWith("Test \"breaks\": "), qPrintable(error->text()));
        QCOMPARE(m_tree->topLevelItem(0)->text(1), "Passed");  // the outcome of the one before is kept
        test::runOutOfMemory(*m_runner);
        QVERIFY(!error->isVisibleTo(m_panel.get()));
        QTRY_VERIFY_WITH_TIMEOUT(error->text().startsWith(test::kOutOfMemory), kPatience);
        QVERIFY(error->isVisibleTo(m_panel.get()));
        m_stage->document.undoStack().undo();
        QVERIFY(!error->isVisibleTo(m_panel.get()));
    }
    /// What the runner says is no refusal, which would be kept as a warning.
    void statusIsNoRefusal() {
        const QSignalSpy refused(m_panel.get(), &PlayTestPanel::refused);
        const QSignalSpy status(m_panel.get(), &PlayTestPanel::statusMessage);
        emit m_runner->failed("1 of 2 passed");
        QCOMPARE(status.count(), 1);
        QCOMPARE(refused.count(), 0);
        emit field("Duration")->refused("unknown unit");
        QCOMPARE(refused.count(), 1);
    }

private:
    const std::vector<PlayTest>& tests() const { return m_stage->document.project().playTests; }
    std::vector<Id> shotIds() const {
        return {m_stage->document.project().shots[0].id, m_stage->document.project().shots[1].id};
    }
    template <class Widget>
    Widget* named(const QString& accessibleName) const {
        for (Widget* widget : m_panel->findChildren<Widget*>()) {
            if (widget->accessibleName() == accessibleName) return widget;
        }
        qFatal("there is no %s", qPrintable(accessibleName));
    }
    NumberField* field(const char* label) const { return named<NumberField>(label); }
    QComboBox* combo(const char* label) const { return named<QComboBox>(label); }
    QToolButton* button(const char* text) const { return named<QToolButton>(text); }
    QLineEdit* name() const { return named<QLineEdit>("Name"); }

    std::unique_ptr<test::Stage> m_stage;
    std::unique_ptr<DocumentFile> m_file;
    std::unique_ptr<PlayTestRunner> m_runner;
    std::unique_ptr<PlayTestPanel> m_panel;
    PlayTestTree* m_tree = nullptr;
};

RUBBLE_TEST_WITH(PlayTestPanelTest, QApplication)
#include "PlayTestPanelTest.moc"
