#include "app/importer/obj/ObjObjects.h"

#include "core/base/DisjointSets.h"

#include <algorithm>
#include <tuple>

namespace rubble {
namespace {

/// A face's edge between places, each of which may have several points in the file.
struct GroupEdge {
    std::uint32_t low = 0, high = 0;
    std::uint32_t part = 0;
};

/// Numbers points so that those at the same position have the same number.
std::vector<std::uint32_t> placesOf(const std::vector<Vec3>& points) {
    std::vector<std::uint32_t> order(points.size()), places(points.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) { return std::tie(points[i].x, points[i].y, points[i].z); };
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < order.size(); ++i)
        places[order[i]] = i > 0 && key(order[i - 1]) == key(order[i]) ? places[order[i - 1]] : order[i];
    return places;
}

/// The edges that have one face in their group.
std::vector<GroupEdge> openEdges(const ObjContent& file) {
    const std::vector<std::uint32_t> places = placesOf(file.points);
    std::vector<GroupEdge> edges;
    for (const ObjFace& face : file.faces) {
        for (std::uint32_t k = 0; k < face.size; ++k) {
            const std::uint32_t from = places[file.corners[face.firstCorner + k].point];
            const std::uint32_t to = places[file.corners[face.firstCorner + (k + 1) % face.size].point];
            if (from != to) edges.push_back({std::min(from, to), std::max(from, to), face.part});
        }
    }
    const auto key = [](const GroupEdge& edge) { return std::tie(edge.low, edge.high, edge.part); };
    std::ranges::sort(edges, {}, key);
    std::vector<GroupEdge> open;
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
        while (end < edges.size() && key(edges[end]) == key(edges[i])) ++end;
        if (end - i == 1) open.push_back(edges[i]);
    }
    return open;
}

}  // namespace

std::vector<std::uint32_t> objectsOfParts(const ObjContent& file) {
    DisjointSets objects(file.parts.size());
    if (!file.hasObjects && file.parts.size() > 1) {
        const std::vector<GroupEdge> open = openEdges(file);
        for (std::size_t i = 1; i < open.size(); ++i) {
            if (open[i].low != open[i - 1].low || open[i].high != open[i - 1].high) continue;
            objects.merge(open[i - 1].part, open[i].part);
        }
    }
    return objects.roots();
}

}  // namespace rubble
