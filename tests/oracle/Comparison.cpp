#include "tests/oracle/Comparison.h"

#include "core/fracture/verify/VerifyDelaunay.h"
#include "core/fracture/verify/VerifyNearestSeed.h"
#include "core/fracture/verify/VerifyPartition.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "core/geometry/polygon/PolygonFaults.h"
#include "tests/oracle/ExactDelaunay.h"
#include "tests/oracle/ExactVoronoi.h"
#include "tests/oracle/SubdivisionFault.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble::oracle {
namespace {

using Fault = std::optional<std::string>;

/// The maximum error of a corner as a fraction of the outline's extent: 8 ulp of weld distance, and as much for
/// rounding.
constexpr double kCornerError = 16.0 * 0x1p-52;
/// A piece or neck wider than the corner error by this factor cannot be lost.
constexpr double kSafetyFactor = 4.0;
constexpr double kRelative = 1e-9;

struct Scale {
    double diameter;
    double cornerError;  // m
};

Scale scaleOf(const Polygon& outline) {
    const Box2 box = boundsOf(outline.outer);
    const double extent = std::max({box.size().x, box.size().y});
    return {box.diagonal(), kCornerError * extent};
}

/// The cell of one seed in the partition, in the terms of ExactCell.
struct FoundCell {
    std::uint32_t pieces = 0;
    double area = 0.0;
    Vec2 centroid{0.0, 0.0};                 // m, relative to the partition's origin
    std::map<std::uint32_t, double> shared;  // by seed
};

std::vector<FoundCell> foundCells(const Partition& partition, std::size_t seeds) {
    std::vector<FoundCell> cells(seeds);
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        const Polygon outline = pieceOutline(partition, piece);
        FoundCell& cell = cells[partition.seedOfPiece[piece]];
        const double pieceArea = area(outline);
        ++cell.pieces;
        cell.centroid = (cell.area * cell.centroid + pieceArea * centroid(outline)) / (cell.area + pieceArea);
        cell.area += pieceArea;
        for (const PieceContact& contact : contactsOf(partition, piece, 0.0))
            cell.shared[partition.seedOfPiece[contact.piece]] += contact.length;
    }
    return cells;
}

std::string compared(const char* what, double found, double exact) {
    return std::string(what) + " " + std::to_string(found) + " instead of " + std::to_string(exact) + ", off by " +
           std::to_string((found - exact) / exact) + " of it";
}

Fault neighbourFault(const FoundCell& found, const ExactCell& exact, const Scale& scale) {
    const double minLength = kMinSharedEdge * scale.diameter;
    const double band = kSafetyFactor * 2.0 * scale.cornerError;
    std::map<std::uint32_t, double> expected(exact.shared.begin(), exact.shared.end());
    for (const auto& [seed, length] : expected) {
        const auto entry = found.shared.find(seed);
        const double foundLength = entry == found.shared.end() ? 0.0 : entry->second;
        if (length > 1.5 * minLength && std::abs(foundLength - length) > kRelative * length + band + 0.1 * minLength)
            return compared(("edge shared with seed " + std::to_string(seed)).c_str(), foundLength, length);
    }
    for (const auto& [seed, length] : found.shared)
        if (length > 1.5 * minLength && !expected.contains(seed))
            return "shares " + std::to_string(length) + " m with seed " + std::to_string(seed) +
                   ", which is no neighbour";
    return std::nullopt;
}

Fault cellFault(const FoundCell& found, const ExactCell& exact, Vec2 shift, const Scale& scale) {
    const double areaBand = scale.cornerError * exact.perimeter;
    if (std::abs(found.area - exact.area) > kRelative * exact.area + areaBand)
        return compared("area", found.area, exact.area);
    if (found.pieces < exact.minPieces || found.pieces > exact.maxPieces)
        return std::to_string(found.pieces) + " pieces instead of " + std::to_string(exact.minPieces) + " to " +
               std::to_string(exact.maxPieces);
    if (found.pieces == 0) return std::nullopt;
    const double lever = scale.diameter * std::min(1.0, 2.0 * areaBand / exact.area);
    if (glm::distance(found.centroid, exact.centroid + shift) > kRelative * scale.diameter + lever)
        return "centroid off by " + std::to_string(glm::distance(found.centroid, exact.centroid + shift)) + " m";
    return neighbourFault(found, exact, scale);
}

