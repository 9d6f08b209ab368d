#include "core/io/output/ExportCheck.h"

#include "core/io/output/ExportFolder.h"
#include "core/io/output/ExportManifest.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"

#include <QTemporaryDir>
#include <QTest>

using namespace rubble;
namespace fs = std::filesystem;

class ExportCheckTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_temporary = std::make_unique<QTemporaryDir>();
        m_pack = fs::path(m_temporary->path().toStdString()) / "wall";
    }
    void unmodifiedExportIsRecognizedByItsSource() {
        QVERIFY(!isExportOf(m_pack, kFirst));
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        QVERIFY(isExportOf(m_pack, kFirst));
        QVERIFY(!isExportOf(m_pack, kSecond));
    }
    void modifiedMissingAndUnreadableFilesAreDetected() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        QVERIFY(writeFileAtomically(m_pack / "wall.obj", "v 0 0 1\n"));
        QVERIFY(!isExportOf(m_pack, kFirst));
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles, EditedFiles::Replaced));
        QVERIFY(isExportOf(m_pack, kFirst));
        fs::remove(m_pack / "wall.mtl");
        QVERIFY(!isExportOf(m_pack, kFirst));
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        fs::resize_file(m_pack / kManifestName, 40);
        QVERIFY(!isExportOf(m_pack, kFirst));
    }
    void errorsOfAnExportAreReported() {
        const auto fault = [&] { return verifyExportFolder(m_pack).value_or(""); };
        const std::string folder = m_pack.string();
        QCOMPARE(fault(), "The folder \"" + folder + "\" has no readable manifest.json.");
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        QCOMPARE(fault(), std::string());
        QVERIFY(writeFileAtomically(m_pack / "notes.txt", "mine"));
        QCOMPARE(fault(), "The folder \"" + folder + "\" contains \"notes.txt\", which is not part of the export.");
        QVERIFY(writeFileAtomically(m_pack / "wall.mtl", "newmtl b\n"));
        QCOMPARE(fault(), "\"" + folder + "/wall.mtl\" was modified after the export.");
        fs::remove(m_pack / "wall.obj");
        QCOMPARE(fault(), "Cannot read \"" + folder + "/wall.obj\": No such file or directory.");
    }
    void filesOfEnginesAreExpected() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        QVERIFY(writeFileAtomically(m_pack / "wall.obj.import", "[remap]"));
        QCOMPARE(findUnexpectedFile(m_pack).value(), std::optional<std::string>());
        fs::create_directory(m_pack / "wall.meta");  // a folder is no file of an engine
        QVERIFY(writeFileAtomically(m_pack / "zebra.txt", "mine"));
        QCOMPARE(findUnexpectedFile(m_pack).value(), std::optional<std::string>("wall.meta"));
    }
    void editedFileIsFoundAndMissingOnesAreNot() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        fs::remove(m_pack / "wall.obj");
        QCOMPARE(findEditedFile(m_pack).value(), std::optional<fs::path>());
        QVERIFY(writeFileAtomically(m_pack / "wall.mtl", "newmtl b\n"));
        QCOMPARE(findEditedFile(m_pack).value(), std::optional(m_pack / "wall.mtl"));
    }
    void linkInPlaceOfAFileIsEdited() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        fs::rename(m_pack / "wall.mtl", m_pack.parent_path() / "elsewhere.mtl");
        fs::create_symlink(m_pack.parent_path() / "elsewhere.mtl", m_pack / "wall.mtl");
        QCOMPARE(findEditedFile(m_pack).value(), std::optional(m_pack / "wall.mtl"));
        QVERIFY(!isExportOf(m_pack, kFirst));
    }

private:
    const ContentHash kFirst = contentHash("first"), kSecond = contentHash("second");
    const std::vector<ExportFile> kFiles = {{"wall.obj", "v 0 0 0\n"}, {"wall.mtl", "newmtl a\n"}};
    std::unique_ptr<QTemporaryDir> m_temporary;
    fs::path m_pack;
};

RUBBLE_TEST(ExportCheckTest)
#include "ExportCheckTest.moc"
