#pragma once

#include "core/asset/project/Project.h"
#include "core/play/analysis/StrengthRequirement.h"

#include <span>
#include <string>

namespace rubble {

/// The strength requirements of an asset and the thresholds that satisfy them.
struct StrengthReport {
    Asset asset;
    std::optional<double> threshold;                  // N·s, of the asset; none if it breaks along bonds
    ThresholdInterval interval;                       // without impulses if there is a fault
    std::optional<std::string> fault = std::nullopt;  // why its requirements cannot be judged
};

/// Returns reports as JSON, one requirement per line:
///
///     {"assets":[{"name":s,"threshold":J,
///       "intents":[{"outcome":s,"kind":s,...,"sentence":s,"impulse":J},...],
///       "above":J,"atMost":J,"suggested":J,"isSatisfied":true,"conflict":s},...]}
///
/// Bounds, suggestion and conflict are null if there is none. An asset that breaks along bonds has null as threshold;
/// if it has requirements, their impulses are null, and the conflict says why.
std::string strengthReportJson(std::span<const StrengthReport> reports);

}  // namespace rubble
