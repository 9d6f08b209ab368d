#pragma once

#include "core/asset/project/Ranges.h"
#include "editor/widgets/NumberField.h"

namespace rubble {

/// The field range of a number of a project. `step`: the step of arrows and wheel; 0: one in the value's second digit.
FieldRange fieldRange(ProjectNumber number, double step = 0.0);
/// The field range of a whole number of a project.
FieldRange wholeFieldRange(ProjectNumber number);
/// The field range of a number that is 0 if unset.
FieldRange optionalFieldRange(ProjectNumber number);

}  // namespace rubble
