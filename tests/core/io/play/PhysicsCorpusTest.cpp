// Tests core/physics/step/Solver.cpp with the scenes of tests/corpus/physics.
#include "core/io/play/BodiesJson.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "core/play/session/Session.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/files/JsonCases.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

using namespace rubble;

namespace {

const QString kCorpus = RUBBLE_SOURCE_DIR "/tests/corpus/physics/";

/// The instances and the ground of a project at the start, as a scene; all of the same material.
Result<BodyScene> sceneOfProject(const std::string& text) {
    const Result<Project> project = readProjectText(text);
    if (!project) return project.error();
    const Result<std::shared_ptr<const PlayScene>> play = playScene(*project);
    if (!play) return play.error();
    const Result<Session> session = Session::start(*play);
    if (!session) return session.error();
    BodyScene scene{.gravity = session->world().gravity()};
    for (const PlayBody& body : session->bodies()) {
        scene.bodies.push_back({.name = session->nameOf(body),
                                .kind = session->world().kind(body.body),
                                .pose = session->world().state(body.body).pose,
                                .shape = static_cast<std::uint32_t>(scene.shapes.size())});
        // The ground reaches farther than a scene of bodies may.
        const bool isGround = body.role == PlayRole::Ground;
        scene.shapes.push_back(isGround ? std::vector{translated(test::boxOf({400.0, 10.0, 400.0}), {0.0, -5.0, 0.0})}
                                        : hullsOf(body));
    }
    return scene;
}

/// A scene of the corpus, and its row in cases.json.
struct PhysicsCase {
    QJsonObject row;
    BodyScene scene;
};

double horizontalDistance(Vec3 a, Vec3 b) { return std::hypot(b.x - a.x, b.z - a.z); }

/// The distance of a point from the line along which a body started, m, horizontally.
double asideOf(const SceneBody& start, Vec3 end) {
    const Vec3 moved = end - start.pose.position, along = start.velocity;
    return std::abs(moved.x * along.z - moved.z * along.x) / std::hypot(along.x, along.z);
}

void addRows(const char* kind) {
    QTest::addColumn<PhysicsCase>("each");
    const QJsonObject cases = test::readJson(kCorpus + "cases.json");
    for (const QJsonValue row : cases[kind].toArray()) {
        const QString file = row["file"].toString();
        const Result<std::string> text = readFile((kCorpus + file).toStdString());
        if (!text) qFatal("%s", text.error().message.c_str());
        const Result<BodyScene> scene = file.endsWith(".rubble") ? sceneOfProject(*text) : readBodyScene(*text);
        if (!scene) qFatal("%s: %s", qPrintable(file), scene.error().message.c_str());
        QTest::newRow(qPrintable(file)) << PhysicsCase{row.toObject(), *scene};
    }
}

}  // namespace
Q_DECLARE_METATYPE(PhysicsCase)

/// Scenes that once went wrong, and others of their kinds. cases.json says how long each is simulated, at how many
/// steps a second, and what must hold at the end: whether all bodies are asleep (`asleep`); at most which `penetration`
/// and horizontal `drift`, m; which `distance`, m, the last body has moved, and how far, m, at most `aside` of the line
/// of its velocity; by which vector, m, it has `moved`; and within which bounds the `energy` stays, as a fraction of
/// that at the start.
class PhysicsCorpusTest : public QObject {
    Q_OBJECT
private slots:
    void energyStaysWithinBounds_data() { addRows("rotation"); }
    void energyStaysWithinBounds() {
        QFETCH(PhysicsCase, each);
        SceneWorld moved = test::worldOf(each.scene, {.sleeping = false});
        const double start = test::energyOf(moved.world);
        const double dt = 1.0 / each.row["hertz"].toDouble();
        double least = 1.0, most = 1.0;
        for (int step = 0; step < std::lround(each.row["seconds"].toDouble() / dt); ++step) {
            moved.world.step(dt);
            const double now = test::energyOf(moved.world) / start;
            QVERIFY(std::isfinite(now));
            least = std::min(least, now);
            most = std::max(most, now);
        }
        qInfo("energy %.4g to %.6g of that at the start", least, most);
        QVERIFY(least >= each.row["energy"][0].toDouble());
        QVERIFY(most <= each.row["energy"][1].toDouble());
    }
    void pilesComeToRest_data() { addRows("piles"); }
    void pilesComeToRest() { bodiesComeToRest(); }
    void stacksStand_data() { addRows("stacks"); }
    void stacksStand() { bodiesComeToRest(); }
    void bodiesSlideAsFarAsFrictionLetsThem_data() { addRows("sliding"); }
    void bodiesSlideAsFarAsFrictionLetsThem() {
        QFETCH(PhysicsCase, each);
        constexpr double kLeast = 0.9;  // of the distance: a contact at an edge may brake the body a little
        constexpr double kMost = 1.04;  // a contact that begins at a seam takes over its load within a step
        const double distance = each.row["distance"].toDouble();
        SceneWorld moved = test::worldOf(each.scene);
        test::simulate(moved.world, each.row["seconds"].toDouble(), 1.0 / each.row["hertz"].toDouble());
        const SceneBody& start = each.scene.bodies.back();
        const Vec3 end = moved.world.state(moved.bodies.back()).pose.position;
        const double gone = horizontalDistance(start.pose.position, end), aside = asideOf(start, end);
        qInfo("%.3f of %.3f m, %.3f m aside", gone, distance, aside);
        QVERIFY(gone >= kLeast * distance);
        QVERIFY(gone <= kMost * distance);
        if (each.row.contains("aside")) QVERIFY(aside <= each.row["aside"].toDouble());
    }
    void slowBodiesMoveOn_data() { addRows("slow"); }
    void slowBodiesMoveOn() {
        QFETCH(PhysicsCase, each);
        const QJsonArray row = each.row["moved"].toArray();
        const Vec3 expected(row[0].toDouble(), row[1].toDouble(), row[2].toDouble());
        SceneWorld moved = test::worldOf(each.scene);
        test::simulate(moved.world, each.row["seconds"].toDouble(), 1.0 / each.row["hertz"].toDouble());
        const Vec3 by = moved.world.state(moved.bodies.back()).pose.position - each.scene.bodies.back().pose.position;
        qInfo("(%.4f, %.4f, %.4f) m", by.x, by.y, by.z);
        QVERIFY(glm::distance(by, expected) <= 0.01 * glm::length(expected));
    }

private:
    static void bodiesComeToRest() {
        QFETCH(PhysicsCase, each);
        SceneWorld moved = test::worldOf(each.scene);
        test::simulate(moved.world, each.row["seconds"].toDouble(), 1.0 / each.row["hertz"].toDouble());
        const std::vector<Pose> poses = test::posesOf(moved);
        const double penetration = penetrationOf(each.scene, poses).largest;
        double drift = 0.0;
        for (std::size_t k = 0; k < poses.size(); ++k) {
            drift = std::max(drift, horizontalDistance(each.scene.bodies[k].pose.position, poses[k].position));
        }
        qInfo("%s, penetration %.1f mm, drift %.1f mm", test::areAllAsleep(moved) ? "asleep" : "awake",
              1e3 * penetration, 1e3 * drift);
        QCOMPARE(test::areAllAsleep(moved), each.row["asleep"].toBool());
        QVERIFY(penetration <= each.row["penetration"].toDouble());
        if (each.row.contains("drift")) QVERIFY(drift <= each.row["drift"].toDouble());
    }
};

RUBBLE_TEST(PhysicsCorpusTest)
#include "PhysicsCorpusTest.moc"