/// Verifies that exactly the seeds without piece are reported, with the right code.
Fault reportFault(const Partition& partition, const std::vector<FoundCell>& found,
                  const std::vector<ExactCell>& exact) {
    std::map<std::uint32_t, Diagnostic> reports;
    for (const Diagnostic& report : partition.diagnostics)
        if (report.code == DiagnosticCode::DuplicateSeed || report.code == DiagnosticCode::SeedWithoutCell)
            if (!reports.try_emplace(report.place.seed, report).second)
                return "seed " + std::to_string(report.place.seed) + " is reported twice";
    for (std::uint32_t seed = 0; seed < found.size(); ++seed) {
        const std::string name = "seed " + std::to_string(seed);
        const auto report = reports.find(seed);
        if ((report != reports.end()) != (found[seed].pieces == 0))
            return name + " has a piece and a report, or neither";
        if (report == reports.end()) continue;
        const bool isDuplicate = report->second.code == DiagnosticCode::DuplicateSeed;
        if (isDuplicate != (exact[seed].sameAs != ExactCell::kSelf)) return name + " is wrongly reported";
        if (isDuplicate && report->second.place.otherSeed != exact[seed].sameAs)
            return name + " is said to equal another seed";
    }
    return std::nullopt;
}

Fault cellsFault(const FractureCase& input, const Partition& partition) {
    const Scale scale = scaleOf(input.outline);
    const auto exact = exactCells(input.outline, input.seeds, kSafetyFactor * scale.cornerError);
    const auto found = foundCells(partition, input.seeds.size());
    const Vec2 shift = input.outline.outer[0] - partition.origin;
    for (std::size_t seed = 0; seed < exact.size(); ++seed)
        if (auto fault = cellFault(found[seed], exact[seed], shift, scale))
            return "seed " + std::to_string(seed) + ": " + *fault;
    return reportFault(partition, found, exact);
}

Fault partitionFault(const FractureCase& input, const Delaunay& delaunay) {
    const auto partition = voronoiPartition(input.outline, delaunay);
    if (!partition) return "voronoiPartition: " + partition.error().message;
    if (auto fault = verifyPartition(*partition, input.outline)) return "verifyPartition: " + *fault;
    if (auto fault = verifyNearestSeed(*partition, input.seeds)) return "verifyNearestSeed: " + *fault;
    if (auto fault = subdivisionFault(*partition, input.outline)) return "subdivision: " + *fault;
    return cellsFault(input, *partition);
}

/// Removes elements one by one, from the last, while `isFaulty` stays true; keeps at least `minSize`.
template <class List, class IsFaulty>
bool shrink(List& list, std::size_t minSize, IsFaulty isFaulty) {
    bool hasShrunk = false;
    for (std::size_t k = list.size(); k-- > 0 && list.size() > minSize;) {
        const auto element = list[k];
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(k));
        if (isFaulty())
            hasShrunk = true;
        else
            list.insert(list.begin() + static_cast<std::ptrdiff_t>(k), element);
    }
    return hasShrunk;
}

}  // namespace

Fault fractureFault(const FractureCase& input) {
    const auto outline = validated(input.outline);
    if (!outline) return "validated: " + outline.error().message;
    if (*outline != input.outline) return "validated: the canonical outline was changed";
    const auto delaunay = triangulate(input.seeds);
    if (!delaunay) return "triangulate: " + delaunay.error().message;
    if (auto fault = verifyDelaunay(*delaunay, input.seeds)) return "verifyDelaunay: " + *fault;
    if (auto fault = delaunayFault(triangleList(*delaunay), input.seeds)) return "Delaunay: " + *fault;
    return partitionFault(input, *delaunay);
}

FractureCase shrunk(FractureCase faulty) {
    const auto isFaulty = [&faulty] {
        const auto outline = validated(faulty.outline);
        return outline && *outline == faulty.outline && fractureFault(faulty);
    };
    bool hasShrunk = true;
    while (hasShrunk) {
        hasShrunk = shrink(faulty.seeds, 0, isFaulty);
        hasShrunk |= shrink(faulty.outline.holes, 0, isFaulty);
        hasShrunk |= shrink(faulty.outline.outer, 3, isFaulty);
    }
    return faulty;
}

}  // namespace rubble::oracle
