#include "core/play/scene/PlayBody.h"

#include <algorithm>
#include <numeric>

namespace rubble {

std::string nameOf(const PlayBody& body, const PlayOrigin& origin) {
    const bool isSingle = body.role == PlayRole::Debris && body.nodes.size() == 1;
    const std::uint32_t fragment = isSingle ? fragmentsOf(body).front() : body.fragment;
    std::string name = fragment != kNone ? fragmentName(body, origin, fragment) : origin.name;
    if (body.role == PlayRole::Debris && body.nodes.size() > 1) {
        name += " (" + std::to_string(body.nodes.size()) + " fragments)";
    }
    return name;
}

std::string fragmentName(const PlayBody& body, const PlayOrigin& origin, std::uint32_t fragment) {
    const std::string id = body.asset->bake->fragmentId(fragment);
    return origin.name + id.substr(id.find('/'));
}

bool isPartial(const PlayBody& body) {
    return !body.nodes.empty() && body.nodes.size() < body.asset->fractureOf(body.fragment)->count;
}

std::vector<std::uint32_t> fragmentsOf(const PlayBody& body) {
    std::vector<std::uint32_t> fragments = body.nodes;
    for (std::uint32_t& fragment : fragments) fragment += body.asset->fractureOf(body.fragment)->first;
    return fragments;
}

std::vector<std::uint32_t> bondedFragments(const PlayBody& body) {
    const PlayFracture* const fracture = body.bondedFracture();
    if (fracture == nullptr || !body.nodes.empty()) return fragmentsOf(body);
    std::vector<std::uint32_t> fragments(fracture->count);
    std::iota(fragments.begin(), fragments.end(), fracture->first);
    return fragments;
}

Vec3 frameOf(const PlayBody& body) {
    return body.asset == nullptr || isPartial(body) ? Vec3(0.0) : body.asset->solid(body.fragment).offset;
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
    if (isPartial(body)) {
        std::vector<Polytope> hulls;
        for (const std::uint32_t fragment : fragmentsOf(body)) {
            const Fragment solid = bake.fragment(fragment).solid;
            for (Polytope& hull : solid.hulls()) hulls.push_back(translated(std::move(hull), solid.offset()));
        }
        return hulls;
    }
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
