// Tests app/importer/files/Sandbox.cpp by a program that enters the sandbox and attempts what is forbidden.
#include "core/io/system/ChildProcess.h"
#include "tests/support/TestProgram.h"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <fstream>

using namespace rubble;

namespace {

constexpr int kPrevented = 0;
constexpr int kDone = 1;
constexpr int kNotSupported = 3;

/// The folder of a mesh beside a file that does not belong to it.
class MeshFolder {
public:
    MeshFolder() {
        std::filesystem::create_directory(path());
        std::ofstream(path() / "inside") << "inside";
        std::ofstream(path() / "../outside") << "outside";
        std::filesystem::create_symlink("../outside", path() / "link");
    }
    std::filesystem::path path() const { return m_root.filePath("mesh").toStdString(); }

private:
    QTemporaryDir m_root;
};

}  // namespace

class SandboxTest : public QObject {
    Q_OBJECT
private slots:
    void forbiddenCallsFail_data() {
        QTest::addColumn<int>("exit");
        for (const char* attempt : {"read-password-file",
                                    "read-above",
                                    "read-through-link",
                                    "read-environment",
                                    "list-folder",
                                    "write-new",
                                    "write-old",
                                    "write-elsewhere",
                                    "write-nameless",
                                    "write-through-openat2",
                                    "truncate",
                                    "truncate-through-openat2",
                                    "delete",
                                    "rename",
                                    "make-folder",
                                    "make-link",
                                    "change-mode",
                                    "connect-internet",
                                    "connect-local",
                                    "fork",
                                    "clone",
                                    "execute",
                                    "trace-parent",
                                    "read-parent",
                                    "signal-parent",
                                    "signal-parent-thread",
                                    "map-code",
                                    "make-executable",
                                    "memory-file",
                                    "io-uring",
                                    "change-folder"})
            QTest::newRow(attempt) << kPrevented;
        for (const char* needed : {"read-inside", "allocate"}) QTest::newRow(needed) << kDone;
    }
    void forbiddenCallsFail() {
        QFETCH(const int, exit);
        const MeshFolder folder;
        const Result<ChildResult> outcome =
            runChild(RUBBLE_IMPORTER_ATTEMPTS, {folder.path().string(), QTest::currentDataTag()}, {}, {});
        QVERIFY(outcome.hasValue() && outcome->exit == ChildExit::Exited);
        if (outcome->exitCode == kNotSupported) QSKIP(outcome->output.c_str());
        QVERIFY2(outcome->exitCode == exit, outcome->output.c_str());
        QCOMPARE(std::filesystem::file_size(folder.path() / "inside"), std::uintmax_t{6});
        QVERIFY(!std::filesystem::exists(folder.path() / "new"));
    }
    void importerTellsItsSandbox() {
        const Result<ChildResult> outcome = runChild(RUBBLE_IMPORTER, {"--sandbox"}, {}, {});
        QCOMPARE(outcome->exitCode, 0);
        qInfo("%s", outcome->output.c_str());
        QVERIFY(outcome->output.starts_with("seccomp: "));
        QVERIFY(outcome->output.find("\nLandlock: ") != std::string::npos);
    }
};

RUBBLE_TEST(SandboxTest)
#include "SandboxTest.moc"
