#pragma once
// What nearly every source above core/base includes.

#include "Core.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
