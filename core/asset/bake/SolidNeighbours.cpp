#include "core/asset/bake/SolidNeighbours.h"

#include "core/base/DisjointSets.h"
#include "core/fracture/planes/SectionPlane.h"
#include "core/fracture/solid/SolidHulls.h"
#include "core/geometry/polygon/HalfPlaneClip.h"
#include "core/geometry/search/BoxTree.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <map>

namespace rubble {
namespace {

/// A plane of faces between fragments of a fracture, seen from one side.
struct CommonPlane {
    std::uint32_t fracture = kNone;  // its index in the bake; kNone: none, the triangle is of the asset's outside
    std::uint32_t face = 0;          // the first face of the partition in the plane
    int side = 0;                    // 0 where that face's fragment is, 1 where the one behind it is
};

/// A triangle of a fragment on a common face, in the axes of its plane.
struct FaceTriangle {
    std::uint32_t fragment = 0;  // number in the bake
    std::array<Vec2, 3> corners{};
    Box3 box;
};

/// What lies on both sides of a common face.
struct TwoSides {
    std::vector<FaceTriangle> triangles[2];  // by CommonPlane::side
};

/// The planes of the faces between fragments of a fracture. All fragments on one side of a plane are separated from
/// those on the other, since a gap leaves one neighbour to each plane of a fragment, though there may be several.
class FracturePlanes {
public:
    explicit FracturePlanes(const Fragments& fragments)
        : m_partition(fragments.solid()->partition), m_sets(m_partition.faces.size()) {
        Box3 box;
        for (const Vec3 point : m_partition.points) box.include(point);
        m_slack = kInPlaneSlack * box.diagonal();
        m_minArea = kMinCommonArea * box.diagonal() * box.diagonal();
        m_origin = m_partition.origin + fragments.origin;
        for (std::uint32_t f = 0; f < m_partition.faces.size(); ++f) m_planes.push_back(planeOf(f));
        for (std::uint32_t fragment = 0; fragment < m_partition.fragmentCount(); ++fragment) joinFacesOf(fragment);
    }

    const Vec3& origin() const { return m_origin; }
    double minArea() const { return m_minArea; }
    const SectionPlane& plane(std::uint32_t face) const { return m_planes[face]; }

    /// The side of the plane of a face on which one of its two fragments is: the first face, and the side.
    std::pair<std::uint32_t, int> sideOf(std::uint32_t face, bool isReversed) {
        const std::uint32_t first = m_sets.rootOf(face);
        const bool isOpposite = glm::dot(m_planes[face].normal(), m_planes[first].normal()) < 0.0;
        return {first, isReversed == isOpposite ? 0 : 1};
    }

    /// The face of a fragment to a neighbour whose plane is parallel and nearest to a triangle, which a gap moved.
    SolidPartition::FaceSide faceNear(std::uint32_t number, std::uint32_t neighbour,
                                      const std::array<Vec3, 3>& corners) const {
        const Vec3 area = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const Vec3 centre = (corners[0] + corners[1] + corners[2]) / 3.0;
        const double size = glm::length(area);
        SolidPartition::FaceSide nearest;
        std::pair least(1e300, 1e300);
        for (const SolidPartition::FaceSide& side : m_partition.facesOf(number)) {
            const SolidPartition::Face& face = m_partition.faces[side.face];
            if ((side.isReversed ? face.fragment : face.behind) != neighbour) continue;
            const SectionPlane& plane = m_planes[side.face];
            const double cosine = size > 0.0 ? std::abs(glm::dot(plane.normal(), area)) / size : 1.0;
            const std::pair distance(cosine < kParallel ? 1.0 - cosine : 0.0, std::abs(plane.heightOf(centre)));
            if (distance < least) least = distance, nearest = side;
        }
        return nearest;
    }

private:
    static constexpr double kInPlaneSlack = 1e-9;  // of the diagonal
    static constexpr double kParallel = 0.999;     // cosine

