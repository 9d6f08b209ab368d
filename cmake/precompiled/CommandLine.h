#pragma once
// What nearly every verb includes.

#include "Geometry.h"

#include <CLI/CLI.hpp>
