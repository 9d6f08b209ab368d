#include "editor/canvas/ShownPattern.h"

#include "core/asset/PieceColours.h"
#include "core/fracture/PatternKind.h"
#include "core/fracture/PatternPartition.h"
#include "core/fracture/SeedEdits.h"
#include "core/geometry/Aspect.h"
#include "core/geometry/Predicates.h"
#include "editor/document/CellChoice.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace rubble {

namespace {

IndexRange cornersOf(const Partition& partition, std::uint32_t piece) {
    return {partition.cornersOfRing[partition.ringsOfPiece[piece]],
            partition.cornersOfRing[partition.ringsOfPiece[piece + 1]]};
}

bool holds(const Box2& box, Vec2 point) {
    return point.x >= box.min.x && point.x <= box.max.x && point.y >= box.min.y && point.y <= box.max.y;
}

/// Compares seeds of two patterns by what is drawn of them.
class Differences {
public:
    Differences(const ShownPattern& before, const ShownPattern& after) : m_before(before), m_after(after) {}

    Box2 box() {
        if (hasCuts(m_before) || hasCuts(m_after)) {
            for (const ShownPattern* pattern : {&m_before, &m_after}) {
                for (std::uint32_t piece = 0; piece < pattern->partition().pieceCount(); ++piece)
                    include(m_box, pattern->box(piece));
            }
        }
        if (m_before.seeds().ids == m_after.seeds().ids) {
            for (std::uint32_t seed = 0; seed < m_after.seeds().ids.size(); ++seed) compare(seed, seed);
        } else {
            compareByName();
        }
        return m_box;
    }

private:
    /// Cuts change pieces whose seeds stay where they are.
    static bool hasCuts(const ShownPattern& pattern) {
        return std::ranges::any_of(pattern.baked().asset->pattern.layers, [](const PatternLayer& layer) {
            const LayerRole role = kindOf(layer.parameters).role;
            return layer.isOn && (role == LayerRole::Cuts || role == LayerRole::Measures);
        });
    }

    void compareByName() {
        std::unordered_map<std::uint64_t, std::uint32_t> seeds;
        const auto key = [](SeedId id) { return std::uint64_t{id.layer} << 32 | id.index; };
        for (std::uint32_t k = 0; k < m_before.seeds().ids.size(); ++k) seeds.emplace(key(m_before.seeds().ids[k]), k);
        for (std::uint32_t k = 0; k < m_after.seeds().ids.size(); ++k) {
            const auto old = seeds.find(key(m_after.seeds().ids[k]));
            if (old == seeds.end()) {
                add(m_after, k);
                continue;
            }
            compare(old->second, k);
            seeds.erase(old);
        }
        for (const auto& [name, seed] : seeds) add(m_before, seed);
    }

    void compare(std::uint32_t before, std::uint32_t after) {
        if (isSame(before, after)) return;
        add(m_before, before);
        add(m_after, after);
    }

    bool isSame(std::uint32_t before, std::uint32_t after) const {
        if (m_before.seeds().positions[before] != m_after.seeds().positions[after]) return false;
        const IndexRange oldPieces = m_before.piecesOf(before);
        const IndexRange newPieces = m_after.piecesOf(after);
        if (oldPieces.size() != newPieces.size()) return false;
        for (std::size_t k = 0; k < oldPieces.size(); ++k) {
            if (!isSamePiece(static_cast<std::uint32_t>(oldPieces.begin + k),
                             static_cast<std::uint32_t>(newPieces.begin + k))) {
                return false;
            }
        }
        return true;
    }

    bool isSamePiece(std::uint32_t before, std::uint32_t after) const {
        const IndexRange old = cornersOf(m_before.partition(), before), now = cornersOf(m_after.partition(), after);
        if (old.size() != now.size()) return false;
        for (std::size_t k = 0; k < old.size(); ++k) {
            if (m_before.corner(old.begin + k) != m_after.corner(now.begin + k)) return false;
        }
        return true;
    }

    void add(const ShownPattern& pattern, std::uint32_t seed) { include(m_box, pattern.boxOf(seed)); }

    const ShownPattern& m_before;
    const ShownPattern& m_after;
    Box2 m_box;
};

}  // namespace

