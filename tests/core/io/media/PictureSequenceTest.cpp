#include "core/io/media/PictureSequence.h"

#include "tests/support/TestProgram.h"
#include "tests/support/files/FileLimits.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

QStringList filesIn(const QString& folder) { return QDir(folder).entryList(QDir::Files | QDir::Hidden, QDir::Name); }

}  // namespace

class PictureSequenceTest : public QObject {
    Q_OBJECT
private slots:
    void init() { m_place = std::make_unique<QTemporaryDir>(); }

    void picturesAreNumberedAndKept() {
        {
            const auto sequence = PictureSequence::create(folder().toStdString());
            for (const char* bytes : {"a", "b"}) QVERIFY((*sequence)->add(bytes).hasValue());
            QCOMPARE((*sequence)->count(), 2);
            (*sequence)->keep();
        }
        QCOMPARE(filesIn(folder()), (QStringList{"frame-0000.png", "frame-0001.png"}));
    }
    void unkeptPicturesAreRemovedWithTheirFolders() {
        {
            const auto sequence = PictureSequence::create(folder().toStdString());
            QVERIFY((*sequence)->add("a").hasValue());
        }
        QVERIFY(QDir(m_place->path()).isEmpty());
    }
    void existingFilesStay() {
        QVERIFY(QDir().mkpath(folder()));
        QFile other(folder() + "/notes.txt");
        QVERIFY(other.open(QIODevice::WriteOnly));
        other.close();
        {
            const auto sequence = PictureSequence::create(folder().toStdString());
            QVERIFY((*sequence)->add("a").hasValue());
        }
        QCOMPARE(filesIn(folder()), QStringList{"notes.txt"});
    }
    void folderWithAVideoIsRejected() {
        auto first = PictureSequence::create(folder().toStdString());
        QVERIFY((*first)->add("a").hasValue());
        (*first)->keep();
        first->reset();
        const auto second = PictureSequence::create(folder().toStdString());
        QCOMPARE(second.error().code, ErrorCode::BadInput);
        QCOMPARE(QString::fromStdString(second.error().message),
                 '"' + folder() +
                     "\" already contains a video: frame-0000.png. Choose another folder, or remove its pictures.");
    }
    void folderOfARunningVideoIsRejected() {
        const auto first = PictureSequence::create(folder().toStdString());
        QVERIFY(first.hasValue());
        const auto second = PictureSequence::create(folder().toStdString());
        QCOMPARE(second.error().code, ErrorCode::BadInput);
        QCOMPARE(QString::fromStdString(second.error().message),
                 "Another video is being written to \"" + folder() + "\". Choose another folder, or wait.");
        QVERIFY((*first)->add("a").hasValue());
    }
    void folderThatCannotBeCreatedIsAnError() {
        QFile::setPermissions(m_place->path(), QFile::ReadOwner | QFile::ExeOwner | QFile::ReadOther | QFile::ExeOther);
        const AsNobody nobody;
        const auto sequence = PictureSequence::create(folder().toStdString());
        QCOMPARE(sequence.error().code, ErrorCode::Io);
        QVERIFY(sequence.error().message.ends_with("Permission denied."));
    }
    void fullDiskLeavesNoFiles() {
        {
            const FileSizeLimit full(3);
            const auto sequence = PictureSequence::create(folder().toStdString());
            QVERIFY((*sequence)->add("abc").hasValue());
            QCOMPARE((*sequence)->add("abcdef").error().code, ErrorCode::Io);
        }
        QVERIFY(QDir(m_place->path()).isEmpty());
    }

private:
    QString folder() const { return m_place->filePath("videos/one"); }
    std::unique_ptr<QTemporaryDir> m_place;
};

RUBBLE_TEST_WITH(PictureSequenceTest, QCoreApplication)
#include "PictureSequenceTest.moc"
