#include "editor/commands/BrushSize.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr double kMinBrushRadius = 3.0;  // pixels
constexpr double kMaxBrushRadius = 400.0;
constexpr double kFactorPerStep = 1.25;

}  // namespace

void BrushSize::setRadiusPixels(double radius) {
    m_radiusPixels = std::clamp(radius, kMinBrushRadius, kMaxBrushRadius);
}

void BrushSize::step(double steps) { setRadiusPixels(m_radiusPixels * std::pow(kFactorPerStep, steps)); }

}  // namespace rubble
