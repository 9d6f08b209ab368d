#pragma once
// What nearly every source that reads files includes.

#include "Geometry.h"

#include <nlohmann/json.hpp>
