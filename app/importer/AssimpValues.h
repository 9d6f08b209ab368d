#pragma once

#include "core/geometry/Vec.h"

#include <glm/mat4x4.hpp>

#include <assimp/matrix4x4.h>
#include <assimp/types.h>
#include <assimp/vector3.h>

#include <string>

namespace rubble {

using Mat4 = glm::dmat4;

/// The number that was meant: of the decimals that single precision takes for the same, the shortest.
double decimalOf(float value);
Vec3 pointOf(const aiVector3D& point);
Mat4 matrixOf(const aiMatrix4x4& matrix);

/// A name of the file as UTF-8, on one line; what is not UTF-8 is taken to be Latin-1.
std::string nameOf(const aiString& source);

}  // namespace rubble
