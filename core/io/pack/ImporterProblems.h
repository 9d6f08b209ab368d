#pragma once

#include "core/base/Diagnostic.h"
#include "core/io/exchange/Pack.h"
#include "core/io/pack/PackExport.h"

#include <span>
#include <vector>

namespace rubble {

/// What importers do with materials because of their names, see importerEffect(). Objects and files have names without
/// such endings.
std::vector<Diagnostic> surfaceNameProblems(std::span<const PackSurface> surfaces);

/// What other programs cut or cannot open, since a name in the export is too long.
std::vector<Diagnostic> nameLengthProblems(const PackListing& pack);

/// What engines do with hulls of many corners, one diagnostic for a pack: of the limit that its largest hull is above.
std::vector<Diagnostic> hullCornerProblems(const Pack& pack);

}  // namespace rubble
