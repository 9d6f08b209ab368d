#include "editor/view3d/ExplodeSlider.h"

#include "tests/support/TestProgram.h"

#include <QApplication>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

using namespace rubble;

class ExplodeSliderTest : public QObject {
    Q_OBJECT
private slots:
    void spansFactorsUpToTwo() {
        ExplodeSlider explode;
        QSignalSpy factors(&explode, &ExplodeSlider::factorChanged);
        auto* slider = explode.findChild<QSlider*>("exploded");
        slider->setValue(slider->maximum());
        QCOMPARE(factors.last()[0].toDouble(), 2.0);
        slider->setValue(slider->maximum() / 2);
        QCOMPARE(factors.last()[0].toDouble(), 1.0);
    }
};

RUBBLE_TEST_WITH(ExplodeSliderTest, QApplication)
#include "ExplodeSliderTest.moc"
