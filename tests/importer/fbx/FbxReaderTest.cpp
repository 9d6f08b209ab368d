#include "core/io/mesh/MeshImport.h"
#include "tests/support/TestProgram.h"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <fstream>

using namespace rubble;

namespace {

QString messageOf(const std::string& bytes) {
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("wall.fbx").toStdString();
    std::ofstream(file, std::ios::binary) << bytes;
    const Result<SourceScene> scene = importMesh(file, RUBBLE_IMPORTER, {});
    return scene ? "read" : QString::fromStdString(scene.error().message);
}

}  // namespace

class FbxReaderTest : public QObject {
    Q_OBJECT
private slots:
    void oldFbxIsRejectedWithItsVersion() {
        QCOMPARE(
            messageOf("; FBX 6.1.0 project file\nFBXHeaderExtension:  {\n\tFBXVersion: 6100\n}\n"),
            "\"wall.fbx\" has a version of FBX before 7.1 (FBX 2011); export it as FBX 2013 or later, or as glTF.");
    }
    void otherContentIsRejectedWithTheReasonOfTheLibrary() {
        const QString message = messageOf("nothing of the kind");
        QVERIFY2(message.startsWith("\"wall.fbx\" cannot be read as FBX: ") && message.endsWith('.'),
                 qPrintable(message));
    }
};

RUBBLE_TEST(FbxReaderTest)
#include "FbxReaderTest.moc"
