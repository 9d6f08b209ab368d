#include "editor/FilmDialog.h"
#include "tests/support/Dialogs.h"
#include "tests/support/EditorStory.h"
#include "tests/support/Ffmpeg.h"
#include "tests/support/FileLimits.h"
#include "tests/support/Pictures.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QSpinBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QToolButton>

using namespace rubble;

namespace {

constexpr double kStep = 1.0 / 60.0;

}  // namespace

/// What was played is filmed from the window: pictures with and without destruction, a film where there is ffmpeg, and nothing
/// where it is cancelled or cannot be written.
class FilmExportTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        openFile(RUBBLE_SOURCE_DIR "/projects/house.rubble");
        play().thread().useSteppedClock();
        QVERIFY(!film().isEnabled());  // nothing was played yet
        play().play();
        QTRY_VERIFY_WITH_TIMEOUT(play().isPlaying(), kPatience);
        play().fire(project().shots.front());
        for (int k = 0; k < 90; ++k) play().thread().advance(kStep);
        play().takeNews();
        QVERIFY(!play().breaks().empty());
        QVERIFY(film().isEnabled());
    }
    void init() { m_place = std::make_unique<QTemporaryDir>(); }

    void withoutFfmpegPicturesAreOffered() {
        const test::Ffmpeg none;
        ask([](FilmDialog& dialog) {
            QVERIFY(dialog.findChild<QLabel*>("film-without-ffmpeg")->isVisible());
            QVERIFY(!dialog.choice().isFilm);
            dialog.reject();
        });
        QVERIFY(!films().isBusy());
    }
    void theDialogSaysWhatComesOfIt() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        ask([this](FilmDialog& dialog) {
            QVERIFY(dialog.choice().isFilm && dialog.choice().place.endsWith("house film.mp4"));
            QCOMPARE(dialog.choice().last, 90u);
            dialog.findChild<QLineEdit*>("film-place")->setText(m_place->filePath("hit"));
            QCOMPARE(dialog.choice().place, m_place->filePath("hit.mp4"));
            QCOMPARE(summary(dialog), QString("46 pictures that show 1.5 s of play in 1.5 s."));
            setNumber(dialog, " pictures a second", 60.0);
            setNumber(dialog, "×", 0.1);
            QCOMPARE(summary(dialog), QString("901 pictures that show 1.5 s of play in 15.0 s."));
            setNumber(dialog, "×", 0.01);
            setNumber(dialog, " pictures a second", 240.0);
            QVERIFY(summary(dialog).startsWith("These are 36,001 pictures; a film can have 10,000."));
            QVERIFY(!okButton(dialog).isEnabled());
            dialog.reject();
        });
    }
    void picturesAreWrittenWithoutDestructionAndWithIt() {
        const test::Ffmpeg none;
        ask([this](FilmDialog& dialog) {
            fill(dialog, m_place->filePath("film"), 0, 90, 2.0);
            dialog.findChild<QCheckBox*>()->setChecked(true);
            QTest::mouseClick(&okButton(dialog), Qt::LeftButton);
        });
        QVERIFY(films().isBusy() && progress().isVisible());
        QVERIFY(window().isEnabled() && !QApplication::activeModalWidget());  // one goes on working meanwhile
        QTRY_VERIFY_WITH_TIMEOUT(!films().isBusy(), kPatience);
        QVERIFY(!progress().isVisible());
        QCOMPARE(QDir(m_place->filePath("film")).entryList(QDir::Files),
                 (QStringList{"frame-0000.png", "frame-0001.png", "frame-0002.png", "frame-0003.png"}));
        const QRect left(0, 0, 160, 90), right(168, 0, 160, 90);
        QCOMPARE(picture(0).size(), QSize(328, 90));
        QVERIFY(test::meanDifference(picture(0).copy(left), picture(0).copy(right)) == 0.0);
        QVERIFY(test::meanDifference(picture(3).copy(left), picture(3).copy(right)) > 0.2);
        QVERIFY(window().statusBar()->currentMessage().startsWith("4 pictures in "));
    }
    void ffmpegMakesAFilm() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        ask([this](FilmDialog& dialog) {
            fill(dialog, m_place->filePath("hit.mp4"), 60, 90, 15.0);
            dialog.accept();
        });
        QTRY_VERIFY_WITH_TIMEOUT(!films().isBusy(), kPatience);
        QCOMPARE(QDir(m_place->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
                 QStringList{"hit.mp4"});
        QFile film(m_place->filePath("hit.mp4"));
        QVERIFY(film.open(QIODevice::ReadOnly));
        QVERIFY(film.readAll().contains("-framerate\n15\n"));
    }
    void aCancelledFilmLeavesNothing() {
        const test::Ffmpeg none;
        ask([this](FilmDialog& dialog) {
            fill(dialog, m_place->filePath("film"), 0, 90, 200.0);
            dialog.accept();
        });
        QTRY_VERIFY_WITH_TIMEOUT(progress().value() > 0, kPatience);
        QVERIFY(QFile::exists(m_place->filePath("film/frame-0000.png")));
        QTest::mouseClick(window().findChild<QToolButton*>("film-cancel"), Qt::LeftButton);
        QVERIFY(!films().isBusy() && !progress().isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(QDir(m_place->path()).isEmpty(), kPatience);
    }
    void whatCannotBeWrittenIsTold() {
        const test::Ffmpeg none;
        QVERIFY(QFile(m_place->filePath("file")).open(QIODevice::WriteOnly));
        ask([this](FilmDialog& dialog) {
            fill(dialog, m_place->filePath("file/film"), 0, 90, 2.0);
            dialog.accept();
        });
        QString sentence;
        test::whenAsked<QMessageBox>([&sentence](QMessageBox& box) {
            sentence = box.text();
            box.accept();
        });
        QTRY_VERIFY_WITH_TIMEOUT(!sentence.isEmpty(), kPatience);
        QVERIFY2(sentence.startsWith("Cannot make the folder"), qPrintable(sentence));
        QVERIFY(!films().isBusy());
    }
    void aFullDiskIsToldAndNothingIsLeft() {
        const test::Ffmpeg none;
        const FileSizeLimit full(2000);
        ask([this](FilmDialog& dialog) {
            fill(dialog, m_place->filePath("film"), 0, 90, 2.0);
            dialog.accept();
        });
        QString sentence;
        test::whenAsked<QMessageBox>([&sentence](QMessageBox& box) {
            sentence = box.text();
            box.accept();
        });
        QTRY_VERIFY_WITH_TIMEOUT(!sentence.isEmpty(), kPatience);
        QVERIFY2(sentence.contains("File too large"), qPrintable(sentence));
        QVERIFY(QDir(m_place->path()).isEmpty());
    }
    void closingTheWindowAsksFirst() {
        const test::Ffmpeg none;
        ask([this](FilmDialog& dialog) {
            fill(dialog, m_place->filePath("film"), 0, 90, 200.0);
            dialog.accept();
        });
        test::whenAsked<QMessageBox>([](QMessageBox& box) { box.reject(); });
        QVERIFY(!window().close());
        QVERIFY(films().isBusy());
        films().cancel();
        window().workspace().document().setSaved();
        QVERIFY(window().close());
        QTRY_VERIFY_WITH_TIMEOUT(QDir(m_place->path()).isEmpty(), kPatience);
    }

    void cleanupTestCase() { close(); }

private:
    PlayController& play() { return window().workspace().play(); }
    FilmMaker& films() { return window().workspace().films(); }
    QAction& film() { return *action("play-film"); }
    QProgressBar& progress() { return *window().findChild<QProgressBar*>("film-progress"); }
    void ask(const std::function<void(FilmDialog&)>& answer) {
        test::whenAsked<FilmDialog>(answer);
        film().trigger();
    }
    static QString summary(FilmDialog& dialog) { return dialog.findChild<QLabel*>("film-summary")->text(); }
    static QPushButton& okButton(FilmDialog& dialog) {
        for (QAbstractButton* button : dialog.findChild<QDialogButtonBox*>()->buttons()) {
            if (button->text() == "Export") return static_cast<QPushButton&>(*button);
        }
        qFatal("no button");
    }
    static void setNumber(FilmDialog& dialog, const QString& suffix, double value) {
        for (QDoubleSpinBox* box : dialog.findChildren<QDoubleSpinBox*>()) {
            if (box->suffix() == suffix) box->setValue(value);
        }
    }
    /// Small and quick.
    static void fill(FilmDialog& dialog, const QString& place, int first, int last, double rate) {
        dialog.findChild<QLineEdit*>("film-place")->setText(place);
        dialog.findChildren<QComboBox*>().last()->setCurrentIndex(0);
        for (QSpinBox* box : dialog.findChildren<QSpinBox*>()) {
            if (box->accessibleName() == "Width") box->setValue(160);
            if (box->accessibleName() == "Height") box->setValue(90);
            if (box->accessibleName() == "First step") box->setValue(first);
            if (box->accessibleName() == "Last step") box->setValue(last);
        }
        setNumber(dialog, " pictures a second", rate);
        setNumber(dialog, "×", 1.0);
    }
    QImage picture(int k) const {
        return QImage(m_place->filePath(QString("film/frame-000%1.png").arg(k))).convertToFormat(QImage::Format_RGB888);
    }

    std::unique_ptr<QTemporaryDir> m_place;
};

QTEST_MAIN(FilmExportTest)
#include "FilmExportTest.moc"
