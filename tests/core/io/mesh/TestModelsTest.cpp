// Tests app/importer/MeshFile.cpp with the models of Debian's assimp-testmodels.
#include "core/asset/checks/VerifyProject.h"
#include "core/asset/import/AssetImport.h"
#include "core/base/Parallel.h"
#include "core/io/mesh/MeshImport.h"
#include "tests/support/TestProgram.h"

#include <QProcess>
#include <QTest>

#include <algorithm>
#include <chrono>
#include <filesystem>

using namespace rubble;

namespace {

/// Every OBJ, glTF, GLB, FBX, STL and PLY file of Debian's assimp-testmodels.
std::vector<std::filesystem::path> testModels() {
    QProcess dpkg;
    dpkg.start("dpkg", {"-L", "assimp-testmodels"});
    if (!dpkg.waitForFinished(kPatience)) return {};
    std::vector<std::filesystem::path> models;
    for (const QByteArray& line : dpkg.readAllStandardOutput().split('\n')) {
        const std::filesystem::path path = line.toStdString();
        const QByteArray ending = QByteArray::fromStdString(path.extension().string()).toLower();
        const bool isOurs = QList<QByteArray>{".obj", ".gltf", ".glb", ".fbx", ".stl", ".ply"}.contains(ending);
        if (isOurs && std::filesystem::is_regular_file(path)) models.push_back(path);
    }
    return models;
}

struct Trial {
    bool isRead = false;
    std::string refusal;
    std::size_t objects = 0;
    std::size_t prisms = 0;
    double seconds = 0.0;
};

Trial tried(const std::filesystem::path& model) {
    const auto start = std::chrono::steady_clock::now();
    const Result<SourceScene> scene = importMesh(model, RUBBLE_IMPORTER, {});
    Trial trial{.isRead = scene.hasValue()};
    trial.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!scene) {
        trial.refusal = scene.error().message;
        return trial;
    }
    const Result<ImportOutcome> outcome =
        importedInto({}, *scene, model.stem().string(), {.as = ImportShape::Prism}, {});
    trial.objects = scene->objects.size();
    trial.prisms = outcome->assets.size();
    trial.refusal = verifyProject(outcome->project).value_or("");
    for (const RejectedObject& rejected : outcome->rejected) {
        if (!rejected.error.message.ends_with('.')) trial.refusal = rejected.error.message;
    }
    return trial;
}

}  // namespace

class TestModelsTest : public QObject {
    Q_OBJECT
private slots:
    void everyModelIsReadOrRejected() {
        const std::vector<std::filesystem::path> models = testModels();
        if (models.empty()) QSKIP("The Debian package assimp-testmodels is not installed.");
        std::vector<Trial> trials(models.size());
        forEachIndex(models.size(), 2, [&](std::size_t i) { trials[i] = tried(models[i]); });

        std::size_t read = 0, objects = 0, prisms = 0;
        double longest = 0.0;
        for (std::size_t i = 0; i < models.size(); ++i) {
            const Trial& trial = trials[i];
            read += trial.isRead;
            objects += trial.objects;
            prisms += trial.prisms;
            longest = std::max(longest, trial.seconds);
            if (!trial.refusal.empty()) qInfo("%s: %s", models[i].c_str(), trial.refusal.c_str());
            QVERIFY2(trial.isRead == trial.refusal.empty(), models[i].c_str());
            QVERIFY2(trial.isRead || trial.refusal.ends_with('.'), models[i].c_str());
        }
        qInfo("%zu of %zu files read, the slowest in %.2f s; %zu of %zu objects are prisms", read, models.size(),
              longest, prisms, objects);
        QVERIFY(2 * read > models.size());
    }
};

RUBBLE_TEST(TestModelsTest)
#include "TestModelsTest.moc"
