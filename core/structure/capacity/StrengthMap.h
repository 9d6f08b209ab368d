#pragma once

#include "core/asset/project/Project.h"

#include <vector>

namespace rubble {

/// The factor of an asset's bonds by their place in the prism's plane: see strengthAt(). Borrows the asset.
class StrengthMap {
public:
    explicit StrengthMap(const Asset& asset);

    double at(Vec2 point) const;

private:
    double byStroke(Vec2 point) const;
    double byHeight(double height) const;
    double byImage(Vec2 point) const;

    const Bonding& m_bonding;
    Box2 m_bounds;  // of the outline, m
};

/// Whether a stroke covers a point: it is within the radius of the line through its points.
bool covers(const BondStroke& stroke, Vec2 point);

}  // namespace rubble
