#pragma once

#include "core/geometry/predicates/Vec.h"

#include <glm/mat4x4.hpp>

#include <assimp/matrix4x4.h>
#include <assimp/types.h>
#include <assimp/vector3.h>

#include <string>
#include <string_view>

namespace rubble {

using Mat4 = glm::dmat4;

/// Returns the shortest decimal that rounds to `value` in single precision: the number most likely meant.
double decimalOf(float value);
/// Converts linear to sRGB, rounded to three decimals.
double srgbFromLinear(double linear);
Vec3 pointOf(const aiVector3D& point);
Mat4 matrixOf(const aiMatrix4x4& matrix);

/// Returns text as UTF-8 on one line. Text that is not valid UTF-8 is read as Latin-1.
std::string lineOf(std::string_view bytes);
std::string nameOf(const aiString& source);
/// Returns lineOf(bytes) for a message: longer text is cut and ends with an ellipsis.
std::string excerptOf(std::string_view bytes);

}  // namespace rubble
