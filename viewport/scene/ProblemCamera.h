#pragma once

#include "viewport/scene/Camera.h"
#include "viewport/scene/ImportScene.h"

namespace rubble {

/// Rotates a camera so that the place of a problem faces it: nothing of the meshes hides what is marked there, or as
/// little as possible. The camera stays as it is where it sees the place well already, and where no other sees more of
/// it. Target and distance stay; frame surroundingsOf() afterwards. Linear in the triangles of the meshes.
Camera facing(const MeshProblem& problem, const SourceModel& model, Camera camera);

}  // namespace rubble
