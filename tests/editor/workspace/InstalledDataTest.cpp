#include "editor/workspace/InstalledData.h"

#include "tests/support/TestProgram.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

using namespace rubble;

class InstalledDataTest : public QObject {
    Q_OBJECT
private slots:
    /// Programs in the build tree use the source tree.
    void examplesLieInTheSourceTree() {
        QCOMPARE(QFileInfo(installedDataFolder()).canonicalFilePath(),
                 QFileInfo(RUBBLE_SOURCE_DIR).canonicalFilePath());
        QCOMPARE(exampleProjects().size(), QDir(RUBBLE_SOURCE_DIR "/projects").entryList({"*.rubble"}).size());
        for (const QString& path : exampleProjects()) QVERIFY2(QFileInfo(path).isFile(), qPrintable(path));
        QVERIFY(exampleProjects().contains(demoProject()));
    }
};

RUBBLE_TEST_WITH(InstalledDataTest, QCoreApplication)
#include "InstalledDataTest.moc"
