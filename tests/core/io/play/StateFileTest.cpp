// Tests core/io/play/StateArchive.cpp, core/physics/state/VerifyContacts.cpp, core/physics/state/VerifyState.cpp,
// core/play/session/SavedSession.cpp and core/play/session/VerifySession.cpp.
#include "core/io/play/StateFile.h"

#include "core/io/play/ReplayFile.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/SolidShapes.h"
#include "tests/support/play/BondedWalls.h"
#include "tests/support/play/Damages.h"
#include "tests/support/play/RandomShots.h"
#include "tests/support/play/SealedStates.h"

#include <QTemporaryDir>

using namespace rubble;
using test::fieldsOf;
using test::sealedState;
using test::withFields;

namespace {

bool isLongRun() { return qEnvironmentVariableIsSet("RUBBLE_LONG"); }

std::vector<std::shared_ptr<const PlayScene>> demoScenes() {
    std::vector<std::shared_ptr<const PlayScene>> scenes{test::playSceneOf(test::threeBlocks())};
    for (const char* name : {"pane", "wall-with-openings", "house", "arcade", "dam"}) {
        scenes.push_back(
            test::playSceneOf(*loadProject(std::string(RUBBLE_SOURCE_DIR "/projects/") + name + ".rubble")));
    }
    Project bonded = test::bondedWall(120);
    bonded.assets[0].levels = {{.pattern = test::patternOf(bonded, {UniformScatter{.count = 3}})}};
    bonded.assets[0].bonding.span = 1.0;
    scenes.push_back(test::playSceneOf(bonded));
    Project clustered = test::clusteredWall(120, 6);
    clustered.assets[0].bonding.span = 1.0;
    scenes.push_back(test::playSceneOf(clustered));
    return scenes;
}

Result<Session> sessionOfBytes(const std::shared_ptr<const PlayScene>& scene, const std::string& bytes,
                               const SessionSettings& settings = {}) {
    Result<SavedSession> saved = readStateBytes(bytes, sceneHash(scene->project));
    if (!saved) return saved.error();
    return resumedSession(scene, std::move(*saved), settings);
}

std::string bytesOfSession(const Session& session, StateKind kind = StateKind::Whole) {
    return stateBytes(savedSession(session, kind), sceneHash(session.scene().project));
}

/// A session in the middle of breaking.
Session brokenSession(const std::shared_ptr<const PlayScene>& scene) {
    Session session = *Session::start(scene);
    test::addInput(session, BreakInput{2});
    test::addInput(
        session,
        ShotInput{
            "throw",
            Throw{.size = Vec3(0.2), .mass = 30.0, .from = {4.2, 0.6, 1.0}, .to = {4.2, 0.6, 0.0}, .speed = 20.0}});
    if (!session.add(TimedInput{500, GravityInput{{0.0, -5.0, 0.0}}})) qFatal("not added");
    for (int k = 0; k < 40; ++k) session.step();
    return session;
}

std::string stateFault(const Result<Session>& session) { return session ? std::string() : session.error().message; }

}  // namespace

