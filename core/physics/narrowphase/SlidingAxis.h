#pragma once

#include "core/physics/narrowphase/SeparatingAxis.h"

#include <optional>

namespace rubble {

/// The face along which two hulls stay apart while the second moves by `displacement`, m, in the first's frame, if they
/// would overlap along `axis` by then; nothing if they would not, or if no face keeps them apart. Of several faces the
/// one with the largest separation at the end.
///
/// Hulls that are separated along one axis before and after a displacement do not meet. A box that slides over flush
/// tiles is farther from the side of the next tile than from its top: a contact with that side, an inner edge of the
/// floor, would stop it.
std::optional<SeparatingAxis> slidingAxis(const SeparatingAxis& axis, const Hull& first, const Hull& second,
                                          const RelativePose& pose, Vec3f displacement);

}  // namespace rubble
