// Tests core/play/breaking/Blow.cpp and core/asset/project/HammerPatch.cpp.
#include "core/play/breaking/Blow.h"

#include "core/asset/project/HammerPatch.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"

#include <algorithm>

using namespace rubble;

namespace {

constexpr double kBlowImpulse = 50.0;  // N·s
const Hammer kBlow{.at = {0.0, 5.0, 0.025}, .impulse = {0.0, 0.0, -kBlowImpulse}};
const Hammer kBlowAtWall{.at = {0.0, 1.8, 0.125}, .impulse = {0.0, 0.0, -kBlowImpulse}};

/// A fixed pane of 1 x 1 m and 60 kg in the air, which 1 N·s breaks.
Project pane(std::uint32_t fragments) {
    Project project = test::floatingBlock(fragments);
    project.assets[0].prism().depth = 0.05;
    project.materials[0].density = 1200.0;
    project.assets[0].threshold = 1.0;
    project.instances[0].isFixed = true;
    return project;
}

Project cutPane(std::uint32_t fragments, double falloffRadius) {
    Project project = pane(20);
    project.assets[0].cutAtImpact = CutAtImpact{.fragments = fragments, .falloffRadius = falloffRadius};
    return project;
}

Session struckBy(const Project& project, const Hammer& hammer) {
    Session session = test::sessionOf(project, {.sleeping = false});
    test::addInput(session, ShotInput{"blow", hammer});
    session.step();
    return session;
}

double fastestOf(const Session& session) {
    double fastest = 0.0;
    for (const PlayBody& body : session.bodies()) {
        fastest = std::max(fastest, glm::length(session.world().state(body.body).velocity));
    }
    return fastest;
}

/// The number of bodies that a blow made faster than half of the fastest.
int movedBy(const Project& project, const Hammer& hammer) {
    const Session session = struckBy(project, hammer);
    const double fastest = fastestOf(session);
    return static_cast<int>(std::ranges::count_if(session.bodies(), [&](const PlayBody& body) {
        return glm::length(session.world().state(body.body).velocity) > 0.5 * fastest;
    }));
}

/// A head with 50 N·s and 500 J.
HammerHead head() { return HammerHead::ofImpulse(kBlowImpulse); }

}  // namespace

class BlowTest : public QObject {
    Q_OBJECT
private slots:
    void headGivesItsImpulseToWhatIsHeavy() { QCOMPARE(head().impulseOn(100.0, 0.0), 50.0); }
    void headMakesNothingFasterThanItself() {
        QCOMPARE(head().impulseOn(1.0, 0.0), 20.0);
        QCOMPARE(head().impulseOn(1.0, 15.0), 5.0);
        QCOMPARE(head().impulseOn(1.0, 20.0), 0.0);
        QCOMPARE(head().impulseOn(1.0, 300.0), 0.0);
        QCOMPARE(head().impulseOn(1.0, -5.0), 25.0);
    }
    /// 50 N·s at 15 m/s and more would be above 750 J.
    void headGivesNoMoreThanItsEnergy() {
        const double given = head().impulseOn(1000.0, 15.0);
        QVERIFY(std::abs(given * (15.0 + 0.5 * given / 1000.0) - 500.0) < 1e-9);
    }
    void headKeepsWhatItDoesNotGive() {
        HammerHead one = head();
        QCOMPARE(one.give(20.0, 2.0, 0.0), 100.0);  // 2 kg at 10 m/s
        QCOMPARE(one.impulse, 30.0);
        QCOMPARE(one.energy, 400.0);
    }

    void patchIsThatOfASteelBall() {
        const double radius = patchRadius(kBlow);  // of 2.5 kg
        QVERIFY2(std::abs(radius - 0.0424) < 1e-4, QByteArray::number(radius));
        QCOMPARE(patchRadius({.impulse = {0.0, 0.0, 1e-12}}), 1e-3);
        QCOMPARE(patchRadius({.impulse = {0.0, 0.0, 1e15}, .radius = 0.2}), 0.2);
    }

    /// One splinter had all of it, at 2,751 m/s.
    void blowIsSpread_data() {
        QTest::addColumn<Project>("project");
        for (const std::uint32_t fragments : {30u, 100u, 1000u}) {
            QTest::addRow("cut into %u", fragments) << cutPane(fragments, 0.2);
            QTest::addRow("cut into %u within 2 cm", fragments) << cutPane(fragments, 0.02);
        }
        for (const std::uint32_t fragments : {2u, 20u, 200u, 1000u}) {
            QTest::addRow("%u of a pattern", fragments) << pane(fragments);
        }
    }
    void blowIsSpread() {
        QFETCH(Project, project);
        const Session session = struckBy(project, kBlow);
        QCOMPARE(session.events().breaks.size(), 1u);
        QVERIFY(session.events().diagnostics.empty());
        double given = 0.0;
        for (const EnergyEntry& entry : session.events().energy) given += entry.given;
        QVERIFY2(given <= 500.0, QByteArray::number(given));
        const Momenta momenta = session.world().momenta();
        QVERIFY2(std::abs(momenta.linear.z + kBlowImpulse) < 1e-2, QByteArray::number(momenta.linear.z));
        QVERIFY2(momenta.kinetic <= 1.01 * given, QByteArray::number(momenta.kinetic));
        QVERIFY2(fastestOf(session) < 1.01 * kHammerSpeed, QByteArray::number(fastestOf(session)));
    }

