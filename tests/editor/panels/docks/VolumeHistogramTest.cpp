#include "editor/panels/docks/VolumeHistogram.h"

#include "tests/support/TestProgram.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

class VolumeHistogramTest : public QObject {
    Q_OBJECT
private slots:
    void allVolumesHaveTheUnitOfTheLargest() {
        VolumeHistogram histogram;
        histogram.resize(300, 150);
        histogram.setVolumes({1.2e-5, 3e-4, 1.2}, std::vector<bool>(3, false));
        QCOMPARE(histogram.accessibleDescription(), QString("3 fragment(s) from 0.000012\u00a0m³ to 1.2\u00a0m³"));
        histogram.setUnits({LengthUnit::Foot});
        QCOMPARE(histogram.accessibleDescription(),
                 QString("3 fragment(s) from 0.0004238\u00a0ft\u00b3 to 42.38\u00a0ft\u00b3"));
    }
    void clicksDragsAndKeysSelectRanges() {
        VolumeHistogram histogram;
        histogram.resize(300, 150);
        histogram.show();
        histogram.setAxis(HistogramAxis::Linear);
        std::vector<double> volumes;
        for (int k = 0; k <= 100; ++k) volumes.push_back(1.0 + k);
        histogram.setVolumes(volumes, std::vector<bool>(volumes.size(), false));
        QSignalSpy ranged(&histogram, &VolumeHistogram::rangeSelected);
        const auto middle = [&](int bar) { return histogram.barRect(bar).center().toPoint(); };
        QTest::mouseClick(&histogram, Qt::LeftButton, {}, middle(3));
        QCOMPARE(ranged.back()[0].toDouble(), histogram.bars()[3].min);
        QVERIFY(ranged.back()[1].toDouble() < histogram.bars()[3].max && !ranged.back()[2].toBool());
        QTest::mousePress(&histogram, Qt::LeftButton, Qt::ControlModifier, middle(9));
        QMouseEvent move(QEvent::MouseMove, QPointF(middle(5)), histogram.mapToGlobal(QPointF(middle(5))), Qt::NoButton,
                         Qt::LeftButton, Qt::ControlModifier);
        QCoreApplication::sendEvent(&histogram, &move);
        QTest::mouseRelease(&histogram, Qt::LeftButton, Qt::ControlModifier, middle(5));
        QCOMPARE(ranged.back()[0].toDouble(), histogram.bars()[5].min);
        QVERIFY(ranged.back()[1].toDouble() < histogram.bars()[9].max && ranged.back()[2].toBool());
        QTest::keyClick(&histogram, Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(ranged.back()[0].toDouble(), histogram.bars()[6].min);
        QTest::mouseClick(&histogram, Qt::LeftButton, {}, middle(static_cast<int>(histogram.bars().size()) - 1));
        QCOMPARE(ranged.back()[1].toDouble(), 101.0);  // the last bar includes its upper bound
    }
};

RUBBLE_TEST_WITH(VolumeHistogramTest, QApplication)
#include "VolumeHistogramTest.moc"
