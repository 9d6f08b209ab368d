#include "core/io/system/ProgramFolder.h"
#include "tests/support/TestProgram.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QTest>

#include <fstream>

using namespace rubble;

class ProgramFolderTest : public QObject {
    Q_OBJECT
private slots:
    void runningProgramIsFound() {
        const std::filesystem::path folder = programFolder();
        QVERIFY(folder.is_absolute());
        QVERIFY(std::filesystem::exists(folder / "test_core_io"));
    }
    void pathOfTheKernelReplacesProc() {
        QTemporaryDir temporary;
        const std::filesystem::path folder = std::filesystem::canonical(temporary.path().toStdString());
        std::filesystem::create_directory(folder / "bin");
        std::ofstream(folder / "bin/program") << "";
        std::filesystem::create_symlink("bin/program", folder / "alias");
        QVERIFY(folderOfProgram(folder / "none", folder / "bin/program") == folder / "bin");
        QVERIFY(folderOfProgram(folder / "none", folder / "alias") == folder / "bin");
    }
    void unknownProgramHasNoFolder() {
        QVERIFY(folderOfProgram("/nowhere/exe", "no-such-program").empty());
        QVERIFY(folderOfProgram("/nowhere/exe", "").empty());
    }
};

RUBBLE_TEST(ProgramFolderTest)
#include "ProgramFolderTest.moc"
