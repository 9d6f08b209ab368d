#include "core/io/pack/VerifyPackBody.h"

#include "core/base/MessageText.h"
#include "core/geometry/hull/InsetHull.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/hull/SimplifiedHull.h"
#include "core/geometry/search/Box3.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

using ErrorText = std::optional<std::string>;

constexpr double kProductTolerance = 1e-9;  // relative: of a product of numbers in the file
constexpr double kHullTolerance = 1e-6;     // relative: of values recomputed from the hulls
constexpr double kMinThickness = 1e-9;      // of the outline's diameter: thinner pieces have no hull
constexpr double kMinSine = 1e-12;          // of the angle between the first two edges of a loop
constexpr double kInsetCorners = 128.0;     // insets², by which narrow faces that vanished may enlarge a cross-section
constexpr double kMeshReach = 0.02;         // of the size: of a mesh, whose acute corners the inset cuts off
constexpr double kInsetReach = 16.0;        // insets, by which they may enlarge the bounds
constexpr double kQuaternionTolerance = 1e-9;  // of the length of a quaternion

bool isFinite(Vec3 vector) { return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z); }

double trace(const Mat3& matrix) { return matrix[0][0] + matrix[1][1] + matrix[2][2]; }

double maxElement(const Mat3& matrix) {
    double max = 0.0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) max = std::max(max, std::abs(matrix[column][row]));
    return max;
}

ErrorText verifyEdgeLoop(const Polytope& hull, const std::vector<std::uint32_t>& face,
                         const std::vector<SignedEdge>& loop) {
    if (loop.size() != face.size())
        return std::to_string(loop.size()) + " signed edges for " + std::to_string(face.size()) + " vertices.";
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const std::string edge = "signed edge " + std::to_string(k);
        if (loop[k].edge >= hull.edges.size())
            return edge + " refers to edge " + std::to_string(loop[k].edge) + ", which does not exist.";
        const auto [first, second] = hull.edges[loop[k].edge];
        const std::array<std::uint32_t, 2> run{face[k], face[(k + 1) % face.size()]};
        if (run != (loop[k].sign > 0 ? std::array{first, second} : std::array{second, first}))
            return edge + " does not run from vertex " + std::to_string(run[0]) + " to vertex " +
                   std::to_string(run[1]) + ".";
    }
    const Vec3 first = hull.vertices[face[1]] - hull.vertices[face[0]];
    const Vec3 second = hull.vertices[face[2]] - hull.vertices[face[1]];
    if (glm::length(glm::cross(first, second)) > kMinSine * glm::length(first) * glm::length(second))
        return std::nullopt;
    return std::string("the loop starts with two collinear edges.");
}

ErrorText verifyHull(const PackHull& hull) {
    if (ErrorText error = verifyPolytope(hull.polytope)) return error;
    const std::size_t faces = hull.polytope.faces.size();
    if (hull.signedEdges.size() != faces)
        return std::to_string(faces) + " faces have " + std::to_string(hull.signedEdges.size()) +
               " loops of signed edges.";
    for (std::size_t face = 0; face < faces; ++face) {
        const ErrorText error = verifyEdgeLoop(hull.polytope, hull.polytope.faces[face], hull.signedEdges[face]);
        if (error) return "face " + std::to_string(face) + ": " + *error;
    }
    return std::nullopt;
}

/// No principal moment of a solid exceeds the sum of the two others.
ErrorText verifyInertia(const Mat3& inertia) {
    if (inertia != glm::transpose(inertia)) return std::string("its inertia is not symmetric.");
    // The second moments of a solid are positive definite; the tolerance allows for flat solids.
    const Mat3 second = Mat3((0.5 + kProductTolerance) * trace(inertia)) - inertia;
    const double plane = second[0][0] * second[1][1] - second[0][1] * second[0][1];
    if (second[0][0] > 0.0 && plane > 0.0 && glm::determinant(second) > 0.0) return std::nullopt;
    return std::string("its inertia is impossible for a solid.");
}

