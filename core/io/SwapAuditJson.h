#pragma once

#include "core/play/SwapAudit.h"

#include <span>

namespace rubble {

/// The audit of an asset by its name; none where it breaks into nothing.
struct NamedAudit {
    std::string name;
    std::optional<SwapAudit> audit;
};

/// Audits as JSON:
///
///     {"assets":[{"name":s,"pieces":n,"contacts":n,"contactPoints":n,"deepestOverlap":d,
///       "resting":{"piece":s,"speed":v},"restingEnergy":E,"lying":{"piece":s,"speed":v},
///       "massDrift":x,"momentumDrift":x,"angularDrift":x,"energyGain":x,
///       "notices":[s,...],"faults":[s,...],"isClean":true},...]}
///
/// Of an asset that breaks into nothing there is its name and `"pieces":0` only.
std::string swapAuditJson(std::span<const NamedAudit> audits);

}  // namespace rubble
