#pragma once

#include "tests/soak/PlayedCase.h"

namespace rubble::soak {

/// A case and how it fails.
struct ShrunkCase {
    SoakCase one;
    Failure failure;
};

/// The smallest case found that breaks the same promise: without inputs, instances, layers and numbers that it does not
/// need. Each attempt is played in a process of its own, at most `attempts` of them.
ShrunkCase shrunkCase(SoakCase one, Failure failure, int attempts = 300);

}  // namespace rubble::soak
