#include "core/io/media/FilmFile.h"

#include "core/io/media/PictureSequence.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/Ffmpeg.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/files/FileLimits.h"

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
    void linkToAFilmStaysOne() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        QVERIFY(QDir(m_place->path()).mkdir("films"));
        const QString target = m_place->filePath("films/real.mp4");
        QFile old(target);
        QVERIFY(old.open(QIODevice::WriteOnly) && old.setPermissions(QFile::ReadOwner | QFile::WriteOwner));
        QVERIFY(QFile::link(target, film()));
        QVERIFY(encode().hasValue());
        QVERIFY(QFileInfo(film()).isSymLink() && bytesOfFile(target).contains("yuv420p"));
        QCOMPARE(QFile::permissions(target) & (QFile::ReadGroup | QFile::ReadOther), QFile::Permissions());
        QCOMPARE(
            QDir(m_place->filePath("films")).entryList(QDir::Files | QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot),
            QStringList{"real.mp4"});
    }
    void protectedFilmIsNotReplaced() {
        QVERIFY(checkFilmReplaceable(film().toStdString()));
        QFile old(film());
        QVERIFY(old.open(QIODevice::WriteOnly) && old.setPermissions(QFile::ReadOwner));
        QFile::setPermissions(m_place->path(), QFile::Permissions(0x7777));
        const AsNobody nobody;
        QCOMPARE(checkFilmReplaceable(film().toStdString()).error().message,
                 "Cannot write \"" + film().toStdString() + "\": Permission denied.");
    }
    void deletedCurrentFolderIsAnError() {
        const test::Ffmpeg ffmpeg(test::Ffmpeg::kTellsArguments);
        const QString before = QDir::currentPath();
        const QString gone = m_place->filePath("gone");
        QVERIFY(QDir(m_place->path()).mkdir("gone") && QDir::setCurrent(gone) && QDir(m_place->path()).rmdir("gone"));
        const Status made = encodeFilm(m_place->filePath("50 % off").toStdString(), 24.0, "film.mp4");
        QVERIFY(QDir::setCurrent(before));
        QCOMPARE(made.error().message, std::string("Cannot write \"film.mp4\": No such file or directory."));
    }
    void linksBesideTheFilmAreNotFollowed() {
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
