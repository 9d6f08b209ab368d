#pragma once

#include "core/asset/import/AssetImport.h"

#include <QString>

#include <vector>

namespace rubble {

struct Units;

/// A fallback, and the refused objects that it imports.
struct OfferedFallback {
    WorkingFallback fallback;
    int objects = 0;
    double before = 0.0, after = 0.0;  // m³, of those whose volume is known
};

/// The fallbacks that import some of the refused objects, in the order in which these have them.
std::vector<OfferedFallback> offeredFallbacks(const std::vector<RejectedObject>& all);

/// The caption of a button; names the axis unless it is the selected one.
QString fallbackText(const WorkingFallback& working, PrismAxis selected);
/// How many objects a fallback imports, and what becomes of their volume.
QString fallbackToolTip(const OfferedFallback& offered, const Units& units);

}  // namespace rubble
