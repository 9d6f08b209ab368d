#pragma once

#include "core/asset/Project.h"
#include "core/fracture/PatternKind.h"

#include <QString>

namespace rubble {

/// A text for users of a kind of layer or its parameters, in their language.
QString patternText(const char* text);
/// What a kind of layer is called wherever it is named: "Blue noise".
QString kindText(const LayerParameters& parameters);
/// The box around what a layer of the asset's whole (level 0), of one of its levels or fragments (see PatternPlaces.h), is to fill, in the frame of its
/// seeds; of the fragments of a level, which differ, one of a usual size.
Box2 boundsToFill(const Asset& asset, std::size_t level = 0);

}  // namespace rubble