    void widerHammersMoveMoreFragments() {
        Hammer hammer = kBlow;
        int before = 0;
        for (const double radius : {0.05, 0.15, 0.4}) {
            hammer.radius = radius;
            const int moved = movedBy(pane(300), hammer);
            QVERIFY2(moved > before, QByteArray::number(moved));
            before = moved;
        }
        hammer.radius = 10.0;
        QCOMPARE(movedBy(pane(300), hammer), 300);
    }

    /// 10 g get at most 0.2 of 50 N·s.
    void whatIsTooLightGetsAsFastAsTheHammer_data() {
        QTest::addColumn<bool>("breaks");
        QTest::newRow("whole") << false;
        QTest::newRow("broken") << true;
    }
    void whatIsTooLightGetsAsFastAsTheHammer() {
        QFETCH(bool, breaks);
        Project project = pane(3);
        project.instances[0].isFixed = false;
        project.materials[0].density = 0.2;
        project.assets[0].threshold = breaks ? 0.1 : 1000.0;
        const Session session = struckBy(project, kBlow);
        QCOMPARE(session.events().breaks.size(), breaks ? 1u : 0u);
        QVERIFY2(fastestOf(session) < 1.01 * kHammerSpeed, QByteArray::number(fastestOf(session)));
        QVERIFY2(session.world().momenta().linear.z < -0.1, QByteArray::number(session.world().momenta().linear.z));
        QCOMPARE(session.events().diagnostics.size(), 1u);
        QCOMPARE(session.events().diagnostics[0].code, DiagnosticCode::UnappliedInput);
        const std::string& message = session.events().diagnostics[0].message;
        QVERIFY2(message.starts_with("The blow \"blow\" gave 0.") &&
                     message.ends_with(" of its 50 N·s: a hammer makes nothing faster than itself, 20 m/s."),
                 message.c_str());
    }

    /// 11.7285 g at 20 m/s.
    void whatABlowGaveIsRoundedToThreeDigits() {
        Project project = pane(3);
        project.instances[0].isFixed = false;
        project.materials[0].density = 0.23457;
        project.assets[0].threshold = 1000.0;
        const Session session = struckBy(project, kBlow);
        QCOMPARE(session.events().diagnostics.size(), 1u);
        const std::string& message = session.events().diagnostics[0].message;
        QVERIFY2(message.starts_with("The blow \"blow\" gave 0.235 of its 50 N·s: "), message.c_str());
    }

    /// A free one, and what comes off one that is held.
    void whatIsTooLightIsReportedAlsoOfBondedBodies_data() {
        QTest::addColumn<bool>("isHeld");
        QTest::addColumn<double>("impulsePerArea");
        QTest::newRow("free, intact") << false << 1e9;
        QTest::newRow("free, broken") << false << 0.01;
        QTest::newRow("held, broken") << true << 0.01;
    }
    void whatIsTooLightIsReportedAlsoOfBondedBodies() {
        QFETCH(bool, isHeld);
        QFETCH(double, impulsePerArea);
        Project project = test::bondedWall(30, impulsePerArea);
        project.materials[0].density = 0.02;
        project.instances[0].isAnchored = isHeld;
        project.gravity = Vec3(0.0);
        const Session session = struckBy(project, kBlowAtWall);
        QCOMPARE(session.events().splits.empty(), impulsePerArea > 1.0);
        QCOMPARE(session.events().diagnostics.size(), 1u);
        const std::string& message = session.events().diagnostics[0].message;
        QVERIFY2(message.starts_with("The blow \"blow\" gave ") &&
                     message.ends_with(" of its 50 N·s: a hammer makes nothing faster than itself, 20 m/s."),
                 message.c_str());
    }
    void heldBondedBodyTakesAllThatItsBondsDoNot() {
        const Session session = struckBy(test::bondedWall(30, 1e9), kBlowAtWall);
        QVERIFY(session.events().splits.empty() && session.events().diagnostics.empty());
    }

    void blowsThatFollowEachOtherDoNotAddUp() {
        Project project = pane(3);
        project.instances[0].isFixed = false;
        project.assets[0].threshold = 1e9;
        Session session = test::sessionOf(project);
        for (int k = 0; k < 100; ++k) {
            test::addInput(session,
                           ShotInput{"blow", {Hammer{.at = {0.0, 5.0, 0.025}, .impulse = {0.0, 0.0, -500.0}}}});
        }
        session.step();
        QVERIFY2(fastestOf(session) < 1.01 * kHammerSpeed, QByteArray::number(fastestOf(session)));
    }
};

RUBBLE_TEST(BlowTest)
#include "BlowTest.moc"
