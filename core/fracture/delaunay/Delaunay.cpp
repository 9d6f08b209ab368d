#include "core/fracture/delaunay/Delaunay.h"

#include "core/base/Parallel.h"
#include "core/fracture/delaunay/HilbertOrder.h"
#include "core/fracture/delaunay/InsertionRounds.h"
#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <string>

namespace rubble {
namespace {

constexpr std::size_t kParts = 16;  // that parallel loops over many sites are divided into

/// Removes duplicate sites. Equal ones are consecutive, the one of lowest index, which stays, first.
void removeDuplicates(Delaunay& delaunay) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < delaunay.sites.size(); ++i) {
        if (kept > 0 && delaunay.sites[i] == delaunay.sites[kept - 1]) {
            delaunay.duplicates.push_back({delaunay.seedOf[i], delaunay.seedOf[kept - 1]});
        } else {
            delaunay.sites[kept] = delaunay.sites[i];
            delaunay.seedOf[kept++] = delaunay.seedOf[i];
        }
    }
    delaunay.sites.resize(kept);
    delaunay.seedOf.resize(kept);
    std::sort(delaunay.duplicates.begin(), delaunay.duplicates.end());
}

/// Sets the sites to the distinct seeds in Hilbert order.
void setSites(std::span<const Vec2> seeds, int threads, Delaunay& delaunay) {
    delaunay.seedOf = hilbertOrder(seeds, threads);
    delaunay.sites.resize(seeds.size());
    std::array<bool, kParts> hasEqual{};
    const std::size_t parts = seeds.size() < kMinSitesForThreads ? 1 : kParts;
    forEachIndex(parts, threads, [&](std::size_t part) {
        const IndexRange range = chunkRange(seeds.size(), part, parts);
        for (std::size_t i = range.begin; i < range.end; ++i) {
            delaunay.sites[i] = seeds[delaunay.seedOf[i]];
            if (i > 0 && delaunay.sites[i] == seeds[delaunay.seedOf[i - 1]]) hasEqual[part] = true;
        }
    });
    if (std::find(hasEqual.begin(), hasEqual.end(), true) != hasEqual.end()) removeDuplicates(delaunay);
}

/// Makes the first site that is not collinear with sites 0 and 1 number 2; false if there is none.
bool moveNonCollinearSiteToThird(Delaunay& delaunay) {
    const UninitializedVector<Vec2>& sites = delaunay.sites;
    std::size_t third = 2;
    while (third < sites.size() && orient2d(sites[0], sites[1], sites[third]) == 0) ++third;
    if (third >= sites.size()) return false;
    const auto rotate = [third](auto& values) {
        std::rotate(values.begin() + 2, values.begin() + static_cast<std::ptrdiff_t>(third),
                    values.begin() + static_cast<std::ptrdiff_t>(third) + 1);
    };
    rotate(delaunay.sites);
    rotate(delaunay.seedOf);
    return true;
}

/// Connects collinear sites: edge k, between sites k and k + 1 along the line, has the ghosts 2k on its left and 2k + 1
/// on its right.
void connectCollinearSites(Delaunay& delaunay) {
    const UninitializedVector<Vec2>& sites = delaunay.sites;
    std::vector<std::uint32_t> line(sites.size());
    for (std::uint32_t i = 0; i < sites.size(); ++i) line[i] = i;
    std::sort(line.begin(), line.end(), [&](std::uint32_t a, std::uint32_t b) {
        return sites[a].x != sites[b].x ? sites[a].x < sites[b].x : sites[a].y < sites[b].y;
    });
    const std::uint32_t edges = static_cast<std::uint32_t>(line.size()) - 1;
    for (std::uint32_t k = 0; k < edges; ++k) {
        const std::uint32_t left = 4 * (2 * k), right = 4 * (2 * k + 1);
        const bool isFirst = k == 0, isLast = k + 1 == edges;
        delaunay.triangles.push_back({{line[k], line[k + 1], kGhost},
                                      {right, isLast ? right + 2 : left + 8 + 2, isFirst ? right + 1 : left - 8 + 1}});
        delaunay.triangles.push_back({{line[k + 1], line[k], kGhost},
                                      {left, isFirst ? left + 2 : right - 8 + 2, isLast ? left + 1 : right + 8 + 1}});
    }
}

}  // namespace

Result<Delaunay> triangulate(std::span<const Vec2> seeds, const TaskContext& task) {
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        if (isExactlyUsable(seeds[i])) continue;
        return Error{ErrorCode::BadInput, "Seed " + std::to_string(i) + " " + *coordinateFault(seeds[i]) + "."};
    }
    Delaunay delaunay;
    setSites(seeds, task.threads, delaunay);
    if (!moveNonCollinearSiteToThird(delaunay)) {
        if (delaunay.sites.size() > 1) connectCollinearSites(delaunay);
        return delaunay;
    }
    if (const Status inserted = insertSites(delaunay, task); !inserted) return inserted.error();
    return delaunay;
}

std::vector<std::uint32_t> outgoingHalfEdges(const Delaunay& delaunay) {
    std::vector<std::uint32_t> outgoing(delaunay.sites.size());
    for (std::uint32_t t = 0; t < delaunay.triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t corner = delaunay.triangles[t].corner[k];
            if (corner != kGhost) outgoing[corner] = 4 * t + k;
        }
    }
    return outgoing;
}

std::vector<std::array<std::uint32_t, 3>> triangleList(const Delaunay& delaunay) {
    std::vector<std::array<std::uint32_t, 3>> list;
    list.reserve(delaunay.triangles.size());
    for (const Delaunay::Triangle& triangle : delaunay.triangles) {
        const std::uint32_t* corner = triangle.corner;
        if (triangle.isGhost()) continue;
        std::array<std::uint32_t, 3> seeds = {delaunay.seedOf[corner[0]], delaunay.seedOf[corner[1]],
                                              delaunay.seedOf[corner[2]]};
        std::rotate(seeds.begin(), std::min_element(seeds.begin(), seeds.end()), seeds.end());
        list.push_back(seeds);
    }
    std::sort(list.begin(), list.end());
    return list;
}

}  // namespace rubble
