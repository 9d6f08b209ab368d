#pragma once

#include "viewport/scene/RenderScene.h"
#include "viewport/scene/play/DustParticles.h"

namespace rubble {

/// A chip when it comes off.
struct ChipStart {
    ChipShape shape = ChipShape::Angular;
    Vec3 from{0.0, 0.0, 0.0};      // m
    Vec3 velocity{0.0, 0.0, 0.0};  // m/s
    double radius = 0.0;           // m
    double lifetime = 0.0;         // s; shrinks away at its end
    Vec3 axis{1.0, 0.0, 0.0};      // about which it rotates, length 1
    double spin = 0.0;             // rad/s
    double seed = 0.0;             // of its form, in [0, 1)
    glm::vec3 colour{1.0f};        // sRGB
};

/// A chip at an age in [0, lifetime), s: it flies in a parabola, bounces twice off the ground, slides and lies flat.
/// Other bodies do not stop it. Where it starts below the ground it lies there.
Chip chipAt(const ChipStart& start, double age, const ParticleWorld& world);

/// The height of a chip's centre when it lies, m.
double lyingHeight(const ChipStart& start);

}  // namespace rubble