/// The principal moments are those of the inertia, in descending order.
ErrorText verifyPrincipal(const PackBody& body) {
    if (!body.principal) return std::nullopt;
    const auto& [moments, rotation] = *body.principal;
    if (!(moments.x >= moments.y * (1.0 - kProductTolerance) && moments.y >= moments.z * (1.0 - kProductTolerance)))
        return std::string("its principal moments do not descend.");
    if (!(std::abs(glm::length(rotation) - 1.0) <= kQuaternionTolerance) || !(rotation.w >= 0.0))
        return std::string("its principal rotation is not of length 1 with w at least 0.");
    if (maxElement(tensorOf(*body.principal) - body.inertia) <= kProductTolerance * trace(body.inertia))
        return std::nullopt;
    return std::string("its principal moments are not those of its inertia.");
}

/// The bounds are those of the hulls without their insets.
ErrorText verifyBounds(const PackBody& body, const std::vector<Polytope>& solids, const PackScale& scale) {
    if (!body.bounds) return std::nullopt;
    PackBounds found{.min = Vec3(1e308), .max = Vec3(-1e308), .thinnest = 1e308};
    for (const Polytope& solid : solids) {
        found.thinnest = std::min(found.thinnest, thinnestWidth(solid));
        for (const Vec3& vertex : solid.vertices) {
            found.min = glm::min(found.min, vertex);
            found.max = glm::max(found.max, vertex);
            found.radius = std::max(found.radius, glm::length(vertex));
        }
    }
    // Acute corners of a mesh's hull are far from where its faces, moved back, would meet.
    const double reach = std::ranges::all_of(solids, isPrism) ? kInsetReach * scale.inset : kMeshReach * scale.size;
    const double slack = kProductTolerance * scale.size + reach;
    const Vec3 low = glm::abs(found.min - body.bounds->min), high = glm::abs(found.max - body.bounds->max);
    if (std::max({low.x, low.y, low.z, high.x, high.y, high.z}) <= slack &&
        std::abs(found.radius - body.bounds->radius) <= slack &&
        std::abs(found.thinnest - body.bounds->thinnest) <= slack)
        return std::nullopt;
    return std::string("its bounds are not those of its hulls.");
}

ErrorText verifyInset(const PackHull& hull, const PackScale& scale) {
    if (hull.inset == 0.0) return std::nullopt;
    const std::optional<Polytope> solid = solidOf({hull.polytope, hull.inset});
    if (!solid) return std::string("its faces, moved outwards by its inset, bound no hull.");
    constexpr double kRounded = 0.1;  // of the inset, where corners of a mesh's hull were rounded
    const double slack = isPrism(*solid) ? kHullTolerance : kRounded;
    const double most = std::min(scale.inset, kMaxInset * thinnestWidth(*solid)) * (1.0 + slack);
    if (hull.inset <= most) return std::nullopt;
    return "its inset is " + messageText(hull.inset) + " m instead of at most " + messageText(most) + " m.";
}

/// The area of the surface of a hull, m².
double areaOf(const Polytope& hull) {
    double doubled = 0.0;
    for (const std::vector<std::uint32_t>& face : hull.faces) {
        Vec3 sum{0.0};
        for (std::size_t k = 1; k + 1 < face.size(); ++k)
            sum += glm::cross(hull.vertices[face[k]] - hull.vertices[face[0]],
                              hull.vertices[face[k + 1]] - hull.vertices[face[0]]);
        doubled += glm::length(sum);
    }
    return 0.5 * doubled;
}

/// How much less than its body the hulls of a mesh may have, m³: they are simplified, and the inset merges corners and
/// rounds them.
double lostVolume(const PackBody& body) {
    constexpr double kRounded = 0.125;  // of the inset
    constexpr double kMerged = 0.5;     // of the corners: those that the inset may merge
    double volume = 0.0;
    for (const PackHull& hull : body.hulls) {
        if (isPrism(hull.polytope)) continue;
        Box3 box;
        for (const Vec3& corner : hull.polytope.vertices) box.include(corner);
        const auto corners = static_cast<std::size_t>(static_cast<double>(hull.polytope.vertices.size()) / kMerged);
        const double lost = maxCollisionError(corners, box.diagonal());
        volume += (kRounded * hull.inset + lost) * areaOf(hull.polytope);
    }
    return volume;
}

