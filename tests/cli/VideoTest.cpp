// Tests app/cli/verbs/VideoVerb.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/files/Ffmpeg.h"
#include "tests/support/files/RunProgram.h"
#include "tests/support/viewport/Pictures.h"

#include <QDir>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

using namespace rubble;
using test::meanDifference;

namespace {

QStringList videoArguments(const QTemporaryDir& place, const QStringList& options) {
    return QStringList{"video",
                       RUBBLE_SOURCE_DIR "/projects/house.rubble",
                       place.filePath("video"),
                       "--samples",
                       "0",
                       "--shot",
                       "box at the door"} +
           options;
}

ProgramOutcome runVideo(const QStringList& arguments) { return runProgram(RUBBLE_CLI, arguments); }

ProgramOutcome video(const QTemporaryDir& place, const QStringList& options) {
    return runVideo(videoArguments(place, options));
}

QStringList filesIn(const QTemporaryDir& place) {
    return QDir(place.filePath("video")).entryList(QDir::Files | QDir::Hidden, QDir::Name);
}

QImage frame(const QTemporaryDir& place, const QString& name) {
    return QImage(place.filePath("video/" + name)).convertToFormat(QImage::Format_RGB888);
}

}  // namespace

class VideoTest : public QObject {
    Q_OBJECT
private slots:
    void pictureIsWrittenEveryFewSteps() {
        const QTemporaryDir place;
        const ProgramOutcome outcome = video(place, {"--steps", "45", "--every", "20", "--size", "180x120"});
        QCOMPARE(outcome.error, QString());
        QCOMPARE(outcome.output, "3 pictures written to " + place.filePath("video") + "\n");
        QCOMPARE(filesIn(place), (QStringList{"frame-0000.png", "frame-0001.png", "frame-0002.png"}));
        for (const QString& name : filesIn(place)) QCOMPARE(frame(place, name).size(), QSize(180, 120));
        QVERIFY(meanDifference(frame(place, "frame-0000.png"), frame(place, "frame-0001.png")) < 0.1);  // at rest
        QVERIFY(meanDifference(frame(place, "frame-0000.png"), frame(place, "frame-0002.png")) > 0.2);  // the box flies
    }
    void comparisonShowsBothSides() {
        const QTemporaryDir place;
        const QStringList options{"--steps", "90", "--every", "90", "--size", "180x120", "--view", "front"};
        QCOMPARE(video(place, options + QStringList{"--compare"}).exit, 0);
        QCOMPARE(frame(place, "frame-0001.png").size(), QSize(368, 120));
        const QRect besideTheDoor(96, 70, 15, 30);
        for (const auto& [name, differs] : {std::pair{"frame-0000.png", false}, std::pair{"frame-0001.png", true}}) {
            const QImage left = frame(place, name).copy(besideTheDoor);
            const QImage right = frame(place, name).copy(besideTheDoor.translated(188, 0));
            QCOMPARE(meanDifference(left, right) > 5.0, differs);
        }
        QCOMPARE(frame(place, "frame-0001.png").pixelColor(184, 60), QColor(Qt::white));
    }
    void folderWithAVideoIsRejected() {
        const QTemporaryDir place;
        QCOMPARE(video(place, {"--steps", "0", "--size", "18x12"}).exit, 0);
        const ProgramOutcome outcome = video(place, {"--steps", "0", "--size", "18x12"});
        QCOMPARE(outcome.exit, 1);
        QCOMPARE(outcome.error, '"' + place.filePath("video") +
                                    "\" already contains a video: frame-0000.png. Choose another folder, or remove its "
                                    "pictures.\n");
    }
    void videoIsEncodedWithFfmpeg() {
        const QTemporaryDir place;
        const QString path = place.filePath("hit.mp4");
        const QStringList options{"video", RUBBLE_SOURCE_DIR "/projects/house.rubble",
                                  path,    "--samples",
                                  "0",     "--from",
                                  "10",    "--steps",
                                  "30",    "--every",
                                  "10",    "--size",
                                  "18x12"};
        {
            const test::Ffmpeg none;
            const ProgramOutcome outcome = runVideo(options);
            QCOMPARE(outcome.exit, 1);
            QCOMPARE(outcome.error,
                     QString("A video needs ffmpeg, which is not installed; give a folder instead to write its "
                             "pictures.\n"));
        }
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        const ProgramOutcome outcome = runVideo(options);
        QCOMPARE(outcome.error, QString());
        QCOMPARE(outcome.output, "3 pictures written to " + path + "\n");
        QFile video(path);
        QVERIFY(video.open(QIODevice::ReadOnly));
        QVERIFY(video.readAll().contains("-framerate\n6\n"));  // real time
    }
    void soundIsGivenToFfmpeg() {
        const QTemporaryDir place;
        const QString path = place.filePath("hit.mp4");
        const QStringList options{"video",     RUBBLE_SOURCE_DIR "/projects/house.rubble",
                                  path,        "--sound",
                                  "--samples", "0",
                                  "--steps",   "20",
                                  "--every",   "10",
                                  "--size",    "18x12"};
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        QCOMPARE(runVideo(options).error, QString());
        QFile video(path);
        QVERIFY(video.open(QIODevice::ReadOnly));
        QVERIFY(QRegularExpression("\n-i\n[^\n]*/sound.wav\n").match(video.readAll()).hasMatch());
        QCOMPARE(QDir(place.path()).entryList(QDir::Files | QDir::Hidden), QStringList{"hit.mp4"});
    }
    void picturesHaveNoSound() {
        const QTemporaryDir place;
        QCOMPARE(video(place, {"--steps", "1", "--sound"}).error,
                 QString("--sound needs a video such as hit.mp4; rubble-cli simulate --wav writes the sound alone.\n"));
    }
    void videoHasTwoStreams() {
        const QString ffprobe = QStandardPaths::findExecutable("ffprobe");
        if (ffprobe.isEmpty()) QSKIP("ffprobe is not installed.");
        const QTemporaryDir place;
        const QString path = place.filePath("hit.mp4");
        const ProgramOutcome made =
            runVideo({"video", RUBBLE_SOURCE_DIR "/projects/house.rubble", path, "--sound", "--samples", "0", "--shot",
                      "box at the door", "--steps", "60", "--every", "10", "--size", "180x120"});
        QCOMPARE(made.error, QString());
        const ProgramOutcome probed =
            runProgram(ffprobe, {"-v", "error", "-show_entries", "stream=codec_type", "-of", "csv=p=0", path});
        QCOMPARE(probed.output.simplified(), QString("video audio"));
    }
    void startAfterTheEndIsRejected() {
        const QTemporaryDir place;
        const ProgramOutcome outcome = video(place, {"--from", "20", "--steps", "10"});
        QCOMPARE(outcome.exit, 1);
        QCOMPARE(outcome.error, QString("The video would start at step 20 and end at step 10.\n"));
    }
    void controlCKeepsOnlyCompletePictures() {
        const QTemporaryDir place;
        QProcess program;
        program.start(RUBBLE_CLI, videoArguments(place, {"--steps", "9999", "--size", "180x120"}));
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

RUBBLE_TEST_WITH(VideoTest, QCoreApplication)
#include "VideoTest.moc"
