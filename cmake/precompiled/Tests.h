#pragma once
// What nearly every test includes.

#include "Geometry.h"

#include <QTest>

#include <filesystem>
