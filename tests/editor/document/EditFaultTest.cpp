#include "editor/document/EditFault.h"

#include "core/asset/checks/VerifyProject.h"
#include "core/base/Random.h"
#include "core/io/project/ProjectFile.h"
#include "editor/document/Document.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/ProcessorTime.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QSignalSpy>
#include <QTest>

#include <array>
#include <limits>

using namespace rubble;

namespace {

template <class Value>
Edit changeOf(Value value) {
    const Id id = value.id;
    return {.text = "Change", .replacements = {Replacement<Value>{id, std::move(value)}}};
}

/// The document's first asset with an outline that reaches to x.
Edit outlineTo(const Document& document, double x) {
    Asset asset = document.project().assets[0];
    for (Vec2& corner : asset.prism().outline.outer) corner.x = corner.x > 0.0 ? x : x - 1.0;
    return changeOf(std::move(asset));
}

double extremeNumber(Random& random) {
    constexpr double kMax = std::numeric_limits<double>::max();
    constexpr std::array kNumbers{0.0,  -1.0, 1.0,     1e-300, 1e-12, 1e-9, 1e-6, 1e-3, 0.5,   2.0,
                                  1e3,  1e4,  10001.0, 1e5,    2e5,   -2e5, 1e6,  1e9,  1e12,  1e15,
                                  1e24, 1e25, 1e60,    kMax,   -kMax, 4e9,  5e-5, 0.1,  -1e-9, 90.0};
    return kNumbers[random.below(kNumbers.size())];
}

/// Sets one number of an element to a value that may be beyond every range, as typing, dragging and dialogs might.
Edit extremeEdit(const Project& project, Random& random) {
    const double number = extremeNumber(random);
    const int axis = static_cast<int>(random.below(3));
    Asset asset = project.assets[random.below(project.assets.size())];
    Material material = project.materials[random.below(project.materials.size())];
    Instance instance = project.instances[random.below(project.instances.size())];
    Shot shot = project.shots[random.below(project.shots.size())];
    SceneSettings scene = sceneSettings(project);
    switch (random.below(24)) {
        case 0: return asset.threshold = number, changeOf(asset);
        case 1: return asset.contactTime = number, changeOf(asset);
        case 2: return asset.prism().depth = number, changeOf(asset);
        case 3: return asset.prism().outline.outer[random.below(3)][axis % 2] = number, changeOf(asset);
        case 4: return asset.shaping.gap = number, changeOf(asset);
        case 5: return asset.insideUvScale = number, changeOf(asset);
        case 6: return material.density = number, changeOf(material);
        case 7: return material.tensileStrength = number, changeOf(material);
        case 8: return material.outside.red = number, changeOf(material);
        case 9: return instance.pose.position[axis] = number, changeOf(instance);
        case 10: return instance.threshold = number, changeOf(instance);
        case 11: return instance.pose.orientation.w = number, changeOf(instance);
        case 12: return shot.time = number, changeOf(shot);
        case 13: return shot.action = Throw{.from = {number, 0.0, 0.0}, .to = {0.0, number, 0.0}}, changeOf(shot);
        case 14: return shot.action = Blast{.impulse = number}, changeOf(shot);
        case 15: return scene.ground.height = number, Edit{.text = "Scene", .replacements = {scene}};
        case 16: return scene.gravity[axis] = number, Edit{.text = "Scene", .replacements = {scene}};
        case 17: return scene.debris.lifetime = number, Edit{.text = "Scene", .replacements = {scene}};
        case 18: {
            for (Vec2& corner : asset.prism().outline.outer) corner *= number;
            return changeOf(asset);
        }
        case 19: return asset.bonding.radius = number, changeOf(asset);
        case 20: return asset.bonding.heightStrengths = {{.height = number}}, changeOf(asset);
        case 21: return instance.bondStrength = number, changeOf(instance);
        case 22: {
            Mortar mortar = project.mortars[random.below(project.mortars.size())];
            return mortar.tolerance = number, changeOf(mortar);
        }
        default: {
            PlayTest test = project.playTests[random.below(project.playTests.size())];
            return test.duration = number, changeOf(test);
        }
    }
}

}  // namespace

