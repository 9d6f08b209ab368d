#include "editor/commands/LayerKind.h"

#include "editor/commands/PatternPlaces.h"

#include <QCoreApplication>

#include <cmath>

namespace rubble {

namespace {

constexpr double kShareOfFragment = 0.25;  // how long a fragment usually is against what it is broken from

}  // namespace

QString patternText(const char* text) { return QCoreApplication::translate("Pattern", text); }

QString kindText(const LayerParameters& parameters) { return patternText(kindOf(parameters).caption); }

Box2 boundsToFill(const Asset& asset, std::size_t level) {
    const Box2 bounds = boundsOf(asset.prism.outline.outer);
    if (level == 0) return bounds;
    const auto depth = static_cast<double>(depthAt(asset, level));
    const Vec2 half = bounds.size() / 2.0 * std::pow(kShareOfFragment, depth);
    return {-half, half};
}

}  // namespace rubble
