// Tests viewport/scene/play/BlastEffects.cpp.
#include "tests/support/TestProgram.h"
#include "viewport/scene/play/BlastEffects.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>

using namespace rubble;

namespace {

/// What is seen of blasts of 2 m at a height, of which one was set off before each of the first steps.
RenderScene blastsAt(double height, std::uint64_t step, std::uint64_t count = 1) {
    std::vector<BlastRecord> blasts;
    for (std::uint64_t k = 1; k <= count; ++k) blasts.push_back({k, {.at = {3.0, height, 0.0}, .radius = 2.0}});
    RenderScene scene;
    addBlasts(scene, blasts, {step, 1.0 / 60.0, {0.0, -9.81, 0.0}});
    return scene;
}

std::ptrdiff_t countOf(const RenderScene& scene, DecalKind kind) {
    return std::ranges::count(scene.decals, kind, &Decal::kind);
}
std::ptrdiff_t countOf(const RenderScene& scene, ParticleKind kind) {
    return std::ranges::count(scene.particles, kind, &Particle::kind);
}

}  // namespace

class BlastEffectsTest : public QObject {
    Q_OBJECT
private slots:
    void flashLightsWhatIsAroundForAMoment() {
        const RenderScene early = blastsAt(0.5, 1);
        QCOMPARE(countOf(early, ParticleKind::Flash), 1);
        QCOMPARE(countOf(early, DecalKind::Light), 1);
        QCOMPARE(countOf(blastsAt(0.5, 9), ParticleKind::Flash), 0);
        QCOMPARE(countOf(blastsAt(0.5, 20), DecalKind::Light), 0);
    }
    void ringRunsAlongTheGroundAndFades() {
        float radius = 0.0f, opacity = 1.0f;
        for (const std::uint64_t step : {2u, 10u, 30u}) {
            const RenderScene scene = blastsAt(0.5, step);
            const auto ring = std::ranges::find(scene.decals, DecalKind::ShockRing, &Decal::kind);
            QVERIFY(ring != scene.decals.end());
            QVERIFY(ring->centre.w > radius && ring->colour.w < opacity);
            QCOMPARE(ring->centre.y, 0.0f);
            const RenderScene before = blastsAt(0.5, step - 1);
            const auto earlier = std::ranges::find(before.decals, DecalKind::ShockRing, &Decal::kind);
            QVERIFY(std::abs(ring->centre.w + ring->details.y - earlier->centre.w) < 1e-5f);
            radius = ring->centre.w;
            opacity = ring->colour.w;
        }
        QCOMPARE(countOf(blastsAt(0.5, 40), DecalKind::ShockRing), 0);
    }
    /// To all sides, lower than smoke.
    void dustIsThrownAlongTheGround() {
        const RenderScene scene = blastsAt(0.5, 60);
        std::size_t sides[4] = {};
        for (const Particle& one : scene.particles) {
            if (one.position.y > 0.8f) continue;
            ++sides[(one.position.x > 3.0f ? 1 : 0) + (one.position.z > 0.0f ? 2 : 0)];
        }
        for (const std::size_t count : sides) QVERIFY(count >= 5);
        QVERIFY(blastsAt(0.5, 390).particles.empty());
    }
    void groundIsScorchedForGood() {
        for (const std::uint64_t step : {1u, 100u, 100000u}) {
            const RenderScene scene = blastsAt(0.5, step);
            QCOMPARE(countOf(scene, DecalKind::Scorch), 1);
            QVERIFY(scene.decals.front().colour.w > 0.4f);
        }
        QCOMPARE(countOf(blastsAt(0.5, 0), DecalKind::Scorch), 0);  // before it
    }
    void groundThatIsFarIsLeftAlone() {
        const RenderScene scene = blastsAt(2.5, 1);
        QCOMPARE(scene.decals.size(), std::size_t{1});
        QCOMPARE(countOf(scene, DecalKind::Light), 1);
        QVERIFY(scene.particles.size() < blastsAt(0.5, 1).particles.size());
    }
    void effectsAreBounded() {
        const RenderScene scene = blastsAt(0.5, 101, 100);
        QCOMPARE(countOf(scene, DecalKind::Scorch), 16);
        QVERIFY(scene.particles.size() <= 12 * 49 && scene.particles.size() > 12 * 20);
    }
    void sameBlastsLookTheSameAndOthersDiffer() {
        QVERIFY(blastsAt(0.5, 10) == blastsAt(0.5, 10));
        const std::vector<BlastRecord> twice{{1, {.radius = 2.0}}, {1, {.radius = 2.0}}};
        RenderScene scene;
        addBlasts(scene, twice, {.step = 1});
        const std::size_t half = scene.particles.size() / 2;
        QVERIFY(scene.particles[1] != scene.particles[half + 1]);
    }
};

RUBBLE_TEST_WITH(BlastEffectsTest, QCoreApplication)
#include "BlastEffectsTest.moc"
