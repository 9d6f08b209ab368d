// Tests viewport/scene/play/Dust.cpp and viewport/scene/play/DustParticles.cpp.
#include "tests/support/TestProgram.h"
#include "viewport/scene/play/Dust.h"

#include "tests/support/asset/ProjectParts.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

constexpr double kStep = 1.0 / 60.0;  // s

/// Something that the steps of a session reported, and the materials that it names.
struct Reported {
    Project project;
    std::vector<EventRecord> events;
};

/// What flies at a step, without gravity unless given.
std::vector<Particle> particlesAt(const Reported& reported, std::uint64_t step, Vec3 gravity = Vec3(0.0)) {
    RenderScene scene{.hasGround = reported.project.ground.isOn};
    addDust(scene, reported.project, reported.events, {step, kStep, gravity});
    return scene.particles;
}

/// A block of 1 x 1 x 0.5 m at (0, 5, 0) that broke in step 1 of a blow from +z.
Reported brokenBlock(double energy = 100.0, Material material = {}) {
    Reported reported;
    const Id id = test::addMaterial(reported.project, material);
    EventRecord broken{.step = 1,
                       .kind = EventKind::Broken,
                       .body = 1,
                       .other = 2,
                       .point = {0.0, 5.0, 0.25},
                       .normal = {0.0, 0.0, -1.0},
                       .energy = energy,
                       .area = 4.0,
                       .mass = 0.5 * material.density,
                       .count = 5,
                       .materials = {id, id}};
    broken.box = {{-0.5, 4.5, -0.25}, {0.5, 5.5, 0.25}};
    reported.events = {broken};
    return reported;
}

/// A body that hit the ground at the origin in step 1.
Reported impactOnGround(double energy, Material material = {}) {
    Reported reported;
    const Id id = test::addMaterial(reported.project, material);
    reported.events = {{.step = 1,
                        .body = 1,
                        .other = 0,
                        .normal = {0.0, 1.0, 0.0},
                        .speed = 5.0,
                        .energy = energy,
                        .materials = {id, 0}}};
    return reported;
}

Material materialOf(double opacity, double density, std::optional<double> toughness) {
    return {.density = density, .fractureToughness = toughness, .opacity = opacity};
}
const Material kGlass = materialOf(0.3, 2500.0, 7.5e5);
const Material kSteel = materialOf(1.0, 7850.0, 6e7);
const Material kSpruce = materialOf(1.0, 420.0, 5e6);

std::size_t countOf(const std::vector<Particle>& particles, ParticleKind kind) {
    return static_cast<std::size_t>(std::ranges::count(particles, kind, &Particle::kind));
}

std::vector<Particle> only(const std::vector<Particle>& particles, ParticleKind kind) {
    std::vector<Particle> some;
    std::ranges::copy_if(particles, std::back_inserter(some),
                         [kind](const Particle& one) { return one.kind() == kind; });
    return some;
}

float meanHeight(const std::vector<Particle>& particles) {
    float sum = 0.0f;
    for (const Particle& one : particles) sum += one.position.y;
    return sum / static_cast<float>(particles.size());
}

}  // namespace

