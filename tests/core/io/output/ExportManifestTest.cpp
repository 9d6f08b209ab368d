#include "core/io/output/ExportManifest.h"

#include "core/io/output/ExportFolder.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"

#include <QTemporaryDir>
#include <QTest>

using namespace rubble;
namespace fs = std::filesystem;

class ExportManifestTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_temporary = std::make_unique<QTemporaryDir>();
        m_pack = fs::path(m_temporary->path().toStdString()) / "wall";
    }
    void manifestIsReadAsItWasWritten() {
        const Manifest manifest{kFirst.hex(), {manifestEntry("a.obj", "v"), manifestEntry("b \"c\".mtl", "")}};
        fs::create_directories(m_pack);
        QVERIFY(writeFileAtomically(m_pack / kManifestName, manifestJson(manifest)));
        const std::optional<Manifest> read = readManifest(m_pack);
        QVERIFY(read);
        QCOMPARE(read->source, manifest.source);
        QVERIFY(read->files == manifest.files);
    }
    void entryHasSizeAndHashOfTheBytes() {
        const ManifestEntry entry = manifestEntry("a.obj", "v 0 0 0\n");
        QCOMPARE(entry.size, std::uint64_t{8});
        QCOMPARE(entry.hash, contentHash("v 0 0 0\n").hex());
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        QVERIFY(manifestEntryOfFile(m_pack, "wall.obj").value() == manifestEntry("wall.obj", "v 0 0 0\n"));
        QCOMPARE(manifestEntryOfFile(m_pack, "gone.obj").error().code, ErrorCode::NotFound);
    }
    void otherVersionsAreNotRead() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        std::string manifest = *readFile(m_pack / kManifestName);
        manifest.replace(manifest.find("\"version\": 1"), 12, "\"version\": 2");
        QVERIFY(writeFileAtomically(m_pack / kManifestName, manifest));
        QVERIFY(!readManifest(m_pack));
    }
    void namesInTheManifestStayInTheFolder() {
        QVERIFY(writeExportFolder(m_pack, kFirst, kFiles));
        std::string manifest = *readFile(m_pack / kManifestName);
        manifest.replace(manifest.find("wall.obj"), 8, "../a.obj");
        QVERIFY(writeFileAtomically(m_pack / kManifestName, manifest));
        QVERIFY(!readManifest(m_pack));
    }

private:
    const ContentHash kFirst = contentHash("first");
    const std::vector<ExportFile> kFiles = {{"wall.obj", "v 0 0 0\n"}, {"wall.mtl", "newmtl a\n"}};
    std::unique_ptr<QTemporaryDir> m_temporary;
    fs::path m_pack;
};

RUBBLE_TEST(ExportManifestTest)
#include "ExportManifestTest.moc"
