#include "core/play/scene/PlayBody.h"

#include <algorithm>

namespace rubble {

std::string nameOf(const PlayBody& body, const PlayOrigin& origin) {
    if (body.fragment == kNone) return origin.name;
    const std::string id = body.asset->bake->fragmentId(body.fragment);
    return origin.name + id.substr(id.find('/'));
}

DiagnosticPlace placeOf(const PlayBody& body) {
    if (body.asset == nullptr) return {};
    const Bake& bake = *body.asset->bake;
    if (body.fragment == kNone) return {.asset = bake.asset};
    return {.asset = bake.asset,
            .level = bake.fragment(body.fragment).level,
            .fragment = body.fragment,
            .path = bake.fragmentPath(body.fragment)};
}

std::vector<Polytope> hullsOf(const PlayBody& body) {
    if (body.asset == nullptr) return {*body.hull};
    const Bake& bake = *body.asset->bake;
    if (body.fragment != kNone) return bake.fragment(body.fragment).solid.hulls();
    return wholeHullsInPrism(bake);
}

double topHeight(const PlayBody& body, const World& world) {
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
