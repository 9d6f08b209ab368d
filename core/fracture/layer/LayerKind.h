#pragma once

#include "core/fracture/layer/LayerParameter.h"

#include <span>
#include <string_view>

namespace rubble {

// A kind of layer is a struct in core/fracture/kinds with
//   - its parameters as members with defaults, and an equality operator,
//   - `static const LayerKind kKind`, which describes it,
//   - `apply(context, seeds)` or `cut(context, cuts)`,
//   - `applyInSolid(context, seeds)`, unless it needs a plane,
// and where needed
//   - `static Kind defaultsFor(const Box3& bounds)`, the parameters of a new layer in a domain with these bounds,
//     without height in the plane,
//   - `const char* summary() const` in place of LayerKind::summary, if it depends on parameters,
//   - `double estimatedPieces(double area) const`, about how many pieces the layer makes of an area (m²),
//   - `double estimatedPiecesIn(const SolidDomain& domain) const`, the same of a closed mesh,
//   - `density(outline)`, a density of seeds that later layers follow,
//   - `elementCount()` and `fault()`, if it contains more than parameters, such as manually placed seeds.
// docs/contributing.md says how to add one.

/// The contribution of a layer to a pattern.
enum class LayerRole {
    Scatters,  // adds random seeds, which may have overrides
    Places,    // adds its own seeds
    Moves,     // moves the seeds of the layers before
    Cuts,      // cuts pieces along lines: cut() instead of apply()
    Measures,  // changes the metric of the Voronoi cells of all seeds: no apply()
};

/// The description of a kind of layer. Texts for users are English; translations use them as keys.
struct LayerKind {
    std::string_view name;  // in files: "blueNoise"
    const char* caption;    // "Blue noise"
    const char* hint;       // what it does, in a few words
    const char* icon;       // "layer-blue-noise", a file in resources/icons
    /// A template that describes a layer in a list, after the caption: "{minimumDistance} apart". Braces enclose the
    /// name of a parameter, or "elements" for elementCount(), and optionally the texts for one and for more: "{rounds|1
    /// round|%1 rounds}". Null if the kind has a member summary().
    const char* summary = nullptr;
    LayerRole role;
    std::span<const LayerParameter> parameters = {};  // in the order of files
    bool isRandom = false;                            // the layer's random seed has an effect
    bool fillsOutline = false;                        // its seeds depend on the whole outline: see followOutline()
};

}  // namespace rubble
