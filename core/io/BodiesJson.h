#pragma once

#include "core/physics/BodyScene.h"

#include <string_view>

namespace rubble {

/// Reads plain bodies:
///
///     {"gravity":[x,y,z],"bodies":[{"name":s,"kind":"dynamic","density":d,"friction":f,"restitution":r,"position":[x,y,z],
///      "orientation":[w,x,y,z],"velocity":[x,y,z],"angularVelocity":[x,y,z],"hulls":[[[x,y,z],...],...]},...]}
///
/// A hull is the points that it is drawn tight around, in the body's frame; bodies whose hulls are the same points share
/// them. Only `bodies`, and of a body `name` and `hulls`, must be there: what is left out is as in BodyScene and SceneBody.
///
/// Errors: BadInput where the text is not such JSON, naming body and place, NaN and Infinity included; Degenerate for a
/// hull whose points lie in one plane; Unsupported where it is a project; those of verifyBodyScene().
Result<BodyScene> readBodyScene(std::string_view json);

}  // namespace rubble
