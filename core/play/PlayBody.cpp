#include "core/play/PlayBody.h"

namespace rubble {

std::string nameOf(const PlayBody& body, const PlayOrigin& origin) {
    if (body.fragment == kNone) return origin.name;
    const std::string id = body.asset->bake->fragmentId(body.fragment);
    return origin.name + id.substr(id.find('/'));
}

std::vector<Polytope> hullsOf(const PlayBody& body) {
    if (body.asset == nullptr) return {*body.hull};
    const Bake& bake = *body.asset->bake;
    if (body.fragment != kNone) return bake.fragment(body.fragment).solid.hulls();
    return wholeHullsInPrism(bake);
}

}  // namespace rubble
