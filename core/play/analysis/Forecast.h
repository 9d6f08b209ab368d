#pragma once

#include "core/base/TaskContext.h"
#include "core/play/session/Session.h"

#include <functional>
#include <memory>
#include <vector>

namespace rubble {

/// A throw, and the state of the session in which it is about to be thrown.
struct ForecastOrder {
    std::shared_ptr<const PlayScene> scene;
    SessionSettings settings;
    std::shared_ptr<const SessionSnapshot> start;
    Throw thrown;
};

/// What a throw will do to a body.
struct BodyForecast {
    std::uint32_t body = 0;  // its number
    /// Impact ÷ threshold of the hardest impact: it breaks if this is at least 1. With bonds: the largest load of one
    /// by what breaks it, as PlayImpact: at least 1 if and only if one of them breaks, also where support is lost.
    double largest = 0.0;

    friend bool operator==(const BodyForecast&, const BodyForecast&) = default;
};

inline constexpr double kForecastTime = 4.0;  // s, from the throw on: most debris has landed by then

/// Carries out a throw on a copy of the session, and returns what it will do within kForecastTime to the bodies that
/// exist now and will be hit, by ascending number. The session itself does exactly the same, unless something else
/// happens to it meanwhile.
///
/// `refine` is called with the bodies so far when they have changed, at most four times per simulated second.
///
/// Errors: those of Session::add(); Cancelled.
using ForecastRefinement = std::function<void(const std::vector<BodyForecast>&)>;
Result<std::vector<BodyForecast>> breakForecast(const ForecastOrder& order, const TaskContext& task = {},
                                                const ForecastRefinement& refine = {});

}  // namespace rubble