    /// The plane of a face, which its largest triangle has best.
    SectionPlane planeOf(std::uint32_t face) const {
        const std::vector<Vec3>& points = m_partition.points;
        Vec3 normal(0.0), point(0.0);
        double largest = 0.0;
        for (const auto& [a, b, c] : m_partition.trianglesOf(face)) {
            const Vec3 area = glm::cross(points[b] - points[a], points[c] - points[a]);
            if (!(glm::length(area) > largest)) continue;
            largest = glm::length(area);
            normal = area;
            point = points[a];
        }
        return largest > 0.0 ? planeThrough(point, normal) : axisPlane(2, point.z);
    }

    /// Joins the faces of a fragment that are in one plane.
    void joinFacesOf(std::uint32_t fragment) {
        std::vector<std::uint32_t> inner;
        for (const SolidPartition::FaceSide& side : m_partition.facesOf(fragment)) {
            if (m_partition.faces[side.face].behind == kNone) continue;
            for (const std::uint32_t other : inner) {
                if (isIn(side.face, other) && isIn(other, side.face)) m_sets.merge(other, side.face);
            }
            inner.push_back(side.face);
        }
    }

    /// Whether a face is in the plane of another.
    bool isIn(std::uint32_t face, std::uint32_t other) const {
        return std::ranges::all_of(m_partition.trianglesOf(face), [&](const auto& triangle) {
            return std::ranges::all_of(triangle, [&](std::uint32_t point) {
                return std::abs(m_planes[other].heightOf(m_partition.points[point])) <= m_slack;
            });
        });
    }

    const SolidPartition& m_partition;
    DisjointSets m_sets;                 // of the faces
    double m_slack = 0.0;                // m
    double m_minArea = 0.0;              // m²
    Vec3 m_origin{0.0};                  // of the partition's points in the asset's frame
    std::vector<SectionPlane> m_planes;  // of each face
};

/// The area that two triangles have in common. `clipped` is scratch memory.
double commonArea(const FaceTriangle& one, const FaceTriangle& other, Ring& clipped) {
    Ring rest(one.corners.begin(), one.corners.end());
    for (int k = 0; k < 3; ++k) {
        const Vec2 from = other.corners[k], along = other.corners[(k + 1) % 3] - from;
        const Vec2 outwards{along.y, -along.x};
        clipByHalfPlane(rest, {outwards, glm::dot(outwards, from)}, clipped);
        std::swap(rest, clipped);
        if (rest.size() < 3) return 0.0;
    }
    return std::abs(signedArea(rest));
}

class SolidNeighbourFinder {
public:
    explicit SolidNeighbourFinder(const Bake& bake) : m_bake(bake) {}

    /// Adds the triangles of a fragment that lie on faces between fragments.
    void add(std::uint32_t fragment) {
        const std::uint32_t fracture = m_bake.fractureContaining(fragment);
        const BakedFracture& own = m_bake.fractures[fracture];
        const TriangleMesh mesh = own.fragments.solid()->meshOf(fragment - own.first);
        const std::vector<CommonPlane> faces = facesOf(fragment);
        for (std::size_t t = 0; t < faces.size(); ++t) {
            const CommonPlane& face = faces[t];
            if (face.fracture == kNone) continue;
            const FracturePlanes& all = planesOfFracture(face.fracture);
            const Vec3 moved = planesOfFracture(fracture).origin() - all.origin();
            FaceTriangle triangle{.fragment = fragment};
            for (int k = 0; k < 3; ++k) {
                triangle.corners[k] = all.plane(face.face).inPlane(mesh.points[mesh.triangles[t][k]] + moved);
                triangle.box.include(Vec3(triangle.corners[k], 0.0));
            }
            const Vec2 u = triangle.corners[1] - triangle.corners[0], v = triangle.corners[2] - triangle.corners[0];
            if (u.x * v.y - u.y * v.x < 0.0) std::swap(triangle.corners[1], triangle.corners[2]);
            m_sides[{face.fracture, face.face}].triangles[face.side].push_back(triangle);
        }
    }

    std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours() {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
        std::map<std::pair<std::uint32_t, std::uint32_t>, double> areas;
        for (const auto& [face, sides] : m_sides) {
            areas.clear();
            addAreas(sides, areas);
            const double least = planesOfFracture(face.first).minArea();
            for (const auto& [pair, area] : areas) {
                if (area > least) pairs.push_back(pair);
            }
        }
        std::ranges::sort(pairs);
        pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
        return pairs;
    }

private:
    CommonPlane planeOf(std::uint32_t fracture, const SolidPartition::FaceSide& side) {
        const auto [face, at] = planesOfFracture(fracture).sideOf(side.face, side.isReversed);
        return {fracture, face, at};
    }

