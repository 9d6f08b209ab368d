#pragma once

#include "core/fracture/pattern/PatternKind.h"
#include "editor/widgets/numbers/Units.h"

#include <QLocale>

namespace rubble {

/// The translation of a text of PatternKind or LayerParameter.
QString patternText(const char* text);
/// The translated name of a layer's kind: "Blue noise".
QString layerKindName(const LayerParameters& parameters);
/// A text in title case for menus: "Blue noise" becomes "Blue Noise".
QString inTitleCase(QString text);
/// A layer in a few words: "Blue noise, 0.1 m apart". See PatternKind::summary.
QString layerText(const PatternLayer& layer, const Units& units = {}, const QLocale& locale = {});
/// The same for lists, after the number that messages and the names of seeds have: "3 · Blue noise, 0.1 m apart".
QString numberedLayerText(const PatternLayer& layer, const Units& units = {}, const QLocale& locale = {});

}  // namespace rubble
