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
        menu.setLight(SkyPreset::Studio, {}, 1.5, {});
        actionNamed(menu, "Night")->trigger();
        QCOMPARE(selected.size(), 1);
        QCOMPARE(selected[0][0].value<SkyPreset>(), SkyPreset::Night);
        QVERIFY(selected[0][1].toString().isEmpty());
        QCOMPARE(selected[0][2].toDouble(), 1.5);
        QVERIFY(actionNamed(menu, "Night")->isChecked() && !actionNamed(menu, "Studio")->isChecked());
    }
    void recentFilesAreRadioItems() {
        LightMenu menu(nullptr);
        QSignalSpy selected(&menu, &LightMenu::lightSelected);
        menu.setLight(SkyPreset::Studio, "/skies/dusk.hdr", 0.5, {"/skies/dusk.hdr", "/skies/noon.hdr"});
        QVERIFY(actionNamed(menu, "dusk.hdr")->isChecked() && !actionNamed(menu, "noon.hdr")->isChecked());
        QVERIFY(!actionNamed(menu, "Studio")->isChecked());
        const qsizetype below = menu.actions().indexOf(actionNamed(menu, "Sky from File…"));
        QCOMPARE(menu.actions().indexOf(actionNamed(menu, "dusk.hdr")), below + 1);
        QCOMPARE(menu.actions().indexOf(actionNamed(menu, "noon.hdr")), below + 2);
        actionNamed(menu, "noon.hdr")->trigger();
        QCOMPARE(selected[0][1].toString(), QString("/skies/noon.hdr"));
        actionNamed(menu, "Brighter")->trigger();  // keeps the file
        QCOMPARE(selected[1][1].toString(), QString("/skies/dusk.hdr"));
        menu.setLight(SkyPreset::Night, {}, 0.0, {"/skies/noon.hdr"});
        QVERIFY(!actionNamed(menu, "dusk.hdr") && !actionNamed(menu, "noon.hdr")->isChecked());
        QVERIFY(actionNamed(menu, "Night")->isChecked());
        QSignalSpy requested(&menu, &LightMenu::fileRequested);
        actionNamed(menu, "Sky from File…")->trigger();
        QCOMPARE(requested.size(), 1);
    }
    void exposureStaysInItsRange() {
        LightMenu menu(nullptr);
        connect(&menu, &LightMenu::lightSelected, &menu, [&menu](SkyPreset sky, const QString& file, double exposure) {
            menu.setLight(sky, file, exposure, {});
        });
        QSignalSpy selected(&menu, &LightMenu::lightSelected);
        actionNamed(menu, "Brighter")->trigger();
        QCOMPARE(selected.last()[2].toDouble(), 0.5);
        QVERIFY(actionNamed(menu, "Reset Exposure of +0.5 Stops")->isEnabled());
        for (int k = 0; k < 40; ++k) actionNamed(menu, "Darker")->trigger();
        QCOMPARE(selected.last()[2].toDouble(), rangeOf(ProjectNumber::Exposure).min);
        for (QAction* action : menu.actions())
            if (action->text().contains("Reset")) action->trigger();
        QCOMPARE(selected.last()[2].toDouble(), 0.0);
        QVERIFY(!actionNamed(menu, "Reset Exposure")->isEnabled());
    }
};

RUBBLE_TEST_WITH(LightMenuTest, QApplication)
#include "LightMenuTest.moc"
