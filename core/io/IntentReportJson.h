#pragma once

#include "core/asset/Project.h"
#include "core/play/Intent.h"

#include <span>
#include <string>

namespace rubble {

/// What the intents of an asset ask of its threshold.
struct IntentReport {
    Asset asset;
    double threshold = 0.0;  // N s, that is in force
    ThresholdInterval interval;
};

/// Reports as JSON, an intent a line:
///
///     {"assets":[{"name":s,"threshold":J,
///       "intents":[{"outcome":s,"kind":s,...,"sentence":s,"impulse":J},...],
///       "above":J,"atMost":J,"suggested":J,"isSatisfied":true,"conflict":s},...]}
///
/// The bounds, the suggestion and the conflict are null where there is none.
std::string intentReportJson(std::span<const IntentReport> reports);

}  // namespace rubble
