#include "core/io/media/VideoFile.h"

#include "core/io/media/PictureSequence.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/Ffmpeg.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/files/FileLimits.h"

#include <QDir>
#include <QTest>

using namespace rubble;

class VideoFileTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_place = std::make_unique<QTemporaryDir>();
        const auto sequence = PictureSequence::create(m_place->filePath("50 % off").toStdString());
        QVERIFY((*sequence)->add("picture").hasValue());
        (*sequence)->keep();
    }

    void videosAreRecognizedByTheirSuffix() {
        for (const char* name : {"a.mp4", "/b/c.mkv", "d.e.mov", "f.webm"}) QVERIFY(isVideoPath(name));
        for (const char* name : {"a", "mp4", "b.mp4/c", "d.png"}) QVERIFY(!isVideoPath(name));
    }
    void ffmpegEncodesThePictures() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        QVERIFY(findFfmpeg().has_value());
        const Status made = encode();
        QVERIFY2(made.hasValue(), made ? "" : made.error().message.c_str());
        const QList<QByteArray> words = bytesOfFile(video()).split('\n');
        QCOMPARE(words[words.indexOf("-framerate") + 1], QByteArray("23.976"));
        QCOMPARE(words[words.indexOf("-i") + 1], m_place->filePath("50 %% off/frame-%04d.png").toUtf8());
        QVERIFY(words.contains("yuv420p"));  // many players show nothing else
        QCOMPARE(QDir(m_place->path()).entryList(QDir::Files | QDir::Hidden), QStringList{"hit.mp4"});
    }
    void errorOfFfmpegIsReportedAndTheOldVideoStays() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kFails);
        QFile old(video());
        QVERIFY(old.open(QIODevice::WriteOnly));
        old.write("old");
        old.close();
        const Status made = encode();
        QCOMPARE(made.error().code, ErrorCode::Io);
        QCOMPARE(made.error().message,
                 std::string("ffmpeg could not encode the video: Error writing trailer: No space left on device"));
        QCOMPARE(bytesOfFile(video()), QByteArray("old"));
        QCOMPARE(QDir(m_place->path()).entryList(QDir::Files | QDir::Hidden), QStringList{"hit.mp4"});
    }
    void linkToAVideoStaysOne() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        QVERIFY(QDir(m_place->path()).mkdir("videos"));
        const QString target = m_place->filePath("videos/real.mp4");
        QFile old(target);
        QVERIFY(old.open(QIODevice::WriteOnly) && old.setPermissions(QFile::ReadOwner | QFile::WriteOwner));
        QVERIFY(QFile::link(target, video()));
        QVERIFY(encode().hasValue());
        QVERIFY(QFileInfo(video()).isSymLink() && bytesOfFile(target).contains("yuv420p"));
        QCOMPARE(QFile::permissions(target) & (QFile::ReadGroup | QFile::ReadOther), QFile::Permissions());
        QCOMPARE(
            QDir(m_place->filePath("videos")).entryList(QDir::Files | QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot),
            QStringList{"real.mp4"});
    }
    void protectedVideoIsNotReplaced() {
        QVERIFY(checkVideoReplaceable(video().toStdString()));
        QFile old(video());
        QVERIFY(old.open(QIODevice::WriteOnly) && old.setPermissions(QFile::ReadOwner));
        QFile::setPermissions(m_place->path(), QFile::Permissions(0x7777));
        const AsNobody nobody;
        QCOMPARE(checkVideoReplaceable(video().toStdString()).error().message,
                 "Cannot write \"" + video().toStdString() + "\": Permission denied.");
    }
    void deletedCurrentFolderIsAnError() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        const QString before = QDir::currentPath();
        const QString gone = m_place->filePath("gone");
        QVERIFY(QDir(m_place->path()).mkdir("gone") && QDir::setCurrent(gone) && QDir(m_place->path()).rmdir("gone"));
        const Status made = encodeVideo(m_place->filePath("50 % off").toStdString(), 24.0, "video.mp4");
        QVERIFY(QDir::setCurrent(before));
        QCOMPARE(made.error().message, std::string("Cannot write \"video.mp4\": No such file or directory."));
    }
    void linksBesideTheVideoAreNotFollowed() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        QFile victim(m_place->filePath("victim"));
        QVERIFY(victim.open(QIODevice::WriteOnly));
        victim.write("mine");
        victim.close();
        QVERIFY(victim.link(m_place->filePath(".hit.part.mp4")));
        QVERIFY(encode().hasValue());
        QCOMPARE(bytesOfFile(victim.fileName()), QByteArray("mine"));
    }
    void missingFfmpegIsAnError() {
        const test::Ffmpeg none;
        QVERIFY(!findFfmpeg());
        const Status made = encode();
        QCOMPARE(made.error().code, ErrorCode::NotFound);
        QCOMPARE(made.error().message, std::string("Encoding a video needs ffmpeg, which is not installed."));
    }
    void encodingCanBeCancelled() {
        const test::Ffmpeg ffmpeg("#!/bin/sh\nsleep 30\n");
        TaskContext task;
        task.cancel.cancel();
        QCOMPARE(encode(task).error().code, ErrorCode::Cancelled);
        QVERIFY(!QFile::exists(video()));
    }

private:
    QString video() const { return m_place->filePath("hit.mp4"); }
    Status encode(const TaskContext& task = {}) {
        return encodeVideo(m_place->filePath("50 % off").toStdString(), 23.976, video().toStdString(), task);
    }
    std::unique_ptr<QTemporaryDir> m_place;
};

RUBBLE_TEST_WITH(VideoFileTest, QCoreApplication)
#include "VideoFileTest.moc"
