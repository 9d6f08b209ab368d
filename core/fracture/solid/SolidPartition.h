#pragma once

#include "core/base/Diagnostic.h"
#include "core/base/Index.h"
#include "core/geometry/predicates/Vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A closed mesh cut into fragments: what Partition is for an outline, in space. Fragments refer to shared points by
/// index, and each face between two of them is stored once, so that neighbours share it bit for bit.
///
/// Faces are flat but for rounding, and triangulated: face f has the triangles [firstTriangle[f], firstTriangle[f +
/// 1]), counter-clockwise seen from outside its `fragment`, so clockwise seen from outside the one behind it. Triangles
/// of the outside are parts of the mesh's; their fragment is the solid side, and nothing is behind them.
///
/// The fragments of one seed are consecutive, in the order of their smallest points (x, then y, then z). Fragments are
/// ordered by seed.
struct SolidPartition {
    /// A face with its two sides.
    struct Face {
        std::uint32_t fragment = 0;
        std::uint32_t behind = kNone;  // fragment; kNone: the face is of the outside
        std::uint32_t source = kNone;  // of outside faces: the triangle of the mesh
    };
    /// A face as one of its fragments has it.
    struct FaceSide {
        std::uint32_t face = 0;
        bool isReversed = false;  // the fragment is the one behind
    };

    Vec3 origin{0.0, 0.0, 0.0};  // m: the points are relative to it
    std::vector<Vec3> points;    // m; some may be unused; the mesh's corners first, in their order
    std::vector<Face> faces;
    std::vector<std::uint32_t> firstTriangle = {0};       // faces + 1
    std::vector<std::array<std::uint32_t, 3>> triangles;  // points

    std::vector<std::uint32_t> seedOfFragment;
    std::vector<std::uint32_t> partOfFragment;  // its number among those of its seed, as cut; kNone: the only one
    std::vector<std::uint32_t> fragmentOfSeed;  // the first of each seed; kNone where it has none
    std::vector<std::uint32_t> firstFace;       // fragments + 1
    std::vector<FaceSide> facesOfFragment;
    std::vector<double> volumes;                           // m³, of each fragment
    std::vector<std::array<std::uint32_t, 2>> duplicates;  // {seed, the seed that it equals}, ascending

    std::uint32_t fragmentCount() const { return static_cast<std::uint32_t>(seedOfFragment.size()); }
    std::span<const FaceSide> facesOf(std::uint32_t fragment) const {
        return std::span(facesOfFragment).subspan(firstFace[fragment], firstFace[fragment + 1] - firstFace[fragment]);
    }
    std::span<const std::array<std::uint32_t, 3>> trianglesOf(std::uint32_t face) const {
        return std::span(triangles).subspan(firstTriangle[face], firstTriangle[face + 1] - firstTriangle[face]);
    }
    /// The volume of a fragment as its triangles have it, m³.
    double volumeOf(std::uint32_t fragment) const;

    void addFace(const Face& face, std::span<const std::array<std::uint32_t, 3>> itsTriangles);
    /// Sets facesOfFragment, once all faces and fragments are there.
    void listFaces();
};

/// The seeds that equal another (DuplicateSeed) and those whose cell misses the mesh (SeedWithoutCell), by seed, of a
/// partition as it was cut.
std::vector<Diagnostic> seedReports(const SolidPartition& partition);

}  // namespace rubble
