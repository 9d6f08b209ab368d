#include "editor/view3d/SceneLegend.h"

#include "tests/support/TestProgram.h"

#include <QApplication>
#include <QSignalSpy>
#include <QTest>

using namespace rubble;

class SceneLegendTest : public QObject {
    Q_OBJECT
private slots:
    void materialColoursHaveNoLegend() { QVERIFY(SceneLegend().texts().isEmpty()); }
    void showsTheRangeOfTheQuantity() {
        SceneLegend legend;
        legend.setContent({SceneColouring::Level, ValueRange{1.0, 3.0}, 0.0});
        QCOMPARE(legend.texts(), (QStringList{"Level", "1", "3"}));
        legend.setContent({SceneColouring::Level, ValueRange{2.0, 2.0}, 0.0});
        QCOMPARE(legend.texts(), (QStringList{"Level", "2"}));
        QCOMPARE(legend.accessibleText(), QString("Level, 2"));
    }
    void showsTheAreaOfTheWidestBond() {
        SceneLegend legend;
        legend.setContent({SceneColouring::Material, std::nullopt, 0.25});
        QCOMPARE(legend.texts().size(), 1);
        QVERIFY(legend.texts().front().startsWith("Contact area "));
    }
    /// Of volumes in the unit of the largest one, the least has many digits.
    void valuesAtTheEndsDoNotOverlap() {
        SceneLegend legend;
        legend.setContent({SceneColouring::Volume, ValueRange{1.234e-9, 0.0123}, 0.0});
        QFont large;
        large.setPixelSize(24);
        for (const QFont& font : {QFont(), large}) {
            const QFontMetrics lines(font);
            const QStringList texts = legend.texts();
            const int needed =
                lines.horizontalAdvance(texts[1]) + lines.horizontalAdvance(" ") + lines.horizontalAdvance(texts[2]);
            QVERIFY(legend.plates({800, 600}, font).front().width() > needed);
        }
    }
    void emitsChangedForNewContentOnly() {
        SceneLegend legend;
        QSignalSpy changed(&legend, &SceneLegend::changed);
        legend.setContent({SceneColouring::Level, ValueRange{1.0, 3.0}, 0.0});
        legend.setContent({SceneColouring::Level, ValueRange{1.0, 3.0}, 0.0});
        QCOMPARE(changed.count(), 1);
    }
};

RUBBLE_TEST_WITH(SceneLegendTest, QApplication)
#include "SceneLegendTest.moc"
