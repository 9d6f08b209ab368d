// Tests core/asset/checks/VerifyProject.cpp, core/asset/checks/ValueFaults.cpp and core/asset/checks/PlayFaults.cpp.
#include "core/asset/checks/VerifyProject.h"
#include "core/asset/project/Project.h"
#include "tests/support/ProcessorTime.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <functional>
#include <limits>

using namespace rubble;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kNoDirection =
    "Saved throw 7 \"box\": it starts where it aims, so that it has no direction; the start "
    "and the aim must be at least 0.000001 m apart.";

/// One of everything, ids 1 to 8, all in order.
Project smallProject() {
    Project project;
    project.nextId = 9;
    project.materials = {{.id = 1, .name = "brick"}};
    Asset wall{.id = 2, .name = "wall", .material = 1};
    wall.prism().outline.outer = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    wall.pattern.layers = {{.id = 3, .parameters = UniformScatter{.count = 5}}};
    wall.levels = {{.pattern = {{{.id = 4, .parameters = BlueNoise{}}}}, .minimumVolume = 0.1}};
    wall.surface = std::make_shared<Surface>(Surface{.materials = {"plaster"}, .triangles = {SurfaceTriangle{}}});
    project.assets = {wall};
    project.instances = {{.id = 5, .name = "left", .asset = 2}, {.id = 6, .name = "right", .asset = 2}};
    project.shots = {{.id = 7, .name = "box", .action = Throw{}}};
    project.playTests = {{.id = 8, .name = "stands", .shots = {7}, .expectations = {{.instance = 5}}}};
    return project;
}

std::shared_ptr<Surface> copyOfSurface(const Project& project) {
    return std::make_shared<Surface>(*project.assets[0].surface);
}

using ProjectChange = std::function<void(Project&)>;

}  // namespace
Q_DECLARE_METATYPE(ProjectChange)

class VerifyProjectTest : public QObject {
    Q_OBJECT

    static void row(const char* sentence, const ProjectChange& change) { QTest::newRow(sentence) << change; }

private slots:
    void validProjectsHaveNoFault() {
        QVERIFY(!verifyProject(Project{}));
        const std::optional<std::string> fault = verifyProject(smallProject());
        QVERIFY2(!fault, fault.value_or("").c_str());
    }

    void patternsOfFragmentsCanShareLayers() {
        Project project = smallProject();
        Asset& wall = project.assets[0];
        wall.fragmentLevels = {{"3.0", wall.levels[0]}, {"3.1", wall.levels[0]}};
        QCOMPARE(verifyProject(project).value_or("no fault"), std::string("no fault"));
        wall.levels.clear();
        QCOMPARE(verifyProject(project).value_or("no fault"), std::string("no fault"));
    }

    void endsOfRangesAreAccepted() {
        Project project = smallProject();
        project.debris = {.lifetime = 1e-9, .fade = 0.0, .maxFragments = 1};
        for (const std::uint32_t pieces : {2u, 1000u}) {
            project.assets[0].cutAtImpact = {.fragments = pieces, .falloffRadius = 1e-9};
            QCOMPARE(verifyProject(project).value_or("no fault"), std::string("no fault"));
        }
    }