ShownPattern::ShownPattern(std::shared_ptr<const BakedPattern> baked) : m_baked(std::move(baked)) {
    const std::uint32_t count = partition().pieceCount();
    m_boxes.resize(count);
    m_areas.resize(count);
    m_middles.resize(count);
    for (std::uint32_t piece = 0; piece < count; ++piece) measure(piece);
    takeReports();
    for (std::uint32_t seed = 0; seed < seeds().ids.size(); ++seed) {
        if (m_runs.empty() || seeds().ids[seed].layer != m_runs.back().layer) {
            m_runs.push_back({seeds().ids[seed].layer, seed, seed});
        }
        ++m_runs.back().end;
    }
    countSorts();
}

void ShownPattern::takeReports() {
    m_marks.resize(seeds().ids.size(), Mark::None);
    for (const Report& report : partition().reports) {
        if (report.seed >= m_marks.size()) continue;
        if (report.code == ReportCode::DuplicateSeed) m_marks[report.seed] = Mark::Duplicate;
        if (report.code == ReportCode::SeedWithoutCell) m_marks[report.seed] = Mark::NoCell;
    }
    m_counts.duplicates = static_cast<std::size_t>(std::ranges::count(m_marks, Mark::Duplicate));
    m_counts.withoutCell = static_cast<std::size_t>(std::ranges::count(m_marks, Mark::NoCell));
}

void ShownPattern::countSorts() {
    for (const Run& run : m_runs) {
        const PatternLayer* layer = findLayer(m_baked->asset->pattern, run.layer);
        const std::size_t all = run.end - run.begin;
        if (std::holds_alternative<PlacedSeeds>(layer->parameters)) {
            m_counts.placed += all;
            continue;
        }
        const auto moved =
            static_cast<std::size_t>(std::ranges::count_if(layer->overrides, [&](const SeedOverride& change) {
                return find({run.layer, change.index}) != kNone;
            }));
        m_counts.moved += moved;
        m_counts.scattered += all - moved;
    }
}

void ShownPattern::measure(std::uint32_t piece) {
    const Partition& cells = partition();
    const Vec2 first = corner(cornersOf(cells, piece).begin);
    for (std::uint32_t ring = cells.ringsOfPiece[piece]; ring < cells.ringsOfPiece[piece + 1]; ++ring) {
        const std::uint32_t begin = cells.cornersOfRing[ring], end = cells.cornersOfRing[ring + 1];
        Vec2 from = corner(end - 1);
        for (std::uint32_t k = begin; k < end; ++k) {
            const Vec2 to = corner(k);
            const double part = cross(from - first, to - first) / 2.0;
            m_areas[piece] += part;
            m_middles[piece] += part / 3.0 * (from + to - 2.0 * first);
            m_boxes[piece].include(to);
            from = to;
        }
    }
    m_middles[piece] = first + (m_areas[piece] > 0.0 ? m_middles[piece] / m_areas[piece] : Vec2(0.0));
}

double ShownPattern::aspect(std::uint32_t piece) const { return aspectOf(pieceOutline(partition(), piece)); }

std::vector<std::uint32_t> ShownPattern::neighbours(std::uint32_t piece) const {
    std::vector<std::uint32_t> neighbours;
    for (const PieceContact& contact : contactsOf(partition(), piece, leastEdge())) neighbours.push_back(contact.piece);
    return neighbours;
}

double ShownPattern::leastEdge() const { return leastSharedEdge(*m_baked); }

std::string ShownPattern::fragmentId(std::uint32_t piece) const {
    const std::string parent = m_baked->inside.empty() ? std::string() : m_baked->inside + "/";
    return std::to_string(m_baked->asset->id) + "/" + parent + pieceName(partition(), piece, seeds().ids);
}

SeedId ShownPattern::cellOf(std::uint32_t piece) const { return cellId(partition(), piece, seeds().ids); }

IndexRange ShownPattern::piecesOf(std::uint32_t seed) const {
    const std::uint32_t first = partition().pieceOfSeed[seed];
    if (first == kNone) return {};
    std::uint32_t end = first;
    while (end < partition().pieceCount() && partition().seedOfPiece[end] == seed) ++end;
    return {first, end};
}

Box2 ShownPattern::boxOf(std::uint32_t seed) const {
    Box2 box;
    box.include(seeds().positions[seed]);
    const IndexRange pieces = piecesOf(seed);
    for (std::size_t piece = pieces.begin; piece < pieces.end; ++piece) include(box, m_boxes[piece]);
    return box;
}

