#include "editor/dialogs/VideoDialog.h"

#include "tests/support/TestProgram.h"
#include "tests/support/editor/TestSettings.h"
#include "viewport/render/RenderSettings.h"

#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

class VideoDialogTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { test::keepSettingsIn(m_folder.path()); }
    void durationsAreRounded() {
        const auto text = [](double seconds) { return aboutDurationText(seconds).replace(QChar(0xa0), ' '); };
        QCOMPARE(text(0.02), QString("about 1 s"));
        QCOMPARE(text(7.4), QString("about 7 s"));
        QCOMPARE(text(41.0), QString("about 40 s"));
        QCOMPARE(text(58.0), QString("about 1 min"));
        QCOMPARE(text(200.0), QString("about 3 min"));
        QCOMPARE(text(5400.0), QString("about 1.5 h"));
    }
    void estimateFollowsTheOptions() {
        VideoDialog dialog({.defaults = {"hit", m_folder.path()}, .length = 60, .stepLength = 1.0 / 60.0}, nullptr);
        QSignalSpy needed(&dialog, &VideoDialog::estimateNeeded);
        auto& duration = *dialog.findChild<QLabel*>("video-duration");
        QVERIFY(duration.text().isEmpty());
        dialog.requestEstimate();
        dialog.setFrameCost({}, true);
        QCOMPARE(duration.text(), QString("Measuring how long this takes…"));
        dialog.setFrameCost(0.5, false);  // 31 frames of 1 s
        QCOMPARE(duration.text().replace(QChar(0xa0), ' '), QString("This takes about 15 s."));
        QCOMPARE(needed.size(), 1);
        auto& quality = *dialog.findChild<QComboBox*>("video-quality");
        for (const RenderQuality selected : {RenderQuality::Draft, RenderQuality::Best, RenderQuality::Good}) {
            quality.setCurrentIndex(static_cast<int>(selected));
            QCOMPARE(dialog.options().samples, videoSamplesOf(selected));
        }
        QCOMPARE(needed.size(), 4);
        dialog.setFrameCost({}, false);  // nothing can be rendered
        QVERIFY(duration.text().isEmpty());
    }

private:
    QTemporaryDir m_folder;
};

RUBBLE_TEST_WITH(VideoDialogTest, QApplication)
#include "VideoDialogTest.moc"
