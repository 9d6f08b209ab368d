#include "core/play/breaking/PartRemoval.h"

#include "core/play/session/Session.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"
#include "tests/support/play/MortarPortal.h"

#include <algorithm>

using namespace rubble;
using test::addInput;

namespace {

bool isHeldOf(const Session& session, std::uint32_t number) {
    return session.body(number) != nullptr && session.body(number)->isHeld;
}

}  // namespace

class PartRemovalTest : public QObject {
    Q_OBJECT
private slots:
    void whatStandsOnAnotherPierStays() {
        Session session = test::sessionOf(test::mortarPortal());
        const std::vector<Instance>& instances = session.scene().project.instances;
        addInput(session, RemoveInput{{instances[0].id, {}}});
        session.step();
        QVERIFY(session.body(1) == nullptr);
        QVERIFY(isHeldOf(session, 2) && isHeldOf(session, 3));
    }
    /// A fragment of a fragment that came off, whose numbers in the bake do not begin at 0.
    void fragmentsOfLevelsAreRemovedFromTheirBody() {
        Project project = test::bondedWall(12);
        project.assets[0].levels = {{.pattern = test::patternOf(project, {UniformScatter{.count = 6}})}};
        Session session = test::sessionOf(project);
        addInput(session, BreakInput{1});
        session.step();
        const PlayBody& whole = test::wallOf(session);
        const std::uint32_t count = whole.bondedFracture()->count, last = whole.bondedFracture()->first + count - 1;
        QVERIFY(count > 3);
        const Bake& bake = *whole.asset->bake;
        addInput(session, RemoveInput{{project.instances[0].id, {bake.fragmentPath(last)}}});
        session.step();
        QCOMPARE(session.events().taken.size(), std::size_t{1});
        QVERIFY(test::wallOf(session).nodes.size() > 1 && test::wallOf(session).nodes.size() < count);
        QVERIFY(!std::ranges::binary_search(test::wallOf(session).nodes, count - 1));
    }
    void whatNothingCarriesFalls() {
        Session session = test::sessionOf(test::mortarPortal());
        const std::vector<Instance>& instances = session.scene().project.instances;
        for (const int pier : {0, 1}) addInput(session, RemoveInput{{instances[pier].id, {}}});
        const double before = session.world().state(session.body(3)->body).centre.y;
        for (int k = 0; k < 60; ++k) session.step();
        QVERIFY(session.body(1) == nullptr && session.body(2) == nullptr);
        QVERIFY(!isHeldOf(session, 3));
        QVERIFY(session.world().state(session.body(3)->body).centre.y < before - 1.0);
    }
    void fragmentsOfAWall() {
        Session session = test::sessionOf(test::bondedWall());
        const Id wall = session.scene().project.instances[0].id;
        const Bake& bake = *test::onlyAsset(session.scene()).bake;
        addInput(session, RemoveInput{{wall, {bake.fragmentPath(7), bake.fragmentPath(31)}}});
        for (int k = 0; k < 60; ++k) session.step();
        std::size_t present = 0;
        for (const PlayBody& body : session.bodies()) {
            const std::vector<std::uint32_t> fragments = fragmentsOf(body);
            QVERIFY(!std::ranges::binary_search(fragments, 7u) && !std::ranges::binary_search(fragments, 31u));
            present += fragments.size();
        }
        QVERIFY(present >= 297 && present <= 298);
    }
    void whatCannotBeRemoved() {
        Session session = test::sessionOf(test::bondedWall());
        const Id wall = session.scene().project.instances[0].id;
        QCOMPARE(errorText(session.add(RemoveInput{{99, {}}})), std::string("Cannot remove: there is no instance 99."));
        QCOMPARE(errorText(session.add(RemoveInput{{wall, {"5.9999"}}})),
                 std::string("Cannot remove \"wall/5.9999\": there is no such fragment."));
        Session block = test::sessionOf(test::floatingBlock());
        const std::string path = test::onlyAsset(block.scene()).bake->fragmentPath(0);
        QVERIFY(errorText(block.add(RemoveInput{{block.scene().project.instances[0].id, {path}}}))
                    .find("only fragments of bonded instances can be removed.") != std::string::npos);
    }
};

RUBBLE_TEST(PartRemovalTest)
#include "PartRemovalTest.moc"
