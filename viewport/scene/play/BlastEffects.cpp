#include "viewport/scene/play/BlastEffects.h"

#include "core/base/math/Trigonometry.h"
#include "viewport/scene/play/ParticleEmitters.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kMinRadius = 0.3, kMaxRadius = 6.0;                     // m: what others look like
constexpr double kFlashTime = 0.12, kLightTime = 0.3, kRingTime = 0.55;  // s
constexpr int kSmoke = 12, kDust = 36;                                   // puffs
constexpr std::uint64_t kBlastStream = 0xb1a5;                           // of random numbers
const glm::vec3 kFire(1.0f, 0.86f, 0.6f), kSoot(0.42f, 0.39f, 0.36f), kRaised(0.66f, 0.62f, 0.56f);

/// A blast while its effects are seen.
class BlastWriter {
public:
    BlastWriter(RenderScene& scene, const BlastRecord& blast, std::uint64_t number, const DustMoment& moment)
        : m_scene(scene),
          m_blast(blast.blast),
          m_world(particleWorldOf(scene, moment)),
          m_age(moment.ageOf(blast.step)),
          m_radius(std::clamp(m_blast.radius, kMinRadius, kMaxRadius)),
          m_height(m_blast.at.y - m_world.ground),
          m_random(mixSeeds(mixSeeds(kBlastStream, blast.step), number)) {}

    /// Whether the ground is near enough to be scorched.
    bool isAtGround() const { return std::abs(m_height) < m_radius; }

    void addFlash() {
        const double left = 1.0 - m_age / kLightTime;
        if (left <= 0.0) return;
        m_scene.decals.push_back({glm::vec4(glm::vec3(m_blast.at - m_world.origin), 2.0 * m_radius),
                                  glm::vec4(kFire, 0.75 * left * left),
                                  glm::vec4(static_cast<float>(DecalKind::Light), 0.0f, 0.0f, 0.0f)});
        add({.kind = ParticleKind::Flash,
             .from = m_blast.at,
             .radius = 0.6 * m_radius,
             .lifetime = kFlashTime,
             .colour = kFire});
    }

    void addSmoke() {
        for (int k = 0; k < kSmoke; ++k) {
            const Vec3 direction = randomDirection(m_random);
            add({.kind = ParticleKind::Dust,
                 .from = m_blast.at + 0.1 * m_radius * direction,
                 .velocity = m_radius * (m_random.between(0.5, 1.6) * direction + Vec3(0.0, 0.5, 0.0)),
                 .radius = 0.12 * m_radius * m_random.between(1.0, 1.7),
                 .lifetime = m_random.between(1.2, 2.6),
                 .opacity = 0.5,
                 .colour = kSoot,
                 .seed = m_random.unit()});
        }
    }

    void addRing() {
        const double part = m_age / kRingTime;
        if (part >= 1.0) return;
        const auto radiusAt = [&](double age) { return 2.6 * m_radius * std::sqrt(std::max(age, 0.0) / kRingTime); };
        const double now = radiusAt(m_age), before = radiusAt(m_age - m_world.stepLength);
        m_scene.decals.push_back(
            {onGround(now), glm::vec4(kRaised, 0.6 * (1.0 - part)),
             glm::vec4(static_cast<double>(DecalKind::ShockRing), before - now, m_random.unit(), 0.0)});
    }

    /// Thrown to all sides along the ground.
    void addGroundDust() {
        for (int k = 0; k < kDust; ++k) {
            const double angle = kFullTurn * (k + m_random.unit()) / kDust;
            const Vec3 out(cosine(angle), 0.0, sine(angle));
            Vec3 from = m_blast.at + m_radius * m_random.between(0.05, 0.4) * out;
            from.y = m_world.ground + 0.1 * m_radius * m_random.unit();
            const Vec3 up(0.0, m_radius * m_random.between(0.1, 0.7), 0.0);
            add({.kind = ParticleKind::Dust,
                 .from = from,
                 .velocity = m_radius * m_random.between(0.8, 2.6) * out + up,
                 .radius = 0.1 * m_radius * m_random.between(1.0, 2.0),
                 .lifetime = m_random.between(0.55, 1.0) * kBlastTime,
                 .opacity = 0.5,
                 .colour = kRaised,
                 .seed = m_random.unit(),
                 .isLingering = true});
        }
    }

    void addScorch() {
        const double wide = std::sqrt(std::max(m_radius * m_radius - m_height * m_height, 0.0));
        m_scene.decals.push_back({onGround(0.8 * wide),
                                  glm::vec4(0.05, 0.045, 0.04, 0.85 * (1.0 - std::abs(m_height) / m_radius)),
                                  glm::vec4(static_cast<double>(DecalKind::Scorch), 0.0, m_random.unit(), 0.0)});
    }

private:
    glm::vec4 onGround(double radius) const {
        const Vec3 place(m_blast.at.x, m_world.ground, m_blast.at.z);
        return glm::vec4(glm::vec3(place - m_world.origin), radius);
    }
    void add(const ParticleStart& start) {
        if (m_age < start.lifetime) m_scene.particles.push_back(particleAt(start, m_age, m_world));
    }

    RenderScene& m_scene;
    Blast m_blast;
    ParticleWorld m_world;
    double m_age, m_radius, m_height;  // s, m, m over the ground
    Random m_random;
};

}  // namespace

void addBlasts(RenderScene& scene, std::span<const BlastRecord> blasts, const DustMoment& moment) {
    std::uint64_t number = 0;  // of those before a step
    std::vector<BlastWriter> writers;
    for (std::size_t k = 0; k < blasts.size() && blasts[k].step <= moment.step; ++k) {
        number = k > 0 && blasts[k - 1].step == blasts[k].step ? number + 1 : 0;
        writers.emplace_back(scene, blasts[k], number, moment);
    }
    for (std::size_t k = writers.size() - std::min(writers.size(), kMaxScorches); k < writers.size(); ++k) {
        BlastWriter& writer = writers[k];
        if (writer.isAtGround()) writer.addScorch();
        if (k + kMaxBlasts < writers.size()) continue;
        if (writer.isAtGround()) writer.addRing();
        if (writer.isAtGround()) writer.addGroundDust();
        writer.addSmoke();
        writer.addFlash();  // over the smoke
    }
}

}  // namespace rubble
