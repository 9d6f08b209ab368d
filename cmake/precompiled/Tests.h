#pragma once
// What nearly every test includes.

#include "Files.h"

#include <QTest>
