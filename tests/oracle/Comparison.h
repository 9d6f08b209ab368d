#pragma once

#include "tests/oracle/FractureCases.h"

#include <optional>
#include <string>

namespace rubble::oracle {

/// Fractures the case and compares all results with the oracle and the verify functions. Returns the first fault, or
/// nothing.
///
/// Areas agree to 1e-9; piece counts, neighbours and seeds without cell agree exactly, within the precision of points
/// that are rounded once: each corner may be off by kCornerError.
std::optional<std::string> fractureFault(const FractureCase& fractureCase);

/// Minimizes a failing case: removes seeds, holes and corners while it still fails.
FractureCase shrunk(FractureCase faulty);

}  // namespace rubble::oracle
