// Tests core/play/session/Session.cpp and core/play/scene/PlayAsset.cpp for assets of meshes.
#include "core/play/session/Session.h"

#include "core/asset/project/AssetShape.h"
#include "core/play/analysis/SwapAudit.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/MeshAsset.h"
#include "tests/support/play/BondedWalls.h"
#include "tests/support/play/Sessions.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

/// A sculpture of stone that stands on the ground, or is so high above it.
Project sculpture(TriangleMesh mesh, std::uint32_t fragments, BreakAs breakAs, double height = 0.0) {
    Project project;
    const Id stone = addMaterial(project, {.name = "stone", .density = 2400.0});
    Asset asset = meshAsset(std::move(mesh), fragments, project.nextId);
    project.nextId += 2;
    asset.material = stone;
    asset.threshold = 200.0;
    asset.breakAs = breakAs;
    asset.bonding.impulsePerArea = 100.0;
    project.assets.push_back(asset);
    addInstance(project, asset.id, "sculpture", {.position = {0.0, height - boundsOf(asset).min.y, 0.0}});
    return project;
}

double heightOfLowest(const Session& session) {
    double lowest = 1e300;
    for (const PlayBody& body : session.bodies()) {
        if (body.asset == nullptr) continue;
        const Pose pose = session.world().state(body.body).pose;
        for (const Polytope& hull : hullsOf(body)) {
            for (const Vec3& vertex : hull.vertices)
                lowest = std::min(lowest, (pose.position + pose.orientation * vertex).y);
        }
    }
    return lowest;
}

bool isAsleep(const Session& session) {
    for (const PlayBody& body : session.bodies()) {
        if (body.asset != nullptr && !session.world().state(body.body).asleep) return false;
    }
    return true;
}

/// Plays until all sleep; false if that takes longer than 12 s.
bool playsToRest(Session& session) {
    for (int step = 0; step < 720; ++step) {
        session.step();
        if (isAsleep(session) && step > 30) return true;
    }
    return false;
}

}  // namespace

class SolidPlayTest : public QObject {
    Q_OBJECT
private slots:
    void droppedSculpturesBreakWhole() {
        Session session = sessionOf(sculpture(bumpySphere(24), 40, BreakAs::Whole, 3.0));
        QVERIFY(playsToRest(session));
        QVERIFY(session.bodies().size() >= 40);
        QVERIFY(heightOfLowest(session) > -0.01);
    }
    void standingOnesStayWhole() {
        Session session = sessionOf(sculpture(torus(32, 20), 40, BreakAs::Whole));
        for (int step = 0; step < 120; ++step) session.step();
        QCOMPARE(countOf(session, PlayRole::Instance), 1u);
    }
    void bondedOnesLosePartsWhereTheyAreHit() {
        Session session = sessionOf(sculpture(bumpySphere(24), 100, BreakAs::Bonded));
        QVERIFY(session.add(ShotInput{"ball", Throw{.kind = ProjectileKind::Ball,
                                                    .size = {0.3, 0.3, 0.3},
                                                    .mass = 60.0,
                                                    .from = {0.0, 1.2, 3.0},
                                                    .to = {0.0, 1.2, 0.0},
                                                    .speed = 15.0}}));
        for (int step = 0; step < 240; ++step) session.step();
        const std::size_t bodies = session.bodies().size();
        QVERIFY2(bodies > 2 && bodies < 100, qPrintable(QString::number(bodies)));
        QVERIFY(heightOfLowest(session) > -0.01);
    }
    /// Fragments of round bodies, whose hulls have many nearly parallel faces, only touch when they break.
    void breaksOfRoundBodiesAreClean() {
        for (const TriangleMesh& mesh : {bumpySphere(24), bumpySphere(60), torus(40, 16), torus(90, 40)}) {
            for (const int count : {30, 100}) {
                const Project project = sculpture(mesh, count, BreakAs::Whole);
                const auto baked = std::make_shared<const Bake>(*bake(project.assets[0]));
                const Result<SwapAudit> audit = swapAudit(project, baked, {});
                QVERIFY2(audit, audit ? "" : audit.error().message.c_str());
                QVERIFY(audit->lying.fragment.empty());
                for (const Diagnostic& one : audit->diagnostics)
                    QVERIFY2(one.severity == Severity::Note, one.message.c_str());
            }
        }
    }
};

RUBBLE_TEST(SolidPlayTest)
#include "SolidPlayTest.moc"
