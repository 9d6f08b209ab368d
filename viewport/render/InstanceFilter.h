#pragma once

#include "viewport/scene/RenderScene.h"

#include <glm/mat4x4.hpp>

#include <array>

namespace rubble {

/// What decides which instances a picture shows, and with how many triangles.
struct InstanceView {
    glm::mat4 clipFromScene{1.0f};
    glm::vec4 eye{0.0f};             // m, in the scene; w: 1 in perspective, 0 in parallel projection
    float pixelsOfMetre = 0.0f;      // at distance 1; in parallel projection anywhere
    float minFragmentPixels = 0.0f;  // instances whose fragments are smaller on average are drawn as a whole
    bool areCracksHidden = false;    // so are all that have no mortar between their fragments
    bool operator==(const InstanceView&) const = default;
};

/// Decides which instances of a scene a view shows, by spheres around them.
/// Source: Gribb, Hartmann, "Fast extraction of viewing frustum planes from the world-view-projection matrix", 2001.
class InstanceFilter {
public:
    struct Sphere {
        glm::vec3 centre{0.0f};  // m, in the scene
        float radius = 0.0f;     // m
    };

    InstanceFilter(const RenderScene& scene, const InstanceView& view);

    /// Around a box in a body's frame, at its current and its previous pose.
    Sphere sphereOf(std::uint32_t body, const Box3& box) const;
    bool isSeen(const Sphere& sphere) const;
    /// The size in the picture, pixels, of what measures `size` metres at the nearest point of a sphere.
    double pixelsOf(double size, const Sphere& sphere) const;

private:
    const RenderScene& m_scene;
    InstanceView m_view;
    std::array<glm::vec4, 4> m_planes;  // of the sides: inward normal of length 1, offset
};

}  // namespace rubble
