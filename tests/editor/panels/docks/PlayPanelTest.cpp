#include "editor/panels/docks/PlayPanel.h"

#include "editor/panels/docks/StepGraph.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"
#include "tests/support/play/BondedWalls.h"

#include <QAction>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

using namespace rubble;

namespace {

/// A block that a box has hit, and the panel with the list of events.
class PlayDesk {
public:
    explicit PlayDesk(double threshold) : stage(blockWith(threshold)), panel(stage.document, stage.controller) {
        panel.resize(900, 200);
        panel.show();
        PlayToolSettings tools;
        tools.projectile = {.size = Vec3(0.2), .mass = 3.0, .speed = 80.0};  // 240 N·s
        tools.isSpeedAutomatic = false;
        stage.controller.setToolSettings(tools);
        stage.start();
        stage.controller.throwAlong({{0.0, 5.0, 4.0}, {0.0, 0.0, -1.0}});
        stage.advance(20);
    }
    void select(int row) {
        EventTable& list = panel.events();
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(list.model()->index(row, 1)).center());
    }
    /// The break, or the impact that was withstood.
    void selectStrength() {
        const std::vector<EventRef>& events = stage.controller.shownEvents();
        const auto found =
            std::ranges::find_if(events, [](const EventRef& event) { return event->strength.has_value(); });
        select(static_cast<int>(found - events.begin()));
    }
    QToolButton& button(const char* action) {
        for (QToolButton* button : panel.findChildren<QToolButton*>()) {
            if (button->defaultAction() && button->defaultAction()->objectName() == action) return *button;
        }
        qFatal("There is no button %s.", action);
    }
    QString summary() const { return panel.findChild<QLabel*>("event-summary")->text(); }
    const Asset& asset() const { return stage.document.project().assets[0]; }

private:
    static Project blockWith(double threshold) {
        Project project = test::floatingBlock();
        project.assets[0].threshold = threshold;
        return project;
    }

public:
    test::Stage stage;
    PlayPanel panel;
};

}  // namespace

