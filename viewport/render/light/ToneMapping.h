#pragma once

#include "core/geometry/predicates/Vec.h"

namespace rubble {

/// The linear value of an sRGB component in [0, 1].
/// Source: IEC 61966-2-1, 1999.
double linearOf(double srgb);
/// Its inverse.
double srgbOf(double linear);
Vec3 linearOf(Vec3 srgb);
Vec3 srgbOf(Vec3 linear);

/// The linear colour in [0, 1] that a display shows for a radiance: colours keep their hue, and bright ones are
/// compressed.
/// Source: Khronos Group, "Khronos PBR Neutral Tone Mapper", 2024.
Vec3 toneMapped(Vec3 radiance);
/// Its inverse, for colours below white.
Vec3 radianceShownAs(Vec3 displayed);

}  // namespace rubble