class DustTest : public QObject {
    Q_OBJECT
private slots:
    void breakMakesDustAndChipsAtItsSurfaces() {
        QVERIFY(particlesAt({}, 1).empty());
        const std::vector<Particle> particles = particlesAt(brokenBlock(), 1);
        QVERIFY(countOf(particles, ParticleKind::Dust) >= 10 && countOf(particles, ParticleKind::Chip) >= 4);
        for (const Particle& one : particles) {
            const glm::vec3 arm = glm::vec3(one.position) - glm::vec3(0.0f, 5.0f, 0.0f);
            QVERIFY(std::abs(arm.x) < 0.6f && std::abs(arm.y) < 0.6f);
            QVERIFY(std::abs(std::abs(arm.z) - 0.25f) < 0.06f);  // of both sides
            QVERIFY(one.previousOffset.w > 0.05f && one.position.w > 0.005f);
        }
    }
    void dustDriftsGrowsAndFades() {
        const Reported reported = brokenBlock();
        const auto dustAt = [&](std::uint64_t step) { return only(particlesAt(reported, step), ParticleKind::Dust); };
        const std::vector<Particle> early = dustAt(6), late = dustAt(16);
        QCOMPARE(late.size(), early.size());
        for (std::size_t k = 0; k < late.size(); ++k) {
            QVERIFY(late[k].position.w > early[k].position.w && late[k].previousOffset.w < early[k].previousOffset.w);
            QVERIFY(glm::distance(late[k].position, early[k].position) > 0.05f);
        }
        QVERIFY(dustAt(43).empty());                 // 0.7 s
        QVERIFY(particlesAt(reported, 61).empty());  // nothing lies longer than a second
        QVERIFY(particlesAt(reported, 0).empty());   // nor before it happened
    }
    void dustHasTheColourOfTheInside() {
        const Colour clay{0.55, 0.30, 0.20};
        for (const Particle& one : particlesAt(brokenBlock(100.0, {.outside = {}, .inside = clay}), 2)) {
            QVERIFY(one.kind() == ParticleKind::Dust || one.kind() == ParticleKind::Chip);
            QVERIFY(one.colour.x > one.colour.y + 0.1f && one.colour.y > one.colour.z);
        }
    }
    void glassSplintersAndMakesHardlyAnyDust() {
        const Reported reported = brokenBlock(100.0, kGlass);
        const Vec3 gravity(0.0, -9.81, 0.0);
        const std::vector<Particle> early = particlesAt(reported, 2, gravity);
        const std::size_t splinters = countOf(early, ParticleKind::Splinter);
        QVERIFY(splinters >= 50 && early.size() - splinters <= 4);
        for (const Particle& one : early) {
            QVERIFY(one.kind() == ParticleKind::Splinter ? one.position.w < 0.021f : one.previousOffset.w < 0.15f);
        }
        const std::vector<Particle> late = particlesAt(reported, 22, gravity);
        QCOMPARE(countOf(late, ParticleKind::Splinter), late.size());
        QVERIFY(meanHeight(late) < meanHeight(early) - 0.2f);  // they fall
        QVERIFY(!std::ranges::equal(
            only(early, ParticleKind::Splinter), late, {}, [](const Particle& one) { return one.colour.w; },
            [](const Particle& one) { return one.colour.w; }));  // and rotate
        QVERIFY(particlesAt(reported, 57, gravity).empty());
    }
    void metalMakesSparksWhereItIsHitHard() {
        const std::vector<Particle> particles = particlesAt(impactOnGround(2000.0, kSteel), 1);
        QVERIFY(countOf(particles, ParticleKind::Spark) >= 10);
        QCOMPARE(countOf(particles, ParticleKind::Flash), std::size_t{1});
        QCOMPARE(countOf(particlesAt(impactOnGround(2000.0, kSteel), 12), ParticleKind::Flash), std::size_t{0});
        QCOMPARE(countOf(particlesAt(impactOnGround(20.0, kSteel), 1), ParticleKind::Spark), std::size_t{0});
        QCOMPARE(countOf(particlesAt(impactOnGround(2000.0), 1), ParticleKind::Spark), std::size_t{0});
        const std::vector<Particle> broken = particlesAt(brokenBlock(0.0, kSteel), 2);
        QVERIFY(broken.size() <= 4 && countOf(broken, ParticleKind::Dust) == broken.size());
    }
    void woodSplinters() {
        const std::vector<Particle> particles = particlesAt(brokenBlock(1000.0, kSpruce), 2);
        QVERIFY(countOf(particles, ParticleKind::Splinter) >= 10 && countOf(particles, ParticleKind::Dust) <= 4);
    }
    void impactGrowsWithTheCubeRootOfItsEnergy() {
        QVERIFY(particlesAt(impactOnGround(1.0), 1).empty());  // a weak one is not seen
        std::size_t before = 0;
        float radius = 0.0f;
        for (const double energy : {10.0, 80.0, 640.0}) {
            const std::vector<Particle> particles = particlesAt(impactOnGround(energy), 1);
            float largest = 0.0f;
            for (const Particle& one : particles) largest = std::max(largest, one.position.w);
            QVERIFY(particles.size() > before && largest > radius);
            before = particles.size();
            radius = largest;
        }
        for (const double energy : {1e9, 1e300}) QVERIFY(particlesAt(impactOnGround(energy), 1).size() <= 40);
    }
    void impactOnTheGroundFliesAlongItAndNotBelow() {
        const Reported reported = impactOnGround(500.0);
        for (const std::uint64_t step : {1u, 10u, 30u}) {
            for (const Particle& one : particlesAt(reported, step, {0.0, -9.81, 0.0})) {
                if (one.kind() == ParticleKind::Chip) QVERIFY(one.position.y >= 0.0f);
            }
        }
        float wide = 0.0f;
        for (const Particle& one : particlesAt(reported, 10)) wide = std::max(wide, std::abs(one.position.x));
        QVERIFY(wide > 0.2f);
    }
    /// A pane of 8 m makes no clouds that hide it.
    void cloudsOfLargeBodiesAreSmall() {
        Reported reported = brokenBlock();
        reported.events[0].box = {{-4.0, 1.0, -0.25}, {4.0, 9.0, 0.25}};
        for (const Particle& one : particlesAt(reported, 20)) QVERIFY(one.position.w < 0.8f);
    }
    /// The box of a wall that stands at 45 degrees to the axes is as deep as it is wide; its dust starts at its faces.
    void dustOfAnObliqueWallStartsAtItsFaces() {
        Reported reported = brokenBlock();
        EventRecord& broken = reported.events[0];
        const double half = 2.0 * std::sqrt(0.5);
        broken.normal = {-std::sqrt(0.5), 0.0, -std::sqrt(0.5)};
        broken.point = {0.07, 1.0, 0.07};  // of 4 x 2 x 0.2 m
        broken.box = {{-half, 0.0, -half}, {half, 2.0, half}};
        broken.mass = 1.6 * reported.project.materials[0].density;
        for (const Particle& one : only(particlesAt(reported, 1), ParticleKind::Dust)) {
            const double depth = glm::dot(Vec3(glm::vec3(one.position)) - broken.point, broken.normal);
            QVERIFY2(std::min(std::abs(depth), std::abs(depth - 0.2)) < 0.06, qPrintable(QString::number(depth)));
        }
    }
    void particlesAreBoundedAndTheLatestWin() {
        Reported reported;
        for (std::uint64_t step = 1; step <= 50; ++step) {
            for (std::uint32_t body = 0; body < 16; ++body) {
                reported.events.push_back(brokenBlock(1e5).events[0]);
                reported.events.back().step = step;
                reported.events.back().body = body;
            }
        }
        reported.project = brokenBlock().project;
        QCOMPARE(particlesAt(reported, 50).size(), std::size_t{2000});
        const std::vector<EventRecord> latest(reported.events.end() - 16, reported.events.end());
        const std::vector<Particle> some = particlesAt({reported.project, latest}, 50), all = particlesAt(reported, 50);
        QVERIFY(std::equal(some.begin(), some.end(), all.begin()));
    }
    void sameEventsGiveTheSameParticlesAndOthersDiffer() {
        Reported reported = brokenBlock();
        const std::vector<Particle> particles = particlesAt(reported, 5);
        QVERIFY(particlesAt(reported, 5) == particles);
        reported.events[0].body = 2;
        QVERIFY(particlesAt(reported, 5) != particles);
    }
    void previousOffsetMatchesThePreviousScene() {
        for (const Reported& reported : {brokenBlock(), brokenBlock(100.0, kGlass), impactOnGround(500.0, kSteel)}) {
            const auto flying = [](const std::vector<Particle>& all) {
                std::vector<Particle> some = all;
                std::erase_if(some, [](const Particle& one) { return one.kind() >= ParticleKind::Spark; });
                return some;
            };
            const std::vector<Particle> before = flying(particlesAt(reported, 5)),
                                        now = flying(particlesAt(reported, 6));
            QCOMPARE(now.size(), before.size());
            for (std::size_t k = 0; k < now.size(); ++k) {
                const glm::vec3 earlier = glm::vec3(now[k].position + now[k].previousOffset);
                QVERIFY(glm::distance(earlier, glm::vec3(before[k].position)) < 1e-5f);
            }
        }
    }
};

RUBBLE_TEST_WITH(DustTest, QCoreApplication)
#include "DustTest.moc"
