// Tests core/play/queries/ChangeRecorder.cpp against Recast, which knows nothing of it.
#include "core/play/queries/ChangeRecorder.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"

#if RUBBLE_HAS_RECAST
#include "tests/support/play/NavigationMesh.h"
#endif

#include <cstdio>
#include <set>

using namespace rubble;

namespace {

constexpr int kAlong = 16;      // stacks
constexpr double kApart = 2.0;  // m
constexpr int kHigh = 4;        // blocks: 1,024 in all

/// Stacks of blocks on a square.
Project stacks() {
    Project project;
    const Id stone = test::addMaterial(project, {.name = "stone"});
    const Id block = test::addAsset(project,
                                    {.name = "block",
                                     .material = stone,
                                     .shape = Prism{{rectangle({-0.5, -0.25}, {0.5, 0.25}), {}}, 0.75},
                                     .threshold = 1e9},
                                    {UniformScatter{.count = 3}});
    for (int stack = 0; stack < kAlong * kAlong; ++stack) {
        const double x = kApart * (stack % kAlong - kAlong / 2), z = kApart * (stack / kAlong - kAlong / 2);
        for (int height = 0; height < kHigh; ++height) {
            const std::string name = std::to_string(stack) + "." + std::to_string(height);
            test::addInstance(project, block, name, {.position = {x, 0.25 + 0.5 * height, z}});
        }
    }
    project.debris = {.lifetime = 0.4, .fade = 0.0};  // so that the last tiles of a shot are of places left empty
    return project;
}

}  // namespace

class NavigationMeshTest : public QObject {
    Q_OBJECT
private slots:
    /// A thousand blocks break in four shots; only tiles that meet a changed box are built again.
    void tilesAtChangedBoxesMakeTheMeshOfTheWholeScene() {
#if RUBBLE_HAS_RECAST
        Session session = test::sessionOf(stacks());
        ChangeRecorder recorder(session);
        test::NavigationMesh kept(20.0, 20), whole(20.0, 20);
        kept.buildAll(test::trianglesOf(session));
        std::size_t breaks = 0, rebuilt = 0, changed = 0, differing = 0;
        std::uint64_t seen = 0;
        const std::vector<PlayBody> blocks = session.bodies();
        for (int shot = 0; shot < 4; ++shot) {
            breakQuarter(session, blocks, shot);
            for (int step = 0; step < 30; ++step) {
                session.step();
                recorder.add(session);
                breaks += session.events().breaks.size();
                if (step != 20 && step != 29) continue;
                const test::SceneTriangles scene = test::trianglesOf(session);
                std::set<std::size_t> tiles;
                for (const Box3& box : recorder.changedBoxes(seen)) {
                    for (const std::size_t tile : kept.tilesAt(box)) tiles.insert(tile);
                }
                seen = session.stepsDone();
                const std::vector<std::string> before = kept.tiles();
                for (const std::size_t tile : tiles) kept.build(scene, tile);
                whole.buildAll(scene);
                rebuilt += tiles.size();
                for (std::size_t tile = 0; tile < before.size(); ++tile) {
                    changed += whole.tiles()[tile] != before[tile] ? 1 : 0;
                    differing += whole.tiles()[tile] != kept.tiles()[tile] ? 1 : 0;
                }
            }
        }
        std::printf("%zu breaks, %zu of %zu tiles built again, %zu of them changed\n", breaks, rebuilt,
                    8 * whole.tiles().size(), changed);
        QCOMPARE(differing, 0u);
        QVERIFY(breaks >= 1000);
        QVERIFY(changed > 300);  // the comparison is of something
        QVERIFY(rebuilt < 8 * whole.tiles().size() * 6 / 10);
#else
        QSKIP("Recast is not installed; tools/setup test installs it.");
#endif
    }

private:
    /// Breaks the blocks of a quarter of the square, and sets off a blast in it.
    static void breakQuarter(Session& session, const std::vector<PlayBody>& blocks, int quarter) {
        for (const PlayBody& block : blocks) {
            const std::uint32_t stack = (block.number - 1) / kHigh;
            if (block.role != PlayRole::Instance || static_cast<int>(stack) / (kAlong * kAlong / 4) != quarter)
                continue;
            test::addInput(session, BreakInput{block.number});
        }
        const double z = kApart * (kAlong / 4 * quarter + kAlong / 8 - kAlong / 2);
        test::addInput(session, ShotInput{"blast", Blast{.at = {1.0, 0.5, z}, .impulse = 500.0, .radius = 4.0}});
    }
};

RUBBLE_TEST(NavigationMeshTest)
#include "NavigationMeshTest.moc"
