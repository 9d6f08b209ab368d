#pragma once

#include "core/asset/project/Project.h"
#include "editor/document/Edit.h"

#include <array>
#include <vector>

namespace rubble {

/// The factors of strength that keys and menus offer, ascending; 1 is neutral.
inline constexpr std::array kBrushStrengths{0.0, 0.1, 0.2, 0.5, 1.0, 1.5, 2.0, 3.0, 5.0, 10.0};

/// A brush that paints the bonds of an asset, in the canvas and in the 3D view.
struct BondBrushSettings {
    BondBrush brush = BondBrush::Anchor;
    bool isErasing = false;
    double strength = 2.0;  // of BondBrush::Strength, within kBrushStrengths
    bool operator==(const BondBrushSettings&) const = default;
};

/// The next of kBrushStrengths above (direction 1) or below (-1) a strength; at the end, the last.
double nextBrushStrength(double strength, int direction);

/// Whether strokes of a brush were painted that an erasing one can remove.
bool hasStrokes(const Asset& asset, BondBrush brush);

/// A stroke while it is painted. Its points are simplified: those left out are within a quarter of the radius of its
/// line.
class BondStrokePath {
public:
    /// `radius`: m; brought into its range.
    BondStrokePath(const BondBrushSettings& settings, double radius);

    /// Leads the stroke to a point of the prism's plane.
    void extend(Vec2 point);
    const BondStroke& stroke() const { return m_stroke; }

private:
    BondStroke m_stroke;
    std::vector<Vec2> m_points;  // before they are simplified
};

/// Paints a stroke over an asset.
Edit paintStroke(Asset asset, BondStroke stroke);

}  // namespace rubble
