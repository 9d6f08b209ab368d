#pragma once

#include "app/thesis/ThesisMethod.h"
#include "core/io/fracture/FractureJson.h"

#include <string>
#include <vector>

namespace rubble {

/// Returns the cells of the reference method's diagram, each of one piece; neighbours share a triangle. Cells with
/// fewer than three corners or with a corner that is not finite are left out.
std::vector<Cell> thesisCells(const ThesisDiagram& diagram);

/// Fractures the prism by the reference method, which ignores holes, and returns the result as cellsJson().
std::string thesisJson(const FractureInput& input);

}  // namespace rubble
