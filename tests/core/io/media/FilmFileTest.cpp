#include "core/io/media/FilmFile.h"

#include "core/io/media/PictureSequence.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/Ffmpeg.h"
#include "tests/support/files/FileBytes.h"

#include <QDir>
#include <QTest>

using namespace rubble;

class FilmFileTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_place = std::make_unique<QTemporaryDir>();
        const auto sequence = PictureSequence::create(m_place->filePath("50 % off").toStdString());
        QVERIFY((*sequence)->add("picture").hasValue());
        (*sequence)->keep();
    }

    void filmsAreRecognizedByTheirSuffix() {
        for (const char* name : {"a.mp4", "/b/c.mkv", "d.e.mov", "f.webm"}) QVERIFY(isFilmPath(name));
        for (const char* name : {"a", "mp4", "b.mp4/c", "d.png"}) QVERIFY(!isFilmPath(name));
    }
    void ffmpegEncodesThePictures() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        QVERIFY(findFfmpeg().has_value());
        const Status made = encode();
        QVERIFY2(made.hasValue(), made ? "" : made.error().message.c_str());
        const QList<QByteArray> words = bytesOfFile(film()).split('\n');
        QCOMPARE(words[words.indexOf("-framerate") + 1], QByteArray("23.976"));
        QCOMPARE(words[words.indexOf("-i") + 1], m_place->filePath("50 %% off/frame-%04d.png").toUtf8());
        QVERIFY(words.contains("yuv420p"));  // many players show nothing else
        QCOMPARE(QDir(m_place->path()).entryList(QDir::Files | QDir::Hidden), QStringList{"hit.mp4"});
    }
    void errorOfFfmpegIsReportedAndTheOldFilmStays() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kFails);
        QFile old(film());
        QVERIFY(old.open(QIODevice::WriteOnly));
        old.write("old");
        old.close();
        const Status made = encode();
        QCOMPARE(made.error().code, ErrorCode::Io);
        QCOMPARE(made.error().message,
                 std::string("ffmpeg could not encode the film: Error writing trailer: No space left on device"));
        QCOMPARE(bytesOfFile(film()), QByteArray("old"));
        QCOMPARE(QDir(m_place->path()).entryList(QDir::Files | QDir::Hidden), QStringList{"hit.mp4"});
    }
    void linksBesideTheFilmAreNotFollowed() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        QFile victim(m_place->filePath("victim"));
        QVERIFY(victim.open(QIODevice::WriteOnly));
        victim.write("mine");
        victim.close();
        for (const char* name : {".hit.part.mp4", "hit.mp4"}) QVERIFY(victim.link(m_place->filePath(name)));
        QVERIFY(encode().hasValue());
        QCOMPARE(bytesOfFile(victim.fileName()), QByteArray("mine"));
        QVERIFY(!QFileInfo(film()).isSymLink());
    }
    void missingFfmpegIsAnError() {
        const test::Ffmpeg none;
        QVERIFY(!findFfmpeg());
        const Status made = encode();
        QCOMPARE(made.error().code, ErrorCode::NotFound);
        QCOMPARE(made.error().message, std::string("Encoding a film needs ffmpeg, which is not installed."));
    }
    void encodingCanBeCancelled() {
        const test::Ffmpeg ffmpeg("#!/bin/sh\nsleep 30\n");
        TaskContext task;
        task.cancel.cancel();
        QCOMPARE(encode(task).error().code, ErrorCode::Cancelled);
        QVERIFY(!QFile::exists(film()));
    }

private:
    QString film() const { return m_place->filePath("hit.mp4"); }
    Status encode(const TaskContext& task = {}) {
        return encodeFilm(m_place->filePath("50 % off").toStdString(), 23.976, film().toStdString(), task);
    }
    std::unique_ptr<QTemporaryDir> m_place;
};

RUBBLE_TEST_WITH(FilmFileTest, QCoreApplication)
#include "FilmFileTest.moc"
