#include "core/play/state/EnergyAudit.h"

#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"

#include <limits>

using namespace rubble;

namespace {

std::vector<EnergyChange> changesOf(const Session& session) {
    std::vector<EnergyChange> changes;
    for (const EnergyEntry& entry : session.events().energy) changes.push_back(entry.change);
    return changes;
}

Session steppedOnce(const Project& project, const PlayInput& input) {
    Session session = test::sessionOf(project, {.sleeping = false});
    test::addInput(session, input);
    session.step();
    return session;
}

const ShotInput kOffCentreBlow{"blow", Hammer{.at = {0.3, 5.0, 0.25}, .impulse = {0.0, 0.0, -400.0}}};

}  // namespace

class EnergyAuditTest : public QObject {
    Q_OBJECT
private slots:
    void onlySourcesMayAddEnergy() {
        QVERIFY((EnergyEntry{.before = 100.0, .after = 101.0}.isConserved()));
        QVERIFY((EnergyEntry{.before = 100.0, .after = 20.0}.isConserved()));
        QVERIFY(!(EnergyEntry{.before = 100.0, .after = 101.1}.isConserved()));
        QVERIFY((EnergyEntry{.before = 100.0, .given = 50.0, .after = 151.0}.isConserved()));
        QVERIFY(!(EnergyEntry{.before = 100.0, .given = 50.0, .after = 152.0}.isConserved()));
        QVERIFY((EnergyEntry{.after = 0.5, .rounding = 1.0}.isConserved()));
        QVERIFY(!(EnergyEntry{.after = 1e-6}.isConserved()));
        QVERIFY(!(EnergyEntry{.after = std::numeric_limits<double>::quiet_NaN()}.isConserved()));
    }
    /// Two ways to the same energy: by inertia in the body's axes, and by the world's angular momentum.
    void kineticEnergyIsThatOfTheWorld() {
        const Session session = steppedOnce(test::floatingBlock(7), kOffCentreBlow);
        const double world = session.world().momenta().kinetic, audited = kineticEnergy(session.world());
        QVERIFY(world > 1.0);
        QVERIFY2(std::abs(audited - world) < 1e-5 * world, QByteArray::number(audited - world));
    }
    void throwGivesItsKineticEnergy() {
        const Session session = steppedOnce(test::floatingBlock(), ShotInput{"box", test::throwAtBlock(20.0, 12.0)});
        QCOMPARE(changesOf(session), std::vector{EnergyChange::Throw});
        QVERIFY(std::abs(session.events().energy[0].given - 1440.0) < 1e-3);
        QVERIFY(std::abs(session.events().energy[0].after - 1440.0) < 1e-2);
    }
    void blowIsWorkOnTheWholeAndOnFragments() {
        const Session session = steppedOnce(test::floatingBlock(), kOffCentreBlow);
        QCOMPARE(changesOf(session), (std::vector{EnergyChange::Blow, EnergyChange::Swap, EnergyChange::Blow}));
        const EnergyAudit& audit = session.events().energy;
        QVERIFY(audit[0].given > 0.0 && audit[2].given > 0.0);
        QVERIFY(audit[0].given + audit[2].given <= 0.5 * 400.0 * 20.0);  // of the head
        QVERIFY(std::abs(audit[1].before - audit[0].after) < 1e-9);
        QVERIFY(std::abs(audit[1].after - audit[1].before) < 1e-4 * audit[1].before);
    }
    void impactIsABreakImpulseAndASwap() {
        Session session = steppedOnce(test::floatingBlock(), ShotInput{"box", test::throwAtBlock(100.0, 12.0)});
        while (session.events().breaks.empty() && session.stepsDone() < 20) session.step();
        QCOMPARE(changesOf(session), (std::vector{EnergyChange::BreakImpulse, EnergyChange::Swap}));
        const EnergyEntry& impulse = session.events().energy[0];
        QVERIFY(std::abs(impulse.before - 7200.0) < 1.0);
        // 100 N·s slow 100 kg from 12 to 11 m/s, and move 500 kg by 0.2 m/s.
        QVERIFY2(std::abs(impulse.after - (6050.0 + 10.0)) < 10.0, QByteArray::number(impulse.after));
    }
    void cutIsNamed() {
        Project project = test::floatingBlock();
        project.assets[0].cutAtImpact = CutAtImpact{.fragments = 20};
        QCOMPARE(changesOf(steppedOnce(project, kOffCentreBlow)),
                 (std::vector{EnergyChange::Blow, EnergyChange::Cut, EnergyChange::Blow}));
    }
    void blastIsWhatItsBodiesGain() {
        const ShotInput bomb{"bomb", Blast{.at = {0.0, 5.0, 2.0}, .impulse = 2000.0, .radius = 5.0}};
        const Session session = steppedOnce(test::floatingBlock(), bomb);
        QCOMPARE(changesOf(session), (std::vector{EnergyChange::Swap, EnergyChange::Blast}));
        QVERIFY(session.events().energy[1].given > 0.0);
    }
    /// Its fragments weigh 100 kg each, whatever the whole weighs.
    void thesisPresetGivesEnergy() {
        Project project = test::floatingBlock(12);
        project.damage.isThesis = true;
        const Session session = steppedOnce(project, ShotInput{"blow", Hammer{{0.0, 5.0, 0.25}, {0.0, 0.0, -2000.0}}});
        const EnergyAudit& audit = session.events().energy;
        QCOMPARE(audit[1].change, EnergyChange::Swap);
        QVERIFY(std::abs(audit[1].given - (audit[1].after - audit[1].before)) < 1e-9 * audit[1].after);
    }
};

RUBBLE_TEST(EnergyAuditTest)
#include "EnergyAuditTest.moc"
