#pragma once

#include "core/play/analysis/ContactSheet.h"
#include "editor/widgets/numbers/Units.h"

#include <QString>

namespace rubble {

/// Returns the name of a measure: "Smallest fragment".
QString measureName(SheetMeasure measure);

/// Returns the caption of a variant: its number, the number of its fragments, the smallest and the longest one, and the
/// effect of the shot.
QString captionOf(const SheetEntry& entry, const Units& units);

/// What was changed in single fragments of an asset, for a question about a variant that does not have it: how many
/// merges and splits, own patterns, own thresholds.
QString fragmentChanges(const Asset& asset);

}  // namespace rubble
