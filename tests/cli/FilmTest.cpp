// Tests app/cli/verbs/FilmVerb.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Pictures.h"
#include "tests/support/files/Ffmpeg.h"
#include "tests/support/files/RunProgram.h"

#include <QDir>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

using namespace rubble;
using test::meanDifference;

namespace {

QStringList filmArguments(const QTemporaryDir& place, const QStringList& options) {
    return QStringList{"film",
                       RUBBLE_SOURCE_DIR "/projects/house.rubble",
                       place.filePath("film"),
                       "--samples",
                       "0",
                       "--shot",
                       "box at the door"} +
           options;
}

ProgramOutcome runFilm(const QStringList& arguments) { return runProgram(RUBBLE_CLI, arguments); }

ProgramOutcome film(const QTemporaryDir& place, const QStringList& options) {
    return runFilm(filmArguments(place, options));
}

QStringList filesIn(const QTemporaryDir& place) {
    return QDir(place.filePath("film")).entryList(QDir::Files | QDir::Hidden, QDir::Name);
}

QImage frame(const QTemporaryDir& place, const QString& name) {
    return QImage(place.filePath("film/" + name)).convertToFormat(QImage::Format_RGB888);
}

}  // namespace

class FilmTest : public QObject {
    Q_OBJECT
private slots:
    void pictureIsWrittenEveryFewSteps() {
        const QTemporaryDir place;
        const ProgramOutcome outcome = film(place, {"--steps", "45", "--every", "20", "--size", "180x120"});
        QCOMPARE(outcome.error, QString());
        QCOMPARE(outcome.output, "3 pictures written to " + place.filePath("film") + "\n");
        QCOMPARE(filesIn(place), (QStringList{"frame-0000.png", "frame-0001.png", "frame-0002.png"}));
        for (const QString& name : filesIn(place)) QCOMPARE(frame(place, name).size(), QSize(180, 120));
        QVERIFY(meanDifference(frame(place, "frame-0000.png"), frame(place, "frame-0001.png")) < 0.1);  // at rest
        QVERIFY(meanDifference(frame(place, "frame-0000.png"), frame(place, "frame-0002.png")) > 0.2);  // the box flies
    }
    void comparisonShowsBothSides() {
        const QTemporaryDir place;
        const QStringList options{"--steps", "90", "--every", "90", "--size", "180x120", "--view", "front"};
        QCOMPARE(film(place, options + QStringList{"--compare"}).exit, 0);
        QCOMPARE(frame(place, "frame-0001.png").size(), QSize(368, 120));
        const QRect besideTheDoor(96, 70, 15, 30);
        for (const auto& [name, differs] : {std::pair{"frame-0000.png", false}, std::pair{"frame-0001.png", true}}) {
            const QImage left = frame(place, name).copy(besideTheDoor);
            const QImage right = frame(place, name).copy(besideTheDoor.translated(188, 0));
            QCOMPARE(meanDifference(left, right) > 5.0, differs);
        }
        QCOMPARE(frame(place, "frame-0001.png").pixelColor(184, 60), QColor(Qt::white));
    }
    void folderWithAFilmIsRejected() {
        const QTemporaryDir place;
        QCOMPARE(film(place, {"--steps", "0", "--size", "18x12"}).exit, 0);
        const ProgramOutcome outcome = film(place, {"--steps", "0", "--size", "18x12"});
        QCOMPARE(outcome.exit, 1);
        QCOMPARE(outcome.error, '"' + place.filePath("film") +
                                    "\" already contains a film: frame-0000.png. Choose another folder, or remove its "
                                    "pictures.\n");
    }
    void filmIsEncodedWithFfmpeg() {
        const QTemporaryDir place;
        const QString path = place.filePath("hit.mp4");
        const QStringList options{"film", RUBBLE_SOURCE_DIR "/projects/house.rubble",
                                  path,   "--samples",
                                  "0",    "--from",
                                  "10",   "--steps",
                                  "30",   "--every",
                                  "10",   "--size",
                                  "18x12"};
        {
            const test::Ffmpeg none;
            const ProgramOutcome outcome = runFilm(options);
            QCOMPARE(outcome.exit, 1);
            QCOMPARE(outcome.error,
                     QString("A film needs ffmpeg, which is not installed; give a folder instead to write its "
                             "pictures.\n"));
        }
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        const ProgramOutcome outcome = runFilm(options);
        QCOMPARE(outcome.error, QString());
        QCOMPARE(outcome.output, "3 pictures written to " + path + "\n");
        QFile film(path);
        QVERIFY(film.open(QIODevice::ReadOnly));
        QVERIFY(film.readAll().contains("-framerate\n6\n"));  // real time
    }
    void startAfterTheEndIsRejected() {
        const QTemporaryDir place;
        const ProgramOutcome outcome = film(place, {"--from", "20", "--steps", "10"});
        QCOMPARE(outcome.exit, 1);
        QCOMPARE(outcome.error, QString("The film would start at step 20 and end at step 10.\n"));
    }
    void controlCKeepsOnlyCompletePictures() {
        const QTemporaryDir place;
        QProcess program;
        program.start(RUBBLE_CLI, filmArguments(place, {"--steps", "9999", "--size", "180x120"}));
        QTRY_VERIFY(filesIn(place).filter(".png").size() >= 2);
        kill(static_cast<pid_t>(program.processId()), SIGINT);
        QVERIFY(program.waitForFinished(kPatience));
        QCOMPARE(program.exitCode(), 130);
        QCOMPARE(program.readAllStandardError(), QByteArray("Cancelled.\n"));
        const QStringList files = filesIn(place);
        QVERIFY(files.size() >= 2 && files.size() < 9999);
        QCOMPARE(files.filter(QRegularExpression("^frame-[0-9]{4}\\.png$")).size(), files.size());
        for (const QString& name : files) QCOMPARE(frame(place, name).size(), QSize(180, 120));
    }
};

RUBBLE_TEST_WITH(FilmTest, QCoreApplication)
#include "FilmTest.moc"
