#pragma once

#include "editor/commands/LayerKind.h"
#include "editor/panels/Units.h"

#include <QLocale>

namespace rubble {

/// The name of a kind's icon: "layer-blue-noise".
const char* kindIconName(const LayerParameters& parameters);
/// A layer in a few words: "Blue noise, 0.1 m apart".
QString layerText(const PatternLayer& layer, const Units& units, const QLocale& locale);

}  // namespace rubble
