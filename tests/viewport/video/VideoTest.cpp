// Tests viewport/video/Video.cpp and viewport/video/CameraListener.cpp.
#include "tests/support/TestProgram.h"
#include "viewport/video/Video.h"

#include "core/io/media/VideoFile.h"
#include "core/sound/session/SoundRecorder.h"
#include "tests/support/files/Ffmpeg.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/files/FileLimits.h"
#include "tests/support/play/Sessions.h"
#include "tests/support/viewport/Pictures.h"
#include "viewport/video/CameraListener.h"

#include <QDir>
#include <QImage>

#include <numbers>

using namespace rubble;

namespace {

/// A box that flies across the image, 1 m in ten steps.
std::vector<SessionPlayback> flights(int count = 1) {
    const auto scene = test::playSceneOf(test::floatingBlock());
    std::vector<SessionPlayback> playbacks;
    for (int k = 0; k < count; ++k) {
        Throw thrown{.size = Vec3(0.5), .mass = 1.0, .from = {-3.0, 7.0, 0.0}, .to = {3.0, 7.0, 0.0}, .speed = 6.0};
        playbacks.emplace_back(scene, Session::start(scene).value(),
                               std::vector<TimedInput>{{0, ShotInput{"throw", thrown}}});
    }
    return playbacks;
}

VideoPlan plan(int pictures, double first = 0.0, double every = 1.0) {
    RenderView view{.camera = {.target = {0.0, 6.0, 0.0}, .distance = 14.0}, .size = {160, 90}};
    return {.view = view, .samples = 0, .first = first, .stepsPerFrame = every, .frames = pictures, .frameRate = 30.0};
}

/// A box that hits the block.
ShotInput hit() { return {"throw", test::throwAtBlock(5.0, 40.0)}; }

double energyOf(const StereoTrack& track, std::size_t side) {
    double sum = 0.0;
    for (std::size_t k = side; k < track.samples.size(); k += 2) sum += 1.0 * track.samples[k] * track.samples[k];
    return sum;
}

/// The first sample of a WAV file that is not zero.
qint64 onsetOf(const QByteArray& wav) {
    const auto heard = std::find_if(wav.begin() + 44, wav.end(), [](char byte) { return byte != 0; });
    return (heard - wav.begin() - 44) / 4;
}

}  // namespace

class VideoTest : public QObject {
    Q_OBJECT
private slots:
    void init() { m_directory = std::make_unique<QTemporaryDir>(); }

    void countsFrames() {
        QCOMPARE(frameCount(0.0, 10.0, 1.0), 11);
        QCOMPARE(frameCount(0.0, 10.0, 3.0), 4);
        QCOMPARE(frameCount(5.0, 5.0, 2.0), 1);
        QCOMPARE(frameCount(0.0, 3.0, 0.1), 31);
        QVERIFY(frameCount(0.0, 1e9, 1e-9) > 0);
    }
    void writesOneImagePerFrame() {
        QVERIFY(video(flights(), plan(3, 4.0, 8.0)));
        QCOMPARE(names(), (QStringList{"frame-0000.png", "frame-0001.png", "frame-0002.png"}));
        QVERIFY(boxAt(0) > 0 && boxAt(0) < boxAt(1) && boxAt(1) < boxAt(2));
    }
    void posesAreInterpolatedBetweenSteps() {
        QVERIFY(video(flights(), plan(5, 10.0, 0.25)));
        for (int k = 0; k < 4; ++k) QVERIFY(test::meanDifference(picture(k), picture(k + 1)) > 0.0);
        QVERIFY(boxAt(0) <= boxAt(2) && boxAt(2) <= boxAt(4) && boxAt(0) < boxAt(4));
    }
    void playbacksAreSideBySide() {
        QVERIFY(video(flights(2), plan(1, 20.0)));
        const QImage both = picture(0);
        QCOMPARE(both.size(), QSize(160 + 8 + 160, 90));
        QVERIFY(test::meanDifference(both.copy(0, 0, 160, 90), both.copy(168, 0, 160, 90)) == 0.0);
    }
    void cancelledVideoLeavesNoFiles() {
        QCOMPARE(cancelled(Unfinished::Removed).error().code, ErrorCode::Cancelled);
        QVERIFY(QDir(m_directory->path()).isEmpty());
        QCOMPARE(cancelled(Unfinished::Kept).error().code, ErrorCode::Cancelled);
        QCOMPARE(names(), (QStringList{"frame-0000.png", "frame-0001.png"}));
    }
    void fullDiskIsReportedAndLeavesNoFiles() {
        const FileSizeLimit full(1000);
        std::vector<SessionPlayback> playbacks = flights();
        const Status shot = renderFrames(playbacks, plan(3), folder(), Unfinished::Removed);
        QCOMPARE(shot.error().code, ErrorCode::Io);
        QVERIFY2(shot.error().message.ends_with("File too large."), shot.error().message.c_str());
        QVERIFY(QDir(m_directory->path()).isEmpty());
    }
    void soundIsThatOfTheSimulationHeardFromTheCamera() {
        VideoPlan heard = plan(30, 0.0, 2.0);  // a second in real time
        heard.view.camera.target.x = 4.0;      // the block is on the left
        const QByteArray sound = soundOf(heard);
        Session session = test::sessionOf(test::floatingBlock());
        test::addInput(session, hit());
        SoundRecorder recorder;
        for (int step = 0; step < 58; ++step) {
            session.step();
            recorder.add(session);
        }
        QVERIFY(!recorder.cues().empty());
        const StereoTrack track = *mixedTrack(recorder.cues(), 1.0, listenerAt(heard.view.camera));
        QCOMPARE(sound, QByteArray::fromStdString(wavFile(track)));
        QVERIFY(energyOf(track, 0) > 1.5 * energyOf(track, 1));
        heard.view.camera.azimuth = std::numbers::pi;  // from behind it is on the right
        QVERIFY(soundOf(heard) != sound);
    }
    void soundIsAsFastAndAsLongAsTheFrames() {
        VideoPlan slow = plan(20, 6.0, 0.5);
        slow.frameRate = 25.0;
        QCOMPARE(soundOf(slow).size(), 44 + 4 * 48000 * 20 / 25);
        const QByteArray real = soundOf(plan(30, 0.0, 2.0)), half = soundOf(plan(60, 0.0, 1.0));
        QVERIFY(onsetOf(real) < 24000 && std::abs(onsetOf(half) - 2 * onsetOf(real)) <= 1);
    }
    void videoTooLongForASoundIsRefusedBeforeItIsRendered() {
        VideoPlan longest = plan(10000);
        longest.hasSound = true;
        longest.frameRate = 1.0;
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kKeepsSound);
        std::vector<SessionPlayback> playbacks = flights();
        const Status made = renderVideo(playbacks, longest, m_directory->filePath("long.mp4").toStdString());
        QCOMPARE(made.error().code, ErrorCode::BadInput);
        QCOMPARE(playbacks[0].session().stepsDone(), std::uint64_t{0});
        QVERIFY(QDir(m_directory->path()).isEmpty());
    }
    void encodesAVideoWithFfmpeg() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        std::vector<SessionPlayback> playbacks = flights();
        double last = 0.0;
        TaskContext task;
        task.progress = [&](double fraction) { last = fraction; };
        const Status shot = renderVideo(playbacks, plan(2), m_directory->filePath("a.mp4").toStdString(), task);
        QVERIFY2(shot.hasValue(), shot ? "" : shot.error().message.c_str());
        QVERIFY(last > 0.5 && last < 1.0);  // after rendering the frames
        QCOMPARE(QDir(m_directory->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
                 QStringList{"a.mp4"});
    }
    void failedEncodingLeavesNoFiles() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kFails);
        std::vector<SessionPlayback> playbacks = flights();
        QCOMPARE(renderVideo(playbacks, plan(2), m_directory->filePath("a.mp4").toStdString()).error().code,
                 ErrorCode::Io);
        QVERIFY(QDir(m_directory->path()).isEmpty());
    }

