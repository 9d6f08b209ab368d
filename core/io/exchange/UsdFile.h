#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/geometry/mesh/Mesh.h"
#include "core/io/exchange/MeshPart.h"
#include "core/io/exchange/PackBuilder.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace rubble {

/// A step of 1/60 s, s: bonds have a capacity in N·s, joints of USD a force in N. The force is the capacity / step.
inline constexpr double kJointStep = 1.0 / 60.0;

/// Returns bodies of a pack as a USD text layer (.usda) with UsdPhysics: y up, metres, kilograms. Each is an Xform at
/// its offset with mass, a Mesh of `meshOf` and its hulls. `bodies`: indices of fragments, ascending, none nested in
/// another, or {kNone} for the whole. Fragments of a bonded pack have joints for their bonds; anchored ones are joined
/// to the world. See docs/formats/usd-mjcf.md.
///
/// Errors: Cancelled.
Result<std::string> usdFile(const PackBuilder& pack, std::span<const std::uint32_t> bodies,
                            const MeshMaterials& materials, const std::function<Mesh(std::uint32_t)>& meshOf,
                            const TaskContext& task = {});

}  // namespace rubble
