// Tests the base-colour textures of imported meshes: app/importer/files/MeshImages.cpp, core/asset/import,
// core/asset/project/Texture.cpp
// and core/io/project/TextureJson.cpp.
#include "core/asset/checks/VerifyProject.h"
#include "core/asset/import/AssetImport.h"
#include "core/base/limits/ImageLimits.h"
#include "core/io/mesh/MeshImport.h"
#include "core/io/pack/PackMeshes.h"
#include "core/io/project/ProjectDifference.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/text/Base64.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/TexturedMesh.h"

#include <nlohmann/json.hpp>

#include <QTest>

#include <sys/stat.h>

using namespace rubble;

namespace {

ImportOutcome outcomeOf(const std::filesystem::path& file) {
    const Result<SourceScene> scene = importMesh(file, RUBBLE_IMPORTER, {});
    if (!scene) qFatal("%s", scene.error().message.c_str());
    ImportOutcome outcome = importedInto({}, *scene, "wall", {}, {}).value();
    if (const auto fault = verifyProject(outcome.project)) qFatal("%s", fault->c_str());
    return outcome;
}

/// The notes of the first asset, a line each.
QString notesOf(const ImportOutcome& outcome) {
    QStringList notes;
    for (const std::string& note : outcome.assets.at(0).notes) notes.append(QString::fromStdString(note));
    return notes.join('\n');
}

const std::optional<Texture>& textureOf(const ImportOutcome& outcome) { return outcome.project.assets.at(0).texture; }

}  // namespace