class StateFileTest : public QObject {
    Q_OBJECT
private slots:
    /// Saved by the version before bonds.
    void readsStatesOfVersion1() {
        Project pane = *loadProject(RUBBLE_SOURCE_DIR "/projects/pane.rubble");
        pane.assets[0].cutAtImpact.reset();  // which it got later, as the next
        pane.materials[0].finish = Finish::Plain;
        const auto scene = test::playSceneOf(pane);
        Result<Session> session = loadState(RUBBLE_SOURCE_DIR "/tests/data/states/pane-version-1.rubblestate", scene);
        QVERIFY2(session.hasValue(), stateFault(session).c_str());
        QCOMPARE(session->stepsDone(), std::uint64_t{60});
        QCOMPARE(session->hash().hex(), std::string("7a8e36ac9d77b6fc92354b776c83fe79"));
        session->step();  // its ground, which ended at 200 m, reaches farther now
        const Box3 ground = session->world().box(session->bodies().front().body);
        QVERIFY(ground.max.x > kMaxCoordinate && ground.min.z < -kMaxCoordinate);
    }
    /// Version 5 has the height of cuts of meshes; without one, states stay those of version 4.
    void heightsOfCutsAreInVersion5Only() {
        Project project = test::floatingBlock();
        project.assets[0].cutAtImpact = CutAtImpact{};
        const auto versionOf = [](const std::string& bytes) { return static_cast<int>(bytes[8]); };
        for (const bool isMesh : {false, true}) {
            if (isMesh) project.assets[0].shape = closedMesh(test::bumpySphere(12)).value();
            const auto scene = test::playSceneOf(project);
            Session session = *Session::start(scene);
            QCOMPARE(versionOf(bytesOfSession(session)), 4);
            test::addInput(session, BreakInput{session.bodies()[1].number});
            for (int k = 0; k < 10; ++k) session.step();
            const SessionDamage damage = session.damage();
            QVERIFY(damage.begin()->second.cut);
            const std::string bytes = bytesOfSession(session);
            QCOMPARE(versionOf(bytes), damage.begin()->second.cut->isInPlane() ? 4 : 5);
            const Result<Session> loaded = sessionOfBytes(scene, bytes);
            QVERIFY2(loaded.hasValue(), stateFault(loaded).c_str());
            QVERIFY(loaded->hash() == session.hash());
            QVERIFY(loaded->damage() == damage);
        }
    }
    void goesOnAsIfItHadNeverBeenSaved() {
        constexpr int kSeed = 23;
        qInfo("seed %d", kSeed);
        Random random(kSeed);
        const auto scenes = demoScenes();
        const int shots = isLongRun() ? 300 : 12;
        std::size_t largest = 0;
        for (int k = 0; k < shots; ++k) {
            const auto& scene = scenes[static_cast<std::size_t>(k) % scenes.size()];
            Session session = *Session::start(scene);
            test::addRandomShots(session, random);
            const std::uint64_t steps = random.below(240);
            for (std::uint64_t step = 0; step < steps; ++step) session.step();
            const std::string bytes = bytesOfSession(session);
            largest = std::max(largest, bytes.size());
            Result<Session> loaded = sessionOfBytes(
                scene, bytes, {.threads = 1 + k % 3, .lanes = k % 2 == 0 ? SimdWidth::Scalar : widestSimd()});
            QVERIFY2(loaded.hasValue(), stateFault(loaded).c_str());
            QVERIFY(loaded->hash() == session.hash());
            QCOMPARE(bytesOfSession(*loaded), bytes);
            for (int step = 1; step <= 300; ++step) {
                session.step();
                loaded->step();
                if (step == 1 || step == 300) QVERIFY2(loaded->hash() == session.hash(), QByteArray::number(k));
            }
            QCOMPARE(loaded->events().diagnostics.size(), session.events().diagnostics.size());
        }
        qInfo("largest: %d bytes", static_cast<int>(largest));
    }
    /// They are cut where they hit, and belong to no instance.
    void fragmentsOfThrownAssetsAreMadeAgain() {
        const auto scene = test::playSceneOf(test::threeBlocks());
        Session session = *Session::start(scene);
        const Throw thrown{.kind = ProjectileKind::Asset,
                           .asset = scene->project.assets[1].id,
                           .from = {0.0, 2.0, 6.0},
                           .to = {0.0, 0.5, 0.0},
                           .speed = 20.0};
        test::addInput(session, ShotInput{"throw", thrown});
        for (int k = 0; k < 40; ++k) session.step();
        QVERIFY(std::ranges::any_of(session.bodies(), [&](const PlayBody& body) {
            return body.role == PlayRole::Debris && session.origins()[body.origin].instance == 0;
        }));
        Result<Session> loaded = sessionOfBytes(scene, bytesOfSession(session));
        QVERIFY2(loaded.hasValue(), stateFault(loaded).c_str());
        for (int k = 0; k < 60; ++k) {
            session.step();
            loaded->step();
        }
        QVERIFY(loaded->hash() == session.hash());
    }
    void filesAreWrittenAndRead() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("moment.rubblestate").toStdString();
        const auto scene = test::playSceneOf(test::threeBlocks());
        const Session session = brokenSession(scene);
        QVERIFY(saveState(path, session, StateKind::Whole).hasValue());
        const Result<Session> loaded = loadState(path, scene);
        QVERIFY(loaded.hasValue());
        QCOMPARE(loaded->stepsDone(), std::uint64_t{40});
        QVERIFY(loaded->hash() == session.hash());
        QVERIFY(loaded->damage() == session.damage());
        const Result<Session> missing = loadState(path + "x", scene);
        QVERIFY(!missing && missing.error().code == ErrorCode::NotFound);
    }
    void sceneOutlivesThrowsAndTests() {
        Project project = test::threeBlocks();
        const ContentHash hash = sceneHash(project);
        project.shots.push_back({.id = project.nextId++, .name = "later", .action = Blast{}});
        project.playTests.push_back({.id = project.nextId++, .name = "later", .state = "now.rubblestate"});
        project.events.maxRecords = 3;
        project.assets[0].requirements.push_back({.event = DropRequirement{}});
        QVERIFY(sceneHash(project) == hash);
        project.gravity.y = -1.6;
        QVERIFY(sceneHash(project) != hash);
    }
    void testsStartFromStatesBesideTheProject() {
        const auto scene = test::playSceneOf(test::threeBlocks());
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString();
        const Session session = brokenSession(scene);
        QVERIFY(saveState(path / "now.rubblestate", session, StateKind::Whole).hasValue());
        const ContentHash hash = sceneHash(scene->project);
        QVERIFY(*loadStart({.name = "a"}, path, hash) == nullptr);
        const auto state = loadStart({.name = "a", .state = "now.rubblestate"}, path, hash);
        QVERIFY(state && (*state)->hash == session.hash());
        const auto missing = loadStart({.name = "a", .state = "none.rubblestate"}, path, hash);
        QVERIFY(!missing && missing.error().code == ErrorCode::NotFound);
        QVERIFY2(missing.error().message.starts_with("Test \"a\": "), missing.error().message.c_str());
        std::filesystem::create_symlink(path / "now.rubblestate", path / "link.rubblestate");
        const auto link = loadStart({.name = "a", .state = "link.rubblestate"}, path, hash);
        QVERIFY(!link && link.error().message.find("is a link, which may lead to any file") != std::string::npos);
    }
    void anotherProjectIsRefusedWithBothHashes() {
        const auto scene = test::playSceneOf(test::threeBlocks());
        Project other = scene->project;
        other.instances[0].pose.position.x += 0.1;
        const std::string message =
            stateFault(sessionOfBytes(test::playSceneOf(other), bytesOfSession(brokenSession(scene))));
        QVERIFY2(message.find(sceneHash(other).hex()) != std::string::npos, message.c_str());
        QVERIFY2(message.find(sceneHash(scene->project).hex()) != std::string::npos, message.c_str());
    }
    void anotherBakeIsRefused() {
        const auto scene = test::playSceneOf(test::threeBlocks());
        SavedSession saved = savedSession(brokenSession(scene), StateKind::Whole);
        saved.bakes.begin()->second.low ^= 1;
        const std::string message = stateFault(resumedSession(scene, saved));
        QVERIFY2(message.starts_with("The state is of another bake of asset \"block\", "), message.c_str());
    }
    void changedFilesAreRefused() {
        constexpr int kSeed = 29;
        qInfo("seed %d", kSeed);
        Random random(kSeed);
        const auto scene = test::playSceneOf(test::threeBlocks());
        const std::string bytes = bytesOfSession(brokenSession(scene));
        for (int k = 0; k < (isLongRun() ? 5000 : 500); ++k) {
            std::string changed = bytes;
            const std::size_t place = random.below(bytes.size());
            changed[place] = static_cast<char>(changed[place] ^ static_cast<char>(1 + random.below(255)));
            QVERIFY(!stateFault(sessionOfBytes(scene, changed)).empty());
            QVERIFY(!stateFault(sessionOfBytes(scene, bytes.substr(0, place))).empty());
            QVERIFY(!stateFault(sessionOfBytes(scene, sealedState(bytes.substr(0, place)))).empty());
        }
    }
    /// Where the checksum fits, what contradicts itself is refused with its place; what does not can be simulated.
    void wrongContentIsRefusedWithItsPlace() {
        constexpr int kSeed = 31;
        qInfo("seed %d", kSeed);
        Random random(kSeed);
        const auto scene = test::playSceneOf(test::threeBlocks());
        const std::string bytes = bytesOfSession(brokenSession(scene)), fields = fieldsOf(bytes);
        QCOMPARE(withFields(bytes, fields), bytes);
        int refused = 0;
        const int rounds = isLongRun() ? 10000 : 600;
        for (int k = 0; k < rounds; ++k) {
            std::string changed = fields;
            const std::size_t place = random.below(fields.size());
            changed[place] = static_cast<char>(changed[place] ^ static_cast<char>(1u << random.below(8)));
            if (random.below(4) == 0) changed[place] = static_cast<char>(random.below(256));
            if (random.below(20) == 0) changed.resize(place);
            Result<Session> session = sessionOfBytes(scene, withFields(bytes, changed), {.checksEnergy = false});
            if (!session) {
                ++refused;
                QVERIFY2(session.error().message.starts_with("The state"), stateFault(session).c_str());
                continue;
            }
            for (int step = 0; step < 5; ++step) session->step();
        }
        qInfo("%d of %d refused", refused, rounds);
        QVERIFY(refused > rounds / 10);
    }
    void thePlaceOfAWrongIndexIsNamed() {
        const auto scene = test::playSceneOf(test::threeBlocks());
        const SavedSession saved = savedSession(brokenSession(scene), StateKind::Whole);
        SavedSession wrong = saved;
        wrong.state.bodies[3].fragment = 4000;
        QCOMPARE(stateFault(resumedSession(scene, wrong)),
                 std::string("The state cannot be used: bodies[3].fragment is wrong; save it again."));
        wrong = saved;
        auto& world = std::get<WorldState>(wrong.world);
        const std::uint32_t last = saved.state.bodies.back().body.index;
        world.proxies[world.bodies[last].firstProxy].next = 7000;
        const std::string fault = stateFault(resumedSession(scene, wrong));
        const std::string place = "world.bodies[" + std::to_string(last) + "].firstProxy is wrong";
        QVERIFY2(fault.find(place) != std::string::npos, fault.c_str());
        wrong = saved;
        std::get<WorldState>(wrong.world).poses[2].centre.x += 0.5f;
        QVERIFY(stateFault(resumedSession(scene, wrong)).find("have the hash") != std::string::npos);
    }
    void bodiesOfASmallStateSleepWhereTheyRest() {
        const auto scene = test::playSceneOf(test::threeBlocks());
        Session session = brokenSession(scene);
        for (int k = 0; k < 400; ++k) session.step();
        const std::string bytes = bytesOfSession(session, StateKind::Small);
        QVERIFY(bytes.size() < bytesOfSession(session).size() / 5);
        Result<Session> loaded = sessionOfBytes(scene, bytes);
        QVERIFY2(loaded.hasValue(), stateFault(loaded).c_str());
        QCOMPARE(bytesOfSession(*loaded, StateKind::Small), bytes);
        QVERIFY(loaded->damage() == session.damage());
        QCOMPARE(loaded->bodies().size(), session.bodies().size());
        for (const PlayBody& body : loaded->bodies()) {
            const bool isDynamic = loaded->world().kind(body.body) == BodyKind::Dynamic;
            QCOMPARE(loaded->world().state(body.body).asleep, isDynamic);
        }
        for (int k = 0; k < 600; ++k) loaded->step();
        for (std::size_t k = 0; k < session.bodies().size(); ++k) {
            const PlayBody &before = session.bodies()[k], &after = loaded->bodies()[k];
            QCOMPARE(after.number, before.number);
            QCOMPARE(after.fragment, before.fragment);
            const BodyState now = loaded->world().state(after.body);
            QVERIFY(now.asleep || loaded->world().kind(after.body) == BodyKind::Static);
            QVERIFY(glm::distance(now.centre, session.world().state(before.body).centre) < 1e-3);
        }
        test::addInput(*loaded, ShotInput{"blast", Blast{.at = {2.0, 0.2, 0.0}, .impulse = 3000.0}});
        loaded->step();
        QVERIFY(std::ranges::any_of(loaded->bodies(),
                                    [&](const PlayBody& body) { return !loaded->world().state(body.body).asleep; }));
    }
};

RUBBLE_TEST(StateFileTest)
#include "StateFileTest.moc"
