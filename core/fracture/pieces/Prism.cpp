#include "core/fracture/pieces/Prism.h"

#include "core/base/MessageText.h"
#include "core/geometry/polygon/PolygonFaults.h"
#include "core/geometry/predicates/Predicates.h"

#include <cmath>

namespace rubble {

Result<Prism> validated(Prism prism) {
    Result<Polygon> outline = validated(std::move(prism.outline));
    if (!outline) return outline.error();
    if (!(prism.depth > 0.0) || !std::isfinite(prism.depth))
        return Error{ErrorCode::BadInput,
                     "The depth is " + messageText(prism.depth) + "; it must be finite and greater than zero."};
    if (!isExactlyUsable(prism.depth / 2.0))
        return Error{ErrorCode::BadInput, "The depth is " + messageText(prism.depth) + "; it must be between " +
                                              messageText(kMinMagnitude) + " and " + messageText(kMaxMagnitude) + "."};
    prism.outline = std::move(*outline);
    return prism;
}

}  // namespace rubble
