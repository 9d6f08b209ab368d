// Tests editor/panels/docks/StrengthPanel.cpp, editor/panels/docks/RequirementPresets.cpp and
// editor/background/SwapAuditRunner.cpp.
#include "editor/panels/docks/StrengthPanel.h"

#include "editor/panels/docks/IntervalBar.h"
#include "editor/widgets/NumberField.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/FailingWork.h"
#include "tests/support/editor/PlayStage.h"

#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

using namespace rubble;

namespace {

/// A block that must survive an impact, and the panel.
class Desk {
public:
    Desk() : m_project(withRequirement()), stage(m_project), audits(stage.document, stage.bakes) {
        selection.setAsset(m_project.assets[0].id);
        panel = std::make_unique<StrengthPanel>(stage.document, selection, stage.bakes, audits);
        panel->resize(320, 600);
        panel->show();
    }
    const Asset& asset() const { return stage.document.project().assets[0]; }
    QPushButton& button(const char* name) { return *panel->findChild<QPushButton*>(name); }
    bool says(const QString& text) const {
        const QList<QLabel*> labels = panel->findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](QLabel* label) { return label->text().contains(text); });
    }

private:
    static Project withRequirement() {
        Project project = test::floatingBlock();
        project.gravity = Vec3(0.0, -9.81, 0.0);
        project.assets[0].requirements = {{RequirementOutcome::Survives, HitRequirement{.mass = 40.0, .speed = 14.0}}};
        return project;
    }
    Project m_project;

public:
    test::Stage stage;
    Selection selection;
    SwapAuditRunner audits;
    std::unique_ptr<StrengthPanel> panel;
};

}  // namespace

