#pragma once

#include "core/base/Result.h"
#include "core/geometry/polygon/Polygon.h"

namespace rubble {

/// What a shape does to an outline.
enum class OutlineOperation { Add, Cut };

/// The union of an outline and a shape, or the outline without the shape: a shape inside it makes a hole, one across
/// its border a notch. Corners of both that remain keep their bits. Corners within kVisibleFraction of the outline's
/// extent from the other's border lie on it; pieces that are smaller vanish. Points between collinear edges are left
/// out unless the outline had them. Rings start at their first corner of the outline, and holes keep their order.
///
/// Errors: those of validated(Polygon) for the shape; Degenerate if the shape changes nothing, if nothing would remain,
/// if more than one part would, or if the outline would nearly touch itself.
Result<Polygon> combined(const Polygon& outline, const Ring& shape, OutlineOperation operation);

}  // namespace rubble
