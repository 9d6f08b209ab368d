// Tests that no event of the interface takes long, whatever is done in the background: editor/document/Autosave.cpp,
// editor/document/DocumentFile.cpp, editor/background/Baker.cpp, editor/dialogs/import/ImportDialog.cpp.
#include "core/asset/bake/Bake.h"
#include "core/asset/library/StarterProject.h"
#include "core/base/Hash.h"
#include "editor/dialogs/import/ImportDialog.h"
#include "editor/document/FilePath.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/ProjectParts.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/editor/EventLoop.h"
#include "tests/support/editor/Watchdog.h"

#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>

using namespace rubble;
using namespace std::chrono_literals;

namespace {

constexpr double kLongestHandler = 50.0;         // ms of processor time; or, where machines are slow,
constexpr double kLargestShare = 0.5;            // of the time that the work takes that is done in the background
constexpr std::uint32_t kPlacedSeeds = 400'000;  // to serialize them takes longer, and so does
constexpr qint64 kPadding = 128 << 20;           // hashing so many bytes
constexpr int kPlateColumns = 500;               // of squares, each of four triangles: two above, two below

/// A wall of some thousand fragments, and another one without an instance that has a layer of many seeds, which is off.
Project largeProject() {
    Project project = starterProject();
    project.assets[0].pattern.layers[0].parameters = UniformScatter{.count = 2000};
    Asset other = project.assets[0];
    other.name = "other";
    PlacedSeeds placed;
    for (std::uint32_t k = 0; k < kPlacedSeeds; ++k)
        placed.seeds.push_back({k, {-0.4 + 0.8 * k / kPlacedSeeds, 1e-3 * (k % 400)}});
    test::addAsset(project, std::move(other), {UniformScatter{.count = 2}, std::move(placed)});
    project.assets[1].pattern.layers[1].isOn = false;
    return project;
}

/// A plate of a million triangles, without its sides.
QByteArray finePlate() {
    constexpr int kPoints = kPlateColumns + 1;
    QByteArray text;
    for (const char* height : {"0.1", "0"}) {
        for (int z = 0; z < kPoints; ++z) {
            for (int x = 0; x < kPoints; ++x)
                text += "v " + QByteArray::number(x) + ' ' + height + ' ' + QByteArray::number(z) + '\n';
        }
    }
    const auto addFace = [&](int a, int b, int c) {
        text += "f " + QByteArray::number(a) + ' ' + QByteArray::number(b) + ' ' + QByteArray::number(c) + '\n';
    };
    for (int z = 0; z < kPlateColumns; ++z) {
        for (int x = 0; x < kPlateColumns; ++x) {
            const int a = 1 + z * kPoints + x, b = a + 1, c = a + kPoints, d = c + 1, below = kPoints * kPoints;
            addFace(a, c, b);
            addFace(b, c, d);
            addFace(a + below, b + below, c + below);
            addFace(b + below, d + below, c + below);
        }
    }
    return text;
}

}  // namespace

class WatchdogTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("The checks of a sanitizer take time themselves.");
#endif
    }
    void init() {
        QVERIFY(saveProject(toPath(pathOf("wall.rubble")), largeProject()));
        openFile(pathOf("wall.rubble"));
        QTRY_VERIFY_WITH_TIMEOUT(bakes().areCurrent(project()), kPatience);
        viewport().hide();  // here the processor draws it
        autosave().setInterval(0s);
        test::runTimersDueWithin(1);
    }
    void cleanup() { close(); }

    void backupsAreWrittenInTheBackground() {
        setHeight(-1.0);
        test::runTimersDueWithin(1500);
        const qsizetype before = backupCount();
        const test::Watchdog watchdog;
        autosave().setInterval(1s);
        QTRY_VERIFY_WITH_TIMEOUT(backupCount() > before, kPatience);
        check(watchdog, [&] { return saveProject(toPath(pathOf("again.rubble")), project()).hasValue(); });
    }
    void filesAreComparedInTheBackground() {
        QString question;
        test::onNextDialog<QMessageBox>([&](QMessageBox& box) {
            question = box.text();
            box.reject();
        });
        QFile file(pathOf("wall.rubble"));
        QVERIFY(file.open(QIODevice::Append) && file.resize(file.size() + kPadding));
        file.close();
        const test::Watchdog watchdog;
        QTRY_VERIFY_WITH_TIMEOUT(question.contains("was changed by another program"), kPatience);
        check(watchdog,
              [&] { return file.open(QIODevice::ReadOnly) && contentHash(file.readAll().toStdString()).low != 0; });
    }
    void assetsAreBakedInTheBackground() {
        const test::Watchdog watchdog;
        Asset asset = project().assets[0];
        asset.pattern.layers[0].randomSeed += 1;
        const Id id = asset.id;
        document().push({.text = "Reseed", .replacements = {Replacement<Asset>{id, std::move(asset)}}});
        QTRY_VERIFY_WITH_TIMEOUT(bakes().areCurrent(project()), kPatience);
        test::runTimersDueWithin(1);
        check(watchdog, [&] { return bake(project().assets[0]).hasValue(); });
    }
    void millionTrianglesAreImportedInTheBackground() {
        QFile file(pathOf("plate.obj"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(finePlate()) > 0);
        file.close();
        const test::Watchdog reading;
        const auto work = [] { return !finePlate().isEmpty(); };
        ImportDialog dialog(file.fileName(), project(), {}, nullptr);
        QVERIFY(dialog.read(RUBBLE_IMPORTER));
        check(reading, work);
        const test::Watchdog showing;
        auto& view = *dialog.findChild<ViewportWidget*>();
        view.hide();  // here the processor draws it
        dialog.show();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.findChild<QProgressBar*>()->isVisible(), kPatience);
        check(showing, work);
        QVERIFY(!view.scene().poses.empty() && !view.settings().hasShadows);
    }

private:
    Document& document() { return window().workspace().document(); }
    Bakes& bakes() { return window().workspace().bakes(); }
    Autosave& autosave() { return window().workspace().autosave(); }
    void setHeight(double height) {
        SceneSettings scene = sceneSettings(project());
        scene.ground.height = height;
        document().push({.text = "Move ground", .replacements = {scene}});
    }
    static qsizetype backupCount() { return QDir(backupFolder()).entryList({"*.rubble"}).size(); }
    /// Compares the longest handler with `work`, which is done here as it is in the background.
    template <class Work>
    static void check(const test::Watchdog& watchdog, const Work& work) {
        const double time = watchdog.processorTimeOfAHandler(), start = test::processorTime();
        QVERIFY(work());
        const double limit = std::max(kLongestHandler, kLargestShare * (test::processorTime() - start));
        qInfo("%.1f ms of processor time, of at most %.1f", time, limit);
        QVERIFY2(time <= limit, qPrintable(QString("%1 ms of processor time").arg(time)));
    }
};

RUBBLE_TEST_WITH(WatchdogTest, QApplication)
#include "WatchdogTest.moc"
