#pragma once

#include "core/asset/Project.h"

namespace rubble {

/// A project with one material, "plaster", and nothing else: what an import is put into.
Project emptyProject();

/// The same with one asset, "wall": 1 x 1 x 0.5 m and 20 scattered seeds, and one instance of it that stands on the
/// ground. Something to break at once.
Project starterProject();

}  // namespace rubble
