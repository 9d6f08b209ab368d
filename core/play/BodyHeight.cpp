#include "core/play/BodyHeight.h"

#include <algorithm>

namespace rubble {

double topOf(const PlayBody& body, const World& world) {
    const Pose pose = world.state(body.body).pose;
    double top = pose.position.y;
    bool isFirst = true;
    for (const Polytope& hull : hullsOf(body)) {
        for (const Vec3& vertex : hull.vertices) {
            const double height = (pose.position + pose.orientation * vertex).y;
            top = isFirst ? height : std::max(top, height);
            isFirst = false;
        }
    }
    return top;
}

}  // namespace rubble
