#include "core/play/breaking/Collapsing.h"

#include "core/play/session/Session.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"

#include <cmath>

using namespace rubble;

namespace {

/// Breaks the bonds of the left pier's lower half.
void breakLeftFoot(Session& session) {
    const auto& [id, structure] = *session.scene().structures.begin();
    InstanceDamage damage = session.damage().at(id);
    const auto isOfFoot = [&, graph = &structure->graph](std::uint32_t node) {
        return node != kNone && graph->centres[node].x < -1.5 && graph->centres[node].y < -0.25;
    };
    for (std::uint32_t k = 0; k < structure->graph.bondCount(); ++k) {
        const Bond& bond = structure->graph.bonds[k];
        if (isOfFoot(bond.first) || isOfFoot(bond.second)) damage.broken[k] = true;
    }
    if (const Status applied = session.apply({{id, damage}}); !applied) qFatal("%s", applied.error().message.c_str());
}

}  // namespace

class CollapsingTest : public QObject {
    Q_OBJECT
private slots:
    void portalWithoutOnePierStandsByAnyConnection() {
        Session session = test::sessionOf(test::bondedPortal(0.0, 0.0));
        breakLeftFoot(session);
        for (int k = 0; k < 200; ++k) session.step();
        QVERIFY(test::wallOf(session).isHeld);
        QVERIFY(test::wallOf(session).nodes.size() > 30);
    }
    void portalWithoutOnePierLosesWhatIsBeyondTheSpan() {
        Session session = test::sessionOf(test::bondedPortal(1.5, 0.0));
        for (int k = 0; k < 30; ++k) session.step();
        QVERIFY(session.damage().begin()->second.isIntact());  // 1.5 m from either pier: it stands
        breakLeftFoot(session);
        session.step();
        const PlayBody& held = test::wallOf(session);
        for (const std::uint32_t node : held.nodes) {
            const double x = session.scene().structures.begin()->second->graph.centres[node].x;
            QVERIFY2(!held.isHeld || x > -1.0, QByteArray::number(x));  // fragments are up to a metre wide
        }
        for (int k = 0; k < 300; ++k) session.step();
        std::size_t standing = 0;
        for (const PlayBody& body : session.bodies()) standing += body.isHeld ? body.nodes.size() : 0;
        QVERIFY(standing > 8 && standing < 40);
    }
    void collapseWaitsForItsDelay() {
        Session session = test::sessionOf(test::bondedPortal(1.5, 0.5));
        breakLeftFoot(session);
        session.step();
        const auto heldNodes = [&] {
            std::size_t held = 0;
            for (const PlayBody& body : session.bodies()) held += body.isHeld ? body.nodes.size() : 0;
            return held;
        };
        const std::size_t before = heldNodes();
        for (int k = 0; k < 29; ++k) {
            session.step();
            QCOMPARE(heldNodes(), before);
        }
        session.step();  // half a second after the hit
        QVERIFY(heldNodes() < before);
        QVERIFY(!session.events().splits.empty());
        QCOMPARE(session.events().splits.front().impactorNumber, kNone);
    }
    /// Potential energy counts what is held, so that it is continuous where that comes free.
    void energyIsContinuousWhereAHeldWallFalls() {
        Session session = test::sessionOf(test::bondedPortal(1.5, 0.2));
        const auto energy = [&] {
            const Momenta momenta = session.world().momenta();
            return momenta.kinetic + momenta.potential + session.heldPotential();
        };
        const double start = energy();
        QVERIFY(start > 1e4);
        breakLeftFoot(session);
        double before = start;
        QVERIFY(std::abs(energy() - start) < 1e-5 * start);
        for (int k = 0; k < 25; ++k) {  // before what falls lands
            session.step();
            QVERIFY2(std::abs(energy() - before) < 1e-3 * start, QByteArray::number(energy() - before));
            before = energy();
        }
        QVERIFY(test::wallOf(session).nodes.size() < 40);
    }
};

RUBBLE_TEST(CollapsingTest)
#include "CollapsingTest.moc"
