#include "core/io/PackFaults.h"

#include "core/base/MessageText.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

using Fault = std::optional<std::string>;

constexpr double kExact = 1e-9;       // relative: what follows from one multiplication
constexpr double kFromHulls = 1e-6;   // relative: what is computed again from the hulls
constexpr double kThinnest = 1e-9;    // of the outline's diameter: pieces below it have no hull
constexpr double kLeastTurn = 1e-12;  // sine of the angle between the first two edges of a loop

bool isFinite(Vec3 vector) { return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z); }

double trace(const Mat3& matrix) { return matrix[0][0] + matrix[1][1] + matrix[2][2]; }

double largest(const Mat3& matrix) {
    double most = 0.0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) most = std::max(most, std::abs(matrix[column][row]));
    return most;
}

Fault edgeLoopFault(const Polytope& hull, const std::vector<std::uint32_t>& face, const std::vector<SignedEdge>& loop) {
    if (loop.size() != face.size())
        return std::to_string(loop.size()) + " signed edges for " + std::to_string(face.size()) + " vertices.";
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const std::string edge = "signed edge " + std::to_string(k);
        if (loop[k].edge >= hull.edges.size())
            return edge + " names edge " + std::to_string(loop[k].edge) + ", which is not there.";
        const auto [first, second] = hull.edges[loop[k].edge];
        const std::array<std::uint32_t, 2> run{face[k], face[(k + 1) % face.size()]};
        if (run != (loop[k].sign > 0 ? std::array{first, second} : std::array{second, first}))
            return edge + " does not run from vertex " + std::to_string(run[0]) + " to vertex " +
                   std::to_string(run[1]) + ".";
    }
    const Vec3 first = hull.vertices[face[1]] - hull.vertices[face[0]];
    const Vec3 second = hull.vertices[face[2]] - hull.vertices[face[1]];
    if (glm::length(glm::cross(first, second)) > kLeastTurn * glm::length(first) * glm::length(second))
        return std::nullopt;
    return std::string("the loop begins with two edges on one line.");
}

Fault hullFault(const PackHull& hull) {
    if (Fault fault = verifyPolytope(hull.polytope)) return fault;
    const std::size_t faces = hull.polytope.faces.size();
    if (hull.signedEdges.size() != faces)
        return std::to_string(faces) + " faces have " + std::to_string(hull.signedEdges.size()) +
               " loops of signed edges.";
    for (std::size_t face = 0; face < faces; ++face) {
        const Fault fault = edgeLoopFault(hull.polytope, hull.polytope.faces[face], hull.signedEdges[face]);
        if (fault) return "face " + std::to_string(face) + ": " + *fault;
    }
    return std::nullopt;
}

/// No solid has a principal moment above the sum of the two others.
Fault inertiaFault(const Mat3& inertia) {
    if (inertia != glm::transpose(inertia)) return std::string("its inertia is not symmetric.");
    // The second moments, which for a solid are positive definite, with room for the rounding of flat ones.
    const Mat3 spread = Mat3((0.5 + kExact) * trace(inertia)) - inertia;
    const double plane = spread[0][0] * spread[1][1] - spread[0][1] * spread[0][1];
    if (spread[0][0] > 0.0 && plane > 0.0 && glm::determinant(spread) > 0.0) return std::nullopt;
    return std::string("no solid has its inertia.");
}

Fault agreementFault(const PackBody& body, const SolidScale& scale) {
    std::vector<MassProperties> parts;
    for (const PackHull& hull : body.hulls) parts.push_back(massOf(hull.polytope));
    const MassProperties hulls = combined(parts);
    const double slack = scale.slackVolume + kFromHulls * body.volume;
    if (!(std::abs(hulls.volume - body.volume) <= slack)) {
        return "its hulls have " + messageText(hulls.volume) + " m^3 in place of " + messageText(body.volume) + " m^3.";
    }
    const double share = slack / body.volume;
    if (!(glm::length(hulls.centre - body.centreOfMass) <= share * scale.size)) {
        return std::string("its hulls have another centre of mass.");
    }
    const double mostTurned = kFromHulls * trace(body.inertia) + scale.density * slack * scale.size * scale.size;
    if (!(largest(scale.density * hulls.inertia - body.inertia) <= mostTurned)) {
        return std::string("its hulls have another inertia.");
    }
    return std::nullopt;
}

}  // namespace

SolidScale scaleOf(const Pack& pack) {
    Vec3 low{0.0, 0.0, 0.0};  // of the frame, in which the centre of mass is within the hulls' bounds
    Vec3 high = low;
    for (const PackHull& hull : pack.whole.hulls) {
        for (const Vec3& vertex : hull.polytope.vertices) {
            low = glm::min(low, vertex);
            high = glm::max(high, vertex);
        }
    }
    const Vec3 size = high - low;
    return {.density = pack.material.density,
            .size = glm::length(size),
            .slackVolume = kThinnest * (size.x * size.x + size.y * size.y) * size.z};
}

Fault solidFault(const PackBody& body, const SolidScale& scale) {
    if (!isFinite(body.offset) || !isFinite(body.centreOfMass)) return std::string("has a place that is not finite.");
    if (!(body.volume > 0.0 && std::abs(body.mass - scale.density * body.volume) <= kExact * body.mass)) {
        return "has a mass of " + messageText(body.mass) + " kg in place of " +
               messageText(scale.density * body.volume) + " kg.";
    }
    if (Fault fault = inertiaFault(body.inertia)) return fault;
    if (body.hulls.empty()) return std::string("has no hull.");
    for (std::size_t k = 0; k < body.hulls.size(); ++k) {
        if (Fault fault = hullFault(body.hulls[k])) return "hull " + std::to_string(k) + ": " + *fault;
    }
    return agreementFault(body, scale);
}

}  // namespace rubble
