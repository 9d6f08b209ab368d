#include "viewport/scene/play/ContactLines.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kArrowLength = 1.0 / 3.0;  // of an asset's size
constexpr double kNormalLength = 0.5;       // of the scale
constexpr double kImpulseOfScale = 100.0;   // N·s
constexpr double kShortest = 0.1, kLongest = 4.0;

// In points and sRGB. They differ in lightness and shape, too, for colour-blind users.
constexpr float kDotRadius = 3.2f, kThin = 0.8f, kThick = 1.3f;
constexpr glm::vec4 kTouching{0.10f, 0.75f, 0.80f, 1.0f}, kOverlapping{0.95f, 0.15f, 0.20f, 1.0f};
constexpr glm::vec4 kNormal{0.30f, 0.45f, 0.95f, 1.0f}, kImpulse{0.98f, 0.62f, 0.08f, 1.0f};
constexpr glm::vec4 kBox{0.72f, 0.35f, 0.85f, 0.8f};

double sizeOf(const PlayAsset& asset) {
    Box3 box;
    for (const Polytope& hull : wholeHullsInPrism(*asset.bake)) {
        for (const Vec3& vertex : hull.vertices) box.include(vertex);
    }
    return box.diagonal();
}

}  // namespace

double arrowScale(const PlayScene& scene) {
    double sum = 0.0;
    for (const auto& [id, asset] : scene.assets) sum += sizeOf(*asset);
    return scene.assets.empty() ? 1.0 : kArrowLength * sum / static_cast<double>(scene.assets.size());
}

double impulseLength(double impulse, double scale) {
    return scale * std::clamp(std::sqrt(std::max(impulse, 0.0) / kImpulseOfScale), kShortest, kLongest);
}

void addContactLines(RenderScene& scene, const Session& session, const PlayOverlays& overlays, double scale) {
    const auto add = [&](Vec3 from, Vec3 to, glm::vec4 colour, float radius, LineEnd end) {
        scene.lines.push_back({glm::vec4(glm::vec3(from - scene.origin), radius),
                               glm::vec4(glm::vec3(to - scene.origin), end == LineEnd::Arrow ? 1.0f : 0.0f), colour});
    };
    for (const ContactPoint& contact : session.world().contactPoints()) {
        const Vec3 point = contact.point;
        if (overlays.hasNormals)
            add(point, point + kNormalLength * scale * contact.normal, kNormal, kThin, LineEnd::Arrow);
        if (overlays.hasImpulses && contact.impulse > 0.0) {
            const Vec3 arrow = impulseLength(contact.impulse, scale) * contact.normal;
            add(point, point + arrow, kImpulse, kThick, LineEnd::Arrow);
        }
        if (!overlays.hasContacts) continue;
        add(point, point, contact.separation < -kDeepOverlap ? kOverlapping : kTouching, kDotRadius, LineEnd::Round);
    }
}

void addBodyBox(RenderScene& scene, const Box3& box, std::uint32_t body) {
    glm::vec4 previousOffset(0.0f);
    if (!scene.previousPoses.empty()) previousOffset = scene.previousPoses[body].position - scene.poses[body].position;
    scene.boxes.push_back({glm::vec4(glm::vec3(box.min - scene.origin), kThin),
                           glm::vec4(glm::vec3(box.max - scene.origin), 0.0f), kBox,
                           glm::vec4(glm::vec3(previousOffset), 0.0f)});
}

}  // namespace rubble
