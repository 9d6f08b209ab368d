// Tests core/io/output/FileUse.cpp and the options of app/cli/options/Command.cpp that write files.
#include "app/cli/Cli.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/files/RunProgram.h"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <map>

using namespace rubble;

namespace fs = std::filesystem;

namespace {

/// What a verb needs beside the option that writes. PROJECT stands for a project's path, PACKS for a folder.
const std::map<std::string, QStringList> kCalls = {
    {"export", {"PROJECT", "--out", "PACKS"}},
    {"draw", {"PROJECT"}},
    {"render", {"PROJECT"}},
    {"video", {"PROJECT"}},
    {"simulate", {"PROJECT", "--steps", "1"}},
    {"replay", {"REPLAY", "PROJECT"}},
    {"test", {"PROJECT"}},
    {"sheet", {"PROJECT", "--asset", "box"}},
    {"damage", {"write", "--project", "PROJECT", "--state", "STATE", "--instance", "box"}},
};

}  // namespace

/// Every option that writes a file, with everything that it must leave alone.
class WrittenOptionsTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_place;

    fs::path inPlace(const char* name) const { return fs::path(m_place->path().toStdString()) / name; }
    /// The call of a verb with values of options that write.
    ProgramOutcome run(const std::string& verb, const std::vector<std::pair<std::string, fs::path>>& written) const {
        QStringList arguments{QString::fromStdString(verb)};
        for (QString argument : kCalls.at(verb)) {
            for (const auto& [word, file] : {std::pair("PROJECT", "box.rubble"),
                                             {"PACKS", "packs"},
                                             {"REPLAY", "box.replay"},
                                             {"STATE", "box.rubblestate"}})
                if (argument == word) argument = QString::fromStdString(inPlace(file).string());
            arguments.push_back(argument);
        }
        const auto needs = [&](const char* option) { return written.front().first != option; };
        if ((verb == "render" || verb == "sheet") && needs("--out"))
            arguments += {"--out", QString::fromStdString(inPlace("new.png").string())};
        for (const auto& [option, path] : written) {
            if (option.starts_with('-')) arguments.push_back(QString::fromStdString(option));
            arguments.push_back(QString::fromStdString(path.string()));
        }
        if (verb == "video") arguments += {"--steps", "1"};
        return runProgram(RUBBLE_CLI, arguments);
    }
    void expectRefused(const std::string& verb, const std::vector<std::pair<std::string, fs::path>>& written,
                       const fs::path& kept, const char* why) const {
        const std::string before = readFile(kept).value();
        const ProgramOutcome outcome = run(verb, written);
        const std::string what = verb + " " + written.front().first + " " + written.front().second.string() + ": ";
        QVERIFY2(outcome.exit == kExitError, (what + outcome.error.toStdString()).c_str());
        QVERIFY2(outcome.error.contains(why), (what + outcome.error.toStdString()).c_str());
        QVERIFY2(outcome.error.count('\n') == 1, (what + outcome.error.toStdString()).c_str());
        QVERIFY2(readFile(kept).value() == before, what.c_str());
    }

