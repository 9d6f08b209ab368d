// Tests core/asset/bake/BakeEstimate.cpp: the memory that baking, exporting and playing take at their peaks.
#include "core/asset/bake/BakeEstimate.h"
#include "core/asset/checks/VerifyBake.h"
#include "core/base/Random.h"
#include "core/io/pack/PackExport.h"
#include "core/play/session/Session.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTemporaryDir>
#include <QTest>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <functional>

using namespace rubble;

namespace {

constexpr std::uint64_t kSeed = 36;

/// The peak of a process that only runs `work`, bytes; 0 if that fails.
double peakOf(const std::function<bool()>& work) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(work() ? 0 : 1);
    int status = 0;
    rusage usage{};
    if (::wait4(child, &status, 0, &usage) != child || status != 0) return 0.0;
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

std::uint32_t side(double count) { return static_cast<std::uint32_t>(std::sqrt(count)); }

/// Without RUBBLE_LONG, these kinds only.
bool isTried(const char* kind) {
    const bool isShort = kind == std::string_view("uniform") || kind == std::string_view("bricks");
    return isShort || qEnvironmentVariableIsSet("RUBBLE_LONG");
}

/// Layers that make about `count` fragments of a box of 2 m x 1 m.
std::vector<std::pair<const char*, LayerParameters>> layersOf(double count) {
    const double width = std::sqrt(2.0 / count);
    const auto number = static_cast<std::uint32_t>(count);
    return {
        {"uniform", UniformScatter{.count = number}},
        {"blue noise", BlueNoise{.minimumDistance = 0.8 * width}},
        {"grid", JitteredGrid{.columns = side(2.0 * count), .rows = side(count / 2.0)}},
        {"clusters", Clusters{.clusters = number / 100, .seedsPerCluster = 100, .radius = 0.1}},
        {"impact", ImpactScatter{.centre = {1.0, 0.5}, .count = number, .radius = 1.0, .falloff = 1.0}},
        {"lattice", HexagonalLattice{.spacing = width}},
        {"bricks", BrickBond{.length = 2.0 * width, .width = width, .height = 0.5 * width, .mortar = 0.0}},
    };
}

bool bakes(const Asset& asset) { return bake(asset, {.threads = 1}).hasValue(); }

bool verifies(const Asset& asset) {
    const Result<Bake> baked = bake(asset, {.threads = 1});
    return baked && !verifyBake(*baked, asset);
}

bool exports(const Project& project, const std::string& folder, const MeshOptions& meshes) {
    const std::vector<Id> assets{project.assets[0].id};
    const auto made = exportPacks(project, assets, folder, {.meshes = meshes}, EditedFiles::Kept, {.threads = 1});
    return made && made->front().status;
}

bool plays(const Project& project) {
    const Result<std::shared_ptr<const PlayScene>> scene = playScene(project, {.threads = 1});
    if (!scene) return false;
    Result<Session> session = Session::start(*scene);
    if (!session) return false;
    session->step();
    return true;
}

}  // namespace

class StageMemoryTest : public QObject {
    Q_OBJECT

    double m_program = 0.0;  // bytes, of the process itself
    QTemporaryDir m_place;

    void compare(const char* stage, double estimate, double peak) {
        const double measured = peak - m_program;
        const QByteArray figures = QByteArray(stage) + ": " + QByteArray::number(estimate / 1e6, 'f', 0) +
                                   " MB estimated, " + QByteArray::number(measured / 1e6, 'f', 0) + " MB measured";
        qInfo("%s", figures.constData());
        QVERIFY2(peak > 0.0 && estimate >= 0.5 * measured && estimate <= 2.0 * measured, figures);
    }

private slots:
    void initTestCase() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("Sanitizers take memory of their own.");
#endif
        m_program = peakOf([] { return true; });
    }
    void peaksAreEstimatedWithinAFactorOfTwo_data() {
        QTest::addColumn<Asset>("asset");
        Random random(kSeed);
        const std::size_t kinds = layersOf(1000.0).size();
        for (std::size_t kind = 0; kind < kinds; ++kind) {
            const double count = 20000.0 + static_cast<double>(random.below(20000));
            const auto [name, layer] = layersOf(count)[kind];
            if (isTried(name)) QTest::addRow("%s %.0f", name, count) << boxAsset(2, 3, layer);
        }
        Asset layered = boxAsset(2, 3, UniformScatter{.count = 1500});
        layered.levels = {Level{.pattern = {{{.id = 9, .parameters = UniformScatter{.count = 20}}}}}};
        QTest::newRow("two levels") << layered;
        Asset sliced = boxAsset(2, 3, Slices{.cuts = 150, .angle = 0.0});
        sliced.pattern.layers.push_back({.id = 4, .parameters = Slices{.cuts = 150, .angle = 1.5}});
        QTest::newRow("slices") << sliced;
    }
    void peaksAreEstimatedWithinAFactorOfTwo() {
        QFETCH(Asset, asset);
        Project project = boxProject(UniformScatter{.count = 5});
        project.assets = {asset};
        BakeEstimate estimate = estimateOf(asset);
        compare("bake", estimate.bytes(MemoryStage::Bake), peakOf([&] { return bakes(asset); }));
        compare("verify", estimate.bytes(MemoryStage::Bake), peakOf([&] { return verifies(asset); }));
        const std::string folder = m_place.filePath(QTest::currentDataTag()).toStdString();
        for (const MeshOptions& meshes : {MeshOptions(), MeshOptions{.formats = {}},
                                          MeshOptions{.formats = {"glb", "usd"}, .glbKind = GlbKind::Physics}}) {
            estimate.meshBytes = meshBytesPerFragment(meshes);
            compare("export", estimate.bytes(MemoryStage::Export),
                    peakOf([&] { return exports(project, folder, meshes); }));
        }
        compare("play", estimate.bytes(MemoryStage::Play), peakOf([&] { return plays(project); }));
    }
};

RUBBLE_TEST(StageMemoryTest)
#include "StageMemoryTest.moc"
