#pragma once

#include "editor/document/Edit.h"

#include <optional>
#include <string>

namespace rubble {

/// Why an edit must not be applied, as a sentence: a value that it sets is out of range, so that the project could be
/// neither saved nor loaded (see valueFault()). An element that has a fault already, as in a restored backup, may be
/// given any value, so that it can be mended step by step. Takes time for what the edit changes, and for the assets of
/// materials that it changes. The project and the edit are the same afterwards.
std::optional<std::string> editFault(Project& project, Edit& edit);

}  // namespace rubble
