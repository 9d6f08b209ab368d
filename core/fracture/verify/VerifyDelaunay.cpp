#include "core/fracture/verify/VerifyDelaunay.h"
#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <array>

namespace rubble {
namespace {

using Fault = std::optional<std::string>;

std::string text(std::uint32_t number) { return std::to_string(number); }

/// Every seed is a site, bit for bit, or a duplicate of one with a lower index.
Fault verifySites(const Delaunay& delaunay, std::span<const Vec2> seeds) {
    if (delaunay.sites.size() != delaunay.seedOf.size())
        return "The number of sites differs from the number of their seeds.";
    std::vector<bool> isSeen(seeds.size(), false);
    for (std::uint32_t site = 0; site < delaunay.sites.size(); ++site) {
        const std::uint32_t seed = delaunay.seedOf[site];
        if (seed >= seeds.size() || isSeen[seed])
            return "Site " + text(site) + " comes from seed " + text(seed) +
                   ", which does not exist or has another site.";
        if (delaunay.sites[site] != seeds[seed])
            return "Site " + text(site) + " is not where seed " + text(seed) + " is.";
        isSeen[seed] = true;
    }
    for (const auto& [seed, of] : delaunay.duplicates) {
        if (seed >= seeds.size() || of >= seed || isSeen[seed])
            return "Seed " + text(seed) + " is not a duplicate of seed " + text(of) + ".";
        if (seeds[seed] != seeds[of]) return "Seeds " + text(seed) + " and " + text(of) + " are not equal.";
        isSeen[seed] = true;
    }
    const auto missing = std::find(isSeen.begin(), isSeen.end(), false);
    if (missing != isSeen.end())
        return "Seed " + text(static_cast<std::uint32_t>(missing - isSeen.begin())) + " is missing.";
    return std::nullopt;
}

Fault verifyTwins(const Delaunay& delaunay) {
    const std::size_t expected = delaunay.sites.size() < 2 ? 0 : 2 * delaunay.sites.size() - 2;
    if (delaunay.triangles.size() != expected) {
        return "There are " + std::to_string(delaunay.triangles.size()) + " triangles with ghosts instead of " +
               std::to_string(expected) + ".";
    }
    for (std::uint32_t t = 0; t < delaunay.triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t halfEdge = 4 * t + k, twin = delaunay.twin(halfEdge);
            if (twin >> 2 >= delaunay.triangles.size() || (twin & 3) > 2 || delaunay.twin(twin) != halfEdge ||
                delaunay.origin(twin) != delaunay.origin(Delaunay::next(halfEdge)) ||
                delaunay.origin(Delaunay::next(twin)) != delaunay.origin(halfEdge)) {
                return "Edge " + text(k) + " of triangle " + text(t) + " and its twin do not agree.";
            }
        }
    }
    return std::nullopt;
}

/// Whether `site` is in the circle of a counter-clockwise triangle, with the tie rule of triangulate().
bool isInCircle(const Delaunay& delaunay, std::array<std::uint32_t, 3> corners, std::uint32_t site) {
    const auto& sites = delaunay.sites;
    const int sign = inCircle(sites[corners[0]], sites[corners[1]], sites[corners[2]], sites[site]);
    if (sign != 0) return sign > 0;
    const auto lowest = std::min_element(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
        return delaunay.seedOf[a] < delaunay.seedOf[b];
    });
    if (delaunay.seedOf[site] < delaunay.seedOf[*lowest]) return true;
    std::rotate(corners.begin(), lowest, corners.end());
    return orient2d(sites[corners[1]], sites[corners[2]], sites[site]) < 0;
}

bool isCollinear(const Delaunay& delaunay) {
    return std::ranges::all_of(delaunay.triangles, &Delaunay::Triangle::isGhost);
}

/// The hull edge a -> b behind a ghost triangle (b, a, ghost) and the next one, b -> c, turn left or go straight on.
/// The hull of collinear sites runs along the line and back.
Fault verifyHullAt(const Delaunay& delaunay, std::uint32_t ghostTriangle, int ghostCorner) {
    const auto& sites = delaunay.sites;
    const Delaunay::Triangle& ghost = delaunay.triangles[ghostTriangle];
    const std::uint32_t b = ghost.corner[(ghostCorner + 1) % 3], a = ghost.corner[(ghostCorner + 2) % 3];
    const std::uint32_t c = delaunay.origin(Delaunay::previous(ghost.twin[ghostCorner]));
    const int turn = orient2d(sites[a], sites[b], sites[c]);
    const Vec2 in = sites[b] - sites[a], out = sites[c] - sites[b];
    const bool turnsBack = turn == 0 && in.x * out.x + in.y * out.y < 0.0;
    if (turn < 0 || (turnsBack && !isCollinear(delaunay))) return "The hull turns right at site " + text(b) + ".";
    return std::nullopt;
}

Fault verifyTriangle(const Delaunay& delaunay, std::uint32_t t) {
    const Delaunay::Triangle& triangle = delaunay.triangles[t];
    for (int k = 0; k < 3; ++k) {
        if (triangle.corner[k] == kGhost) return verifyHullAt(delaunay, t, k);
    }
    const auto& sites = delaunay.sites;
    if (orient2d(sites[triangle.corner[0]], sites[triangle.corner[1]], sites[triangle.corner[2]]) <= 0) {
        return "Triangle " + text(t) + " is not counter-clockwise.";
    }
    for (const std::uint32_t twin : triangle.twin) {
        const std::uint32_t apex = delaunay.origin(Delaunay::previous(twin));
        if (apex != kGhost &&
            isInCircle(delaunay, {triangle.corner[0], triangle.corner[1], triangle.corner[2]}, apex)) {
            return "Site " + text(apex) + " lies in the circle of triangle " + text(t) + ".";
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> verifyDelaunay(const Delaunay& delaunay, std::span<const Vec2> seeds) {
    if (Fault fault = verifySites(delaunay, seeds)) return fault;
    if (Fault fault = verifyTwins(delaunay)) return fault;
    for (std::uint32_t t = 0; t < delaunay.triangles.size(); ++t) {
        if (Fault fault = verifyTriangle(delaunay, t)) return fault;
    }
    return std::nullopt;
}

}  // namespace rubble
