#pragma once

#include "editor/panels/SliderField.h"

namespace rubble {

/// A field for thresholds, N·s: its slider goes over those that things of a scene usually have, any other can be typed.
inline SliderField* thresholdField() {
    constexpr double kLeastUsual = 1.0, kMostUsual = 1e5;  // N·s
    auto* field = new SliderField(FieldRange::aboveZero(), kLeastUsual, kMostUsual, SliderScale::Logarithmic);
    field->setFormat({QObject::tr("N·s"), 0});
    return field;
}

}  // namespace rubble
