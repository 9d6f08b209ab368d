// Tests app/importer/MeshFile.cpp: what it reports about files that it rejects.
#include "core/base/Utf8.h"
#include "core/io/mesh/MeshImport.h"
#include "tests/support/TestProgram.h"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <fstream>

using namespace rubble;

namespace {

QString messageOf(const char* name, const std::string& bytes) {
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath(name).toStdString();
    std::ofstream(file, std::ios::binary) << bytes;
    const Result<SourceScene> scene = importMesh(file, RUBBLE_IMPORTER, {});
    return scene ? "read" : QString::fromStdString(scene.error().message);
}

std::string gltfWithBuffer(const std::string& name) {
    return R"({"asset":{"version":"2.0"},"buffers":[{"uri":")" + name + R"(","byteLength":36}],
        "bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,
        "type":"VEC3"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],
        "scenes":[{"nodes":[0]}],"scene":0})";
}

}  // namespace

class MeshFileTest : public QObject {
    Q_OBJECT
private slots:
    void firstVersionOfGltfIsRejected() {
        QCOMPARE(messageOf("wall.gltf", R"({"asset":{"version":"1.0"},"meshes":{"m":{}},"nodes":{}})"),
                 "\"wall.gltf\" has version \"1.0\" of glTF; export it as glTF 2.0.");
        QCOMPARE(messageOf("wall.glb", std::string("glTF\1\0\0\0\x14\0\0\0\0\0\0\0\0\0\0\0", 20)),
                 "\"wall.glb\" has version 1 of GLB; export it as glTF 2.0.");
    }
    void longReasonsAreShortened() {
        const QString message = messageOf("wall.gltf", gltfWithBuffer(std::string(70000, 'a')));
        QVERIFY2(message.size() < 400 && message.contains(QString::fromUtf8("aaa\u2026aaa")), qPrintable(message));
        const QString line = messageOf("wall.obj", "v " + std::string(70000, 'a') + '\n');
        QVERIFY2(line.size() < 400 && line.contains(QString::fromUtf8("aaa\u2026\", has")), qPrintable(line));
    }
    void longNamesOutsideAreShortened() {
        const QString message = messageOf("wall.gltf", gltfWithBuffer("../" + std::string(1000, 'a')));
        QVERIFY2(
            message.contains(QString::fromUtf8("aaa\u2026aaa")) && message.contains(" lies outside its folder; only"),
            qPrintable(message));
        QVERIFY(message.endsWith("are read."));
    }
    void bytesInReasonsAreLatin1() {
        const QString message = messageOf("wall.gltf", gltfWithBuffer("w\xe4nde.bin"));
        QVERIFY2(message.contains(QString::fromUtf8("w\u00e4nde.bin")), qPrintable(message));
    }
};

RUBBLE_TEST(MeshFileTest)
#include "MeshFileTest.moc"
