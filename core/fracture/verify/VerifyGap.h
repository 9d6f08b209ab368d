#pragma once

#include "core/fracture/fragments/Fragment.h"

#include <optional>
#include <string>

namespace rubble {

/// Returns the first fault of shrunk pieces in one sentence, or nothing: each lies within its original, and no corner
/// or midpoint of a side is nearer to a cut edge than half the gap (m; 0: none), up to 1e-9 of the outline's diameter.
/// Precondition: verifyPartition() finds no fault.
std::optional<std::string> verifyGap(const Fragments& fragments, double gap);

}  // namespace rubble
