#include "core/play/session/StandingParts.h"

#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"

using namespace rubble;
using test::addInput;

namespace {

constexpr Id kAny = 0;

/// A wall of 4 x 3 square fragments of 1 m.
Project squaresWall() {
    Project project = test::bondedWall();
    project.assets[0].pattern = test::patternOf(project, {JitteredGrid{.columns = 4, .rows = 3, .jitter = 0.0}});
    return project;
}

/// The fragment of a wall at a point in its plane.
std::uint32_t fragmentNear(const PlayAsset& asset, Vec2 at) {
    std::uint32_t nearest = 0;
    for (std::uint32_t k = 0; k < asset.fragments.size(); ++k) {
        const auto distance = [&](std::uint32_t one) {
            return glm::distance(Vec2(centreInAsset(asset.fragments[one])), at);
        };
        if (distance(k) < distance(nearest)) nearest = k;
    }
    return nearest;
}

/// All fragments of a wall but those at some points.
std::vector<std::uint32_t> allBut(const PlayAsset& asset, const std::vector<Vec2>& points) {
    std::vector<std::uint32_t> standing;
    for (std::uint32_t k = 0; k < asset.fragments.size(); ++k) standing.push_back(k);
    for (const Vec2& point : points) std::erase(standing, fragmentNear(asset, point));
    return standing;
}

}  // namespace

class StandingPartsTest : public QObject {
    Q_OBJECT
private slots:
    void allOfAStandingWall() {
        Session session = test::sessionOf(test::bondedWall());
        const Id wall = session.scene().project.instances[0].id;
        session.step();
        const StandingParts parts = standingParts(session, wall);
        QVERIFY(std::abs(parts.volume - 3.0) < 1e-9);
        QCOMPARE(parts.fragments.size(), std::size_t{300});
        QVERIFY(wall != kAny);
    }
    void notWhatABallKnockedOut() {
        Session session = test::sessionOf(test::bondedWall());
        const Id wall = session.scene().project.instances[0].id;
        addInput(session, ShotInput{"ball", test::ballAtWall()});
        for (int k = 0; k < 120; ++k) session.step();
        const StandingParts parts = standingParts(session, wall);
        std::size_t held = 0;
        for (const PlayBody& body : session.bodies()) held += body.isHeld ? body.nodes.size() : 0;
        QVERIFY(parts.fragments.size() >= held && parts.fragments.size() < 300);
        QVERIFY(parts.volume > 2.0 && parts.volume < 3.0);
    }
    void widthsOfHoles() {
        const auto scene = test::playSceneOf(squaresWall());
        const PlayStructure& structure = *scene->structures.begin()->second;
        const PlayAsset& asset = *structure.asset;
        QCOMPARE(asset.fragments.size(), std::size_t{12});
        const auto widthWithout = [&](const std::vector<Vec2>& lost) {
            return holeWidth(structure, allBut(asset, lost));
        };
        QCOMPARE(widthWithout({}), 0.0);
        QVERIFY(std::abs(widthWithout({{0.5, 0.0}}) - std::sqrt(2.0)) < 1e-9);
        QVERIFY(std::abs(widthWithout({{0.5, 0.0}, {-0.5, 0.0}}) - std::sqrt(5.0)) < 1e-9);
        // They meet at a corner, and are apart.
        QVERIFY(std::abs(widthWithout({{0.5, 0.0}, {-0.5, 1.0}}) - std::sqrt(2.0)) < 1e-9);
        QVERIFY(std::abs(widthWithout({{-1.5, -1.0}, {1.5, 1.0}}) - std::sqrt(2.0)) < 1e-9);
        QVERIFY(std::abs(holeWidth(structure, {}) - 5.0) < 1e-9);
    }
};

RUBBLE_TEST(StandingPartsTest)
#include "StandingPartsTest.moc"
