#include "viewport/scene/MomentColours.h"

#include "core/asset/PieceColours.h"

#include <algorithm>
#include <string>

namespace rubble {
namespace {

constexpr Colour kBreaks{0.93, 0.08, 0.30};
constexpr double kColdest = 0.2;  // of the ramp: below, bodies are hardly seen before a dark ground
constexpr Colour kAsleep{0.30, 0.44, 0.68};
constexpr Colour kStands{0.62, 0.62, 0.64};  // never moves: of no island

Colour unpacked(std::uint32_t rgb) {
    return {(rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0};
}

Colour mixed(const Colour& a, const Colour& b, double share) {
    const auto mix = [&](double from, double to) { return from + share * (to - from); };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

double heatOf(std::span<const BodyHeat> heat, std::uint32_t number) {
    const auto found = std::ranges::lower_bound(heat, number, {}, &BodyHeat::body);
    return found != heat.end() && found->body == number ? found->value : 0.0;
}

/// By the number of the island's first body, which nobody else ever has: a colour stays while that body is in it.
Colour islandColour(std::uint32_t root, const std::vector<std::uint32_t>& numbers) {
    return root == 0 ? kStands : pieceColour(std::to_string(numbers[root]));
}

}  // namespace

Colour heatColour(double value) {
    return value >= 1.0 ? kBreaks : rampColour(kColdest + (1.0 - kColdest) * std::max(value, 0.0));
}

void tintBodies(RenderScene& scene, std::span<const BodyTint> bodies, const Session& session,
                const PlayOverlays& overlays, std::span<const BodyHeat> heat) {
    std::vector<std::uint32_t> islands, numbers;
    if (overlays.hasIslands && !overlays.hasHeat) {
        islands = session.world().islands();
        numbers.resize(islands.size());
        for (const BodyTint& body : bodies) numbers[body.id.index] = body.number;
    }
    for (const BodyTint& body : bodies) {
        BodyLook& look = scene.looks[body.body];
        const auto paint = [&](const Colour& colour) {
            look.outside = packed(colour);
            look.inside = packed(insideOf(colour));
        };
        if (overlays.hasHeat) paint(heatColour(heatOf(heat, body.number)));
        if (!islands.empty()) paint(islandColour(islands[body.id.index], numbers));
        if (overlays.hasSleep && body.isAsleep) {
            look.outside = packed(mixed(unpacked(look.outside), kAsleep, 0.75));
            look.inside = packed(mixed(unpacked(look.inside), kAsleep, 0.75));
        }
    }
}

}  // namespace rubble
