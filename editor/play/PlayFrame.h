#pragma once

#include "core/play/analysis/Forecast.h"
#include "core/play/session/Aim.h"
#include "editor/play/EventCourse.h"
#include "viewport/scene/RenderScene.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// The wall-clock time of a step by phase, ms.
struct StepCost {
    std::uint64_t step = 0;
    double pairs = 0.0;    // broad phase
    double collide = 0.0;  // narrow phase
    double swaps = 0.0;    // breaking bodies and swapping them for fragments
    double solve = 0.0;    // preparing and solving constraints
    double finish = 0.0;
    double total() const { return pairs + collide + swaps + solve + finish; }
};

/// Statistics of a step.
struct PlayStatistics {
    StepCost cost;
    int bodies = 0;  // except the ground
    int asleep = 0;
    int candidatePairs = 0;
    int contactPoints = 0;
    double energy = 0.0;  // J, kinetic and potential
};

/// A former course of the simulation that can be returned to.
struct PlayBranch {
    std::uint32_t id = 0;
    std::uint64_t fork = 0;    // the last step that it shares with the current course
    std::uint64_t length = 0;  // steps
    BreakCounts broken;
    bool operator==(const PlayBranch&) const = default;
};

/// The steps that are played again and again: after the last comes the first.
struct PlayLoop {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
    bool operator==(const PlayLoop&) const = default;
};

/// A body that is dragged by a spring.
struct GrabbedBody {
    Vec3 point{0.0, 0.0, 0.0};   // of the body, m; where the spring pulls
    Vec3 target{0.0, 0.0, 0.0};  // m; where it is pulled to
    double mass = 0.0;           // kg
    double weight = 0.0;         // N
    double force = 0.0;          // of the spring, N, at most
    /// True if the spring cannot lift it.
    bool isTooHeavy() const { return force < weight; }
};

/// What would fall without the body, or the bonded fragment, at the pointer.
struct CollapseForecast {
    std::string name;        // of that body or fragment
    std::size_t bodies = 0;  // that would fall, with the fragments
    double mass = 0.0;       // kg, of these
    double first = 0.0;      // s, until the first and the last of them have fallen on what stands below; infinite where
    double last = 0.0;       // there is nothing
};

/// The state after a step as it is displayed.
struct PlayFrame {
    std::shared_ptr<const PlayScene> played;
    std::shared_ptr<const RenderScene> scene;
    std::uint64_t step = 0;
    std::uint64_t length = 0;  // of the timeline, steps
    double shownFrom = 0.0;    // clock time at which the interpolation from the previous frame starts, s
    double shownFor = 0.0;     // duration of the interpolation, s; 0: none
    PlayStatistics statistics;
    std::optional<Throw> aimed;                // the throw being aimed
    std::optional<Trajectory> trajectory;      // its trajectory
    bool hasForecast = false;                  // the heat overlay shows what it will do
    std::optional<CollapseForecast> collapse;  // if its overlay is on
    std::optional<GrabbedBody> grabbed;
    bool hasDestruction = true;  // bodies can break from here on
    bool isAtRest = false;       // see PlayEngine::isAtRest()
    bool isRecorded = false;     // the session is still on its way to the step that is sought; another frame follows
    std::optional<PlayLoop> loop;
    std::vector<PlayBranch> branches;  // oldest first
};

/// The events since the previous update, in order.
struct PlayUpdate {
    std::optional<PlayFrame> frame;             // the newest
    std::optional<std::uint64_t> discardAfter;  // the records of later steps are void; applied before the following
    std::vector<std::shared_ptr<const LoggedStep>> events;  // of new steps
    std::vector<StepCost> costs;                            // of new steps
    std::vector<Diagnostic> diagnostics;
    std::optional<ShotInput> shot;               // the last that was fired
    std::shared_ptr<const ForecastOrder> order;  // a forecast to compute, see PlayEngine::setForecast()
    bool isReplayOver = false;                   // a script has ended
    bool isBranchKept = false;                   // an input in the past has made the former future a branch
};

}  // namespace rubble