private:
    /// The sound of a video of a hit.
    QByteArray soundOf(VideoPlan heard) {
        heard.hasSound = true;
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kKeepsSound);
        const auto scene = test::playSceneOf(test::floatingBlock());
        std::vector<SessionPlayback> playbacks;
        playbacks.emplace_back(scene, Session::start(scene).value(), std::vector<TimedInput>{{0, hit()}});
        const QString path = m_directory->filePath("hit.mp4");
        const Status made = renderVideo(playbacks, heard, path.toStdString());
        if (!made) qFatal("%s", made.error().message.c_str());
        return bytesOfFile(path);
    }
    std::string folder() const { return m_directory->filePath("video").toStdString(); }
    QStringList names() const { return QDir(m_directory->filePath("video")).entryList(QDir::Files, QDir::Name); }
    bool video(std::vector<SessionPlayback> playbacks, const VideoPlan& plan) {
        const Status shot = renderFrames(playbacks, plan, folder(), Unfinished::Removed);
        if (!shot) qWarning("%s", shot.error().message.c_str());
        return shot.hasValue();
    }
    Status cancelled(Unfinished unfinished) {
        std::vector<SessionPlayback> playbacks = flights();
        TaskContext task;
        task.progress = [&task](double fraction) {
            if (fraction >= 0.5) task.cancel.cancel();
        };
        return renderFrames(playbacks, plan(4), folder(), unfinished, task);
    }
    QImage picture(int k) const {
        return QImage(m_directory->filePath(QString("video/frame-000%1.png").arg(k)))
            .convertToFormat(QImage::Format_RGB888);
    }
    /// The column of the thrown box's centre, from the pixels that differ without it; 0 if it is not visible.
    int boxAt(int k) {
        if (m_empty.isNull()) {
            std::vector<SessionPlayback> playbacks = flights();
            const auto empty = m_directory->filePath("empty");
            if (!renderFrames(playbacks, plan(1), empty.toStdString(), Unfinished::Removed)) qFatal("no picture");
            m_empty = QImage(empty + "/frame-0000.png").convertToFormat(QImage::Format_RGB888);
        }
        const QImage now = picture(k);
        int sum = 0, count = 0;
        for (int y = 0; y < 40; ++y) {  // above the block
            for (int x = 0; x < now.width(); ++x) {
                if (std::abs(qGray(now.pixel(x, y)) - qGray(m_empty.pixel(x, y))) < 12) continue;
                sum += x;
                ++count;
            }
        }
        return count == 0 ? 0 : sum / count;
    }

    std::unique_ptr<QTemporaryDir> m_directory;
    QImage m_empty;
};

RUBBLE_TEST_WITH(VideoTest, QCoreApplication)
#include "VideoTest.moc"
