#include "editor/view3d/LightMenu.h"

#include "core/asset/project/Ranges.h"
#include "tests/support/TestProgram.h"

#include <QAction>
#include <QApplication>
#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

QAction* actionNamed(const LightMenu& menu, const QString& text) {
    for (QAction* action : menu.actions()) {
        if (action->text().remove('&') == text) return action;
    }
    return nullptr;
}

}  // namespace

class LightMenuTest : public QObject {
    Q_OBJECT
private slots:
    void skiesAreRadioItems() {
        LightMenu menu(nullptr);
        QVERIFY(actionNamed(menu, "Studio")->isChecked());
        QSignalSpy selected(&menu, &LightMenu::lightSelected);
        menu.setLight(SkyPreset::Studio, 1.5);
        actionNamed(menu, "Night")->trigger();
        QCOMPARE(selected.size(), 1);
        QCOMPARE(selected[0][0].value<SkyPreset>(), SkyPreset::Night);
        QCOMPARE(selected[0][1].toDouble(), 1.5);
        QVERIFY(actionNamed(menu, "Night")->isChecked() && !actionNamed(menu, "Studio")->isChecked());
    }
    void exposureStaysInItsRange() {
        LightMenu menu(nullptr);
        connect(&menu, &LightMenu::lightSelected, &menu, &LightMenu::setLight);
        QSignalSpy selected(&menu, &LightMenu::lightSelected);
        actionNamed(menu, "Brighter")->trigger();
        QCOMPARE(selected.last()[1].toDouble(), 0.5);
        for (int k = 0; k < 40; ++k) actionNamed(menu, "Darker")->trigger();
        QCOMPARE(selected.last()[1].toDouble(), rangeOf(ProjectNumber::Exposure).min);
        actionNamed(menu, "Reset Exposure")->trigger();
        QCOMPARE(selected.last()[1].toDouble(), 0.0);
    }
};

RUBBLE_TEST_WITH(LightMenuTest, QApplication)
#include "LightMenuTest.moc"
