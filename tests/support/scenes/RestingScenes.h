#pragma once

#include "core/physics/world/BodyScene.h"

#include <cstdint>
#include <span>

namespace rubble::test {

/// Whether bodies stand from the start, or fall and come to rest.
enum class RestingKind { Stack, Pile };

/// What a scene may have come to when it rests.
struct RestingLimits {
    double seconds = 10.0;       // until all bodies sleep
    double drift = 0.01;         // m, horizontally, of a stack
    double penetration = 0.006;  // m, and half the thinnest side
};

/// A scene of bodies on a ground that must all come to rest. The bodies are displaced at random.
struct RestingScene {
    const char* name;
    RestingKind kind;
    BodyScene (*build)(std::uint64_t randomSeed);
    RestingLimits limits{};
};

// Deterministic; the ground is the first body, its top the plane y = 0; density 1000 kg/m³, friction 0.6.

/// Bodies that lie flat on each other: of several hulls, round, thin, high, and under a load of 1,000 times their mass.
std::span<const RestingScene> stackScenes();
/// Slender, flat, compact and concave bodies that fall onto each other from a low height.
std::span<const RestingScene> pileScenes();

/// The thinnest hull of the dynamic bodies, m.
double thinnestSide(const BodyScene& scene);

}  // namespace rubble::test
