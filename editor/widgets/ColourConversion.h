#pragma once

#include "core/asset/project/FragmentColours.h"

#include <QColor>

namespace rubble {

/// A colour with eight bits per channel, as in the 3D view.
inline QColor toQColor(const Colour& colour) { return QColor(packed(colour)); }

/// A colour of eight bits per channel, as the colour dialog returns it.
inline Colour fromQColor(const QColor& colour) {
    return {colour.red() / 255.0, colour.green() / 255.0, colour.blue() / 255.0};
}

}  // namespace rubble