private slots:
    void init() {
        m_place = std::make_unique<QTemporaryDir>();
        Project project = boxProject(UniformScatter{.count = 3});
        QVERIFY(saveProject(inPlace("box.rubble"), project));
        const QString file = QString::fromStdString(inPlace("box.rubble").string());
        QCOMPARE(runProgram(RUBBLE_CLI, {"simulate", file, "--steps", "1", "--record",
                                         QString::fromStdString(inPlace("box.replay").string()), "--save-state",
                                         QString::fromStdString(inPlace("box.rubblestate").string())})
                     .exit,
                 0);
        QCOMPARE(
            runProgram(RUBBLE_CLI, {"export", file, "--out", QString::fromStdString(inPlace("packs").string())}).exit,
            0);
        QVERIFY(writeFileAtomically(inPlace("README.md"), "mine"));
        fs::create_symlink("box.rubble", inPlace("link"));
        fs::create_hard_link(inPlace("box.rubble"), inPlace("hard"));
        fs::create_symlink("README.md", inPlace("link.png"));
    }
    void everyVerbThatWritesIsTried() {
        std::set<std::string> verbs;
        for (const WrittenOption& one : writtenOptions()) verbs.insert(one.verb);
        for (const std::string& verb : verbs) QVERIFY2(kCalls.contains(verb), verb.c_str());
        QVERIFY(writtenOptions().size() >= 12);
    }
    void inputsAreKept() {
        for (const auto& [verb, option] : writtenOptions()) {
            for (const char* name : {"box.rubble", "link", "hard"})
                expectRefused(verb, {{option, inPlace(name)}}, inPlace("box.rubble"), " is read.");
        }
        const QString state = QString::fromStdString(inPlace("box.rubblestate").string());
        const ProgramOutcome outcome =
            runProgram(RUBBLE_CLI, {"simulate", QString::fromStdString(inPlace("box.rubble").string()), "--steps", "1",
                                    "--state", state, "--save-state", state});
        QVERIFY2(outcome.exit == kExitError && outcome.error.contains(" is read."), qPrintable(outcome.error));
    }
    void exportsAreKept() {
        for (const auto& [verb, option] : writtenOptions()) {
            for (const char* name : {"packs/export.json", "packs/box/pack.json", "packs/box/manifest.json"})
                expectRefused(verb, {{option, inPlace(name)}}, inPlace(name), " is a file of an export.");
        }
    }
    void meshesAreKept() {
        const fs::path folder = inPlace("box.rubble.meshes");
        fs::create_directory(folder);
        QVERIFY(writeFileAtomically(folder / "a.png", "mine"));
        for (const auto& [verb, option] : writtenOptions()) {
            expectRefused(verb, {{option, folder / "a.png"}}, folder / "a.png", " lies in the folder of a project's");
            expectRefused(verb, {{option, folder / "b.png"}}, folder / "a.png", " lies in the folder of a project's");
        }
    }
    void foreignFilesAreKept() {
        for (const auto& [verb, option] : writtenOptions()) {
            for (const char* name : {"README.md", "link.png"})
                expectRefused(verb, {{option, inPlace(name)}}, inPlace("README.md"), " exists, and is something else");
        }
    }
    void outputsAreNotTheSame() {
        const std::vector<WrittenOption> options = writtenOptions();
        int tried = 0;
        for (const WrittenOption& one : options) {
            for (const WrittenOption& other : options) {
                if (one.verb != other.verb || one.option == other.option) continue;
                const fs::path path = inPlace("new.file");
                const ProgramOutcome outcome = run(one.verb, {{one.option, path}, {other.option, path}});
                QVERIFY2(outcome.exit == kExitError && outcome.error.contains(" is also written as "),
                         qPrintable(outcome.error));
                QVERIFY(!fs::exists(path));
                ++tried;
            }
        }
        QVERIFY(tried >= 12);
    }
    /// Their own earlier files, pipes and devices are written to.
    void whatIsTheirsIsReplaced() {
        for (int k = 0; k < 2; ++k) QCOMPARE(run("draw", {{"--out", inPlace("box.svg")}}).exit, 0);
        QCOMPARE(run("draw", {{"--out", "/dev/null"}}).exit, 0);
        for (int k = 0; k < 2; ++k) QCOMPARE(run("export", {{"--depfile", inPlace("packs.d")}}).exit, 0);
        QVERIFY(fs::is_regular_file(inPlace("packs.d")));
    }
    void namesOfANewExportAreKept() {
        fs::remove_all(inPlace("packs"));
        for (const char* name : {"packs/export.json", "packs/box/pack.json"}) {
            const ProgramOutcome outcome = run("export", {{"--depfile", inPlace(name)}});
            QVERIFY2(outcome.exit == kExitError, qPrintable(outcome.error));
            QVERIFY2(outcome.error.contains("is a file of this export"), qPrintable(outcome.error));
        }
        QVERIFY(!fs::exists(inPlace("packs")));
    }
};

RUBBLE_TEST(WrittenOptionsTest)
#include "WrittenOptionsTest.moc"