class PlayPanelTest : public QObject {
    Q_OBJECT
private slots:
    void anImpactBecomesARequirement_data() {
        QTest::addColumn<QString>("button");
        QTest::addColumn<double>("threshold");
        QTest::addColumn<bool>("survives");
        QTest::newRow("must break, and did") << "must-break" << 100.0 << false;
        QTest::newRow("must survive, and did") << "must-survive" << 600.0 << true;
        QTest::newRow("must survive, but broke") << "must-survive" << 100.0 << true;
    }
    void anImpactBecomesARequirement() {
        QFETCH(QString, button);
        QFETCH(double, threshold);
        QFETCH(bool, survives);
        PlayDesk desk(threshold);
        QVERIFY(!desk.stage.controller.shownEvents().empty());
        QToolButton& pressed = desk.button(qPrintable(button));
        QVERIFY(!pressed.isEnabled());  // nothing is selected
        desk.selectStrength();
        QVERIFY(pressed.isEnabled());
        QSignalSpy reported(&desk.panel, &PlayPanel::statusMessage);
        QTest::mouseClick(&pressed, Qt::LeftButton);
        QCOMPARE(reported.size(), 1);
        QCOMPARE(desk.asset().requirements.size(), std::size_t{1});
        const StrengthRequirement& requirement = desk.asset().requirements.front();
        QCOMPARE(requirement.outcome, survives ? RequirementOutcome::Survives : RequirementOutcome::Breaks);
        const double impulse = std::get<ImpulseRequirement>(requirement.event).impulse;
        const double seen = desk.panel.events().selectedEvent()->strength->impact;
        QVERIFY(survives ? impulse >= seen && impulse < 1.01 * seen : impulse <= seen && impulse > 0.99 * seen);
        QVERIFY(desk.stage.controller.isPlaying());  // it does not restart
        QCOMPARE(desk.stage.document.undoStack().count(), 1);
        desk.stage.document.undoStack().undo();
        QVERIFY(desk.asset().requirements.empty());
    }
    void impactsOfDeletedAssetsHaveNoButtons() {
        PlayDesk desk(100.0);
        desk.selectStrength();
        Edit edit{.text = "Delete"};
        edit.replacements = {Replacement<Instance>{desk.stage.document.project().instances[0].id, std::nullopt},
                             Replacement<Asset>{desk.asset().id, std::nullopt}};
        QVERIFY(desk.stage.document.push(edit));
        QVERIFY(!desk.button("must-break").isEnabled());
    }
    void filterGovernsListAndSummary() {
        PlayDesk desk(100.0);
        const std::size_t all = desk.stage.controller.events().size();
        QVERIFY2(desk.summary().startsWith("Breaks: 1 · Fragments: 5 · "), qPrintable(desk.summary()));
        QVERIFY(all > 1);
        QTest::mouseClick(desk.panel.findChild<QToolButton*>("event-broken"), Qt::LeftButton);
        QCOMPARE(desk.stage.controller.shownEvents().size(), all - 1);
        QCOMPARE(desk.panel.events().model()->rowCount(), static_cast<int>(all - 1));
        QVERIFY2(desk.summary().endsWith(QString("%1 of %2 events shown").arg(all - 1).arg(all)),
                 qPrintable(desk.summary()));
        desk.stage.controller.stop();
        QCOMPARE(desk.summary(), "The simulation is stopped.");
        QCOMPARE(desk.panel.events().model()->rowCount(), 0);
    }
    void activatingAnEventGoesToItsTimeAndPlace() {
        PlayDesk desk(100.0);
        QSignalSpy jumps(&desk.panel, &PlayPanel::jumpRequested);
        desk.selectStrength();
        const EventRef event = desk.panel.events().selectedEvent();
        QTest::keyClick(&desk.panel.events(), Qt::Key_Return);
        desk.stage.settle();
        QCOMPARE(desk.stage.step(), event->record.step);
        QCOMPARE(jumps[0][0].value<Vec3>(), event->record.point);
    }
    void sumsAreInTheToolTip() {
        PlayDesk desk(100.0);
        desk.stage.advance(60);
        const QString tip = desk.panel.findChild<QLabel*>("event-summary")->toolTip();
        QVERIFY2(tip.contains("Friction, rolling and rattling took"), qPrintable(tip));
    }
    void brokenBondsAreNoBreaks() {
        test::Stage stage(test::bondedWall());
        PlayPanel panel(stage.document, stage.controller);
        stage.start();
        stage.controller.fire(
            {.action = Throw{.mass = 200.0, .from = {0.0, 1.5, 3.0}, .to = {0.0, 1.5, 0.0}, .speed = 30.0}});
        stage.advance(20);
        const QString summary = panel.findChild<QLabel*>("event-summary")->text();
        QVERIFY2(summary.startsWith("Broken bonds: "), qPrintable(summary));
    }
    void aLoadedStateMayHaveBrokenBefore() {
        PlayDesk desk(100.0);
        std::shared_ptr<const SavedSession> saved;
        desk.stage.controller.requestState([&](const std::shared_ptr<const SavedSession>& state) { saved = state; });
        desk.stage.controller.thread().settle();
        QCoreApplication::sendPostedEvents(&desk.stage.controller);
        QVERIFY(saved);
        desk.stage.controller.load(saved);
        desk.stage.settle();
        QVERIFY2(desk.summary().startsWith("Nothing has broken since the loaded state."), qPrintable(desk.summary()));
    }
    void eventsAfterTheDisplayedTimeAreMarked() {
        PlayDesk desk(100.0);
        desk.stage.controller.seek(0);
        desk.stage.settle();
        const QAbstractItemModel& list = *desk.panel.events().model();
        QVERIFY(list.rowCount() > 0);
        QVERIFY(list.index(0, 0).data(Qt::FontRole).value<QFont>().italic());
        desk.stage.controller.seek(20);
        desk.stage.settle();
        QVERIFY(!list.index(0, 0).data(Qt::FontRole).isValid());
    }
    void aNarrowPanelHasListAndFilterOnly() {
        PlayDesk desk(100.0);
        const auto* graph = desk.panel.findChild<StepGraph*>();
        QVERIFY(graph->isVisible() && desk.button("must-break").isVisible());
        desk.panel.resize(330, 300);
        QTRY_VERIFY(!graph->isVisible());
        QVERIFY(!desk.button("must-break").isVisible());
        QTRY_VERIFY(desk.panel.minimumSizeHint().width() <= 330);
        desk.panel.resize(900, 300);
        QTRY_VERIFY(graph->isVisible() && desk.button("must-break").isVisible());
    }
    void exportsHaveAButtonWithAMenu() {
        PlayDesk desk(100.0);
        QAction all("Export Events…"), shown("Export Shown Events…");
        desk.panel.setExportActions(&all, &shown);
        const auto* button = desk.panel.findChild<QToolButton*>("export-events");
        QCOMPARE(button->defaultAction(), &all);
        QVERIFY(button->actions().contains(&shown));
        QVERIFY(desk.panel.events().actions().contains(&shown));
    }
};

RUBBLE_TEST_WITH(PlayPanelTest, QApplication)
#include "PlayPanelTest.moc"
