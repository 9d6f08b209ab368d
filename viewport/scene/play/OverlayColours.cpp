#include "viewport/scene/play/OverlayColours.h"

#include "core/asset/project/FragmentColours.h"

#include <algorithm>
#include <string>

namespace rubble {
namespace {

constexpr Colour kBreaks{0.93, 0.08, 0.30};
constexpr double kColdest = 0.2;  // start of the ramp: darker colours are hard to see on a dark ground
constexpr Colour kAsleep{0.30, 0.44, 0.68};
constexpr Colour kRemoved{1.0, 0.72, 0.10};
constexpr Colour kStanding{0.62, 0.66, 0.70};
constexpr Colour kStatic{0.62, 0.62, 0.64};  // static bodies belong to no island

Colour unpacked(std::uint32_t rgb) {
    return {(rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0};
}

Colour mixed(const Colour& a, const Colour& b, double fraction) {
    const auto mix = [&](double from, double to) { return from + fraction * (to - from); };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

double heatOf(std::span<const BodyHeat> heat, std::uint32_t number) {
    const auto found = std::ranges::lower_bound(heat, number, {}, &BodyHeat::body);
    return found != heat.end() && found->body == number ? found->value : 0.0;
}

bool isIn(const BodyPart& part, const BodyTint& body) {
    if (part.body != body.number) return false;
    return part.fragments.empty() || std::ranges::binary_search(part.fragments, body.fragment);
}

bool isFalling(const BodyCollapse& collapse, const BodyTint& body) {
    return std::ranges::binary_search(collapse.falling, body.number) ||
           std::ranges::any_of(collapse.fallingParts, [&](const BodyPart& part) { return isIn(part, body); });
}

/// Derived from the number of the island's first body, which is unique: the colour stays while that body is in the
/// island.
Colour islandColour(std::uint32_t root, const std::vector<std::uint32_t>& numbers) {
    return root == 0 ? kStatic : fragmentColour(std::to_string(numbers[root]));
}

}  // namespace

bool BodyCollapse::hasPartOf(std::uint32_t body) const {
    const auto isPart = [&](const BodyPart& part) { return part.body == body && !part.fragments.empty(); };
    return isPart(removed) || std::ranges::any_of(fallingParts, isPart);
}

Colour heatColour(double value) {
    return value >= 1.0 ? kBreaks : rampColour(kColdest + (1.0 - kColdest) * std::max(value, 0.0));
}

void tintBodies(RenderScene& scene, std::span<const BodyTint> bodies, const Session& session,
                const PlayOverlays& overlays, std::span<const BodyHeat> heat, const BodyCollapse* collapse) {
    std::vector<std::uint32_t> islands, numbers;
    if (overlays.hasIslands) {
        islands = session.world().islands();
        numbers.resize(islands.size());
        for (const BodyTint& body : bodies) numbers[body.id.index] = body.number;
    }
    for (const BodyTint& body : bodies) {
        BodyAppearance& appearance = scene.appearances[body.body];
        const auto paint = [&](const Colour& colour) {
            appearance.outside = packed(colour);
            appearance.inside = packed(insideOf(colour));
        };
        if (!islands.empty()) paint(islandColour(islands[body.id.index], numbers));
        if (overlays.hasBodies) paint(fragmentColour(std::to_string(body.number)));
        if (overlays.hasHeat) paint(heatColour(heatOf(heat, body.number)));
        const auto tint = [&](const Colour& colour) {
            for (std::uint32_t* surface : {&appearance.outside, &appearance.inside}) {
                *surface = packed(mixed(unpacked(*surface), colour, 0.75)) | (*surface & kTransparencyBits);
            }
        };
        if (overlays.hasSleep && body.isAsleep) tint(kAsleep);
        if (collapse == nullptr) continue;
        if (isIn(collapse->removed, body)) {
            paint(kRemoved);
        } else if (isFalling(*collapse, body)) {
            paint(kBreaks);
        } else {
            tint(kStanding);
        }
    }
}

}  // namespace rubble