std::uint32_t ShownPattern::pieceAt(Vec2 point) const {
    for (std::uint32_t piece = 0; piece < partition().pieceCount(); ++piece) {
        if (!holds(m_boxes[piece], point)) continue;
        const Polygon outline = pieceOutline(partition(), piece);
        if (containment(outline, point - partition().origin) != Containment::Outside) return piece;
    }
    return kNone;
}

std::uint32_t ShownPattern::seedNear(Vec2 point, double reach) const {
    std::uint32_t nearest = kNone;
    double least = reach * reach;
    for (std::uint32_t seed = 0; seed < seeds().positions.size(); ++seed) {
        const Vec2 apart = seeds().positions[seed] - point;
        const double distance = apart.x * apart.x + apart.y * apart.y;
        if (distance > least) continue;
        nearest = seed;
        least = distance;
    }
    return nearest;
}

std::uint32_t ShownPattern::triangleAt(Vec2 point) const {
    const Delaunay& delaunay = m_baked->triangulation;
    for (std::uint32_t k = 0; k < delaunay.triangles.size(); ++k) {
        const auto& corner = delaunay.triangles[k].corner;
        if (std::ranges::find(corner, Delaunay::kGhost) != std::end(corner)) continue;
        const Vec2 a = site(corner[0]), b = site(corner[1]), c = site(corner[2]);
        if (orient2d(a, b, point) >= 0 && orient2d(b, c, point) >= 0 && orient2d(c, a, point) >= 0) return k;
    }
    return kNone;
}

std::uint32_t ShownPattern::find(SeedId seed) const {
    const auto run = std::ranges::find(m_runs, seed.layer, &Run::layer);
    if (run == m_runs.end()) return kNone;
    const auto begin = seeds().ids.begin() + run->begin, end = seeds().ids.begin() + run->end;
    const auto place = std::lower_bound(begin, end, seed);
    return place != end && *place == seed ? static_cast<std::uint32_t>(place - seeds().ids.begin()) : kNone;
}

SeedOrigin ShownPattern::origin(std::uint32_t seed) const {
    const SeedId id = seeds().ids[seed];
    const PatternLayer* layer = findLayer(m_baked->asset->pattern, id.layer);
    if (std::holds_alternative<PlacedSeeds>(layer->parameters)) return SeedOrigin::Placed;
    const auto change = std::ranges::lower_bound(layer->overrides, id.index, {}, &SeedOverride::index);
    const bool isMoved = change != layer->overrides.end() && change->index == id.index;
    return isMoved ? SeedOrigin::Moved : SeedOrigin::Scattered;
}

std::size_t ShownPattern::layerNumber(std::uint32_t seed) const {
    const std::vector<PatternLayer>& layers = m_baked->asset->pattern.layers;
    return static_cast<std::size_t>(std::ranges::find(layers, seeds().ids[seed].layer, &PatternLayer::id) -
                                    layers.begin());
}

double ShownPattern::value(std::uint32_t piece, CellColouring colouring) const {
    switch (colouring) {
        case CellColouring::Area: return m_areas[piece];
        case CellColouring::Neighbours: return static_cast<double>(neighbours(piece).size());
        case CellColouring::Aspect: return aspect(piece);
        case CellColouring::Volume:
        case CellColouring::Mass: return volume(piece);
        case CellColouring::Threshold: return 1.0;
        case CellColouring::Level:
        case CellColouring::None:
        case CellColouring::Piece: break;
    }
    return 0.0;
}

ShownPattern::Range ShownPattern::range(CellColouring colouring) const {
    const bool isFigure = colouring != CellColouring::None && colouring != CellColouring::Piece;
    if (!isFigure || colouring == CellColouring::Level || m_areas.empty()) return {};
    Range range{1e308, -1e308};
    for (std::uint32_t piece = 0; piece < partition().pieceCount(); ++piece) {
        const double shown = value(piece, colouring);
        range = {std::min(range.least, shown), std::max(range.most, shown)};
    }
    return range;
}

QColor ShownPattern::colour(std::uint32_t piece, CellColouring colouring, Range range) const {
    if (colouring == CellColouring::Piece) return QColor(packed(pieceColour(fragmentId(piece))));
    const double spread = range.most - range.least;
    const double share = spread > 0.0 ? (value(piece, colouring) - range.least) / spread : 0.5;
    return QColor(packed(rampColour(share)));
}

void include(Box2& box, const Box2& other) {
    box.include(other.min);
    box.include(other.max);
}

Box2 differenceBox(const ShownPattern& before, const ShownPattern& after) { return Differences(before, after).box(); }

}  // namespace rubble
