#pragma once

#include "core/asset/project/Project.h"
#include "viewport/render/light/SkyPreset.h"

#include <memory>
#include <optional>

namespace rubble {

struct SkyLight;

enum class Shading { Faces, Wireframe };

/// How good pictures are, in samples: see renderImage(). Draft is a single pass.
enum class RenderQuality { Draft, Good, Best };
constexpr int samplesOf(RenderQuality quality) {
    switch (quality) {
        case RenderQuality::Good: return 32;
        case RenderQuality::Best: return 128;
        case RenderQuality::Draft: break;
    }
    return 0;
}
/// Those of a video need fewer: nobody looks at one for long.
constexpr int videoSamplesOf(RenderQuality quality) { return samplesOf(quality) / 8; }

/// The settings for drawing a scene.
struct RenderSettings {
    Theme theme = Theme::Light;
    SkyPreset sky = SkyPreset::Studio;
    std::shared_ptr<const SkyLight> skyFile;  // in place of `sky`; none: that
    double exposure = 0.0;                    // stops: halvings or doublings of all light
    Shading shading = Shading::Faces;
    bool hasEdges = true;  // dark lines along the edges of faces
    bool hasGrid = true;
    bool hasShadows = true;
    bool hasAxes = true;      // axes indicator in the lower left corner
    bool hasScaleBar = true;  // outdoors, in the lower right corner; only with a grid
    bool hasOverlays = true;  // axes, scale bar, outlines of selected bodies, hulls and lines; false: the scene alone
    int msaa = 0;        // samples per pixel: 1, 2, 4 or 8, clamped to what the GPU supports; 0: 4, or 1 in software
    double scale = 1.0;  // device pixels per point: scales lines and the axes indicator
    Colour accent{1.0, 0.55, 0.1};     // of selected bodies
    std::optional<Colour> background;  // in place of sky and ground; none: these
    bool operator==(const RenderSettings&) const = default;
};

}  // namespace rubble
