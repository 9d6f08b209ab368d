#include "core/physics/step/ContactEnergy.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"
#include "tests/support/scenes/Scenes.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

/// Two cubes of 1 m in empty space without gravity, the second at rest. The first arrives with a velocity.
SceneWorld twoCubes(Vec3 velocity, Vec3 angularVelocity, double restitution, Vec3 offset = {1.0, 0.0, 0.0}) {
    BodyScene scene;
    const std::uint32_t shape = addShape(scene, {boxOf(Vec3(1.0))});
    addFreeBody(scene, "first", shape, {});
    addFreeBody(scene, "second", shape, {.position = offset});
    scene.bodies[0].velocity = velocity;
    scene.bodies[0].angularVelocity = angularVelocity;
    for (auto& body : scene.bodies) body.restitution = restitution;
    SceneWorld made = worldOf(scene);
    if (!made.world.setGravity(Vec3(0.0))) throw std::runtime_error("gravity");
    return made;
}

double hitEnergy(const World& world) {
    double sum = 0.0;
    for (const HitEvent& hit : world.events().hits) sum += hit.energy;
    return sum;
}

}  // namespace

class ContactEnergyTest : public QObject {
    Q_OBJECT
private slots:
    /// Each has 1,000 kg; of the energy of the relative motion, 500 kg · v² / 2, the part 1 - e² is lost.
    void centralHit_data() {
        QTest::addColumn<double>("restitution");
        for (const double e : {0.0, 0.3, 0.6, 1.0}) QTest::addRow("e = %g", e) << e;
    }
    void centralHit() {
        QFETCH(double, restitution);
        SceneWorld made = twoCubes({4.0, 0.0, 0.0}, Vec3(0.0), restitution);
        made.world.step(kStep);
        const double lost = 0.25 * 1000.0 * 16.0 * (1.0 - restitution * restitution);
        QVERIFY2(std::abs(made.world.events().contactLoss - lost) < 5.0, qPrintable(QString::number(lost)));
        QVERIFY(std::abs(hitEnergy(made.world) - lost) < 5.0);
    }
    /// Off-centre, oblique and spinning, with friction: what the two have lost is what they had and have not.
    void obliqueHits() {
        for (int k = 0; k < 40; ++k) {
            const Vec3 velocity{3.0 + 0.1 * k, 0.15 * k - 3.0, 0.5}, spin{0.2 * k - 4.0, 1.0, 0.1 * k};
            SceneWorld made = twoCubes(velocity, spin, 0.02 * k, {1.0, 0.02 * k - 0.4, 0.1});
            for (int step = 0; step < 5; ++step) {
                const double before = energyOf(made.world);
                made.world.step(kStep);
                const double lost = before - energyOf(made.world), tolerance = 2e-4 * before;
                const QByteArray where = QByteArray::number(k) + ", step " + QByteArray::number(step);
                QVERIFY2(std::abs(made.world.events().contactLoss - lost) < tolerance, where);
                if (!made.world.events().hits.empty())
                    QVERIFY2(std::abs(hitEnergy(made.world) - lost) < 0.01 * before, where);
            }
        }
    }
    /// Wherever in a step it lands: the energy of the fall.
    void fallOntoTheGround() {
        for (int k = 0; k < 30; ++k) {
            const double height = 0.5 + 0.01 * k;
            BodyScene scene;
            addGround(scene, 5.0);
            addFreeBody(scene, "cube", addShape(scene, {boxOf(Vec3(1.0))}), {.position = {0.0, 0.5 + height, 0.0}});
            SceneWorld made = worldOf(scene);
            double hits = 0.0, all = 0.0;
            for (int step = 0; step < 60; ++step) {
                made.world.step(kStep);
                hits += hitEnergy(made.world);
                all += made.world.events().contactLoss;
            }
            const double fall = 1000.0 * 9.81 * height;
            QVERIFY2(std::abs(all / fall - 1.0) < 0.01, qPrintable(QString::number(all / fall)));
            QVERIFY2(std::abs(hits / fall - 1.0) < 0.01, qPrintable(QString::number(hits / fall)));
        }
    }
    /// A cube at rest takes nothing from itself, and one that slides loses μ m g v dt.
    void restAndFriction() {
        BodyScene scene;
        addGround(scene, 50.0);
        addFreeBody(scene, "cube", addShape(scene, {boxOf({2.0, 0.2, 2.0})}), {.position = {0.0, 0.1, 0.0}});
        SceneWorld made = worldOf(scene);
        for (int step = 0; step < 20; ++step) {
            made.world.step(kStep);
            QVERIFY(step < 2 || std::abs(made.world.events().contactLoss) < 0.05);  // it settles first
        }
        QVERIFY(made.world.setVelocity(made.bodies[1], {5.0, 0.0, 0.0}, Vec3(0.0)));
        made.world.step(kStep);
        const double before = energyOf(made.world);
        made.world.step(kStep);
        const double lost = before - energyOf(made.world);
        QVERIFY(lost > 100.0);
        QVERIFY(std::abs(made.world.events().contactLoss - lost) < 0.01 * lost);
        QVERIFY(made.world.events().hits.empty());
    }
    /// What flies beside it loses nothing.
    void freeFlightIsNoContact() {
        BodyScene scene;
        addGround(scene, 5.0);
        const std::uint32_t shape = addShape(scene, {boxOf(Vec3(1.0))});
        addFreeBody(scene, "rests", shape, {.position = {0.0, 0.5, 0.0}});
        addFreeBody(scene, "flies", shape, {.position = {3.0, 50.0, 0.0}});
        scene.bodies[2].velocity = {3.0, 4.0, 0.0};
        scene.bodies[2].angularVelocity = {9.0, 1.0, 2.0};
        SceneWorld made = worldOf(scene);
        for (int step = 0; step < 60; ++step) {
            made.world.step(kStep);
            QVERIFY(step < 2 || std::abs(made.world.events().contactLoss) < 0.05);  // it settles first
        }
    }
    void grabbedWorkIsNoLoss() {
        BodyScene scene;
        addGround(scene, 5.0);
        addFreeBody(scene, "cube", addShape(scene, {boxOf(Vec3(1.0))}), {.position = {0.0, 0.5, 0.0}});
        SceneWorld made = worldOf(scene);
        made.world.step(kStep);
        QVERIFY(made.world.grab(made.bodies[1], {0.0, 0.5, 0.0}, 5e4));
        QVERIFY(made.world.dragTo({0.0, 4.0, 0.0}));
        for (int step = 0; step < 30; ++step) made.world.step(kStep);
        QVERIFY(energyOf(made.world) > 10'000.0);  // it hangs, and touches nothing
        QVERIFY(std::abs(made.world.events().contactLoss) < 20.0);
    }
    /// What a contact takes and another gives is no loss.
    void hitsTakeNoMoreThanAllContacts() {
        const auto limited = [](std::vector<double> energies, double loss) {
            std::vector<HitEvent> hits(energies.size());
            for (std::size_t k = 0; k < hits.size(); ++k) hits[k].energy = energies[k];
            limitHits(hits, loss);
            for (std::size_t k = 0; k < hits.size(); ++k) energies[k] = hits[k].energy;
            return energies;
        };
        QCOMPARE(limited({6.0, -1.0, 2.0}, 8.0), (std::vector{6.0, -1.0, 2.0}));
        QCOMPARE(limited({6.0, -1.0, 2.0}, 4.0), (std::vector{3.0, 0.0, 1.0}));
        QCOMPARE(limited({6.0}, -3.0), (std::vector{0.0}));
        QCOMPARE(limited({-2.0}, -3.0), (std::vector{-2.0}));
        QCOMPARE(limited({}, 0.0), (std::vector<double>{}));
    }
    /// A heap that falls together: what it loses in all is what its contacts took, on any number of threads.
    void heap() {
        std::array<double, 2> lost{};
        for (const int threads : {1, 2}) {
            SceneWorld made = worldOf(sceneNamed("heap-600"), {.threads = threads});
            double taken = 0.0, hits = 0.0;
            const double before = energyOf(made.world);
            for (int step = 0; step < 240; ++step) {
                made.world.step(kStep);
                taken += made.world.events().contactLoss;
                hits += hitEnergy(made.world);
            }
            const double all = before - energyOf(made.world);
            qInfo("%d threads: %.6g J lost, contacts took %.6g, hits %.6g", threads, all, taken, hits);
            QVERIFY(std::abs(taken / all - 1.0) < 0.01);
            QVERIFY(hits < taken);
            lost[static_cast<std::size_t>(threads - 1)] = taken;
        }
        QCOMPARE(lost[0], lost[1]);
    }
};

RUBBLE_TEST(ContactEnergyTest)
#include "ContactEnergyTest.moc"
