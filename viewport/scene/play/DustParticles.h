#pragma once

#include "viewport/scene/RenderScene.h"

namespace rubble {

/// A particle when it starts.
struct ParticleStart {
    ParticleKind kind = ParticleKind::Dust;
    Vec3 from{0.0, 0.0, 0.0};      // m
    Vec3 velocity{0.0, 0.0, 0.0};  // m/s
    double radius = 0.0;           // m
    double lifetime = 0.0;         // s
    double opacity = 1.0;          // dust: after it has faded in
    glm::vec3 colour{1.0f};        // sRGB
    double phase = 0.0;            // in [0, 1): dust: the seed of its noise; others: their rotation, in turns
    double spin = 0.0;             // turns/s
};

/// Where particles fall.
struct ParticleWorld {
    Vec3 gravity{0.0, 0.0, 0.0};  // m/s²; dust and flashes float
    double ground = 0.0;          // m: the height at which they lie; far below all without a ground
    Vec3 origin{0.0, 0.0, 0.0};   // m: of the scene
    double stepLength = 0.0;      // s
};

/// A particle at an age in (0, lifetime), s. Dust drifts, grows and fades; a flash fades; the others fall, and lie on
/// the ground until they fade; sparks glow.
Particle particleAt(const ParticleStart& start, double age, const ParticleWorld& world);

}  // namespace rubble
