// Tests the scripts in tools and cmake.
#include "tests/support/TestProgram.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace {

struct Outcome {
    int exit = -1;
    QString out;
    QString err;
};

Outcome run(const QString& program, const QStringList& arguments, const QString& searchPath = qgetenv("PATH")) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", searchPath);
    process.setProcessEnvironment(environment);
    process.start(program, arguments);
    process.waitForFinished(kPatience);
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

const QString kTools = RUBBLE_SOURCE_DIR "/tools/";

bool writeFile(const QString& path, const QByteArray& text) {
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() &&
           file.setPermissions(file.permissions() | QFile::ExeOwner);
}

/// A PATH in which dpkg-query knows all packages but one, and apt-get, run by root, prints its arguments.
bool makeDebian(const QString& place, const QByteArray& missing) {
    const QByteArray query = "#!/bin/sh\n[ \"$3\" = '" + missing + "' ] || printf installed\n";
    return writeFile(place + "/dpkg-query", query) && writeFile(place + "/id", "#!/bin/sh\necho 0\n") &&
           writeFile(place + "/apt-get", "#!/bin/sh\necho apt-get \"$@\"\n") &&
           QFile::link("/usr/bin/env", place + "/env");
}

/// Programs node and npm in that PATH; the latter does this.
bool makeNpm(const QString& place, const QByteArray& command) {
    const auto link = [&](const QString& name) { return QFile::link("/usr/bin/" + name, place + '/' + name); };
    return writeFile(place + "/node", "#!/bin/sh\n") && writeFile(place + "/npm", "#!/bin/sh\n" + command + '\n') &&
           link("cp") && link("rm") && link("mkdir");
}

const QString kLock = RUBBLE_SOURCE_DIR "/tests/exchange/package-lock.json";

/// tools/setup in such a place, where it has its packages of npm as well.
Outcome setup(const QString& group, const QString& place) {
    qputenv("RUBBLE_NPM", place.toUtf8());
    const Outcome outcome = run("/bin/bash", {kTools + "setup", group}, place);
    qunsetenv("RUBBLE_NPM");
    return outcome;
}

/// A module core/base, whose only header includes what is given, and a module core/geometry with the sub-folders hull
/// and mesh, of which mesh may use the other.
bool makeModules(const QString& root, const QByteArray& baseIncludes) {
    return writeFile(root + "/dependencies.txt",
                     "core/base: core/base\n"
                     "core/geometry/hull: core/base core/geometry/hull\n"
                     "core/geometry/mesh: core/base core/geometry/hull core/geometry/mesh\n") &&
           writeFile(root + "/core/base/Base.h", "#include " + baseIncludes + "\n") &&
           writeFile(root + "/core/geometry/hull/Hull.h", "#include <core/base/Base.h>\n") &&
           writeFile(root + "/core/geometry/mesh/Mesh.cpp",
                     "#include \"core/geometry/hull/Hull.h\"\n#include <vector>\n");
}

/// Whether the check fails and says this; its lines are broken anywhere, so white space does not count.
bool isRefused(const QString& root, const QString& message) {
    const Outcome outcome = run("cmake", {"-DROOT=" + root, "-DDEPENDENCIES=" + root + "/dependencies.txt", "-P",
                                          RUBBLE_SOURCE_DIR "/cmake/CheckDependencies.cmake"});
    return outcome.exit != 0 && outcome.err.simplified().contains(message);
}

/// What the check of words prints of a file with this text.
Outcome checkWords(const QByteArray& text) {
    const QTemporaryDir folder;
    if (!writeFile(folder.filePath("Text.md"), text)) return {};
    return run(kTools + "words", {folder.filePath("Text.md")});
}

}  // namespace

class ScriptsTest : public QObject {
    Q_OBJECT
private slots:
    /// The script stops where an edge has not two triangles.
    void sculpturesAreClosed() {
        QTemporaryDir folder;
        for (const char* detail : {"0.4", "0.5"}) {
            const Outcome made = run("python3", {kTools + "sculptures", folder.path(), "--detail", detail});
            QCOMPARE(made.err, QString());
            QCOMPARE(made.exit, 0);
            QCOMPARE(QDir(folder.path()).entryList({"*.obj"}), (QStringList{"column.obj", "head.obj", "vase.obj"}));
        }
    }
    void setupListsPackagesOnAnUnknownSystem() {
        const Outcome outcome = run("/bin/bash", {kTools + "setup"}, "/nowhere");
        QCOMPARE(outcome.exit, 1);
        QVERIFY(outcome.err.startsWith("tools/setup: installs packages on Debian 12 and its relatives only"));
        QVERIFY(outcome.err.contains("nlohmann-json3-dev"));
        QCOMPARE(outcome.err.count('\n'), 1);
    }
    void setupDoesNothingIfAllIsInstalled() {
        const QTemporaryDir place;
        QVERIFY(makeDebian(place.path(), ""));
        QVERIFY(QFile::copy(kLock, place.filePath("installed-all")));
        const Outcome outcome = setup("all", place.path());
        QCOMPARE(outcome.err + outcome.out, QString());
        QCOMPARE(outcome.exit, 0);
    }
    void setupInstallsPackagesOfNpm() {
        const QTemporaryDir place;
        QVERIFY(makeDebian(place.path(), "") && makeNpm(place.path(), "echo npm \"$@\""));
        QVERIFY(setup("test", place.path()).err.contains("--ignore-scripts --omit=optional"));
        QVERIFY(QFile::exists(place.filePath("package.json")));
        QCOMPARE(setup("test", place.path()).err, QString());  // the lock is the same
        const QString all = setup("all", place.path()).err;
        QVERIFY(all.contains("--ignore-scripts") && !all.contains("--omit"));
        QCOMPARE(setup("test", place.path()).err, QString());
    }
    void setupGoesOnWithoutNpm() {
        const QTemporaryDir place;
        QVERIFY(makeDebian(place.path(), ""));
        const Outcome absent = setup("test", place.path());
        QCOMPARE(absent.exit, 0);
        QVERIFY(absent.err.startsWith("tools/setup: node and npm are not there"));
        QVERIFY(makeNpm(place.path(), "exit 1"));
        const Outcome offline = setup("test", place.path());
        QCOMPARE(offline.exit, 0);
        QVERIFY(offline.err.startsWith("tools/setup: npm could not install the packages of tests/exchange"));
        QVERIFY(!QFile::exists(place.filePath("installed-test")));
    }
    void setupInstallsOnlyMissingPackages() {
        const QTemporaryDir place;
        QVERIFY(makeDebian(place.path(), "libglm-dev"));
        const Outcome outcome = run("/bin/bash", {kTools + "setup"}, place.path());
        QVERIFY(outcome.err.startsWith("Installing 1 Debian packages: libglm-dev\n"));
        QVERIFY(outcome.err.endsWith("apt-get -y -qq -o Dpkg::Use-Pty=0 install --no-install-recommends libglm-dev\n"));
        QCOMPARE(outcome.exit, 0);
    }
    void setupRejectsAnUnknownGroup() {
        const Outcome outcome = run(kTools + "setup", {"everything"});
        QCOMPARE(outcome.err, QString("tools/setup: 'everything' is none of build, test, package, coverage, all.\n"));
        QCOMPARE(outcome.exit, 1);
    }