class TextureImportTest : public QObject {
    Q_OBJECT
private slots:
    void objMaterialsBringTheirImage() {
        const TexturedMesh mesh("map_Kd -s 1 1 1 -clamp on my checker.png", "map_Kd my checker.png");
        mesh.write("my checker.png", checkerPng());
        const ImportOutcome outcome = outcomeOf(mesh.path());
        QVERIFY(textureOf(outcome).has_value());
        QCOMPARE(textureOf(outcome)->name, std::string("my checker.png"));
        QVERIFY(textureOf(outcome)->image->bytes() == checkerPng());
        QCOMPARE(textureOf(outcome)->materials, (std::vector<std::uint32_t>{0, 1}));
        QVERIFY((outcome.project.materials[0].outside == Colour{1.0, 1.0, 1.0}));  // not the grey of others
        QVERIFY2(notesOf(outcome).contains("It has the base-colour texture \"my checker.png\" (16 × 16)."),
                 qPrintable(notesOf(outcome)));
    }
    void imageIsFoundBesideTheMaterialFileOrTheMesh() {
        for (const char* name : {"sub/a.png", "/home/artist/a.png", "C:\\textures\\a.png", "sub\\a.png"}) {
            const TexturedMesh mesh("map_Kd " + std::string(name));
            mesh.write(std::string(name).starts_with("sub") ? "sub/a.png" : "a.png", checkerPng());
            const ImportOutcome outcome = outcomeOf(mesh.path());
            QVERIFY2(textureOf(outcome).has_value(), name);
            QCOMPARE(textureOf(outcome)->name, std::string("a.png"));
        }
    }
    void imageOfTheLargestAreaIsKept() {
        const TexturedMesh mesh("map_Kd a.png", {}, "map_Kd b.jpg");
        mesh.write("a.png", checkerPng());
        mesh.write("b.jpg", orangeJpeg());
        const ImportOutcome outcome = outcomeOf(mesh.path());
        QCOMPARE(textureOf(outcome)->name, std::string("b.jpg"));
        QCOMPARE(textureOf(outcome)->materials, (std::vector<std::uint32_t>{2}));
        QVERIFY2(notesOf(outcome).contains("It has 2 images; \"b.jpg\" (8 × 8), which covers the largest area, is its "
                                           "base-colour texture."),
                 qPrintable(notesOf(outcome)));
    }
    void gltfImagesAreReadFromFilesDataAndViews() {
        const std::string png = checkerPng();
        const std::pair<std::string, std::string> images[] = {
            {"{\"uri\":\"my%20brick.png\"}", ""},
            {"{\"name\":\"brick\",\"uri\":\"data:image/png;base64," + base64(png) + "\"}", ""},
            {"{\"name\":\"brick\",\"bufferView\":3,\"mimeType\":\"image/png\"}", png}};
        for (const auto& [image, view] : images) {
            const TexturedMesh mesh("");
            mesh.write("my brick.png", png);
            mesh.write("wall.gltf", gltfWith(image, view));
            const ImportOutcome outcome = outcomeOf(mesh.path("wall.gltf"));
            QVERIFY2(textureOf(outcome).has_value(), qPrintable(notesOf(outcome)));
            QVERIFY(textureOf(outcome)->image->bytes() == png);
            QVERIFY(textureOf(outcome)->name.ends_with("brick.png"));
        }
    }
    void imagesThatAreNotReadAreReported_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("note");
        QTest::newRow("missing") << "none.png"
                                 << "refers to \"none.png\", which does not exist";
        QTest::newRow("outside") << "../outside.png"
                                 << "refers to \"../outside.png\", which lies outside its folder";
        QTest::newRow("absolute") << "/etc/hostname"
                                  << "refers to \"/etc/hostname\", which lies outside its folder";
        QTest::newRow("fifo") << "fifo.png"
                              << "refers to \"fifo.png\", which is no file that can be read";
        QTest::newRow("network") << "http://example.org/a.png"
                                 << "which lies outside its folder";
        QTest::newRow("truncated") << "cut.png"
                                   << "The image \"cut.png\" is not read: it is damaged or ends too early";
        QTest::newRow("text") << "text.png"
                              << "The image \"text.png\" is not read: it is neither PNG nor JPEG";
        QTest::newRow("bomb") << "bomb.png"
                              << "it has 60000 × 60000 pixels; scale it down to 8192 a side at most";
        QTest::newRow("large") << "large.png"
                               << "refers to \"large.png\", which is too large to be read";
    }
    void imagesThatAreNotReadAreReported() {
        QFETCH(QString, name);
        QFETCH(QString, note);
        const TexturedMesh mesh("map_Kd " + name.toStdString());
        mesh.write("../outside.png", checkerPng());
        mesh.write("cut.png", checkerPng().substr(0, 100));
        mesh.write("text.png", "no image");
        mesh.write("bomb.png", pngFile(60000, 60000, "x"));
        mesh.write("large.png", checkerPng());
        std::filesystem::resize_file(mesh.path("large.png"), kMaxImageBytes + 1);
        ::mkfifo(mesh.path("fifo.png").c_str(), 0600);
        const ImportOutcome outcome = outcomeOf(mesh.path());
        QVERIFY(!textureOf(outcome));
        QVERIFY2(notesOf(outcome).contains(note), qPrintable(notesOf(outcome)));
    }
    void damagedGltfImagesAreReported() {
        for (const char* image : {"{\"uri\":\"data:image/png;base64,***\"}", "{\"bufferView\":9}", "{}",
                                  "{\"uri\":\"data:image/png;base64,QUJD\"}"}) {
            const TexturedMesh mesh("");
            mesh.write("wall.gltf", gltfWith(image, "x"));
            const ImportOutcome outcome = outcomeOf(mesh.path("wall.gltf"));
            QVERIFY(!textureOf(outcome));
            QVERIFY2(notesOf(outcome).contains("The image \"Brick\" is not read"), qPrintable(notesOf(outcome)));
        }
    }
    void projectsKeepTextures() {
        const TexturedMesh mesh("map_Kd a.png");
        mesh.write("a.png", checkerPng());
        Project project = outcomeOf(mesh.path()).project;
        Asset copy = project.assets[0];
        copy.id = project.nextId++;
        copy.name = "copy";
        copy.pattern.layers.clear();  // their ids are unique
        project.assets.push_back(copy);
        const std::string text = projectText(project);
        QCOMPARE(nlohmann::json::parse(text)["images"].size(), std::size_t{1});  // shared
        const Project read = readProjectText(text).value();
        QVERIFY(read == project);
        QVERIFY(read.assets[0].texture->image == read.assets[1].texture->image);
        QVERIFY(projectText(read) == text);
        project.assets[0].texture.reset();
        project.assets[1].texture.reset();
        QVERIFY(!nlohmann::json::parse(projectText(project)).contains("images"));
        QVERIFY(read != project);
    }
    void exportsBringTheTextureBack() {
        const TexturedMesh mesh("map_Kd a b.png", "map_Kd a b.png");
        mesh.write("a b.png", checkerPng());
        const Project project = outcomeOf(mesh.path()).project;
        const Asset& asset = project.assets[0];
        const Bake whole = bake(asset).value();
        const PackMeshes meshes =
            packMeshes(PackBuilder({whole, asset, materialsOf(project, asset), packNames(asset), {}}), {}).value();
        for (const ExportFile& file : meshes.files) mesh.write("pack/" + file.name, file.bytes);
        for (const char* name : {"pack/wall-intact.obj", "pack/wall-intact.glb"}) {
            const ImportOutcome again = outcomeOf(mesh.path(name));
            QVERIFY2(textureOf(again).has_value(), qPrintable(notesOf(again)));
            QVERIFY(textureOf(again)->image->bytes() == checkerPng());
            QCOMPARE(textureOf(again)->name, std::string("a_b.png"));
            QCOMPARE(textureOf(again)->materials, (std::vector<std::uint32_t>{0, 1}));
        }
    }
    void comparisonNamesTheTexture() {
        const TexturedMesh mesh("map_Kd a.png");
        mesh.write("a.png", checkerPng());
        const Project project = outcomeOf(mesh.path()).project;
        Project plain = project;
        plain.assets[0].texture.reset();
        const auto changes = assetChanges(plain, plain.assets[0], project, project.assets[0]);
        QCOMPARE(changes.size(), std::size_t{1});
        QCOMPARE(sentenceOf(changes[0]), std::string("base-colour texture: a.png (16 × 16), was none"));
    }
    void reimportReplacesTheTexture() {
        const TexturedMesh mesh("map_Kd a.png");
        mesh.write("a.png", checkerPng());
        const Project project = outcomeOf(mesh.path()).project;
        mesh.write("a.png", checkerPng(4));
        const SourceScene scene = importMesh(mesh.path(), RUBBLE_IMPORTER, {}).value();
        const Project again = importedInto(project, scene, "wall", {.asset = "wall"}, {}).value().project;
        QVERIFY(again.assets[0].texture->image->bytes() == checkerPng(4));
    }
    void damagedProjectsAreRejected_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("fault");
        QTest::newRow("base64") << "/images/0/base64"
                                << "\"%%%%\""
                                << "images[0].base64: expected base64";
        QTest::newRow("no bytes") << "/images/0/base64"
                                  << "\"\""
                                  << "images[0].base64: expected an image";
        QTest::newRow("type") << "/images/0/type"
                              << "\"image/jpeg\""
                              << "images[0].type: the image is image/png";
        QTest::newRow("other type") << "/images/0/type"
                                    << "\"image/gif\""
                                    << "images[0].type";
        QTest::newRow("text") << "/images/0/base64"
                              << "\"QUJD\""
                              << "images[0]: the image is neither PNG nor JPEG";
        QTest::newRow("index") << "/assets/0/texture/image"
                               << "1"
                               << "refers to image 1 of 1";
        QTest::newRow("material") << "/assets/0/texture/materials"
                                  << "[3]"
                                  << "its texture must be on materials";
        QTest::newRow("no material") << "/assets/0/texture/materials"
                                     << "[]"
                                     << "its texture must be on materials";
        QTest::newRow("twice") << "/assets/0/texture/materials"
                               << "[0,0]"
                               << "its texture must be on materials";
        QTest::newRow("name") << "/assets/0/texture/name"
                              << "\"../a.png\""
                              << "the name of its texture must be";
        QTest::newRow("no name") << "/assets/0/texture/name"
                                 << "\"\""
                                 << "the name of its texture must be";
    }
    void damagedProjectsAreRejected() {
        QFETCH(QString, path);
        QFETCH(QString, value);
        QFETCH(QString, fault);
        const TexturedMesh mesh("map_Kd a.png");
        mesh.write("a.png", checkerPng());
        nlohmann::json json = nlohmann::json::parse(projectText(outcomeOf(mesh.path()).project));
        json[nlohmann::json::json_pointer(path.toStdString())] = nlohmann::json::parse(value.toStdString());
        const QString reported = QString::fromStdString(errorText(readProjectText(json.dump())));
        QVERIFY2(reported.contains(fault), qPrintable(reported));
    }
};

RUBBLE_TEST(TextureImportTest)
#include "TextureImportTest.moc"
