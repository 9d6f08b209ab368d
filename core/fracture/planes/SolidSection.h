#pragma once

#include "core/fracture/planes/SectionPlane.h"
#include "core/fracture/solid/SolidPartition.h"
#include "core/geometry/mesh/TriangleMesh.h"
#include "core/geometry/polygon/Polygon.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace rubble {

/// What a plane cuts of a solid. Polygons are in the plane's axes, m, in canonical winding.
///
/// Points in the plane count as above it, so the section is that of a plane which is lower by nothing: what only
/// touches the plane from above is not cut, and what touches it from below with a face is cut there. Neighbours have
/// the same corners, bit for bit, on both sides of their common edges. Loops without area are left out.
struct SolidSection {
    /// What is cut of a fragment.
    struct Part {
        std::uint32_t fragment = 0;
        std::vector<Polygon> polygons;
        double area = 0.0;  // m²
        Box2 box;
    };
    SectionPlane plane;
    std::vector<Part> parts;       // of the fragments that are cut, ascending
    std::vector<Polygon> outline;  // of the whole solid
    double area = 0.0;             // m², of the outline
};

/// The fragment at a point in the section's plane, the first one on a common edge; kNone outside. O(fragments).
std::uint32_t fragmentAt(const SolidSection& section, Vec2 point);

/// Cuts a solid by parallel planes, fast enough for each frame: heights are computed once, and a plane visits the faces
/// that it meets only.
class SolidSlicer {
public:
    /// For planes parallel to `plane`. The partition is not empty.
    SolidSlicer(std::shared_ptr<const SolidPartition> partition, const SectionPlane& plane);
    /// For a closed mesh that is not cut: one fragment.
    SolidSlicer(const TriangleMesh& mesh, const SectionPlane& plane);

    /// The lowest and the highest point, m above the plane.
    double minHeight() const { return m_minHeight; }
    double maxHeight() const { return m_maxHeight; }
    /// The section with the plane moved up by a height. O(faces + corners of the section, times their logarithm).
    SolidSection at(double height) const;

private:
    std::shared_ptr<const SolidPartition> m_partition;
    SectionPlane m_plane;
    std::vector<double> m_heights;      // of each point
    std::vector<double> m_low, m_high;  // of each face
    double m_minHeight = 0.0, m_maxHeight = 0.0;
    double m_tolerance = 0.0;  // m
};

/// One section: for more than one of a direction, make a SolidSlicer.
SolidSection sectionOf(const SolidPartition& partition, const SectionPlane& plane);
SolidSection sectionOf(const TriangleMesh& mesh, const SectionPlane& plane);

}  // namespace rubble
