#pragma once

#include "core/fracture/Pattern.h"

#include <QString>

namespace rubble {

/// What a kind of layer is called wherever it is named: "Blue noise".
QString kindText(const LayerParameters& parameters);

}  // namespace rubble
