#pragma once

#include "core/fracture/solid/FaceTriangulation.h"
#include "core/fracture/solid/InnerFaces.h"

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace rubble {

/// Points that lie on edges. Where ties leave a loop without area, its edges are divided by its points, so that they
/// cancel out: the loop is gone, and its neighbours fit together.
class EdgeSplits {
public:
    bool isEmpty() const { return m_points.empty(); }
    void clear() { m_points.clear(); }
    /// Divides an edge by a point on it; false if it is there already, or would leave a part that is no shorter.
    bool add(std::uint32_t from, std::uint32_t to, std::uint32_t point, std::span<const Vec3> points);
    /// Appends the points after `from` on the way to `to`, that included.
    void appendPath(std::uint32_t from, std::uint32_t to, PointLoop& path) const;

private:
    std::map<std::pair<std::uint32_t, std::uint32_t>, PointLoop> m_points;  // from the lower end to the higher
};

/// Whether a point lies inside an edge, within a tolerance in steps.
bool isOnEdge(Vec3 point, Vec3 from, Vec3 to, double tolerance);

/// Whether a loop has no area: less than a strip of kSolidWeldDistance along it would have.
bool isThin(std::span<const std::uint32_t> loop, std::span<const Vec3> points);

/// The loops without repeated points of which a loop consists; edges there and back are left out.
std::vector<PointLoop> simpleLoops(const PointLoop& loop);

/// The simple loops of which edges in a plane consist, which enter each point as often as they leave it, with the
/// inside on their left. Edges there and back are left out; where loops touch in a point, each bounds its own inside.
std::vector<PointLoop> linkedLoops(std::vector<PointStep> edges, std::span<const Vec3> points, const PlaneView& view);

}  // namespace rubble
