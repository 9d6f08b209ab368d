#pragma once

#include "core/fracture/Pattern.h"
#include "editor/panels/Units.h"

#include <QLocale>

namespace rubble {

/// The name of a kind of layer: "Blue noise".
QString kindText(const LayerParameters& parameters);
/// The name of its icon: "layer-blue-noise".
QString kindIconName(const LayerParameters& parameters);
/// A layer in a few words: "Blue noise, 0.1 m apart".
QString layerText(const PatternLayer& layer, const Units& units, const QLocale& locale);

}  // namespace rubble
