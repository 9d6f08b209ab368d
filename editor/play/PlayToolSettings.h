#pragma once

#include "core/asset/project/Project.h"

namespace rubble {

/// The settings of the interactive tools of play.
struct PlayToolSettings {
    // Its places say nothing; the speed, of a tapped throw, counts only if it is not automatic.
    Throw projectile{.size = {0.7, 0.7, 0.7}, .mass = 2500.0, .speed = 40.0};
    bool isSpeedAutomatic = true;                    // see reachingSpeed()
    bool throwsOnClick = false;                      // else a click selects
    double hammerImpulse = 5000.0;                   // N·s
    bool isHammerRadiusAutomatic = true;             // see patchRadius()
    double hammerRadius = 0.2;                       // m, of the patch that it strikes, if not automatic
    Blast blast{.impulse = 10000.0, .radius = 3.0};  // its place says nothing
    double grabForce = 20000.0;                      // N at most
    bool operator==(const PlayToolSettings&) const = default;
};

/// The defaults for a scene whose bounding box has a diagonal, m: those above for a wall or a house; in scenes smaller
/// than 2 m a projectile and forces that suit what is there, rounded to two digits.
PlayToolSettings defaultPlayTools(double diagonal);

/// What is taken away at a point.
enum class RemovalExtent { Body, Fragment };

/// A throw as the user charges it.
struct ChargedThrow {
    Throw projectile;
    bool isSpeedAutomatic = true;
    double charge = 0.0;  // in [0, 1]: 0 is a tap
    bool operator==(const ChargedThrow&) const = default;
};

inline constexpr double kFullCharge = 2.5;  // times the speed of a tap

}  // namespace rubble
