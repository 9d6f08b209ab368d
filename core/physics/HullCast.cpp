#include "core/physics/HullCast.h"

#include "core/physics/Manifold.h"

namespace rubble {
namespace {

// What touches is within so much of what touches first: a face that meets flat does so with all its corners, up to rounding.
constexpr float kAtOnce = 1e-3f;  // m

Vec3f middleOf(const Manifold& manifold) {
    Vec3f sum(0.0f);
    for (int i = 0; i < manifold.count; ++i) sum += manifold.points[i].place;
    return sum * (1.0f / static_cast<float>(manifold.count));
}

}  // namespace

HullMeeting meetingOf(const Hull& first, const Hull& second, const RelativePlace& place, Vec3f way) {
    SweptTouch touch{separatingAxis(first, second, place, 0.0f, {}), 0.0f};
    if (touch.axis.separation > 0.0f) touch = sweptTouch(first, second, place, way * -1.0f);
    if (touch.axis.kind == AxisKind::None) return {};
    const RelativePlace met{place.turn, place.offset - way * touch.share};
    const Manifold manifold = touchingAlong(touch.axis, first, second, met, touch.axis.separation + kAtOnce);
    return {touch.share, middleOf(manifold), touch.axis.normal * -1.0f};
}

}  // namespace rubble
