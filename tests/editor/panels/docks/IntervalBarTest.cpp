#include "editor/panels/docks/IntervalBar.h"

#include "tests/support/TestProgram.h"

#include <QApplication>

using namespace rubble;

namespace {

/// The number of pixels of a colour.
int count(const QImage& image, QColor colour) {
    int found = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) found += image.pixelColor(x, y) == colour ? 1 : 0;
    }
    return found;
}

}  // namespace

class IntervalBarTest : public QObject {
    Q_OBJECT
private slots:
    void intervalIsGreenAndReadOut() {
        IntervalBar bar;
        bar.resize(240, bar.sizeHint().height());
        ThresholdInterval interval{.low = 100.0, .high = 400.0, .impulses = {100.0, 400.0}};
        bar.setInterval({{.outcome = RequirementOutcome::Survives}, {.outcome = RequirementOutcome::Breaks}}, interval,
                        200.0);
        QCOMPARE(bar.accessibleDescription().toStdString(), intervalText(interval));
        const QColor fits(46, 158, 91);
        const int wide = count(bar.grab().toImage(), fits);
        QVERIFY(wide > 100);
        interval.high = 150.0;
        bar.setInterval({}, interval, 200.0);
        QVERIFY(count(bar.grab().toImage(), fits) < wide);
        interval.high = 50.0;  // the requirements conflict
        bar.setInterval({}, interval, 200.0);
        QCOMPARE(count(bar.grab().toImage(), fits), 0);
    }
};

RUBBLE_TEST_WITH(IntervalBarTest, QApplication)
#include "IntervalBarTest.moc"
