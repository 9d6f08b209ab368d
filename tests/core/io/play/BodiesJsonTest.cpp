#include "core/io/play/BodiesJson.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

constexpr const char* kCorners = "[[0,0,0],[1,0,0],[0,1,0],[0,0,1]]";

/// A body with a tetrahedron and additional members.
std::string bodyJson(const std::string& name, const std::string& members = {}) {
    return "{\"name\":\"" + name + "\",\"hulls\":[" + kCorners + "]" + (members.empty() ? "" : "," + members) + "}";
}

std::string sceneJson(const std::string& bodies) { return "{\"bodies\":[" + bodies + "]}"; }

std::string sceneFault(const std::string& text) { return errorText(readBodyScene(text)); }

/// Returns the error for a body with these members.
std::string bodyFault(const std::string& members) { return sceneFault(sceneJson(bodyJson("crate", members))); }

ErrorCode sceneErrorCode(const std::string& json) { return readBodyScene(json).error().code; }

}  // namespace

class BodiesJsonTest : public QObject {
    Q_OBJECT
private slots:
    void everyMemberIsRead() {
        const Result<BodyScene> scene = readBodyScene(
            R"({"gravity":[0,-1,0.5],"bodies":[{"name":"crate","kind":"kinematic","density":700,"friction":0.25,)"
            R"("restitution":0.5,"position":[1,2,3],"orientation":[0,0,1,0],"velocity":[4,5,6],)"
            R"("angularVelocity":[7,8,9],"hulls":[)" +
            std::string(kCorners) + "]}]}");
        QVERIFY2(scene, scene ? "" : scene.error().message.c_str());
        QCOMPARE(scene->gravity, Vec3(0.0, -1.0, 0.5));
        const SceneBody expected{.name = "crate",
                                 .kind = BodyKind::Kinematic,
                                 .density = 700.0,
                                 .friction = 0.25,
                                 .restitution = 0.5,
                                 .pose = {{1.0, 2.0, 3.0}, {0.0, 0.0, 1.0, 0.0}},
                                 .velocity = {4.0, 5.0, 6.0},
                                 .angularVelocity = {7.0, 8.0, 9.0}};
        QVERIFY(scene->bodies == std::vector{expected});
        QCOMPARE(scene->shapes.size(), std::size_t{1});
        QCOMPARE(scene->shapes[0][0].faces.size(), std::size_t{4});
    }
    void optionalMembersHaveDefaults() {
        const Result<BodyScene> scene = readBodyScene(sceneJson(bodyJson("crate")));
        QVERIFY(scene);
        QCOMPARE(scene->gravity, Vec3(0.0, -9.81, 0.0));
        QVERIFY(scene->bodies == std::vector{SceneBody{.name = "crate"}});
    }
    void bodiesWithEqualHullsShareThem() {
        const std::string larger = R"({"name":"c","hulls":[[[0,0,0],[2,0,0],[0,2,0],[0,0,2]]]})";
        const Result<BodyScene> scene = readBodyScene(sceneJson(bodyJson("a") + "," + larger + "," + bodyJson("b")));
        QVERIFY(scene);
        QCOMPARE(scene->shapes.size(), std::size_t{2});
        QCOMPARE(scene->bodies[0].shape, scene->bodies[2].shape);
        QCOMPARE(scene->bodies[1].shape, 1u);
    }
    void sceneMayBeEmpty() {
        const Result<BodyScene> scene = readBodyScene(R"({"bodies":[]})");
        QVERIFY(scene && scene->bodies.empty());
    }

    void errorsNameBodyAndPath() {
        QCOMPARE(bodyFault(R"("density":"heavy")"),
                 std::string("Body \"crate\": bodies[0].density: expected a number, found \"heavy\"."));
        QCOMPARE(
            bodyFault(R"("position":[0,1])"),
            std::string("Body \"crate\": bodies[0].position: expected an array of 3 numbers, found an array of 2."));
        QCOMPARE(bodyFault(R"("kind":"solid")"),
                 std::string("Body \"crate\": bodies[0].kind: expected \"static\", \"kinematic\" or \"dynamic\", found "
                             "\"solid\"."));
        QCOMPARE(bodyFault(R"("mass":3)"), std::string("Body \"crate\": bodies[0]: unknown key \"mass\"."));
        QCOMPARE(sceneFault(sceneJson(R"({"name":"crate"})")),
                 std::string("Body \"crate\": bodies[0]: the key \"hulls\" is missing."));
        QCOMPARE(sceneFault(sceneJson("7")), std::string("bodies[0]: expected an object, found 7."));
        QCOMPARE(sceneFault(sceneJson(R"({"hulls":[]})")), std::string("bodies[0]: the key \"name\" is missing."));
        QCOMPARE(sceneFault("{}"), std::string("The document: the key \"bodies\" is missing."));
        QCOMPARE(sceneErrorCode("{"), ErrorCode::BadInput);
    }
    void nanAndInfinityAreRejectedWithTheirPath() {
        QCOMPARE(bodyFault(R"("position":[0,NaN,0])"),
                 std::string("Body \"crate\": bodies[0].position[1]: expected a number, found \"NaN\"."));
        QCOMPARE(bodyFault(R"("density":-Infinity)"),
                 std::string("Body \"crate\": bodies[0].density: expected a number, found \"-Infinity\"."));
        const std::string named = "{\"name\":\"NaN \\\" NaN\",\"hulls\":[[[0,0,0],[NaN,0,0],[0,1,0],[0,0,1]]]}";
        QCOMPARE(sceneFault(sceneJson(named)),
                 std::string("Body \"NaN \" NaN\": bodies[0].hulls[0][1][0]: expected a number, found \"NaN\"."));
    }
    void invalidHullsAreRejectedWithTheBodysName() {
        const auto hulls = [](const std::string& value) {
            return sceneFault(sceneJson(R"({"name":"crate","hulls":)" + value + "}"));
        };
        QCOMPARE(hulls("[]"), std::string("Body \"crate\": it has no hulls."));
        QCOMPARE(hulls("[[]]"), std::string("Body \"crate\": hull 0: A hull needs at least four points; there are 0."));
        const std::string flat = "[[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]]";
        QCOMPARE(hulls(flat),
                 std::string("Body \"crate\": hull 0: The 4 points lie in one plane, so they have no convex hull."));
        QCOMPARE(sceneErrorCode(sceneJson(R"({"name":"crate","hulls":)" + flat + "}")), ErrorCode::Degenerate);
    }
    void invalidValuesAreRejectedWithTheBodysName() {
        QVERIFY(bodyFault(R"("density":-1)").starts_with("Body \"crate\": the density is -1"));
        QVERIFY(
            sceneFault(sceneJson(bodyJson("a") + "," + bodyJson("a"))).starts_with("Two bodies have the name \"a\""));
    }
    void projectsAreRejected() {
        const std::string project = R"({"format":"rubble-project","version":1})";
        QCOMPARE(sceneFault(project),
                 std::string("The document has a format, such as a project, and is not a scene of bodies."));
        QCOMPARE(sceneErrorCode(project), ErrorCode::Unsupported);
    }
};

RUBBLE_TEST(BodiesJsonTest)
#include "BodiesJsonTest.moc"