class EditFaultTest : public QObject {
    Q_OBJECT
private slots:
    void editBeyondARangeIsRefused() {
        Document document(boxProject(UniformScatter{}));
        const Project before = document.project();
        const QSignalSpy refused(&document, &Document::refused), changed(&document, &Document::changed);
        QVERIFY(!document.push(outlineTo(document, 200'000.0)));
        QCOMPARE(refused.size(), 1);
        QCOMPARE(refused[0][0].toString(),
                 "Asset 2 \"box\": the x of point 0 of the outline is 199999, but it must be "
                 "from -100000 to 100000.");
        QVERIFY(changed.isEmpty() && document.project() == before && !document.isModified());
        QVERIFY(!document.undoStack().canUndo());
        QVERIFY(document.push(outlineTo(document, 90'000.0)));
    }
    void derivedThresholdBeyondItsRangeIsRefused() {
        Document document(boxProject(UniformScatter{}));
        Asset asset = document.project().assets[0];
        asset.contactTime = 1e-9;
        QVERIFY(document.push(changeOf(asset)));
        Material material = document.project().materials[0];
        material.tensileStrength = 0.5e6;
        QVERIFY(document.push(changeOf(material)));
        material.tensileStrength = 1.0;  // 1 Pa on some tenths of a square metre for less than 1e-9 s
        QVERIFY(!document.push(changeOf(material)));
        QCOMPARE(document.project().materials[0].tensileStrength.value(), 0.5e6);
    }
    void elementOutOfRangeCanBeMendedStepByStep() {
        Project project = boxProject(UniformScatter{});
        project.instances[0].pose.position = {2e5, 0.0, 3e5};
        Document document(project);
        Instance instance = project.instances[0];
        instance.pose.position.x = 0.0;
        QVERIFY(document.push(changeOf(instance)));
        instance.pose.position.z = 0.0;
        QVERIFY(document.push(changeOf(instance)));
        instance.pose.position.z = 3e5;
        QVERIFY(!document.push(changeOf(instance)));
    }
    void refusedEditsLeaveNoStep() {
        Document document(boxProject(UniformScatter{}));
        document.pushTogether("Both", [&] { document.push(outlineTo(document, 200'000.0)); });
        QVERIFY(document.undoStack().count() == 0 && !document.isModified());
        document.pushTogether("Both", [&] { document.push(outlineTo(document, 9.0)); });
        QCOMPARE(document.undoStack().undoText(), "Both");
    }
    /// Whatever is typed or dragged, the project can be saved and loaded.
    void extremeEditsLeaveAProjectThatCanBeLoaded() {
        int accepted = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Document document(fullProject());
            Random random(seed);
            for (int step = 0; step < 200; ++step) {
                if (!document.push(extremeEdit(document.project(), random))) continue;
                ++accepted;
                const std::optional<std::string> fault = verifyProject(document.project());
                QVERIFY2(!fault, qPrintable(faultOfSeed(seed, fault.value_or(""))));
            }
            const Result<Project> loaded = readProjectText(projectText(document.project()));
            QVERIFY2(loaded && *loaded == document.project(), qPrintable(QString("seed %1").arg(seed)));
        }
        QVERIFY(accepted > 500);
    }
    /// A drag pushes an edit with each movement of the mouse.
    void movingFiveThousandInstancesIsChecked() {
        Project project = boxProject(UniformScatter{});
        project.nextId = 10'000;
        for (Id id = 11; id < 5010; ++id)
            project.instances.push_back({.id = id, .name = "box " + std::to_string(id), .asset = 2});
        Edit edit{.text = "Move"};
        for (Instance instance : project.instances) {
            instance.pose.position.x += 1.0;
            edit.replacements.push_back(Replacement<Instance>{instance.id, std::move(instance)});
        }
        const double start = test::processorTime();
        QVERIFY(!editFault(project, edit));
        const double milliseconds = test::processorTime() - start;
        qInfo("checking 5,000 instances took %.1f ms", milliseconds);
        QVERIFY(milliseconds < 500.0);  // usually a few
        QVERIFY(project.instances.back().pose.position.x == 0.0);
    }
};

RUBBLE_TEST_WITH(EditFaultTest, QCoreApplication)
#include "EditFaultTest.moc"
