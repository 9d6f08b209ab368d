#pragma once

#include "core/geometry/mesh/TriangleMesh.h"

#include <vector>

namespace rubble::test {

/// A sheet of n × m quads, points in rows of n + 1, counter-clockwise from above; on [0, 1]² in the plane z = 0.
TriangleMesh sheet(int n, int m);
/// A strip of n quads whose ends are joined after half a turn.
TriangleMesh moebiusStrip(int n);
/// The figure-8 Klein bottle of n × n quads, which crosses itself.
TriangleMesh kleinBottle(int n);
/// The projective plane of six points.
TriangleMesh projectivePlane();
/// A box of 12 triangles.
TriangleMesh box(Vec3 low, Vec3 high);
TriangleMesh unitBox();
/// A cube with its lowest corner at a place.
TriangleMesh boxAt(double x, double y, double z, double size = 1.0);
/// A mesh without some of its triangles, and with more of them.
TriangleMesh without(TriangleMesh mesh, const std::vector<std::uint32_t>& triangles);
TriangleMesh with(TriangleMesh mesh, const std::vector<Vec3>& points,
                  const std::vector<std::array<std::uint32_t, 3>>& triangles);
/// A mesh with a point moved.
TriangleMesh moved(TriangleMesh mesh, std::uint32_t point, Vec3 place);
/// A mesh whose triangles have points of their own, as in STL files.
TriangleMesh unshared(const TriangleMesh& mesh);
/// A tetrahedron, counter-clockwise from outside if d is below the triangle a, b, c seen counter-clockwise.
TriangleMesh tetrahedron(Vec3 a, Vec3 b, Vec3 c, Vec3 d);
/// How often a mesh goes around a point above which no edge is.
int windingNumber(const TriangleMesh& mesh, Vec3 p);

}  // namespace rubble::test