ErrorText verifyMass(const PackBody& body, const std::vector<Polytope>& solids, const PackScale& scale) {
    std::vector<MassProperties> parts;
    double hidden = 0.0;
    for (const Polytope& solid : solids) {
        parts.push_back(massOf(solid));
        if (scale.inset > 0.0 && isPrism(solid))
            hidden += kInsetCorners * scale.inset * scale.inset * (solid.planes[0].offset + solid.planes[1].offset);
    }
    const MassProperties hulls = combined(parts);
    double slack = scale.slackVolume + kHullTolerance * body.volume + hidden;
    if (!std::ranges::all_of(solids, isPrism)) {  // the hulls of a mesh are around it, but for details
        slack += std::max(hulls.volume - body.volume, lostVolume(body));
    }
    if (!(std::abs(hulls.volume - body.volume) <= slack)) {
        return "its hulls have a volume of " + messageText(hulls.volume) + " m³ instead of " +
               messageText(body.volume) + " m³.";
    }
    const double fraction = slack / body.volume;
    if (!(glm::length(hulls.centre - body.centreOfMass) <= fraction * scale.size)) {
        return std::string("its hulls have a different centre of mass.");
    }
    const double maxDifference = kHullTolerance * trace(body.inertia) + scale.density * slack * scale.size * scale.size;
    if (!(maxElement(scale.density * hulls.inertia - body.inertia) <= maxDifference)) {
        return std::string("its hulls have a different inertia.");
    }
    return std::nullopt;
}

}  // namespace

std::vector<Polytope> solidsOf(const PackBody& body) {
    std::vector<Polytope> solids;
    for (const PackHull& hull : body.hulls)
        solids.push_back(solidOf({hull.polytope, hull.inset}).value_or(hull.polytope));
    return solids;
}

PackScale scaleOf(const Pack& pack) {
    Vec3 low{0.0, 0.0, 0.0};  // the origin is the centre of mass, which lies within the hulls' bounds
    Vec3 high = low;
    for (const PackHull& hull : pack.whole.hulls) {
        for (const Vec3& vertex : hull.polytope.vertices) {
            low = glm::min(low, vertex);
            high = glm::max(high, vertex);
        }
    }
    const Vec3 size = high - low;
    return {.density = pack.own().density,
            .size = glm::length(size),
            .slackVolume = kMinThickness * (size.x * size.x + size.y * size.y) * size.z,
            .inset = pack.inset};
}

std::optional<std::string> verifyPackBody(const PackBody& body, const PackScale& scale) {
    if (!isFinite(body.offset) || !isFinite(body.centreOfMass))
        return std::string("its offset or centre of mass is not finite.");
    if (body.centreOfMass != Vec3(0.0)) return std::string("its centre of mass is not the origin of its frame.");
    if (!(body.volume > 0.0 && std::abs(body.mass - scale.density * body.volume) <= kProductTolerance * body.mass)) {
        return "its mass is " + messageText(body.mass) + " kg instead of " + messageText(scale.density * body.volume) +
               " kg.";
    }
    if (ErrorText error = verifyInertia(body.inertia)) return error;
    if (body.hulls.empty()) return std::string("it has no hull.");
    for (std::size_t k = 0; k < body.hulls.size(); ++k) {
        if (ErrorText error = verifyHull(body.hulls[k])) return "hull " + std::to_string(k) + ": " + *error;
        if (ErrorText error = verifyInset(body.hulls[k], scale)) return "hull " + std::to_string(k) + ": " + *error;
    }
    const std::vector<Polytope> solids = solidsOf(body);
    if (ErrorText error = verifyMass(body, solids, scale)) return error;
    if (ErrorText error = verifyPrincipal(body)) return error;
    return verifyBounds(body, solids, scale);
}

}  // namespace rubble
