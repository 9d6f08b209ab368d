#pragma once

#include "core/physics/queries/ShadowVolume.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace rubble {

struct WorldState;

// A face that hulls divide into more than kMaxVisibleParts convex parts is halved first, up to kMaxHalvings times. A
// part of a half divided that often is visible or hidden as its centroid is.
inline constexpr std::size_t kMaxVisibleParts = 64;
inline constexpr int kMaxHalvings = 10;

/// Called with a body and a visible part of one of its faces, relative to the viewpoint.
using VisitVisiblePart = std::function<void(std::uint32_t body, const FacePolygon& part)>;

/// Visits the parts of all faces within a radius, and some beyond, that are visible from a point, by ascending body.
/// Faces are hidden by all other hulls, those of the same body included: so are faces between touching bodies. Hulls
/// that contain the point hide nothing and have no visible faces. O(n log n) for n hulls that each hide few others.
///
/// Returns how often a face was compared with a hull, a measure of the work that does not depend on the machine.
std::size_t visitVisibleFaces(const WorldState& state, Vec3 viewpoint, double radius, const VisitVisiblePart& visit);

}  // namespace rubble
