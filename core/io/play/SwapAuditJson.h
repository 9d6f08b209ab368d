#pragma once

#include "core/play/analysis/SwapAudit.h"

#include <span>

namespace rubble {

/// The swap audit of an asset; none if the asset does not break.
struct NamedAudit {
    std::string name;
    std::optional<SwapAudit> audit;
};

/// Returns swap audits as JSON:
///
///     {"assets":[{"name":s,"pieces":n,"contacts":n,"contactPoints":n,"deepestOverlap":d,
///       "resting":{"piece":s,"speed":v},"restingEnergy":E,"lying":{"piece":s,"speed":v},
///       "exported":{"piece":s,"gap":d},"massDrift":x,"momentumDrift":x,"angularDrift":x,"energyGain":x,
///       "notices":[s,...],"faults":[s,...],"isClean":true},...]}
///
/// `lying` is of prisms only. An asset that does not break has `name` and `"pieces":0` only.
std::string swapAuditJson(std::span<const NamedAudit> audits);

}  // namespace rubble
