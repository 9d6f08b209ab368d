#include "editor/panels/docks/PlayPanel.h"

#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"

#include <QAction>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

using namespace rubble;

namespace {

/// A block that a box has hit, and the panel with the list of impacts.
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
        auto& list = *panel.findChild<QTreeView*>("impacts");
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(list.model()->index(row, 1)).center());
    }
    QToolButton& button(const char* action) {
        for (QToolButton* button : panel.findChildren<QToolButton*>()) {
            if (button->defaultAction() && button->defaultAction()->objectName() == action) return *button;
        }
        qFatal("There is no button %s.", action);
    }
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
        QVERIFY(!desk.stage.controller.impacts().empty());
        QToolButton& pressed = desk.button(qPrintable(button));
        QVERIFY(!pressed.isEnabled());  // nothing is selected
        desk.select(0);
        QVERIFY(pressed.isEnabled());
        QSignalSpy told(&desk.panel, &PlayPanel::statusMessage);
        QTest::mouseClick(&pressed, Qt::LeftButton);
        QCOMPARE(told.size(), 1);
        QCOMPARE(desk.asset().requirements.size(), std::size_t{1});
        const StrengthRequirement& requirement = desk.asset().requirements.front();
        QCOMPARE(requirement.outcome, survives ? RequirementOutcome::Survives : RequirementOutcome::Breaks);
        const double impulse = std::get<ImpulseRequirement>(requirement.event).impulse;
        const double seen = desk.stage.controller.impacts().front().impact;
        QVERIFY(survives ? impulse >= seen && impulse < 1.01 * seen : impulse <= seen && impulse > 0.99 * seen);
        QVERIFY(desk.stage.controller.isPlaying());  // it does not restart
        QCOMPARE(desk.stage.document.undoStack().count(), 1);
        desk.stage.document.undoStack().undo();
        QVERIFY(desk.asset().requirements.empty());
    }
    void impactsOfDeletedAssetsHaveNoButtons() {
        PlayDesk desk(100.0);
        desk.select(0);
        Edit edit{.text = "Delete"};
        edit.replacements = {Replacement<Instance>{desk.stage.document.project().instances[0].id, std::nullopt},
                             Replacement<Asset>{desk.asset().id, std::nullopt}};
        QVERIFY(desk.stage.document.push(edit));
        QVERIFY(!desk.button("must-break").isEnabled());
    }
};

RUBBLE_TEST_WITH(PlayPanelTest, QApplication)
#include "PlayPanelTest.moc"
