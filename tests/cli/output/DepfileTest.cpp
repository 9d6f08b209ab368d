#include "app/cli/output/Depfile.h"

#include "tests/support/TestProgram.h"
#include "tests/support/files/RunProgram.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

using Paths = std::vector<std::string>;

std::string depfile(const Paths& targets, const Paths& prerequisites) {
    const Result<std::string> text = depfileText(targets, prerequisites);
    return text ? *text : "error: " + text.error().message;
}

void writeText(const QString& path, const std::string& text) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(QByteArray::fromStdString(text)) < 0) qFatal("cannot write");
}

// Names that are valid in folders of exports and in most paths.
const Paths kOddNames{"plain", "two words", "a#b", "a$b", "50%", "back\\slash", "both\\ words", "größe"};

/// A folder of its own in which there is an empty file.
QDir folderWith(const QTemporaryDir& place, const std::string& name) {
    const QDir folder(place.filePath(QString::number(qHash(QByteArray::fromStdString(name)))));
    folder.mkpath(".");
    writeText(folder.filePath(QString::fromStdString(name)), "");
    return folder;
}

}  // namespace

class DepfileTest : public QObject {
    Q_OBJECT
private slots:
    void targetsDependOnPrerequisites() {
        QCOMPARE(depfile({"a/manifest.json", "b/manifest.json"}, {"house.rubble"}),
                 "a/manifest.json b/manifest.json: house.rubble\n");
        QCOMPARE(depfile({"a"}, {}), "a:\n");
        QCOMPARE(depfile({}, {"house.rubble"}), "");
    }
    void specialLettersAreEscaped() {
        QCOMPARE(depfile({"two words"}, {"c:/a#b$c.rubble"}), "two\\ words: c\\:/a\\#b$$c.rubble\n");
        QCOMPARE(depfile({"a\\b"}, {"a\\ b"}), "a\\b: a\\\\\\ b\n");
    }
    void pathsOfSeveralLinesAreRefused() {
        QCOMPARE(depfile({"a\nb"}, {}),
                 "error: A dependency file cannot name \"a\\u000ab\", which has a line feed or a tab.");
    }
    /// Make rebuilds a file with an odd name if and only if its prerequisite is newer.
    void makeReadsOddNames() {
        if (QStandardPaths::findExecutable("make").isEmpty()) QSKIP("make is not installed");
        const QTemporaryDir place;
        for (const std::string& name : kOddNames) {
            const std::string source = name + ".rubble";
            const QDir folder = folderWith(place, source);
            // The recipe runs, which says that the prerequisite is known and exists.
            writeText(folder.filePath("Makefile"), "include packs.d\nout:\n\t@echo built $(words $^)\n");
            writeText(folder.filePath("packs.d"), depfile({"out"}, {source}));
            const ProgramOutcome made = runProgram("make", {"-C", folder.path(), "--no-print-directory", "out"});
            QVERIFY2(made.exit == 0, qPrintable(QString::fromStdString(name) + ": " + made.error));
            QVERIFY2(made.output.startsWith("built "), qPrintable(made.output));
            QVERIFY(QFile::remove(folder.filePath(QString::fromStdString(source))));
            const ProgramOutcome missing = runProgram("make", {"-C", folder.path(), "out"});
            QVERIFY2(missing.error.contains("No rule to make target"), qPrintable(missing.error));
        }
    }
    /// Ninja builds again after the file with an odd name was touched, and only then.
    void ninjaReadsOddNames() {
        if (QStandardPaths::findExecutable("ninja").isEmpty()) QSKIP("ninja is not installed");
        const QTemporaryDir place;
        for (const std::string& name : kOddNames) {
            const std::string source = name + ".rubble";
            const QDir folder = folderWith(place, source);
            writeText(folder.filePath("ready.d"), depfile({"out"}, {source}));
            writeText(folder.filePath("build.ninja"),
                      "rule r\n  command = cp ready.d packs.d && touch out\n"
                      "  depfile = packs.d\nbuild out: r\n");
            const auto ninja = [&folder] { return runProgram("ninja", {"-C", folder.path(), "out"}).output; };
            QVERIFY(ninja().contains("[1/1]"));
            QVERIFY2(ninja().contains("no work to do"), name.c_str());
            QFile file(folder.filePath(QString::fromStdString(source)));
            QVERIFY(file.open(QIODevice::ReadWrite));
            QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(60), QFileDevice::FileModificationTime));
            file.close();
            QVERIFY2(ninja().contains("[1/1]"), name.c_str());
        }
    }
};

RUBBLE_TEST(DepfileTest)
#include "DepfileTest.moc"
