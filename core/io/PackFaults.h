#pragma once

#include "core/io/PackFile.h"

#include <optional>
#include <string>

namespace rubble {

/// What the bodies of a pack are held against.
struct SolidScale {
    double density = 0.0;      // kg/m^3
    double size = 0.0;         // m, the diagonal of the whole
    double slackVolume = 0.0;  // m^3 that a body may have been given of pieces too thin for a hull
};
SolidScale scaleOf(const Pack& pack);

/// What is wrong with a body alone: its mass, its inertia, its hulls, and how these agree. Begins in the middle of a
/// sentence: "hull 0: Face 2 is not planar ...".
std::optional<std::string> solidFault(const PackBody& body, const SolidScale& scale);

}  // namespace rubble
