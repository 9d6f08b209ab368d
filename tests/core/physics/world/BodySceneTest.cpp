#include "core/physics/world/BodyScene.h"

#include "tests/support/TestProgram.h"
#include "tests/support/scenes/SceneParts.h"
#include "tests/support/scenes/Scenes.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace rubble;

namespace {

/// A box in free fall.
BodyScene oneBox() {
    BodyScene scene;
    test::addFreeBody(scene, "crate", test::addShape(scene, {test::boxOf({1.0, 1.0, 1.0})}), {});
    return scene;
}

/// The error of makeWorld() for a modified box.
template <class Change>
std::string faultAfter(Change change) {
    BodyScene scene = oneBox();
    change(scene);
    const Result<SceneWorld> made = makeWorld(scene);
    return made ? "none" : made.error().message;
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Polytope insideOut(Polytope polytope) {
    for (auto& face : polytope.faces) std::ranges::reverse(face);
    for (Plane& plane : polytope.planes) plane = {-plane.normal, -plane.offset};
    return polytope;
}

Polytope flattened(Polytope polytope) {
    for (Vec3& vertex : polytope.vertices) vertex.z = 0.0;
    return polytope;
}

}  // namespace

class BodySceneTest : public QObject {
    Q_OBJECT
private slots:
    void bodiesAreCreatedInOrder() {
        const BodyScene scene = test::wallScene();
        const Result<SceneWorld> made = makeWorld(scene);
        QVERIFY2(made, made ? "" : made.error().message.c_str());
        QCOMPARE(made->bodies.size(), std::size_t{106});
        QCOMPARE(made->world.kind(made->bodies[0]), BodyKind::Static);
        QCOMPARE(made->world.kind(made->bodies[1]), BodyKind::Dynamic);
        QCOMPARE(made->world.mass(made->bodies[1]), 250.0);
        QCOMPARE(made->world.state(made->bodies[1]).pose.position.x, -4.5);
    }
    void bodiesOfOneShapeShareIt() {
        const Result<SceneWorld> made = makeWorld(test::pyramidScene());
        QVERIFY(made);
        QCOMPARE(&made->world.shape(made->bodies[1]), &made->world.shape(made->bodies[210]));
    }
    void scenesHaveTheirDocumentedBodies() {
        QCOMPARE(test::freeBodies(test::houseScene()), std::size_t{77});
        QCOMPARE(test::freeBodies(test::cutHouseScene()), std::size_t{616});
        QCOMPARE(test::freeBodies(test::wallScene()), std::size_t{105});
        QCOMPARE(test::freeBodies(test::pyramidScene()), std::size_t{210});
        QCOMPARE(test::freeBodies(test::heapScene(600)), std::size_t{600});
        for (const char* name : {"house", "cut-house", "wall", "pyramid", "heap-600"}) {
            QCOMPARE(QString::fromStdString(verifyBodyScene(test::sceneNamed(name)).value_or("")), QString());
        }
    }
    void scenesAreDeterministic() { QCOMPARE(test::heapScene(600), test::heapScene(600)); }