class StrengthPanelTest : public QObject {
    Q_OBJECT
private slots:
    void suggestedThresholdIsApplied() {
        Desk desk;
        QVERIFY(desk.says("not valid"));  // 100 N·s
        QTest::mouseClick(&desk.button("set-threshold"), Qt::LeftButton);
        QVERIFY(desk.asset().threshold > 500.0);
        QVERIFY(desk.says("The threshold is valid"));
        desk.stage.document.undoStack().undo();
        QCOMPARE(desk.asset().threshold, 100.0);
    }
    void typingChangesARequirement() {
        Desk desk;
        auto fields = desk.panel->findChildren<NumberField*>();
        QCOMPARE(fields.size(), 2);
        fields[1]->setFocus();
        fields[1]->selectAll();
        QTest::keyClicks(fields[1], "7");
        QTest::keyClick(fields[1], Qt::Key_Return);
        QTRY_COMPARE(std::get<HitRequirement>(desk.asset().requirements[0].event).speed, 7.0);
    }
    void conflictingRequirementsAreReported() {
        Desk desk;
        auto* outcome = desk.panel->findChild<QComboBox*>();
        Asset asset = desk.asset();
        asset.requirements.push_back({RequirementOutcome::Breaks, HitRequirement{.mass = 4.0, .speed = 14.0}});
        desk.stage.document.push({.text = "Add Requirement", .replacements = {Replacement<Asset>{asset.id, asset}}});
        QVERIFY(outcome != nullptr);
        QVERIFY(desk.button("set-threshold").isHidden());
        QVERIFY(desk.says("survives"));
    }
    void bondedAssetHasAnImpulsePerArea() {
        Desk desk;
        QVERIFY(!desk.panel->findChild<IntervalBar*>()->isHidden());
        Asset asset = desk.asset();
        asset.breakAs = BreakAs::Bonded;
        asset.bonding.impulsePerArea = 1e-3;
        asset.requirements = {{RequirementOutcome::Survives, ImpulseRequirement{50.0}}};
        desk.stage.document.push({.text = "Break as bonded", .replacements = {Replacement<Asset>{asset.id, asset}}});
        desk.stage.bake();
        QTRY_VERIFY(desk.says("The impulse per area is not valid"));
        QVERIFY(desk.says("on the centre of the front"));
        QVERIFY(desk.panel->findChild<IntervalBar*>()->isHidden());
        QVERIFY(desk.button("set-threshold").text().startsWith("Set Impulse per Area to "));
        desk.button("set-threshold").click();
        QTRY_VERIFY(desk.says("The impulse per area is valid"));
        QVERIFY(*desk.asset().bonding.impulsePerArea > 1e-3);
    }
    void holesAreLimitedAndShown() {
        Desk desk;
        Asset asset = desk.asset();
        asset.breakAs = BreakAs::Bonded;
        asset.bonding.impulsePerArea = 1.0;
        asset.requirements = {{RequirementOutcome::HoleAtMost, ImpulseRequirement{50.0}, 0.01}};
        desk.stage.document.push({.text = "Break as bonded", .replacements = {Replacement<Asset>{asset.id, asset}}});
        desk.stage.bake();
        QTRY_VERIFY(desk.says("The impulse per area is not valid: it must be above"));
        QVERIFY(desk.says("in an impulse of"));
        desk.panel->findChild<QToolButton*>("select-lost")->click();
        QTRY_VERIFY(!desk.selection.fragments().isEmpty());
        desk.button("set-threshold").click();
        QTRY_VERIFY(desk.says("The impulse per area is valid"));
        QSignalSpy refusals(desk.panel.get(), &StrengthPanel::refused);
        desk.panel->findChild<QToolButton*>("select-lost")->click();
        QTRY_COMPARE(refusals.size(), 1);
        QVERIFY(desk.selection.fragments().isEmpty());
        auto fields = desk.panel->findChildren<NumberField*>();
        fields[0]->setFocus();
        fields[0]->selectAll();
        QTest::keyClicks(fields[0], "100");
        QTest::keyClick(fields[0], Qt::Key_Return);
        QTRY_COMPARE(desk.asset().requirements[0].hole, 100.0);
        QTRY_VERIFY(desk.says("The impulse per area is valid"));
    }
    void presetsSayWhichHitTheyAssume() {
        Desk desk;
        const QMenu* menu = desk.panel->findChild<QToolButton*>("add-requirement")->menu();
        QCOMPARE(menu->actions().size(), 3);
        for (const QAction* outcome : menu->actions()) {
            QVERIFY(outcome->menu()->toolTipsVisible());
            QStringList names;
            for (const QAction* preset : outcome->menu()->actions()) {
                names.append(QString(preset->text()).remove('&'));
                QVERIFY2(preset->toolTip().size() > 30, qPrintable(preset->toolTip()));
            }
            for (const char* name : {"Pushed by Hand", "Football at 20 m/s", "Dropped from 1 m", "Thrown Stone"}) {
                QVERIFY2(!names.filter(name).isEmpty(), name);
            }
        }
        menu->actions()[1]->menu()->actions()[1]->trigger();
        QCOMPARE(desk.asset().requirements.size(), std::size_t{2});
        QCOMPARE(desk.asset().requirements[1].outcome, RequirementOutcome::Breaks);
        QCOMPARE(std::get<HitRequirement>(desk.asset().requirements[1].event).mass, 0.05);
    }
    void rowsSayWhatTheirFigureAssumes() {
        Desk desk;
        QVERIFY(desk.says("square hit on the centre, free to move; 74\u00a0% of it at a corner"));
        Instance fixed = desk.stage.document.project().instances[0];
        fixed.isFixed = true;
        desk.stage.document.push({.text = "Fix", .replacements = {Replacement<Instance>{fixed.id, fixed}}});
        QVERIFY(desk.says("square hit on the centre, held in place"));
        QVERIFY(desk.says("560\u00a0N·s = 5.6×"));  // 40 kg at 14 m/s
    }
    void buttonPlaysExactlyTheEvent() {
        Desk desk;
        QSignalSpy trials(desk.panel.get(), &StrengthPanel::trialRequested);
        connect(desk.panel.get(), &StrengthPanel::trialRequested, &desk.stage.controller, &PlayController::playShot);
        QVERIFY(desk.says("= 5.185×"));  // 40 kg and 500 kg at 14 m/s: 518.5 N·s at a threshold of 100
        QTest::mouseClick(desk.panel->findChild<QToolButton*>("play-event"), Qt::LeftButton);
        QTRY_COMPARE(trials.size(), 1);
        desk.stage.settle();
        QVERIFY(desk.stage.controller.isPlaying());
        desk.stage.advance(10);
        const std::span<const EventRef> breaks = desk.stage.controller.events().breaks();
        QVERIFY(!breaks.empty());
        QVERIFY2(std::abs(breaks[0]->strength->ratio() - 5.185) < 0.01 * 5.185,
                 QByteArray::number(breaks[0]->strength->ratio()));
    }
    void withoutAnInstanceThereIsNothingToPlayOn() {
        Desk desk;
        desk.stage.document.push(
            {.text = "Delete",
             .replacements = {Replacement<Instance>{desk.stage.document.project().instances[0].id, std::nullopt}}});
        const auto* button = desk.panel->findChildren<QToolButton*>("play-event").last();
        QVERIFY(!button->isEnabled());
        QVERIFY2(button->toolTip().contains("No instance"), qPrintable(button->toolTip()));
    }
    void swapAuditFollowsTheAsset() {
        Desk desk;
        QVERIFY(desk.says("Not checked"));
        QTest::mouseClick(&desk.button("check-break-stability"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(desk.says("Passed"), kPatience);
        QVERIFY(desk.button("fix-break-stability").isHidden());
        Asset asset = desk.asset();
        asset.prism().depth = 0.3;
        desk.stage.document.push({.text = "Resize", .replacements = {Replacement<Asset>{asset.id, asset}}});
        QVERIFY(desk.says("Not checked"));
    }
    void checkThatFailsIsExplained() {
        Desk desk;
        desk.stage.bakes.clear();
        QTest::mouseClick(&desk.button("check-break-stability"), Qt::LeftButton);
        QVERIFY(desk.says("The asset is not baked yet"));
        QVERIFY(desk.button("check-break-stability").isEnabled());
        test::runOutOfMemory(desk.audits);
        QCOMPARE(desk.button("check-break-stability").text(), "Checking…");
        QTRY_VERIFY_WITH_TIMEOUT(desk.says(test::kOutOfMemory), kPatience);
        QVERIFY(desk.button("check-break-stability").isEnabled());
        desk.selection.setAsset(0);
        QVERIFY(!desk.says(test::kOutOfMemory));  // it is about the other asset
    }
    void checkIsCancelledByAChange() {
        Desk desk;
        const QSignalSpy refusals(desk.panel.get(), &StrengthPanel::refused);
        QTest::mouseClick(&desk.button("check-break-stability"), Qt::LeftButton);
        QVERIFY(desk.audits.isPending());
        Asset asset = desk.asset();
        asset.prism().depth = 0.3;
        desk.stage.document.push({.text = "Resize", .replacements = {Replacement<Asset>{asset.id, asset}}});
        QVERIFY(!desk.audits.isPending() && desk.says("Not checked"));
        desk.stage.bake();
        QTest::mouseClick(&desk.button("check-break-stability"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(desk.says("Passed"), kPatience);
        QVERIFY(refusals.isEmpty());
    }
};

RUBBLE_TEST_WITH(StrengthPanelTest, QApplication)
#include "StrengthPanelTest.moc"
