#pragma once

#include "tests/oracle/FractureCases.h"

#include <optional>
#include <string>

namespace rubble::oracle {

/// Fractures the case and holds all that comes out against the oracle and the verify functions; says what is wrong
/// first, or nothing.
///
/// Areas agree to 1e-9, piece counts, neighbours and seeds without cell exactly, as far as points that are rounded once
/// can tell: an error of kHair in the place of each corner is allowed for.
std::optional<std::string> fractureFault(const FractureCase& fractureCase);

/// The smallest case made from a faulty one by leaving out seeds, holes and corners as long as it stays faulty.
FractureCase shrunk(FractureCase faulty);

}  // namespace rubble::oracle
