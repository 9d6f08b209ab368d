#pragma once

#include "core/io/pack/PackFile.h"

#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// The size of a pack's whole, which the tolerances of its bodies are relative to.
struct PackScale {
    double density = 0.0;      // kg/m³
    double size = 0.0;         // m, the diagonal of the whole
    double slackVolume = 0.0;  // m³ that a body may have received from pieces too thin for a hull
    double inset = 0.0;        // m: of hulls
};
PackScale scaleOf(const Pack& pack);

/// The hulls of a body without their insets: exactly, but where a narrow face vanished. An inset hull that is not a
/// prism stays as it is.
std::vector<Polytope> solidsOf(const PackBody& body);

/// Returns the first error in a body's mass, inertia and hulls, if there is one, to follow the body's name: "hull 0:
/// Face 2 is not planar ...".
std::optional<std::string> verifyPackBody(const PackBody& body, const PackScale& scale);

}  // namespace rubble
