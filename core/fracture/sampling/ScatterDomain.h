#pragma once

namespace rubble {

/// The area in which a layer scatters its seeds.
enum class ScatterDomain {
    Outline,      // inside the outline
    BoundingBox,  // inside its bounding box; seeds outside the outline compete like any other
};

}  // namespace rubble
