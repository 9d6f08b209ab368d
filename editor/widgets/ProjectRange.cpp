#include "editor/widgets/ProjectRange.h"

namespace rubble {

FieldRange fieldRange(ProjectNumber number, double step) {
    const NumberRange& range = rangeOf(number);
    return {.min = range.min,
            .max = range.max,
            .isMinExcluded = range.isMinExcluded,
            .step = step,
            .leastAboveZero = range.leastAboveZero};
}

FieldRange wholeFieldRange(ProjectNumber number) {
    const NumberRange& range = rangeOf(number);
    return FieldRange::whole(range.min, range.max);
}

FieldRange optionalFieldRange(ProjectNumber number) {
    FieldRange range = fieldRange(number);
    range.leastAboveZero = range.min;
    range.min = 0.0;
    range.isMinExcluded = false;
    return range;
}

}  // namespace rubble
