#pragma once

#include "core/asset/project/Project.h"

#include <glm/vec3.hpp>

#include <optional>

namespace rubble {

/// What a material breaks into.
enum class DebrisKind {
    Mineral,  // brick, stone and concrete: angular chips, grit and dust
    Powder,   // plaster: small chips and much dust
    Glass,    // flat splinters that glint, hardly any dust
    Ice,      // pale angular chips, hardly any dust
    Metal,    // a few chips, and sparks where it is hit hard
    Wood,     // long splinters, hardly any dust
};

/// What the particles of a material are, and their colours.
struct DebrisMaterial {
    DebrisKind kind = DebrisKind::Mineral;
    Colour inside, outside;
};

/// The kind that a material's density, toughness and opacity indicate.
DebrisKind debrisKindOf(const Material& material);
/// What comes off a body, or the ground, with a material. Nothing of a plain projectile, which has none.
std::optional<DebrisMaterial> debrisMaterialOf(const Project& project, Id material, bool isGround);

/// A colour as particles have it, mixed with a fraction of that of pale dust.
glm::vec3 paleColour(const Colour& colour, double pale);

}  // namespace rubble
