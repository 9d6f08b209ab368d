#include "editor/panels/docks/PlayToolsPanel.h"

#include "core/asset/project/Ranges.h"
#include "editor/widgets/NumberField.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"

#include <QCheckBox>
#include <QTest>

#include <algorithm>

using namespace rubble;

class PlayToolsPanelTest : public QObject {
    Q_OBJECT
private slots:
    void fieldsHaveTheRangesOfShots_data() {
        QTest::addColumn<QString>("label");
        QTest::addColumn<int>("number");
        const auto row = [](const char* label, ProjectNumber number) {
            QTest::newRow(label) << QString(label) << static_cast<int>(number);
        };
        row("Width", ProjectNumber::ProjectileSize);
        row("Mass", ProjectNumber::Mass);
        row("Speed", ProjectNumber::ProjectileSpeed);
        row("Head Radius", ProjectNumber::HammerRadius);
        row("Radius", ProjectNumber::BlastRadius);
        row("Force", ProjectNumber::GrabForce);
    }
    void fieldsHaveTheRangesOfShots() {
        QFETCH(QString, label);
        QFETCH(int, number);
        test::Stage stage;
        const PlayToolsPanel panel(stage.document, stage.controller);
        const auto fields = panel.findChildren<NumberField*>();
        const auto field = std::ranges::find(fields, label, &QWidget::accessibleName);
        QVERIFY(field != fields.end());
        const NumberRange& range = rangeOf(static_cast<ProjectNumber>(number));
        QCOMPARE((*field)->range().min, range.min);
        QCOMPARE((*field)->range().max, range.max);
        QCOMPARE((*field)->range().isMinExcluded, range.isMinExcluded);
    }
    void lengthsFollowTheUnit() {
        test::Stage stage;
        PlayToolsPanel panel(stage.document, stage.controller);
        panel.setUnits({LengthUnit::Foot});
        QStringList inFeet;
        for (NumberField* field : panel.findChildren<NumberField*>()) {
            if (field->text().endsWith("ft")) inFeet << field->accessibleName();
        }
        QCOMPARE(inFeet, QStringList({"Width", "Height", "Length", "Head Radius", "Radius"}));
    }
    void sizeOfABallIsItsDiameter() {
        test::Stage stage;
        const PlayToolsPanel panel(stage.document, stage.controller);
        PlayToolSettings tools = stage.controller.toolSettings();
        tools.projectile.kind = ProjectileKind::Ball;
        stage.controller.setToolSettings(tools);
        QStringList visible;
        for (const NumberField* field : panel.findChildren<NumberField*>()) {
            if (!field->isHidden()) visible << field->accessibleName();
        }
        QCOMPARE(visible.first(2), QStringList({"Diameter", "Mass"}));
        tools.projectile.kind = ProjectileKind::Box;
        stage.controller.setToolSettings(tools);
        QCOMPARE(panel.findChildren<NumberField*>().first()->accessibleName(), "Width");
    }
    void speedIsAutomaticUntilSwitchedOff() {
        test::Stage stage;
        const PlayToolsPanel panel(stage.document, stage.controller);
        const auto fields = panel.findChildren<NumberField*>();
        const auto speed = std::ranges::find(fields, QString("Speed"), &QWidget::accessibleName);
        QVERIFY(speed != fields.end() && (*speed)->isHidden());
        panel.findChild<QCheckBox*>("automaticSpeed")->click();
        QVERIFY(!stage.controller.toolSettings().isSpeedAutomatic);
        QVERIFY(!(*speed)->isHidden());
    }
    void clickThrowsIfChecked() {
        test::Stage stage;
        const PlayToolsPanel panel(stage.document, stage.controller);
        auto* box = panel.findChild<QCheckBox*>("throwOnClick");
        QVERIFY(!box->isChecked());
        box->click();
        QVERIFY(stage.controller.toolSettings().throwsOnClick);
        stage.controller.setToolSettings({});
        QVERIFY(!box->isChecked());
    }
    void radiusOfTheHammerIsAutomaticUntilSwitchedOff() {
        test::Stage stage;
        const PlayToolsPanel panel(stage.document, stage.controller);
        const auto fields = panel.findChildren<NumberField*>();
        const auto radius = std::ranges::find(fields, QString("Head Radius"), &QWidget::accessibleName);
        QVERIFY(radius != fields.end() && (*radius)->isHidden());
        panel.findChild<QCheckBox*>("automaticRadius")->click();
        QVERIFY(!stage.controller.toolSettings().isHammerRadiusAutomatic);
        QVERIFY(!(*radius)->isHidden());
    }
};

RUBBLE_TEST_WITH(PlayToolsPanelTest, QApplication)
#include "PlayToolsPanelTest.moc"
