#pragma once

#include "core/play/Aim.h"
#include "viewport/scene/RenderScene.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// How long a step took, ms of wall-clock time.
struct StepCost {
    std::uint64_t step = 0;
    double pairs = 0.0;    // finding pairs
    double collide = 0.0;  // how they touch
    double swaps = 0.0;    // breaking and exchanging bodies
    double solve = 0.0;    // preparing and solving
    double finish = 0.0;
    double total() const { return pairs + collide + swaps + solve + finish; }
};

/// What is to be told about a moment.
struct PlayFigures {
    StepCost cost;
    int bodies = 0;  // without the ground
    int asleep = 0;
    int candidatePairs = 0;
    int contactPoints = 0;
    double energy = 0.0;  // J, kinetic and of height
};

/// A break as it is told.
struct ToldBreak {
    std::uint64_t step = 0;
    std::string name;
    double impact = 0.0;     // N s
    double threshold = 0.0;  // N s
    Vec3 point{0.0, 0.0, 0.0};
    std::uint32_t pieces = 0;
    double milliseconds = 0.0;
    double ratio() const { return impact / threshold; }
};

/// A moment of play as a window shows it.
struct PlayFrame {
    std::shared_ptr<const PlayScene> played;
    std::shared_ptr<const RenderScene> scene;
    std::uint64_t step = 0;
    std::uint64_t length = 0;  // of the timeline, steps
    double shownFrom = 0.0;    // s of the clock: when the way from the moment before begins to be shown
    double shownFor = 0.0;     // s that it takes; 0: it is shown at once
    PlayFigures figures;
    std::optional<Flight> flight;  // of what is being aimed
    bool isHolding = false;        // something is grabbed
    bool hasDestruction = true;    // things break from here on
};

/// What happened since the last news, in order.
struct PlayNews {
    std::optional<PlayFrame> frame;             // the newest
    std::optional<std::uint64_t> forgetBeyond;  // what was told of later steps is not so any more; before the following
    std::vector<ToldBreak> breaks;
    std::vector<StepCost> costs;  // of new steps
    std::vector<std::string> notices;
    std::optional<ShotInput> shot;  // the last that was fired
};

}  // namespace rubble
