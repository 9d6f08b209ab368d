#include "editor/workspace/RecentFiles.h"

#include "editor/document/FilePath.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/TestSettings.h"

#include <QDir>
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <fstream>

using namespace rubble;

class RecentFilesTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        test::keepSettingsIn(m_folder->path());
        QSettings().clear();
    }

    void everyFileNameIsKept() {
        const QStringList paths = {created("h\xff.rubble"), created(std::string(248, 'x') + ".rubble")};
        for (const qsizetype count : {1, 2}) {  // lists of one are stored in another way
            RecentFiles files;
            files.add(paths[count - 1]);
            QCOMPARE(files.paths().size(), count);
            QCOMPARE(storedPaths(), files.paths());
        }
        QCOMPARE(storedPaths(), (QStringList{paths[1], paths[0]}));
        for (const QString& path : paths) std::filesystem::remove(toPath(path));  // QTemporaryDir cannot
        QVERIFY(RecentFiles().paths().isEmpty());
    }

private:
    QString created(const std::string& name) const {
        const std::filesystem::path path = toPath(m_folder->path()) / name;
        std::ofstream(path) << "x";
        return fromPath(path);
    }

    /// The paths as another run of the program reads them: not from Qt's memory, but from a copy of the file.
    QStringList storedPaths() const {
        QSettings().sync();
        const QTemporaryDir other;
        const QString name = QDir(m_folder->path()).relativeFilePath(QSettings().fileName());
        if (!QDir(other.path()).mkpath(QFileInfo(name).path())) return {};
        if (!QFile::copy(QSettings().fileName(), other.filePath(name))) return {};
        test::keepSettingsIn(other.path());
        const QStringList paths = RecentFiles().paths();
        test::keepSettingsIn(m_folder->path());
        return paths;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

RUBBLE_TEST_WITH(RecentFilesTest, QCoreApplication)
#include "RecentFilesTest.moc"
