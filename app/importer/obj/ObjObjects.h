#pragma once

#include "app/importer/obj/ObjContent.h"

namespace rubble {

/// Returns the number of the object that each part of an OBJ file becomes, numbered by their first parts. Objects are
/// kept apart. Groups that are open surfaces by themselves, and share points on their borders with other open ones,
/// such as the front, the back and the sides of a wall, are one object. O(n log n).
std::vector<std::uint32_t> objectsOfParts(const ObjContent& file);

}  // namespace rubble
