// Tests viewport/scene/play/Dust.cpp, viewport/scene/play/DustParticles.cpp and
// viewport/scene/play/ParticleEmitters.cpp.
#include "tests/support/TestProgram.h"
#include "viewport/scene/play/Dust.h"

#include "tests/support/play/ReportedEvents.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

using test::brokenBlock;
using test::impactOnGround;
using test::ReportedEvents;

/// What flies at a step, without gravity unless given.
std::vector<Particle> particlesAt(const ReportedEvents& reported, std::uint64_t step, Vec3 gravity = Vec3(0.0)) {
    RenderScene scene{.hasGround = reported.project.ground.isOn};
    addDust(scene, reported.project, reported.events, {step, 1.0 / 60.0, gravity});
    return scene.particles;
}

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
    void breakMakesDustAtItsSurfaces() {
        QVERIFY(particlesAt({}, 1).empty());
        const std::vector<Particle> particles = particlesAt(brokenBlock(), 1);
        QVERIFY(countOf(particles, ParticleKind::Dust) >= 10);
        for (const Particle& one : particles) {
            const glm::vec3 arm = glm::vec3(one.position) - glm::vec3(0.0f, 5.0f, 0.0f);
            QVERIFY(std::abs(arm.x) < 0.6f && std::abs(arm.y) < 0.6f);
            QVERIFY(std::abs(std::abs(arm.z) - 0.25f) < 0.06f);  // of both sides
            QVERIFY(one.previousOffset.w > 0.005f && one.position.w > 0.005f);
        }
    }
    void dustDriftsGrowsAndFades() {
        const ReportedEvents reported = brokenBlock();
        const auto dustAt = [&](std::uint64_t step) { return only(particlesAt(reported, step), ParticleKind::Dust); };
        const std::vector<Particle> early = dustAt(6), late = dustAt(16);
        QCOMPARE(late.size(), early.size());
        for (std::size_t k = 0; k < late.size(); ++k) {
            QVERIFY(late[k].position.w > early[k].position.w);
            QVERIFY(glm::distance(late[k].position, early[k].position) > 0.05f);
        }
        const auto opacity = [](const std::vector<Particle>& dust) {
            float sum = 0.0f;
            for (const Particle& one : dust) sum += one.previousOffset.w;
            return sum;
        };
        QVERIFY(opacity(late) < 0.9f * opacity(early));
        QVERIFY(particlesAt(reported, 391).empty());  // 6.5 s
        QVERIFY(particlesAt(reported, 0).empty());    // nor before it happened
    }
    /// A block that broke 5 m above the ground.
    void someDustSinksSpreadsAndLingers() {
        const ReportedEvents reported = brokenBlock();
        const std::vector<Particle> early = particlesAt(reported, 2), late = particlesAt(reported, 180);
        QVERIFY(!late.empty() && late.size() < early.size() / 2);
        QVERIFY(meanHeight(late) < 0.5f * meanHeight(early));
        for (const Particle& one : late) {
            QVERIFY(one.position.y > 0.0f && one.position.w > 0.4f);
            QVERIFY(one.previousOffset.w > 0.0f && one.previousOffset.w < 0.3f);
        }
    }
    void moreLingersTheMoreBroke() {
        ReportedEvents small = brokenBlock(), large = brokenBlock();
        small.events[0].area = 1.0;
        large.events[0].area = 10.0;
        QVERIFY(particlesAt(large, 150).size() > 2 * particlesAt(small, 150).size());
        QVERIFY(particlesAt(brokenBlock(100.0, test::kPlaster), 2).size() > particlesAt(brokenBlock(), 2).size());
    }
    void dustHasTheColourOfTheInside() {
        const Colour clay{0.55, 0.30, 0.20};
        for (const Particle& one : particlesAt(brokenBlock(100.0, {.outside = {}, .inside = clay}), 2)) {
            QCOMPARE(one.kind(), ParticleKind::Dust);
            QVERIFY(one.colour.x > one.colour.y + 0.1f && one.colour.y > one.colour.z);
        }
    }
    void glassAndWoodMakeHardlyAnyDust() {
        for (const Material& material : {test::kGlass, test::kSpruce}) {
            const std::vector<Particle> particles = particlesAt(brokenBlock(100.0, material), 2);
            QVERIFY(!particles.empty() && particles.size() <= 4);
            for (const Particle& one : particles) QVERIFY(one.previousOffset.w < 0.3f);
            QVERIFY(particlesAt(impactOnGround(100.0, material), 2).size() <
                    particlesAt(impactOnGround(100.0), 2).size());
        }
        QVERIFY(particlesAt(brokenBlock(100.0, test::kGlass), 25).empty());
    }
    void metalMakesSparksWhereItIsHitHard() {
        const std::vector<Particle> particles = particlesAt(impactOnGround(2000.0, test::kSteel), 1);
        QVERIFY(countOf(particles, ParticleKind::Spark) >= 10);
        QCOMPARE(countOf(particles, ParticleKind::Flash), std::size_t{1});
        QCOMPARE(countOf(particlesAt(impactOnGround(2000.0, test::kSteel), 12), ParticleKind::Flash), std::size_t{0});
        QCOMPARE(countOf(particlesAt(impactOnGround(20.0, test::kSteel), 1), ParticleKind::Spark), std::size_t{0});
        QCOMPARE(countOf(particlesAt(impactOnGround(2000.0), 1), ParticleKind::Spark), std::size_t{0});
        const std::vector<Particle> broken = particlesAt(brokenBlock(0.0, test::kSteel), 2);
        QVERIFY(broken.size() <= 4 && countOf(broken, ParticleKind::Dust) == broken.size());
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
    void impactOnTheGroundFliesAlongIt() {
        float wide = 0.0f;
        for (const Particle& one : particlesAt(impactOnGround(500.0), 10)) {
            wide = std::max(wide, std::abs(one.position.x));
        }
        QVERIFY(wide > 0.2f);
    }
    /// A pane of 8 m makes no clouds that hide it.
    void cloudsOfLargeBodiesAreSmall() {
        ReportedEvents reported = brokenBlock();
        reported.events[0].box = {{-4.0, 1.0, -0.25}, {4.0, 9.0, 0.25}};
        for (const Particle& one : particlesAt(reported, 20)) QVERIFY(one.position.w < 1.6f);
    }
    /// The box of a wall that stands at 45 degrees to the axes is as deep as it is wide; its dust starts at its faces.
    void dustOfAnObliqueWallStartsAtItsFaces() {
        ReportedEvents reported = brokenBlock();
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
    void particlesAreBoundedAndEveryEventHasSome() {
        ReportedEvents reported;
        reported.project = brokenBlock().project;
        for (std::uint64_t step = 1; step <= 50; ++step) {
            for (std::uint32_t body = 0; body < 16; ++body) {
                reported.events.push_back(brokenBlock(1e5).events[0]);
                EventRecord& broken = reported.events.back();
                broken.step = step;
                broken.body = body;
                const double aside = body < 8 ? 0.0 : 50.0;
                broken.point.x += aside;
                broken.box = {broken.box.min + Vec3(aside, 0.0, 0.0), broken.box.max + Vec3(aside, 0.0, 0.0)};
            }
        }
        const std::vector<Particle> particles = particlesAt(reported, 50);
        QVERIFY(particles.size() > 200 && particles.size() <= 500);
        const auto right = std::ranges::count_if(particles, [](const Particle& one) { return one.position.x > 25.0f; });
        QVERIFY(right > 80 && particles.size() - static_cast<std::size_t>(right) > 80);
        ReportedEvents sparks = impactOnGround(1e6, test::kSteel);
        sparks.events.resize(400, sparks.events[0]);
        for (std::uint32_t k = 0; k < 400; ++k) sparks.events[k].body = k;
        const std::size_t sparkCount = countOf(particlesAt(sparks, 2), ParticleKind::Spark);
        QVERIFY(sparkCount >= 580 && sparkCount < 650);
    }
    void sameEventsGiveTheSameParticlesAndOthersDiffer() {
        ReportedEvents reported = brokenBlock();
        const std::vector<Particle> particles = particlesAt(reported, 5);
        QVERIFY(particlesAt(reported, 5) == particles);
        reported.events[0].body = 2;
        QVERIFY(particlesAt(reported, 5) != particles);
    }
    void previousOffsetMatchesThePreviousScene() {
        for (const ReportedEvents& reported :
             {brokenBlock(), brokenBlock(100.0, test::kGlass), impactOnGround(500.0, test::kSteel)}) {
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
