#pragma once

#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/pattern/Pattern.h"
#include "core/geometry/search/Box3.h"

#include <span>

namespace rubble {

/// A kind of layer, with functions on the parameters of such a layer.
struct PatternKind : LayerKind {
    /// The template that describes a layer in a list, see LayerKind::summary.
    const char* (*summary)(const LayerParameters& parameters);
    /// The initial parameters of a new layer in a domain with these bounds: a box without height is one in the plane.
    LayerParameters (*defaultsIn)(const Box3& bounds);
    LayerParameters defaultsFor(const Box3& bounds) const { return defaultsIn(bounds); }
    LayerParameters defaultsFor(const Box2& bounds) const { return defaultsIn(boxOf(bounds.min, bounds.max)); }
    /// The number of elements that a layer holds besides its parameters, such as placed seeds; null: it holds none.
    std::size_t (*elementCount)(const LayerParameters& parameters);
    /// Whether it has an effect on a closed mesh; the others need a plane.
    bool isSpatial = false;
};

/// The kind of a layer.
const PatternKind& kindOf(const LayerParameters& parameters);
/// Whether files and hashes contain a parameter of a layer: a spatial one only where it differs from its default, so
/// that those of patterns in the plane stay as they are.
bool isWritten(const LayerParameter& parameter, const LayerParameters& layer);
/// All kinds, in the order of LayerParameters.
std::span<const PatternKind* const> patternKinds();

}  // namespace rubble
