#pragma once
// What nearly every source that reads files includes.

#include "Files.h"

#include <nlohmann/json.hpp>
