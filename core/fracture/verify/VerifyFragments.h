#pragma once

#include "core/fracture/fragments/Fragment.h"
#include "core/fracture/pieces/Prism.h"

#include <optional>
#include <string>

namespace rubble {

/// Returns the first fault of fragments in one sentence, or nothing: pieces and fragments refer to each other; hulls
/// pass verifyPolytope() and fill their piece; volumes sum to the prism's minus the gap; contacts are mutual; origins
/// are centres of mass. Precondition: verifyPartition() finds no fault.
std::optional<std::string> verifyFragments(const Fragments& fragments, const Prism& prism);

}  // namespace rubble
