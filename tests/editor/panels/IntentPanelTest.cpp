#include "editor/panels/IntentPanel.h"

#include "editor/panels/NumberField.h"
#include "tests/support/PlayStage.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

/// A block that is to survive a hit, with the panel on it.
class Desk {
public:
    Desk() : m_project(withIntent()), stage(m_project), trials(stage.document, stage.bakes) {
        selection.setAsset(m_project.assets[0].id);
        panel = std::make_unique<IntentPanel>(stage.document, selection, stage.bakes, trials);
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
    static Project withIntent() {
        Project project = test::floatingBlock();
        project.gravity = Vec3(0.0, -9.81, 0.0);
        project.assets[0].intents = {{IntentOutcome::Survives, HitIntent{.mass = 40.0, .speed = 14.0}}};
        return project;
    }
    Project m_project;

public:
    test::Stage stage;
    Selection selection;
    AssetTrials trials;
    std::unique_ptr<IntentPanel> panel;
};

}  // namespace

class IntentPanelTest : public QObject {
    Q_OBJECT
private slots:
    void takesAThresholdThatFits() {
        Desk desk;
        QVERIFY(desk.says("does not fit"));  // 100 N s
        QTest::mouseClick(&desk.button("use-threshold"), Qt::LeftButton);
        QVERIFY(desk.asset().threshold > 500.0);
        QVERIFY(desk.says("Its threshold fits"));
        desk.stage.document.undoStack().undo();
        QCOMPARE(desk.asset().threshold, 100.0);
    }
    void aSentenceIsChangedByTyping() {
        Desk desk;
        auto fields = desk.panel->findChildren<NumberField*>();
        QCOMPARE(fields.size(), 2);
        fields[1]->setFocus();
        fields[1]->selectAll();
        QTest::keyClicks(fields[1], "7");
        QTest::keyClick(fields[1], Qt::Key_Return);
        QTRY_COMPARE(std::get<HitIntent>(desk.asset().intents[0].event).speed, 7.0);
    }
    void tellsWhatConflicts() {
        Desk desk;
        auto* outcome = desk.panel->findChild<QComboBox*>();
        Asset asset = desk.asset();
        asset.intents.push_back({IntentOutcome::Breaks, HitIntent{.mass = 4.0, .speed = 14.0}});
        desk.stage.document.push({.text = "ask more", .swaps = {Swap<Asset>{asset.id, asset}}});
        QVERIFY(outcome != nullptr);
        QVERIFY(desk.button("use-threshold").isHidden());
        QVERIFY(desk.says("survives"));
    }
    void auditsASwap() {
        Desk desk;
        QVERIFY(desk.says("Not audited"));
        QTest::mouseClick(&desk.button("audit-swap"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(desk.says("Clean."), 20000);
        QVERIFY(desk.button("fix-swap").isHidden());
        Asset asset = desk.asset();
        asset.prism.depth = 0.3;
        desk.stage.document.push({.text = "thinner", .swaps = {Swap<Asset>{asset.id, asset}}});
        QVERIFY(desk.says("Not audited"));
    }
};

QTEST_MAIN(IntentPanelTest)
#include "IntentPanelTest.moc"
