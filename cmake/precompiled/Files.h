#pragma once
// What nearly every source that names files includes.

#include "Geometry.h"

#include <filesystem>
