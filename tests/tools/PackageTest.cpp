// Tests the Debian package.
#include "tests/support/TestProgram.h"
#include "tests/support/files/RunProgram.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

class PackageTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const ProgramOutcome packed =
            runProgram("cpack", {"--config", RUBBLE_BINARY_DIR "/CPackConfig.cmake", "-D",
                                 "CPACK_DEBIAN_COMPRESSION_TYPE=gzip", "-B", m_folder.path()});
        QVERIFY2(packed.exit == 0, qPrintable(packed.output + packed.error));
        const QStringList packages = QDir(m_folder.path()).entryList({"rubble_" RUBBLE_VERSION "_*.deb"});
        QCOMPARE(packages.size(), 1);
        m_package = m_folder.filePath(packages.first());
    }

    void packageHasADescription() {
        QCOMPARE(field("Package"), QString("rubble"));
        QCOMPARE(field("Version"), QString(RUBBLE_VERSION));
        QCOMPARE(field("Section"), QString("graphics"));
        QVERIFY(field("Maintainer").contains('@'));
        const QStringList description = field("Description").split('\n');
        QCOMPARE(description.first(), QString("editor of destructible assets"));
        QVERIFY(description.size() > 3);
        for (const QString& line : description.mid(1)) {  // two spaces would prevent reflowing
            QVERIFY2(line.startsWith(' ') && !line.startsWith("  ") && line.size() <= 80, qPrintable(line));
        }
    }
    void packageDependsOnTheLibrariesOfItsPrograms() {
        const QString depends = field("Depends");
        for (const char* library : {"libassimp5", "libc6", "libdraco7", "libqt6svg6", "libstdc++6"}) {
            QVERIFY2(depends.contains(library), qPrintable(depends));
        }
    }
    void filesAreOwnedByRootBelowUsr() {
        const QString content = runProgram("dpkg-deb", {"--contents", m_package}).output;
        QVERIFY(content.contains("./usr/bin/rubble-cli\n"));
        for (const QString& line : content.split('\n', Qt::SkipEmptyParts)) {
            QVERIFY2(line.contains(" root/root ") && line.contains(" ./usr/"), qPrintable(line));
        }
    }
    void programsRunWhereUnpacked() {
        const ProgramOutcome tried = runProgram(RUBBLE_SOURCE_DIR "/tools/package", {"--unpack", m_package});
        QVERIFY2(tried.exit == 0, qPrintable(tried.output + tried.error));
    }

private:
    QString field(const char* name) const {
        return runProgram("dpkg-deb", {"--field", m_package, name}).output.trimmed();
    }

    const QTemporaryDir m_folder;
    QString m_package;
};

RUBBLE_TEST_WITH(PackageTest, QCoreApplication)
#include "PackageTest.moc"
