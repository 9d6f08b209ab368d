#pragma once

#include "viewport/scene/RenderScene.h"

namespace rubble {

/// The moment that is shown.
struct DustMoment {
    std::uint64_t step = 0;
    double stepLength = 1.0 / 60.0;  // s
    Vec3 gravity{0.0, 0.0, 0.0};     // m/s²

    /// The age of what a step reported, s.
    double ageOf(std::uint64_t then) const { return stepLength * static_cast<double>(step + 1 - then); }
};

/// A particle when it starts.
struct ParticleStart {
    ParticleKind kind = ParticleKind::Dust;
    Vec3 from{0.0, 0.0, 0.0};      // m
    Vec3 velocity{0.0, 0.0, 0.0};  // m/s
    double radius = 0.0;           // m
    double lifetime = 0.0;         // s
    double opacity = 1.0;          // dust: after it has faded in
    glm::vec3 colour{1.0f};        // sRGB
    double seed = 0.0;             // of the noise of dust, in [0, 1)
    bool isLingering = false;      // dust: sinks, and spreads over the ground
};

/// Where particles fall.
struct ParticleWorld {
    Vec3 gravity{0.0, 0.0, 0.0};  // m/s²; dust and flashes float
    double ground = 0.0;          // m: the height at which they lie; far below all without a ground
    Vec3 origin{0.0, 0.0, 0.0};   // m: of the scene
    double stepLength = 0.0;      // s
};
ParticleWorld particleWorldOf(const RenderScene& scene, const DustMoment& moment);

/// A particle at an age in (0, lifetime), s. Dust drifts, grows and fades; a flash fades; sparks fall, and lie on the
/// ground until they fade.
Particle particleAt(const ParticleStart& start, double age, const ParticleWorld& world);

}  // namespace rubble