    FracturePlanes& planesOfFracture(std::uint32_t fracture) {
        const auto known = m_fractures.find(fracture);
        if (known != m_fractures.end()) return known->second;
        return m_fractures.emplace(fracture, FracturePlanes(m_bake.fractures[fracture].fragments)).first->second;
    }

    /// The faces that the triangles of an ancestor lie on; kNone: the asset itself.
    const std::vector<CommonPlane>& facesOfAncestor(std::uint32_t ancestor) {
        const auto known = m_ancestors.find(ancestor);
        if (known != m_ancestors.end()) return known->second;
        return m_ancestors.emplace(ancestor, facesOf(ancestor)).first->second;
    }

    /// The faces that the triangles of a fragment lie on, in the order of SolidFragments::meshOf(): faces to its
    /// siblings, or those that triangles of its parent lie on, of which they are parts.
    std::vector<CommonPlane> facesOf(std::uint32_t fragment) {
        const std::uint32_t fracture = m_bake.fractureContaining(fragment);
        const BakedFracture& own = m_bake.fractures[fracture];
        const SolidFragments& all = *own.fragments.solid();
        const std::uint32_t number = all.numberInPartition(fragment - own.first);
        const std::vector<CommonPlane>* parent = own.parent == kNone ? nullptr : &facesOfAncestor(own.parent);
        const auto outside = [&](std::uint32_t source) { return parent ? (*parent)[source] : CommonPlane{}; };
        FracturePlanes& planes = planesOfFracture(fracture);
        std::vector<CommonPlane> faces;
        if (all.shrunk) {
            const ShrunkFragment& shrunk = all.shrunk->fragments[number];
            for (std::size_t t = 0; t < shrunk.sides.size(); ++t) {
                const ShrunkFragment::Side& side = shrunk.sides[t];
                if (side.neighbour == kNone) {
                    faces.push_back(outside(side.source));
                    continue;
                }
                const auto& [a, b, c] = shrunk.mesh.triangles[t];
                const std::vector<Vec3>& points = shrunk.mesh.points;
                faces.push_back(
                    planeOf(fracture, planes.faceNear(number, side.neighbour, {points[a], points[b], points[c]})));
            }
            return faces;
        }
        for (const SolidPartition::FaceSide& side : all.partition.facesOf(number)) {
            const SolidPartition::Face& face = all.partition.faces[side.face];
            const CommonPlane one = face.behind == kNone ? outside(face.source) : planeOf(fracture, side);
            faces.insert(faces.end(), all.partition.trianglesOf(side.face).size(), one);
        }
        return faces;
    }

    /// Adds the areas that fragments with different parents have in common.
    void addAreas(const TwoSides& sides, std::map<std::pair<std::uint32_t, std::uint32_t>, double>& areas) const {
        std::vector<Box3> boxes;
        for (const FaceTriangle& triangle : sides.triangles[1]) boxes.push_back(triangle.box);
        const BoxTree tree(boxes);
        Ring clipped;
        for (const FaceTriangle& one : sides.triangles[0]) {
            tree.visitOverlapping(one.box, [&](std::uint32_t k) {
                const FaceTriangle& other = sides.triangles[1][k];
                if (m_bake.fractureContaining(one.fragment) == m_bake.fractureContaining(other.fragment)) return;
                areas[std::minmax(one.fragment, other.fragment)] += commonArea(one, other, clipped);
            });
        }
    }

    const Bake& m_bake;
    std::map<std::uint32_t, FracturePlanes> m_fractures;                  // by index
    std::map<std::uint32_t, std::vector<CommonPlane>> m_ancestors;        // by number
    std::map<std::pair<std::uint32_t, std::uint32_t>, TwoSides> m_sides;  // by fracture and face
};

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> solidNeighbours(const Bake& bake,
                                                                     std::span<const std::uint32_t> fragments) {
    SolidNeighbourFinder finder(bake);
    for (const std::uint32_t fragment : fragments) finder.add(fragment);
    return finder.neighbours();
}

}  // namespace rubble
