// Tests app/cli/options/CommandTree.cpp and ShellCompletion.cpp in the shells.
#include "app/cli/options/ShellCompletion.h"

#include "tests/support/TestProgram.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/files/RunProgram.h"

#include <QDir>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

const QStringList kShells{"bash", "zsh", "fish"};

QString scriptOf(const QString& shell) { return runProgram(RUBBLE_CLI, {"completion", shell}).output; }

/// What bash offers for the last of some words, in a folder with "packs/" and "house.rubble".
QStringList offeredByBash(const QStringList& words) {
    const QTemporaryDir place;
    QDir(place.path()).mkpath("packs");
    QFile(place.filePath("house.rubble")).open(QIODevice::WriteOnly);
    QString line = "source <(" RUBBLE_CLI " completion bash); cd '" + place.path() + "'; COMP_WORDS=(";
    for (const QString& word : words) line += " '" + word + "'";
    line += "); COMP_CWORD=" + QString::number(words.size() - 1) + "; _rubble_cli; printf '%s\\n' \"${COMPREPLY[@]}\"";
    const ProgramOutcome outcome = runProgram("bash", {"--norc", "-c", line});
    return outcome.exit == 0 && outcome.error.isEmpty() ? outcome.output.split('\n', Qt::SkipEmptyParts)
                                                        : QStringList{"failed: " + outcome.error};
}

/// The names of verbs in --help, or of the options of a verb.
QStringList namesIn(const QStringList& command, const char* pattern) {
    QStringList names;
    const QString help = runProgram(RUBBLE_CLI, command + QStringList{"--help"}).output;
    QRegularExpressionMatchIterator found =
        QRegularExpression(pattern, QRegularExpression::MultilineOption).globalMatch(help.section("\n\nResults", 0, 0));
    while (found.hasNext()) names.append(found.next().captured(1));
    return names;
}

}  // namespace

class CompletionTest : public QObject {
    Q_OBJECT
private slots:
    void bashCompletes_data() {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QStringList>("offered");
        const auto row = [](const QStringList& words, const QStringList& offered) {
            QTest::newRow(qPrintable(words.join(' '))) << words << offered;
        };
        row({"rubble-cli", "exp"}, {"export"});
        row({"rubble-cli", "re"}, {"render", "replay"});
        row({"rubble-cli", "--v"}, {"--version"});
        row({"rubble-cli", "comp"}, {});  // it is hidden
        row({"rubble-cli", "help", "exp"}, {"export"});
        row({"rubble-cli", "export", "--dr"}, {"--dry-run"});
        row({"rubble-cli", "export", "house.rubble", "--format", ""}, {"obj", "glb", "both", "none"});
        row({"rubble-cli", "export", "--format", "=", "g"}, {"glb"});
        row({"rubble-cli", "export", "--format", "="}, {"obj", "glb", "both", "none"});
        row({"rubble-cli", "export", "-o", "p"}, {"packs"});
        row({"rubble-cli", "export", "-o", "h"}, {});  // it is a file
        row({"rubble-cli", "query", "house.rubble", "wo"}, {"would-fall"});
        row({"rubble-cli", "check", "ho"}, {});  // left to the shell, which knows files
        row({"rubble-cli", "unknown", "--"}, {});
    }
    void bashCompletes() {
        QFETCH(const QStringList, words);
        QFETCH(const QStringList, offered);
        QCOMPARE(offeredByBash(words), offered);
    }
    void bashKnowsEveryVerbAndOption() {
        const QStringList verbs = namesIn({}, "^  ([a-z]+)[, ]");
        QVERIFY(verbs.size() > 15);
        for (const QString& verb : verbs) {
            QVERIFY2(offeredByBash({"rubble-cli", verb}).contains(verb), qPrintable(verb));
            const QStringList offered = offeredByBash({"rubble-cli", verb, "--"});
            for (const QString& option : namesIn({verb}, "^  (?:-[a-z],)?(--[a-z-]+)"))
                QVERIFY2(offered.contains(option), qPrintable(verb + ' ' + option));
        }
    }
    void everyScriptNamesEveryOption() {
        for (const QString& shell : kShells) {
            const QString script = scriptOf(shell);
            for (const QString& verb : namesIn({}, "^  ([a-z]+)[, ]")) {
                for (const QString& option : namesIn({verb}, "^  (?:-[a-z],)?(--[a-z-]+)")) {
                    const QString name = shell == "fish" ? " -l " + option.mid(2) + ' ' : option;
                    QVERIFY2(script.contains(name), qPrintable(shell + ' ' + verb + ' ' + option));
                }
            }
        }
    }
    void scriptsAreValid_data() {
        QTest::addColumn<QString>("shell");
        for (const QString& shell : kShells) QTest::newRow(qPrintable(shell)) << shell;
    }
    void scriptsAreValid() {
        QFETCH(const QString, shell);
        if (QStandardPaths::findExecutable(shell).isEmpty()) QSKIP(qPrintable(shell + " is not installed"));
        const QTemporaryDir place;
        QFile file(place.filePath("script"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(scriptOf(shell).toUtf8()) > 0);
        file.close();
        const ProgramOutcome read = runProgram(shell, {"-n", file.fileName()});
        QVERIFY2(read.exit == 0 && read.error.isEmpty(), qPrintable(read.error));
    }
    void fishCompletes() {
        if (QStandardPaths::findExecutable("fish").isEmpty()) QSKIP("fish is not installed");
        const auto offered = [](const QString& line) {
            const QString script = RUBBLE_CLI " completion fish | source; complete -C '" + line + "'";
            return runProgram("fish", {"--no-config", "-c", script}).output;
        };
        QVERIFY(offered("rubble-cli exp").startsWith("export\t"));
        QVERIFY(offered("rubble-cli export --dr").startsWith("--dry-run\t"));
        QVERIFY(offered("rubble-cli export --format g").startsWith("glb\t"));
    }
    void quotesInDescriptionsAreEscaped() {
        const CommandTreeOption option{.names = {"-t", "--test"},
                                       .description = "It's a [test]: one",
                                       .value = ValueKind::Words,
                                       .words = {"a", "b"}};
        const std::vector<CommandTreeVerb> verbs{
            {.name = "verb", .description = "It's", .options = {option}, .arguments = {}}};
        const std::string zsh = zshCompletion(verbs), fish = fishCompletion(verbs);
        QVERIFY2(zsh.find(R"([It'\''s a \[test\]\: one]:value:(a b)')") != std::string::npos, zsh.c_str());
        QVERIFY2(zsh.find(R"('verb:It'\''s')") != std::string::npos, zsh.c_str());
        QVERIFY2(fish.find(R"(-s t -l test -x -a 'a b' -d 'It\'s a [test]: one')") != std::string::npos, fish.c_str());
    }
};

RUBBLE_TEST(CompletionTest)
#include "CompletionTest.moc"
