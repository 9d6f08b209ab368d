#include "viewport/scene/BondLines.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr float kThinnest = 0.5f, kWidest = 3.5f;  // points, radii
constexpr glm::vec4 kColour{0.98f, 0.55f, 0.10f,
                            0.95f};  // sRGB: stands out from stone, glass and the selection's accent

/// Calls visit(first body, second body, area) for every visible bond.
template <class Visit>
void forEachBond(const RenderScene& scene, std::span<const AssetModel* const> models, Visit visit) {
    const auto isHidden = [&](std::uint32_t body) { return (scene.appearances[body].marks & kHidden) != 0; };
    for (std::size_t k = 0; k < models.size(); ++k) {
        if (!models[k]->bonds) continue;
        for (const std::uint32_t body : scene.batches[k].firstBodies) {
            for (const ModelBond& bond : *models[k]->bonds) {
                const std::uint32_t first = body + bond.first, second = body + bond.second;
                if (!isHidden(first) && !isHidden(second)) visit(first, second, bond.area);
            }
        }
    }
}

}  // namespace

void addBondLines(RenderScene& scene, std::span<const AssetModel* const> models) {
    forEachBond(scene, models, [&](std::uint32_t, std::uint32_t, double area) {
        scene.largestBondArea = std::max(scene.largestBondArea, area);
    });
    const auto centreOf = [&](std::uint32_t body) {
        return glm::vec3(scene.poses[body].position) + glm::vec3(explodeOffset(scene, body));
    };
    forEachBond(scene, models, [&](std::uint32_t first, std::uint32_t second, double area) {
        const auto fraction = static_cast<float>(area / scene.largestBondArea);
        const float radius = kThinnest + (kWidest - kThinnest) * fraction;
        scene.lines.push_back({glm::vec4(centreOf(first), radius), glm::vec4(centreOf(second), 0.0f), kColour});
    });
}

}  // namespace rubble
