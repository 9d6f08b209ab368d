// Tests editor/actions/VideoActions.cpp, editor/dialogs/VideoDialog.cpp and editor/background/VideoExporter.cpp.
#include "editor/dialogs/VideoDialog.h"
#include "editor/widgets/NumberField.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/editor/TextFit.h"
#include "tests/support/files/Ffmpeg.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/files/FileLimits.h"
#include "tests/support/viewport/Pictures.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLayout>
#include <QMenu>
#include <QMessageBox>
#include <QProgressBar>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QToolButton>

#include <algorithm>

using namespace rubble;

/// Video export from the window: images with and without destruction, videos with ffmpeg, cancelling and errors.
class VideoExportTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        openFile(RUBBLE_SOURCE_DIR "/projects/house.rubble");
        play().thread().useSteppedClock();
        exportSavedThrowBeforePlay();
        QSettings().remove("video");
        play().play();
        QTRY_VERIFY_WITH_TIMEOUT(play().isPlaying(), kPatience);
        play().fire(project().shots.front());
        for (int k = 0; k < 90; ++k) play().thread().advance(kStep);
        play().applyUpdate();
        QVERIFY(!play().events().breaks().empty());
        QVERIFY(video().isEnabled());
    }
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void withoutFfmpegImagesAreExported() {
        const test::Ffmpeg none;
        ask([](VideoDialog& dialog) {
            QVERIFY(dialog.findChild<QLabel*>("video-without-ffmpeg")->isVisible());
            QVERIFY(!dialog.options().isVideo);
            dialog.reject();
        });
        QVERIFY(!videos().isBusy());
    }
    void dialogEndsBelowItsButtons() {
        for (const bool hasFfmpeg : {true, false}) {
            const test::Ffmpeg ffmpeg(hasFfmpeg ? test::Ffmpeg::kTellsArguments : nullptr);
            ask([](VideoDialog& dialog) {
                const int bottom = dialog.findChild<QDialogButtonBox*>()->geometry().bottom();
                const int below = dialog.height() - 1 - bottom - dialog.layout()->contentsMargins().bottom();
                QVERIFY2(below >= 0 && below <= 2, qPrintable(QString::number(below)));
                dialog.reject();
            });
        }
    }
    void dialogShowsNumberOfFrames() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        ask([this](VideoDialog& dialog) {
            QVERIFY(dialog.options().isVideo && dialog.options().path.endsWith("house video.mp4"));
            QCOMPARE(dialog.options().last, 90u);
            const auto* steps = dialog.findChild<QLabel*>("video-steps");
            QCOMPARE(steps->text(), QString("(steps 0 to 90)"));
            setNumber(dialog, "Start", 0.51);  // s; the nearest step is the 31st
            QCOMPARE(steps->text(), QString("(steps 31 to 90)"));
            QCOMPARE(dialog.options().first, 31u);
            setNumber(dialog, "Start", 0.0);
            dialog.findChild<QLineEdit*>("video-path")->setText(m_folder->filePath("hit"));
            QCOMPARE(dialog.options().path, m_folder->filePath("hit.mp4"));
            QCOMPARE(summary(dialog),
                     QString("46 frames of 1280 × 720 pixels: 1.5\u00a0s of video from 1.5\u00a0s of simulation."));
            setNumber(dialog, "Frame rate", 60.0);
            setNumber(dialog, "Speed", 0.1);
            QCOMPARE(summary(dialog),
                     QString("901 frames of 1280 × 720 pixels: 15.0\u00a0s of video from 1.5\u00a0s of simulation."));
            setNumber(dialog, "Speed", 0.01);
            setNumber(dialog, "Frame rate", 240.0);
            QVERIFY(summary(dialog).startsWith("The video would have 36,001 frames; at most 10,000 are possible."));
            QVERIFY(!okButton(dialog).isEnabled());
            dialog.reject();
        });
    }
    void dialogEstimatesTheDuration() {
        if (!hasView()) QSKIP("OpenGL is not available.");
        ask([this](VideoDialog& dialog) {
            fill(dialog, m_folder->filePath("video"), 0, 90, 2.0);
            auto& duration = *dialog.findChild<QLabel*>("video-duration");
            QTRY_VERIFY_WITH_TIMEOUT(duration.text().startsWith("This takes about "), kPatience);
            dialog.reject();
        });
    }
    /// From the menu of the view, which replaces the menus that presenting hides; without overlays.
    void presentedViewIsRecorded() {
        viewport().setPresenting(true);
        emit viewport().customContextMenuRequested(viewport().rect().center());
        auto* menu = viewport().findChild<QMenu*>("present-menu");
        QVERIFY(menu);
        const QString place = m_folder->filePath("presented");
        test::onNextDialog<VideoDialog>([place](VideoDialog& dialog) {
            fill(dialog, place, 0, 30, 2.0);
            dialog.accept();
        });
        VideoRequest recorded;
        connect(&videos(), &VideoExporter::finished, this, [&](const VideoRequest& request) { recorded = request; });
        menu->actions().front()->trigger();
        menu->close();
        play().thread().settle();
        QCoreApplication::sendPostedEvents(&play());
        QVERIFY(videos().isBusy() && window().statusBar()->isVisible());  // with the progress, and Cancel
        QTRY_VERIFY_WITH_TIMEOUT(!videos().isBusy(), kPatience);
        QVERIFY(!window().statusBar()->isVisible());
        QVERIFY(!recorded.plan.view.settings.hasOverlays);
        QCOMPARE(QDir(place).entryList(QDir::Files).size(), 2);
        videos().disconnect(this);
        viewport().setPresenting(false);
        QVERIFY(window().statusBar()->isVisible());
    }
    void imagesShowSimulationWithAndWithoutDestruction() {
        const test::Ffmpeg none;
        ask([this](VideoDialog& dialog) {
            fill(dialog, m_folder->filePath("video"), 0, 90, 2.0);
            dialog.findChild<QCheckBox*>()->setChecked(true);
            QTest::mouseClick(&okButton(dialog), Qt::LeftButton);
        });
        QVERIFY(videos().isBusy() && progress().isVisible());
        QVERIFY(window().isEnabled() && !QApplication::activeModalWidget());  // the window stays usable
        QTRY_VERIFY_WITH_TIMEOUT(!videos().isBusy(), kPatience);
        QVERIFY(!progress().isVisible());
        QCOMPARE(QDir(m_folder->filePath("video")).entryList(QDir::Files),
                 (QStringList{"frame-0000.png", "frame-0001.png", "frame-0002.png", "frame-0003.png"}));
        const QRect left(0, 0, 160, 90), right(168, 0, 160, 90);
        QCOMPARE(picture(0).size(), QSize(328, 90));
        QVERIFY(test::meanDifference(picture(0).copy(left), picture(0).copy(right)) == 0.0);
        QVERIFY(test::meanDifference(picture(3).copy(left), picture(3).copy(right)) > 0.2);
        QVERIFY(window().statusBar()->currentMessage().startsWith("Exported 4 frames to "));
        QVERIFY(lastMessage().text.startsWith("Exported 4 frames to "));
        QVERIFY(lastMessage().severity == Severity::Note);
        QVERIFY(!window().findChild<QMessageBox*>());  // it would take the keys
    }
    void ffmpegEncodesAVideo() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        exportVideo(m_folder->filePath("hit.mp4"), 60, 90, 15.0);
        QTRY_VERIFY_WITH_TIMEOUT(!videos().isBusy(), kPatience);
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
                 QStringList{"hit.mp4"});
        QFile video(m_folder->filePath("hit.mp4"));
        QVERIFY(video.open(QIODevice::ReadOnly));
        QVERIFY(video.readAll().contains("-framerate\n15\n"));
    }
    void videosHaveSoundAndImagesHaveNone() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kKeepsSound);
        ask([this](VideoDialog& dialog) {
            auto* sound = dialog.findChild<QCheckBox*>("video-sound");
            QVERIFY(!sound->isChecked() && !dialog.options().hasSound);
            fill(dialog, m_folder->filePath("hit.mp4"), 0, 90, 60.0);
            sound->setChecked(true);
            QVERIFY(dialog.options().hasSound);
            auto* kind = dialog.findChild<QComboBox*>();
            kind->setCurrentIndex(1);
            QVERIFY(!sound->isEnabled() && !dialog.options().hasSound);
            kind->setCurrentIndex(0);
            QTest::mouseClick(&okButton(dialog), Qt::LeftButton);
        });
        QTRY_VERIFY_WITH_TIMEOUT(!videos().isBusy(), kPatience);
        const QByteArray heard = bytesOfFile(m_folder->filePath("hit.mp4"));
        QCOMPARE(heard.size(), 44 + 4 * 48000 * 91 / 60);
        QVERIFY(std::ranges::any_of(heard.mid(44), [](char byte) { return byte != 0; }));
        ask([](VideoDialog& dialog) {
            QVERIFY(dialog.findChild<QCheckBox*>("video-sound")->isChecked());  // it is remembered
            dialog.reject();
        });
        QSettings().remove("video/sound");
    }
    void cancelledVideoLeavesNoFiles() {
        const test::Ffmpeg none;
        exportVideo(m_folder->filePath("video"), 0, 90, 200.0);
        QTRY_VERIFY_WITH_TIMEOUT(progress().value() > 0, kPatience);
        QVERIFY(QFile::exists(m_folder->filePath("video/frame-0000.png")));
        QTest::mouseClick(window().findChild<QToolButton*>("video-cancel"), Qt::LeftButton);
        QVERIFY(!videos().isBusy() && !progress().isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(QDir(m_folder->path()).isEmpty(), kPatience);
    }
    void unwritableTargetIsReported() {
        const test::Ffmpeg none;
        QVERIFY(QFile(m_folder->filePath("file")).open(QIODevice::WriteOnly));
        exportVideo(m_folder->filePath("file/video"), 0, 90, 2.0);
        QTRY_VERIFY_WITH_TIMEOUT(!videos().isBusy(), kPatience);
        const QString error = lastMessage().text;
        QVERIFY2(error.startsWith("Cannot create the folder"), qPrintable(error));
        QVERIFY(lastMessage().severity == Severity::Error && !QApplication::activeModalWidget());
        QCOMPARE(window().statusBar()->currentMessage(), error);
    }
    void fullDiskIsReportedAndLeavesNoFiles() {
        const test::Ffmpeg none;
        const FileSizeLimit full(2000);
        exportVideo(m_folder->filePath("video"), 0, 90, 2.0);
        QTRY_VERIFY_WITH_TIMEOUT(!videos().isBusy(), kPatience);
        const QString error = lastMessage().text;
        QVERIFY2(error.contains("File too large"), qPrintable(error));
        QVERIFY(QDir(m_folder->path()).isEmpty());
    }
    void closingTheWindowDuringExportAsksFirst() {
        const test::Ffmpeg none;
        exportVideo(m_folder->filePath("video"), 0, 90, 200.0);
        test::onNextDialog<QMessageBox>([](QMessageBox& box) { box.reject(); });
        QVERIFY(!window().close());
        QVERIFY(videos().isBusy());
        videos().cancel();
        window().workspace().document().setSaved();
        QVERIFY(window().close());
        QTRY_VERIFY_WITH_TIMEOUT(QDir(m_folder->path()).isEmpty(), kPatience);
    }

    void typedNumbersAreCheckedBeforeExport() {
        const test::Ffmpeg none;
        ask([this](VideoDialog& dialog) {
            fill(dialog, m_folder->filePath("video"), 0, 90, 2.0);
            for (NumberField* field : dialog.findChildren<NumberField*>()) {
                if (field->accessibleName() != "Width") continue;
                field->setFocus();
                field->selectAll();
                QTest::keyClicks(field, "3 kg");
            }
            dialog.accept();
            QVERIFY(dialog.isVisible());
            dialog.reject();
        });
        QVERIFY(!videos().isBusy());
    }
    void remainingTimeIsShown() {
        const test::Ffmpeg none;
        exportVideo(m_folder->filePath("video"), 0, 90, 60.0);
        QTRY_VERIFY_WITH_TIMEOUT(progress().format().contains(" left"), kPatience);
        progress().setFormat("Video %p %, 188 min left");
        progress().setValue(100);
        QCOMPARE(test::clippedTexts(*window().statusBar()), QStringList());
        videos().cancel();
    }

    void cleanupTestCase() { close(); }

private:
    /// Nothing was simulated yet: a saved throw of the project is.
    void exportSavedThrowBeforePlay() {
        init();
        const test::Ffmpeg none;
        QVERIFY(video().isEnabled());
        play().setTimeStep(1.0 / 120.0);
        test::onNextDialog<VideoDialog>([this](VideoDialog& dialog) {
            QCOMPARE(dialog.options().last, 360u);  // 3 s
            fill(dialog, m_folder->filePath("throw"), 0, 60, 1.0);
            dialog.accept();
        });
        double stepLength = 0.0;
        connect(&videos(), &VideoExporter::finished, this,
                [&](const VideoRequest& request) { stepLength = request.script.settings.dt; });
        video().trigger();
        QVERIFY(videos().isBusy());
        QTRY_VERIFY_WITH_TIMEOUT(!videos().isBusy(), kPatience);
        videos().disconnect(this);
        play().setTimeStep(1.0 / 60.0);
        QCOMPARE(stepLength, 1.0 / 120.0);
        QVERIFY(!play().isInPlay());
        QVERIFY2(lastMessage().text.startsWith("Exported 2 frames to "), qPrintable(lastMessage().text));
        const QImage first(m_folder->filePath("throw/frame-0000.png")),
            last(m_folder->filePath("throw/frame-0001.png"));
        QVERIFY(test::meanDifference(first.convertToFormat(QImage::Format_RGB888),
                                     last.convertToFormat(QImage::Format_RGB888)) > 0.1);
    }
    Message lastMessage() { return window().views().messages().list().back(); }
    PlayController& play() { return window().workspace().play(); }
    VideoExporter& videos() { return window().workspace().videos(); }
    QAction& video() { return *action("play-video"); }
    QProgressBar& progress() { return *window().findChild<QProgressBar*>("video-progress"); }
    /// The video starts once the simulation has handed over its recording.
    void ask(const std::function<void(VideoDialog&)>& answer) {
        test::onNextDialog<VideoDialog>([answer](VideoDialog& dialog) {
            answer(dialog);
            if (dialog.isVisible()) dialog.reject();  // a check failed
        });
        video().trigger();
        play().thread().settle();
        QCoreApplication::sendPostedEvents(&play());
    }
    void exportVideo(const QString& path, int first, int last, double rate) {
        ask([path, first, last, rate](VideoDialog& dialog) {
            fill(dialog, path, first, last, rate);
            dialog.accept();
        });
    }
    static QString summary(VideoDialog& dialog) { return dialog.findChild<QLabel*>("video-summary")->text(); }
    static QPushButton& okButton(VideoDialog& dialog) {
        for (QAbstractButton* button : dialog.findChild<QDialogButtonBox*>()->buttons()) {
            if (button->text() == "Export") return static_cast<QPushButton&>(*button);
        }
        qFatal("Export button not found.");
    }
    static void setNumber(VideoDialog& dialog, const QString& name, double value) {
        for (NumberField* field : dialog.findChildren<NumberField*>()) {
            if (field->accessibleName() != name) continue;
            field->setValue(value);
            emit field->edited(value);
        }
    }
    /// Options of a small, fast video; `first` and `last` in steps of 1/60 s.
    static void fill(VideoDialog& dialog, const QString& place, int first, int last, double rate) {
        dialog.findChild<QLineEdit*>("video-path")->setText(place);
        dialog.findChild<QComboBox*>("video-quality")->setCurrentIndex(0);
        setNumber(dialog, "Width", 160);
        setNumber(dialog, "Height", 90);
        setNumber(dialog, "End", last * kStep);
        setNumber(dialog, "Start", first * kStep);
        setNumber(dialog, "Frame rate", rate);
        setNumber(dialog, "Speed", 1.0);
    }
    QImage picture(int k) const {
        return QImage(m_folder->filePath(QString("video/frame-000%1.png").arg(k)))
            .convertToFormat(QImage::Format_RGB888);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

RUBBLE_TEST_WITH(VideoExportTest, QApplication)
#include "VideoExportTest.moc"
