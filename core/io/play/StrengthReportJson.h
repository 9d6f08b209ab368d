#pragma once

#include "core/asset/project/Project.h"
#include "core/play/analysis/ThresholdInterval.h"

#include <span>
#include <string>

namespace rubble {

/// The strength requirements of an asset and the thresholds that satisfy them.
struct StrengthReport {
    Asset asset;
    double strength = 0.0;  // the asset's threshold, N·s; where it breaks along bonds, N·s/m² of these
    ThresholdInterval interval;
};

/// Returns reports as JSON, one requirement per line:
///
///     {"assets":[{"name":s,"threshold":J,
///       "intents":[{"outcome":s,"kind":s,...,"sentence":s,"impulse":J},...],
///       "above":J,"atMost":J,"suggested":J,"isSatisfied":true,"conflict":s},...]}
///
/// Bounds, suggestion and conflict are null if there is none. An asset that breaks along bonds has "impulsePerArea" in
/// place of "threshold", and the figures are impulses per area.
std::string strengthReportJson(std::span<const StrengthReport> reports);

}  // namespace rubble