    void invalidNumbersAreRejectedByName() {
        const auto body = [](auto set) { return faultAfter([&](BodyScene& scene) { set(scene.bodies[0]); }); };
        QCOMPARE(body([](SceneBody& b) { b.density = -5.0; }),
                 std::string("Body \"crate\": the density is -5, but it must be above 0 and at most 1000000."));
        QCOMPARE(body([](SceneBody& b) { b.density = 0.0; }),
                 std::string("Body \"crate\": the density is 0, but it must be above 0 and at most 1000000."));
        QCOMPARE(body([](SceneBody& b) { b.friction = -0.1; }),
                 std::string("Body \"crate\": the friction is -0.1, but it must be from 0 to 1000."));
        QCOMPARE(body([](SceneBody& b) { b.restitution = 1.5; }),
                 std::string("Body \"crate\": the restitution is 1.5, but it must be from 0 to 1."));
        QCOMPARE(body([](SceneBody& b) { b.restitution = kNan; }),
                 std::string("Body \"crate\": the restitution is nan, but it must be from 0 to 1."));
        QCOMPARE(body([](SceneBody& b) { b.pose.position.y = kNan; }),
                 std::string("Body \"crate\": the position is (0, nan, 0), but its length must be at most 100000."));
        QCOMPARE(body([](SceneBody& b) { b.velocity.x = kInfinity; }),
                 std::string("Body \"crate\": the velocity is (inf, 0, 0), but its length must be at most 10000."));
        QCOMPARE(body([](SceneBody& b) { b.angularVelocity.z = 2e4; }),
                 std::string(
                     "Body \"crate\": the angular velocity is (0, 0, 20000), but its length must be at most 10000."));
    }
    void orientationsMustHaveLengthOne() {
        const auto orientation = [](Quat value) {
            return faultAfter([&](BodyScene& scene) { scene.bodies[0].pose.orientation = value; });
        };
        QCOMPARE(orientation({0.7071, 0.7071, 0.0, 0.0}), std::string("none"));
        QCOMPARE(orientation({1.0, 1.0, 0.0, 0.0}),
                 std::string("Body \"crate\": the length of the orientation is 1.4142135623730951, but it must be 1."));
        QCOMPARE(orientation({0.0, 0.0, 0.0, 0.0}),
                 std::string("Body \"crate\": the length of the orientation is 0, but it must be 1."));
        QVERIFY(orientation({kNan, 0.0, 0.0, 0.0}).starts_with("Body \"crate\": the length of the orientation is nan"));
    }
    void namesMustBeUnique() {
        QCOMPARE(faultAfter([](BodyScene& scene) { scene.bodies.push_back(scene.bodies[0]); }),
                 std::string("Two bodies have the name \"crate\": numbers 0 and 1, counted from 0."));
        QCOMPARE(faultAfter([](BodyScene& scene) { scene.bodies[0].name.clear(); }),
                 std::string("Body 0 has no name."));
    }
    void invalidShapesAreRejectedWithTheBodysName() {
        const auto shape = [](std::vector<Polytope> hulls) {
            return faultAfter([&](BodyScene& scene) { scene.shapes[0] = std::move(hulls); });
        };
        const Polytope box = test::boxOf({1.0, 1.0, 1.0});
        QCOMPARE(shape({}), std::string("Body \"crate\": it has no hulls."));
        QCOMPARE(shape({box, Polytope{}}), std::string("Body \"crate\": hull 1: There are fewer than four vertices."));
        QCOMPARE(shape({insideOut(box)}), std::string("Body \"crate\": hull 0: Face 0 faces inward or is not convex: "
                                                      "vertex 4 is in front of it."));
        QVERIFY(shape({flattened(box)}).starts_with("Body \"crate\": hull 0: Face "));
        QVERIFY(
            shape({test::boxOf({1.0, 1.0, 1e6})}).starts_with("Body \"crate\": hull 0: the position of a corner is ("));
        QCOMPARE(faultAfter([](BodyScene& scene) { scene.bodies[0].shape = 1; }),
                 std::string("Body \"crate\": there is no shape 1."));
    }
    void massesOutOfRangeAreRejected() {
        QVERIFY(faultAfter([](BodyScene& scene) {
                    scene.shapes[0] = {test::boxOf({0.01, 0.01, 0.01})};
                    scene.bodies[0].density = 1e-6;
                }).starts_with("Body \"crate\": the mass is 1"));
    }
    void gravityMustBeFinite() {
        QCOMPARE(faultAfter([](BodyScene& scene) { scene.gravity.y = kNan; }),
                 std::string("Scene: the gravity is (0, nan, 0), but its length must be at most 10000."));
    }
    void fixedBodiesNeedNoDensity() {
        QCOMPARE(faultAfter([](BodyScene& scene) {
                     scene.bodies[0].kind = BodyKind::Static;
                     scene.bodies[0].density = 0.0;
                 }),
                 std::string("none"));
    }
};

RUBBLE_TEST(BodySceneTest)
#include "BodySceneTest.moc"
