#pragma once

#include "core/asset/project/FragmentPath.h"
#include "core/fracture/sampling/GreyImage.h"
#include "core/geometry/polygon/Polygon.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace rubble {

/// How an asset breaks.
enum class BreakAs {
    Whole,   // a hit at or above the threshold swaps it for all of its fragments
    Bonded,  // a hit breaks bonds between its fragments; what is no longer connected comes off
};

/// How the load of a hit on a bond decreases with the distance from the point that was hit.
enum class HitFalloff {
    Constant,  // 1 up to the radius
    Linear,    // 1 at the point, 0 at the radius
    Smooth,    // the same with level ends: 1 - 3 x² + 2 x³
};

/// What a stroke of a bond brush sets.
enum class BondBrush {
    Anchor,       // holds fragments in place, whatever hits them
    Strength,     // multiplies the strength of bonds
    NeverBreaks,  // the bonds between such fragments never break, nor do the fragments
};

/// A stroke painted over the fragments of an asset: it outlives every bake. Of the strokes of a brush that touch the
/// same fragment or bond, the last decides.
struct BondStroke {
    BondBrush brush = BondBrush::Anchor;
    bool isErasing = false;    // removes what earlier strokes of the brush set
    double strength = 1.0;     // for BondBrush::Strength, >= 0: the factor
    double radius = 0.1;       // m, > 0
    std::vector<Vec2> points;  // m, in the prism's plane; one at least, joined by lines
    bool operator==(const BondStroke&) const = default;
};

/// The strength of bonds at a height: linear between two heights, constant beyond the first and the last.
struct HeightStrength {
    double height = 0.0;  // m above the lowest point of the outline
    double factor = 1.0;  // >= 0
    bool operator==(const HeightStrength&) const = default;
};

/// A grey image, stretched over the bounding box of the outline, that multiplies the strength of bonds.
struct StrengthImage {
    double darkest = 0.0;                    // the factor where it is black, >= 0
    double brightest = 1.0;                  // and where it is white, >= 0
    std::shared_ptr<const GreyImage> image;  // null: none selected yet
    bool operator==(const StrengthImage& other) const;
};

/// Sibling fragments that come off as one, and break apart only afterwards.
struct FragmentCluster {
    std::uint32_t level = 0;              // 0: the coarsest, breaks first
    std::vector<FragmentPath> fragments;  // ascending, one at least
    auto operator<=>(const FragmentCluster&) const = default;
};

/// Puts clusters, and the fragments of each, into the order that an asset has them in; those without any are removed.
void sortClusters(std::vector<FragmentCluster>& clusters);

/// How the bonds between the fragments of an asset hold and break, by the simple rule: see SimpleRule.
struct Bonding {
    // N·s/m², > 0: the impulse that breaks a bond, by its area; none: follows from the material, see bondImpulseOf().
    std::optional<double> impulsePerArea;
    double radius = 0.3;                          // m, > 0: of a hit: it loads bonds within
    HitFalloff falloff = HitFalloff::Linear;      //
    double damageFrom = 0.5;                      // of what a bond holds, in (0, 1]: a weaker load leaves no damage
    double span = 0.0;                            // m, >= 0: sideways to an anchor; 0: any distance
    double collapseDelay = 0.2;                   // s, >= 0: after which that breaks what has lost its support
    std::uint32_t minimumIsland = 1;              // fragments, >= 1: smaller islands fall apart
    std::vector<BondStroke> strokes;              // in the order of painting
    std::vector<HeightStrength> heightStrengths;  // ascending height
    std::optional<StrengthImage> strengthImage;
    std::vector<FragmentPath> neverBreaks;  // ascending: single fragments, beside those that are painted
    std::vector<FragmentCluster> clusters;  // ascending; a fragment is in one of a level at most
    bool operator==(const Bonding&) const = default;
};

/// Bonds between instances whose faces lie against each other.
struct Mortar {
    std::uint32_t id = 0;
    std::string name;
    std::vector<std::uint32_t> instances;  // ascending ids; empty: all
    double tolerance = 0.005;              // m, >= 0: the widest joint
    double leastArea = 1e-4;               // m², >= 0: smaller faces are not joined
    double impulsePerArea = 500.0;         // N·s/m², > 0, that breaks it
    bool operator==(const Mortar&) const = default;
};

}  // namespace rubble