    void faultsOfIdsAndNamesAreNamed_data() {
        QTest::addColumn<ProjectChange>("change");
        row("Asset 0 \"wall\" has the id 0, which names nothing.", [](Project& p) { p.assets[0].id = 0; });
        row("Test 8 \"stands\" has an id that is not below the project's next id, 8.",
            [](Project& p) { p.nextId = 8; });
        row("Material 2 \"brick\" and Asset 2 \"wall\" have the same id.", [](Project& p) { p.materials[0].id = 2; });
        row("Layer 5 of asset 2 \"wall\" and Instance 5 \"left\" have the same id.",
            [](Project& p) { p.assets[0].pattern.layers[0].id = 5; });
        row("Layer 3 of asset 2 \"wall\" and Layer 3 of asset 2 \"wall\" have the same id.",
            [](Project& p) { p.assets[0].levels[0].pattern.layers[0].id = 3; });
        row("Layer 4 of asset 2 \"wall\" and Layer 4 of asset 2 \"wall\" have the same id.", [](Project& p) {
            auto& layers = p.assets[0].levels[0].pattern.layers;
            layers.push_back(layers.front());
        });
        row("Layer 4 of asset 2 \"wall\" and Instance 4 \"left\" have the same id.", [](Project& p) {
            p.assets[0].fragmentLevels = {{"3.0", p.assets[0].levels[0]}};
            p.instances[0].id = 4;
        });
        row("Instance 5 \"left\" comes after the one with id 6; ids must ascend.",
            [](Project& p) { std::swap(p.instances[0], p.instances[1]); });
        row("Asset 2 has a name of 10001 bytes, but at most 10000 are read; shorten it.",
            [](Project& p) { p.assets[0].name = std::string(10'001, 'a'); });
        row("Material 1 has no name.", [](Project& p) { p.materials[0].name.clear(); });
        row("Material 1 has a name that is not text in UTF-8.", [](Project& p) { p.materials[0].name = "br\xfc"; });
        row("Instance 6 \"left\" has a name that is already taken.", [](Project& p) { p.instances[1].name = "left"; });
    }
    void faultsOfIdsAndNamesAreNamed() { changeIsReported(); }

    void missingReferencesAreNamed_data() {
        QTest::addColumn<ProjectChange>("change");
        row("Asset 2 \"wall\" refers to material 9, which does not exist.",
            [](Project& p) { p.assets[0].material = 9; });
        row("Instance 5 \"left\" refers to asset 1, which does not exist.",
            [](Project& p) { p.instances[0].asset = 1; });
        row("Saved throw 7 \"box\" refers to asset 4, which does not exist.",
            [](Project& p) { p.shots[0].action = Throw{.kind = ProjectileKind::Asset, .asset = 4}; });
        row("Test 8 \"stands\" refers to saved throw 6, which does not exist.", [](Project& p) {
            p.playTests[0].shots = {7, 6};
        });
        row("Test 8 \"stands\" refers to instance 2, which does not exist.",
            [](Project& p) { p.playTests[0].expectations[0].instance = 2; });
    }
    void missingReferencesAreNamed() { changeIsReported(); }

    void numbersOutOfRangeAreNamed_data() {
        QTest::addColumn<ProjectChange>("change");
        row("Material 1 \"brick\": the density is 0, but it must be from 0.001 to 1000000.",
            [](Project& p) { p.materials[0].density = 0.0; });
        row("Material 1 \"brick\": the friction is -0.1, but it must be from 0 to 1000.",
            [](Project& p) { p.materials[0].friction = -0.1; });
        row("Material 1 \"brick\": the restitution is 1.5, but it must be from 0 to 1.",
            [](Project& p) { p.materials[0].restitution = 1.5; });
        row("Material 1 \"brick\": the colour's green is nan, but it must be from 0 to 1.",
            [](Project& p) { p.materials[0].inside.green = kNan; });
        row("Asset 2 \"wall\": the threshold is inf, but it must be from 1e-09 to 1e+24.",
            [](Project& p) { p.assets[0].threshold = std::numeric_limits<double>::infinity(); });
        row("Asset 2 \"wall\": the minimum volume is -1, but it must be from 0 to 1000000000000.",
            [](Project& p) { p.assets[0].levels[0].minimumVolume = -1.0; });
        row("Asset 2 \"wall\": Layer 4: \"Distance\" is 0 m, but must be finite and above zero.",
            [](Project& p) { p.assets[0].levels[0].pattern.layers[0].parameters = BlueNoise{.minimumDistance = 0.0}; });
        row("Asset 2 \"wall\": triangle 0 of the surface: the corner is (0, 0, nan), but it must be from -100000 to "
            "100000.",
            [](Project& p) {
                const auto surface = copyOfSurface(p);
                surface->triangles[0].corners[1].z = kNan;
                p.assets[0].surface = surface;
            });
        row("Asset 2 \"wall\": a material of the surface has a name that is not text in UTF-8.", [](Project& p) {
            const auto surface = copyOfSurface(p);
            surface->materials[0] = "\xc0\xaf";
            p.assets[0].surface = surface;
        });
        row("Asset 2 \"wall\": the surface's back cap refers to a material that does not exist.", [](Project& p) {
            const auto surface = copyOfSurface(p);
            surface->back.material = 1;
            p.assets[0].surface = surface;
        });
        row("Asset 2 \"wall\": the number of fragments of the fracture at the impact is 1, but it must be from 2 to "
            "1000.",
            [](Project& p) { p.assets[0].cutAtImpact = {.fragments = 1}; });
        row("Asset 2 \"wall\": the number of fragments of the fracture at the impact is 1001, but it must be from 2 to "
            "1000.",
            [](Project& p) { p.assets[0].cutAtImpact = {.fragments = 1001}; });
        row("Asset 2 \"wall\": the falloff radius of the fracture at the impact is 0, but it must be from 1e-09 to "
            "100000.",
            [](Project& p) { p.assets[0].cutAtImpact = {.falloffRadius = 0.0}; });
        row("Asset 2 \"wall\": requirement 1: the height is -1, but it must be from 0.000001 to 100000.",
            [](Project& p) {
                p.assets[0].requirements = {{}, {.event = DropRequirement{-1.0}}};
            });
        row("Asset 2 \"wall\": requirement 0: the mass is 0, but it must be from 1e-09 to 1e+15.",
            [](Project& p) { p.assets[0].requirements = {{.event = HitRequirement{.mass = 0.0}}}; });
        row("Asset 2 \"wall\": requirement 0: the speed is nan, but it must be above 0 and at most 10000.",
            [](Project& p) { p.assets[0].requirements = {{.event = HitRequirement{.speed = kNan}}}; });
        row("Instance 5 \"left\": the position is (nan, 0, 0), but it must be from -100000 to 100000.",
            [](Project& p) { p.instances[0].pose.position.x = kNan; });
        row("Instance 5 \"left\": the orientation has the length 2, but it must be 1.", [](Project& p) {
            p.instances[0].pose.orientation = Quat{2.0, 0.0, 0.0, 0.0};
        });
        row("Instance 5 \"left\": the orientation is too long; its length must be 1.", [](Project& p) {
            p.instances[0].pose.orientation = {1e308, 1e308, 0.0, 0.0};
        });
        row("Instance 6 \"right\": the threshold is 0, but it must be from 1e-09 to 1e+24.",
            [](Project& p) { p.instances[1].threshold = 0.0; });
        row("The ground: the restitution is 2, but it must be from 0 to 1.",
            [](Project& p) { p.ground.restitution = 2.0; });
        row("The project: the gravity is (0, nan, 0), but it must be from -1000 to 1000.",
            [](Project& p) { p.gravity.y = kNan; });
        row("The project: the thesis threshold is 0, but it must be from 1e-09 to 1e+24.",
            [](Project& p) { p.damage.thesisThreshold = 0.0; });
        row("Test 8 \"stands\": the expected value is -1, but it must be from 0 to 100000.", [](Project& p) {
            p.playTests[0].expectations[0] = {.kind = ExpectationKind::StandsUntouched, .value = -1.0};
        });
        row("The debris: the lifetime is 0, but it must be from 1e-09 to 1000000000.",
            [](Project& p) { p.debris.lifetime = 0.0; });
        row("The debris: the fade is -1, but it must be from 0 to 1000000000.",
            [](Project& p) { p.debris.fade = -1.0; });
        row("The debris: the maximum number of fragments is 0, but it must be at least 1.",
            [](Project& p) { p.debris.maxFragments = 0; });
        row("Test 8 \"stands\": the state \"../a.rubblestate\" must be the name of a file beside the project.",
            [](Project& p) { p.playTests[0].state = "../a.rubblestate"; });
        row("The settings of events: the least energy is -1, but it must be from 0 to 1e+15.",
            [](Project& p) { p.events.leastEnergy = -1.0; });
        row("The settings of events: the maximum number per step is 0, but it must be from 1 to 1000000.",
            [](Project& p) { p.events.maxRecords = 0; });
        row("Saved throw 7 \"box\": the time is -1, but it must be from 0 to 100000.",
            [](Project& p) { p.shots[0].time = -1.0; });
        row("Saved throw 7 \"box\": the size in y is 0, but it must be from 0.001 to 1000.", [](Project& p) {
            p.shots[0].action = Throw{.size = {1.0, 0.0, 1.0}};
        });
        row(kNoDirection, [](Project& p) { p.shots[0].action = Throw{.from = {0.0, 1.0, 0.0}}; });
        row("Saved throw 7 \"box\": the impulse is (0, 0, nan), but it must be from -1e+15 to 1e+15.", [](Project& p) {
            p.shots[0].action = Hammer{.impulse = {0.0, 0.0, kNan}};
        });
        row("Saved throw 7 \"box\": the radius is 0, but it must be from 0.001 to 100000.",
            [](Project& p) { p.shots[0].action = Blast{.radius = 0.0}; });
        row("The project: the gravity is (0, 10000000, 0), but it must be from -1000 to 1000.",
            [](Project& p) { p.gravity.y = 1e7; });
        row("Material 1 \"brick\": the friction is 1e+20, but it must be from 0 to 1000.",
            [](Project& p) { p.materials[0].friction = 1e20; });
        row("Material 1 \"brick\": the density is 1e+39, but it must be from 0.001 to 1000000.",
            [](Project& p) { p.materials[0].density = 1e39; });
        row("Material 1 \"brick\": the density is 1e-38, but it must be from 0.001 to 1000000.",
            [](Project& p) { p.materials[0].density = 1e-38; });
        row("Asset 2 \"wall\": The shape of fragments: the gap is 1e-300, but it must be 0, or from 0.000001 to 10000.",
            [](Project& p) { p.assets[0].shaping.gap = 1e-300; });
        row("Asset 2 \"wall\": the depth is 5e-324, but it must be from 0.00001 to 10000.",
            [](Project& p) { p.assets[0].prism().depth = 5e-324; });
        row("Asset 2 \"wall\": the x of point 1 of the outline is 1e+15, but it must be from -100000 to 100000.",
            [](Project& p) { p.assets[0].prism().outline.outer[1].x = 1e15; });
        row("Asset 2 \"wall\": the width of the outline is 20000, but it must be from 0.00001 to 10000.",
            [](Project& p) {
                for (Vec2& corner : p.assets[0].prism().outline.outer) corner.x *= 20000.0;
            });
        row("Saved throw 7 \"box\": the size in x is 1e+100, but it must be from 0.001 to 1000.",
            [](Project& p) { p.shots[0].action = Throw{.kind = ProjectileKind::Ball, .size = Vec3(1e100)}; });
        row("Saved throw 7 \"box\": the size in x is 1e-12, but it must be from 0.001 to 1000.",
            [](Project& p) { p.shots[0].action = Throw{.kind = ProjectileKind::Ball, .size = Vec3(1e-12)}; });
        row("Saved throw 7 \"box\": the impulse is 1e+300, but it must be from 0 to 1e+15.",
            [](Project& p) { p.shots[0].action = Blast{.impulse = 1e300}; });
        row("Saved throw 7 \"box\": the time is 1e+300, but it must be from 0 to 100000.",
            [](Project& p) { p.shots[0].time = 1e300; });
        row("Test 8 \"stands\": the duration is 1e+300, but it must be from 0.00001 to 100000.",
            [](Project& p) { p.playTests[0].duration = 1e300; });
        row("Test 8 \"stands\": the duration is 0, but it must be from 0.00001 to 100000.",
            [](Project& p) { p.playTests[0].duration = 0.0; });
    }
    void numbersOutOfRangeAreNamed() { changeIsReported(); }

    void throwsOfAlmostNoLengthAreNamed() {
        Project project = smallProject();
        for (const double length : {0.0, 1e-200, 9e-7}) {
            project.shots[0].action = Throw{.from = {1.0, 2.0, 3.0}, .to = {1.0 + length, 2.0, 3.0}};
            QCOMPARE(verifyProject(project).value_or("no fault"), std::string(kNoDirection));
        }
        project.shots[0].action = Throw{.from = {1.0, 2.0, 3.0}, .to = {1.000002, 2.0, 3.0}};
        QVERIFY(!verifyProject(project));
    }
    void manyReferencesAreVerifiedAtOnce() {
        Project project = smallProject();
        const Id first = project.nextId;
        for (Id id = first; id < first + 20'000; ++id)
            project.shots.push_back({.id = id, .name = "shot " + std::to_string(id), .action = Hammer{}});
        project.nextId = first + 20'000;
        project.playTests[0].shots.assign(2'000'000, first + 19'999);
        const double start = test::processorTime();
        QCOMPARE(verifyProject(project).value_or("no fault"), std::string("no fault"));
        QVERIFY(test::processorTime() - start < 10'000.0);  // one by one, this takes half a minute at least
    }

    void prismsThatCannotBeFracturedAreNamed() {
        Project project = smallProject();
        project.assets[0].prism().depth = -1.0;
        const std::optional<std::string> fault = verifyProject(project);
        QVERIFY(fault.has_value());
        QVERIFY2(fault->starts_with("Asset 2 \"wall\": ") && fault->find("-1") != std::string::npos, fault->c_str());
    }

private:
    void changeIsReported() {
        QFETCH(ProjectChange, change);
        Project project = smallProject();
        change(project);
        QCOMPARE(verifyProject(project).value_or("no fault"), std::string(QTest::currentDataTag()));
    }
};

RUBBLE_TEST(VerifyProjectTest)
#include "VerifyProjectTest.moc"
