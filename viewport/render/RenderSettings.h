#pragma once

#include "core/asset/Project.h"

namespace rubble {

enum class Theme { Light, Dark };
enum class Shading { Faces, Wireframe };

/// How a scene is drawn, apart from what is in it.
struct RenderSettings {
    Theme theme = Theme::Light;
    Shading shading = Shading::Faces;
    bool hasEdges = true;  // dark lines along the edges of faces
    bool hasGrid = true;
    bool hasShadows = true;
    bool hasAxes = true;  // the small cross of axes in the lower left corner
    int msaa = 0;         // samples a pixel: 1, 2, 4 or 8, at most what the card has; 0: 4, or 1 without a card
    double scale = 1.0;   // pixels of the display a point: lines and axes grow with it
    Colour accent{1.0, 0.55, 0.1};  // of what is selected
    bool operator==(const RenderSettings&) const = default;
};

}  // namespace rubble
