#pragma once

#include "core/physics/world/BodyScene.h"

#include <string_view>

namespace rubble {

/// Reads a scene of bodies:
///
///     {"gravity":[x,y,z],"bodies":[{"name":s,"kind":"dynamic","density":d,"friction":f,"restitution":r,
///     "position":[x,y,z],
///      "orientation":[w,x,y,z],"velocity":[x,y,z],"angularVelocity":[x,y,z],"hulls":[[[x,y,z],...],...]},...]}
///
/// Each hull is the convex hull of its points, in the body's frame; bodies with equal points share their hulls. Only
/// `bodies`, and `name` and `hulls` of a body, are required; the defaults are those of BodyScene and SceneBody.
///
/// Errors: BadInput if the text is not JSON of this form, with body and path, also for NaN and Infinity; Degenerate for
/// a hull of coplanar points; Unsupported for a project; those of verifyBodyScene().
Result<BodyScene> readBodyScene(std::string_view json);

}  // namespace rubble
