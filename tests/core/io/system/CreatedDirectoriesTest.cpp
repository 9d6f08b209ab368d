#include "core/io/system/CreatedDirectories.h"

#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"

#include <QTemporaryDir>
#include <QTest>

using namespace rubble;
namespace fs = std::filesystem;

class CreatedDirectoriesTest : public QObject {
    Q_OBJECT
private slots:
    void emptyDirectoriesAreRemovedAgain() {
        const QTemporaryDir temporary;
        const fs::path place = temporary.path().toStdString();
        {
            CreatedDirectories created;
            QVERIFY(created.create(place / "a" / "b" / "c"));
            QVERIFY(fs::is_directory(place / "a" / "b" / "c"));
        }
        QVERIFY(!fs::exists(place / "a"));
        QVERIFY(fs::exists(place));
    }
    void directoriesWithFilesStay() {
        const QTemporaryDir temporary;
        const fs::path place = temporary.path().toStdString();
        {
            CreatedDirectories created;
            QVERIFY(created.create(place / "a" / "b"));
            QVERIFY(created.create(place / "a" / "c"));
            QVERIFY(writeFileAtomically(place / "a" / "b" / "file", "kept"));
        }
        QVERIFY(fs::exists(place / "a" / "b" / "file"));
        QVERIFY(!fs::exists(place / "a" / "c"));
    }
    void directoriesThatWereThereStay() {
        const QTemporaryDir temporary;
        const fs::path place = temporary.path().toStdString();
        fs::create_directory(place / "a");
        { QVERIFY(CreatedDirectories().create(place / "a")); }
        QVERIFY(fs::exists(place / "a"));
    }
    void fileInTheWayIsAnError() {
        const QTemporaryDir temporary;
        const fs::path file = fs::path(temporary.path().toStdString()) / "file";
        QVERIFY(writeFileAtomically(file, "kept"));
        CreatedDirectories created;
        for (const fs::path& path : {file, file / "a"}) {
            const Status status = created.create(path);
            QVERIFY(!status && status.error().code == ErrorCode::Io);
            const std::string start = "Cannot create the folder \"" + path.string() + "\": ";
            QVERIFY2(status.error().message.starts_with(start), status.error().message.c_str());
        }
    }
};

RUBBLE_TEST(CreatedDirectoriesTest)
#include "CreatedDirectoriesTest.moc"
