#pragma once

#include "core/asset/bake/Bake.h"
#include "core/asset/project/Project.h"
#include "core/structure/bonds/Bond.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// The factor of the strength of a level's bonds: Level::bondStrength of the settings by which the fracture's parent is
/// fractured; 1 for the fragments of the whole.
double levelStrength(const Asset& asset, const Bake& bake, std::uint32_t fracture);

/// The factor of an asset's strokes, heights and image at a point of the prism's plane:
///  - of the strength strokes within whose radius the point is, the last; an erasing one gives 1;
///  - the strength by the height above the lowest point of the outline;
///  - the image over the outline's bounding box, bilinear between the centres of pixels, constant beyond those at its
///    edges. Transparent pixels give 1, half transparent ones the mean of 1 and their factor.
double strengthAt(const Asset& asset, Vec2 point);

/// The impulse that breaks each bond of a fracture of a bake, N·s: bondImpulseOf() * area * levelStrength() *
/// strengthAt() the centroid * `factor`, such as Instance::bondStrength. Infinite between two fragments that
/// neverBreaking() has, and between such a fragment and an anchor. `bonds`: those of bondsOf(), in the asset's frame.
std::vector<double> bondCapacities(const Asset& asset, const Material& material, const Bake& bake,
                                   std::uint32_t fracture, std::span<const Bond> bonds, double factor = 1.0);

/// Whether each fragment of a fracture never breaks: of the strokes of BondBrush::NeverBreaks that touch its outline
/// the last does not erase, or it is listed, or an ancestor of it.
std::vector<bool> neverBreaking(const Asset& asset, const Bake& bake, std::uint32_t fracture);

/// The fragments of a fracture, by ascending index, that are painted as anchors: of the strokes of BondBrush::Anchor
/// that touch their outlines the last does not erase.
std::vector<std::uint32_t> anchoredFragments(const Asset& asset, const Bake& bake, std::uint32_t fracture);

}  // namespace rubble
