#pragma once

#include "viewport/render/AxesIndicator.h"

#include <string>

namespace rubble {

/// The unit of a scale bar.
struct ScaleUnit {
    double metres = 1.0;
    std::string name;  // "ft"; empty: km, m, cm or mm by the length
};

/// The largest length up to `max` m that is 1, 2 or 5 times a power of ten in its unit, with its text.
struct RoundLength {
    double metres = 1.0;
    std::string text;  // "50 cm"
};
RoundLength roundLength(double max, const ScaleUnit& unit = {});

/// The length at the camera's target that a scale bar shows, and its width in points: at most kMaxScaleBarWidth.
/// `scale`: pixels per point.
struct ScaleBarLength {
    RoundLength length;
    double points = 0.0;
};
ScaleBarLength scaleBarLength(const Camera& camera, ImageSize size, double scale, const ScaleUnit& unit = {});
inline constexpr double kMaxScaleBarWidth = 150.0;

/// A scale bar in the lower right corner: a round length at the camera's target, labelled. `scale`: pixels per point.
std::vector<ScreenLine> scaleBar(const Camera& camera, ImageSize size, double scale, glm::vec3 colour, glm::vec3 halo);

}  // namespace rubble