    void includesOfLowerFoldersAreAllowed() {
        const QTemporaryDir root;
        QVERIFY(makeModules(root.path(), "<string>"));
        const Outcome outcome =
            run("cmake", {"-DROOT=" + root.path(), "-DDEPENDENCIES=" + root.path() + "/dependencies.txt", "-P",
                          RUBBLE_SOURCE_DIR "/cmake/CheckDependencies.cmake"});
        QCOMPARE(outcome.err, QString());
        QCOMPARE(outcome.exit, 0);
    }
    void includesOfHigherModulesAreRefused() {
        const QTemporaryDir root;
        QVERIFY(makeModules(root.path(), "\"core/geometry/hull/Hull.h\""));
        QVERIFY(isRefused(root.path(), "core/base/Base.h: core/base may not use core/geometry/hull"));
    }
    void includesInAngleBracketsAreChecked() {
        const QTemporaryDir root;
        QVERIFY(makeModules(root.path(), "<core/geometry/hull/Hull.h>"));
        QVERIFY(isRefused(root.path(), "core/base/Base.h: core/base may not use core/geometry/hull"));
    }
    void includesOfHigherSubFoldersAreRefused() {
        const QTemporaryDir root;
        QVERIFY(makeModules(root.path(), "<string>"));
        QVERIFY(writeFile(root.filePath("core/geometry/hull/Hull.cpp"), "#include \"core/geometry/mesh/Mesh.h\"\n"));
        QVERIFY(
            isRefused(root.path(), "core/geometry/hull/Hull.cpp: core/geometry/hull may not use core/geometry/mesh"));
    }
    void qtIsRefusedInTheCore() {
        const QTemporaryDir root;
        QVERIFY(makeModules(root.path(), "<QString>"));
        QVERIFY(isRefused(root.path(), "core/base/Base.h: core/base may not use Qt"));
    }
    void sourcesBesideSubFoldersAreRefused() {
        const QTemporaryDir root;
        QVERIFY(makeModules(root.path(), "<string>"));
        QVERIFY(writeFile(root.filePath("core/geometry/Ray.h"), "\n"));
        QVERIFY(isRefused(root.path(), "core/geometry/Ray.h: no module has sources in core/geometry"));
    }
    void foldersOfTooManySourcesAreRefused() {
        const QTemporaryDir root;
        QVERIFY(makeModules(root.path(), "<string>"));
        for (int i = 0; i < 40; ++i) QVERIFY(writeFile(root.filePath(QString("core/base/File%1.h").arg(i)), "\n"));
        QVERIFY(isRefused(root.path(), "core/base has more than 40 sources"));
    }
    void typesOfOneNameAreRefused() {
        const QTemporaryDir root;
        QVERIFY(makeModules(root.path(), "<string>"));
        QVERIFY(writeFile(root.filePath("core/geometry/hull/Box.h"), "struct Box {};\n"));
        QVERIFY(writeFile(root.filePath("core/geometry/mesh/Box.h"), "class Box {};\n"));
        QVERIFY(isRefused(root.path(), "both define Box"));
    }

    void retiredTermsAreFoundWithTheirReplacement() {
        // The term is in two parts here, so that it is not found in this file.
        const Outcome outcome = checkWords(QByteArray("Plain words.\nNo asset is at") + " hand.\n");
        QCOMPARE(outcome.exit, 1);
        QVERIFY2(outcome.out.contains("Text.md:2: \"at"
                                      " hand\": write active"),
                 qPrintable(outcome.out));
    }
    void plainTextHasNoRetiredTerms() {
        const Outcome outcome = checkWords("No asset selected. At handover, a handful of seeds. FragmentLookup.\n");
        QCOMPARE(outcome.out + outcome.err, QString());
        QCOMPARE(outcome.exit, 0);
    }
};

RUBBLE_TEST_WITH(ScriptsTest, QCoreApplication)
#include "ScriptsTest.moc"
