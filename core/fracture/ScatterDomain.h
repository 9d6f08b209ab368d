#pragma once

namespace rubble {

/// Where a scatter throws its seeds.
enum class ScatterDomain {
    Outline,      // inside the outline
    BoundingBox,  // inside its bounding box, as the thesis does; seeds outside the outline compete like any other
};

}  // namespace rubble
