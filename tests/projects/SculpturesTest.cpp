#include "core/asset/checks/VerifyBake.h"
#include "core/asset/checks/VerifyMeshes.h"
#include "core/asset/checks/VerifyProject.h"
#include "core/io/project/ProjectFile.h"
#include "core/play/analysis/SwapAudit.h"
#include "core/play/session/PlayTestRun.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"

#include <QTest>

#include <algorithm>
#include <limits>
#include <set>
#include <string>

using namespace rubble;

namespace {

/// The project as it is stored: that it is what its builder builds, ProjectFilesTest checks.
const Project& stored() {
    static const Project project = loadProject(RUBBLE_SOURCE_DIR "/projects/sculptures.rubble").value();
    return project;
}

/// The lowest corner of the hulls of a body, m.
double lowestCorner(const Session& session, const PlayBody& body) {
    const World& world = session.world();
    const BodyState state = world.state(body.body);
    double lowest = std::numeric_limits<double>::max();
    for (const PlacedHull& placed : world.shape(body.body).hulls) {
        for (std::size_t k = 0; k < placed.hull->corners.x.size(); ++k) {
            const Vec3 arm(placed.offset + placed.hull->corner(static_cast<int>(k)));
            lowest = std::min(lowest, (state.centre + state.pose.orientation * arm).y);
        }
    }
    return lowest;
}

/// The instances and thrown assets that break or lose parts within some steps, by name.
std::set<std::string> brokenWithin(Session& session, int steps) {
    std::set<std::string> broken;
    const auto add = [&](const auto& events) {
        for (const auto& event : events) {
            const std::string name = session.nameOf(event.body);
            broken.insert(name.substr(0, name.find('/')));
        }
    };
    for (int k = 0; k < steps; ++k) {
        session.step();
        add(session.events().breaks);
        add(session.events().splits);
    }
    return broken;
}

}  // namespace

/// The demo of closed meshes: a column, a vase and a head.
class SculpturesTest : public QObject {
    Q_OBJECT
private slots:
    void meshesAreOfTheSizeOfSculptures() {
        std::size_t meshes = 0;
        for (const Asset& asset : stored().assets) {
            if (asset.isPrism()) continue;
            const std::size_t triangles = asset.mesh()->mesh.triangles.size();
            QVERIFY2(triangles >= 5000 && triangles <= 60'000, asset.name.c_str());
            ++meshes;
        }
        QCOMPARE(meshes, std::size_t{3});
    }
    void bakesHaveNoFaults() {
        for (const Asset& asset : stored().assets) {
            const Result<Bake> baked = bake(asset);
            QVERIFY(baked.hasValue());
            for (const Diagnostic& one : baked->diagnostics)
                QVERIFY2(one.severity == Severity::Note, one.message.c_str());
            QCOMPARE(verifyBake(*baked, asset).value_or(""), std::string());
            QCOMPARE(verifyMeshes(*baked, asset).value_or(""), std::string());
            if (!asset.isPrism()) QVERIFY(baked->fragmentCount() >= 40 && baked->fragmentCount() <= 100);
        }
    }
    /// Curved surfaces collide as hulls, which leave some overlap; what is not held falls.
    void fragmentsStayWhereTheyBreak() {
        QCOMPARE(verifyProject(stored()).value_or(""), std::string());
        const auto scene = test::playSceneOf(stored());
        for (const auto& [id, asset] : scene->assets) {
            const Result<SwapAudit> audit = swapAudit(stored(), asset);
            QVERIFY(audit.hasValue());
            QVERIFY2(audit->isClean(), audit->isClean() ? "" : audit->diagnostics[0].message.c_str());
        }
    }
    /// What breaks comes to rest, on the ground.
    void shotsBreakSculpturesWhichComeToRest_data() {
        QTest::addColumn<QString>("shot");
        QTest::addColumn<QString>("broken");
        QTest::newRow("ball") << "ball at the column"
                              << "column";
        QTest::newRow("thrown") << "vase thrown at the column"
                                << "vase thrown at the column";
        QTest::newRow("dropped") << "vase dropped"
                                 << "vase dropped";
        QTest::newRow("hammer") << "hammer on the face"
                                << "head";
    }
    void shotsBreakSculpturesWhichComeToRest() {
        QFETCH(QString, shot);
        QFETCH(QString, broken);
        Session session = test::sessionOf(stored());
        const auto found = std::ranges::find(stored().shots, shot.toStdString(), &Shot::name);
        QVERIFY(session.add(*found).hasValue());
        const std::set<std::string> names = brokenWithin(session, kSteps);
        QVERIFY(names.contains(broken.toStdString()));
        double lowest = 0.0;
        for (const PlayBody& body : session.bodies()) {
            const BodyState state = session.world().state(body.body);
            if (session.world().kind(body.body) != BodyKind::Dynamic) continue;
            QVERIFY2(state.asleep, session.nameOf(body).c_str());
            lowest = std::min(lowest, lowestCorner(session, body));
        }
        qInfo("%zu bodies, the lowest point is %.4f m above the ground", session.bodies().size(), lowest);
        QVERIFY(lowest > -0.01);
    }
    void passesItsTests() {
        const auto scene = test::playSceneOf(stored());
        QCOMPARE(scene->project.playTests.size(), std::size_t{5});
        for (const PlayTest& test : scene->project.playTests) {
            const Result<PlayTestOutcome> outcome = runPlayTest(scene, test);
            QVERIFY(outcome.hasValue());
            for (const ExpectationOutcome& one : outcome->expectations)
                QVERIFY2(one.isMet, (test.name + ": " + one.expected + ": " + one.seen).c_str());
        }
    }

private:
    static constexpr int kSteps = 2400;
};

RUBBLE_TEST(SculpturesTest)
#include "SculpturesTest.moc"
