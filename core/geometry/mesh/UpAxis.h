#pragma once

namespace rubble {

/// The axis that points up in the coordinates of a mesh file. In the world it is y.
enum class UpAxis { Y, Z };

}  // namespace rubble
