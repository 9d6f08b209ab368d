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
    process.waitForFinished(60000);
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

const QString kTools = RUBBLE_SOURCE_DIR "/tools/";

bool writeFile(const QString& path, const QByteArray& text) {
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() &&
           file.setPermissions(file.permissions() | QFile::ExeOwner);
}

/// A search path on which dpkg-query knows every package but one, and apt-get only says how it was called, by root.
bool makeDebian(const QString& place, const QByteArray& missing) {
    const QByteArray query = "#!/bin/sh\n[ \"$3\" = '" + missing + "' ] || printf installed\n";
    return writeFile(place + "/dpkg-query", query) && writeFile(place + "/id", "#!/bin/sh\necho 0\n") &&
           writeFile(place + "/apt-get", "#!/bin/sh\necho apt-get \"$@\"\n") &&
           QFile::link("/usr/bin/env", place + "/env");
}

/// A room `core/base` that includes what is given, and one `core/geometry` that may use it.
bool makeRooms(const QString& place, const QByteArray& baseInclude) {
    return writeFile(place + "/arrows.txt", "core/base: core/base\ncore/geometry: core/geometry core/base\n") &&
           writeFile(place + "/core/base/Base.h", "#include " + baseInclude + "\n") &&
           writeFile(place + "/core/geometry/Geometry.cpp", "#include \"core/base/Base.h\"\n#include <vector>\n");
}

Outcome checkArrows(const QString& place) {
    return run("cmake", {"-DROOT=" + place, "-DARROWS=" + place + "/arrows.txt", "-P",
                         RUBBLE_SOURCE_DIR "/cmake/CheckArrows.cmake"});
}

}  // namespace

class ScriptsTest : public QObject {
    Q_OBJECT
private slots:
    void setupSaysWhatIsNeededOnASystemItDoesNotKnow() {
        const Outcome outcome = run("/bin/bash", {kTools + "setup"}, "/nowhere");
        QCOMPARE(outcome.exit, 1);
        QVERIFY(outcome.err.startsWith("tools/setup: installs packages on Debian 12 and its relatives only"));
        QVERIFY(outcome.err.contains("nlohmann-json3-dev"));
        QCOMPARE(outcome.err.count('\n'), 1);
    }
    void setupDoesNothingWhereAllIsThere() {
        const QTemporaryDir place;
        QVERIFY(makeDebian(place.path(), ""));
        const Outcome outcome = run("/bin/bash", {kTools + "setup", "all"}, place.path());
        QCOMPARE(outcome.err + outcome.out, QString());
        QCOMPARE(outcome.exit, 0);
    }
    void setupInstallsWhatIsMissingAndNothingElse() {
        const QTemporaryDir place;
        QVERIFY(makeDebian(place.path(), "libglm-dev"));
        const Outcome outcome = run("/bin/bash", {kTools + "setup"}, place.path());
        QVERIFY(outcome.err.startsWith("Installing 1 Debian packages: libglm-dev\n"));
        QVERIFY(outcome.err.endsWith("apt-get -y -qq -o Dpkg::Use-Pty=0 install --no-install-recommends libglm-dev\n"));
        QCOMPARE(outcome.exit, 0);
    }
    void setupRefusesAGroupItDoesNotKnow() {
        const Outcome outcome = run(kTools + "setup", {"everything"});
        QCOMPARE(outcome.err, QString("tools/setup: 'everything' is none of build, test, package, coverage, all.\n"));
        QCOMPARE(outcome.exit, 1);
    }

    void arrowsAllowWhatARoomMayUse() {
        const QTemporaryDir place;
        QVERIFY(makeRooms(place.path(), "<string>"));
        QCOMPARE(checkArrows(place.path()).exit, 0);
    }
    void arrowsRefuseAnIncludeUpwards() {
        const QTemporaryDir place;
        QVERIFY(makeRooms(place.path(), "\"core/geometry/Polygon.h\""));
        const Outcome outcome = checkArrows(place.path());
        QVERIFY(outcome.exit != 0);
        QVERIFY(outcome.err.contains("core/base/Base.h: core/base may not use core/geometry"));
    }
    void arrowsRefuseQtInTheCore() {
        const QTemporaryDir place;
        QVERIFY(makeRooms(place.path(), "<QString>"));
        const Outcome outcome = checkArrows(place.path());
        QVERIFY(outcome.exit != 0);
        QVERIFY(outcome.err.contains("core/base/Base.h: core/base may not use Qt"));
    }
};

QTEST_GUILESS_MAIN(ScriptsTest)
#include "ScriptsTest.moc"
