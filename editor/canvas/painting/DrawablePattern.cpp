#include "editor/canvas/painting/DrawablePattern.h"

#include "core/asset/project/FragmentColours.h"
#include "core/fracture/pattern/PatternKind.h"
#include "core/fracture/pattern/PatternPartition.h"
#include "core/fracture/pattern/SeedEdits.h"
#include "core/geometry/hull/AspectRatio.h"
#include "core/geometry/predicates/Predicates.h"
#include "editor/document/CellSelection.h"
#include "editor/widgets/ColourConversion.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace rubble {

namespace {

IndexRange cornersOf(const Partition& partition, std::uint32_t piece) {
    return {partition.cornersOfRing[partition.outerRing(piece)],
            partition.cornersOfRing[partition.ringsOfPiece[piece + 1]]};
}

bool contains(const Box2& box, Vec2 point) {
    return point.x >= box.min.x && point.x <= box.max.x && point.y >= box.min.y && point.y <= box.max.y;
}

/// Compares what is drawn of the seeds of two patterns.
class Differences {
public:
    Differences(const DrawablePattern& before, const DrawablePattern& after) : m_before(before), m_after(after) {}

    Box2 box() {
        if (hasCuts(m_before) || hasCuts(m_after)) {
            for (const DrawablePattern* pattern : {&m_before, &m_after}) {
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
    /// Whether cut layers can change pieces whose seeds did not move.
    static bool hasCuts(const DrawablePattern& pattern) {
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

    void add(const DrawablePattern& pattern, std::uint32_t seed) { include(m_box, pattern.boxOf(seed)); }

    const DrawablePattern& m_before;
    const DrawablePattern& m_after;
    Box2 m_box;
};

}  // namespace

DrawablePattern::DrawablePattern(std::shared_ptr<const BakedPattern> baked) : m_baked(std::move(baked)) {
    const std::uint32_t count = partition().pieceCount();
    m_boxes.resize(count);
    m_areas.resize(count);
    m_centroids.resize(count);
    for (std::uint32_t piece = 0; piece < count; ++piece) measure(piece);
    readDiagnostics();
    for (std::uint32_t seed = 0; seed < seeds().ids.size(); ++seed) {
        if (m_layers.empty() || seeds().ids[seed].layer != m_layers.back().layer) {
            m_layers.push_back({seeds().ids[seed].layer, seed, seed});
        }
        ++m_layers.back().end;
    }
    countOrigins();
}

void DrawablePattern::readDiagnostics() {
    m_defects.resize(seeds().ids.size(), Defect::None);
    for (const Diagnostic& diagnostic : partition().diagnostics) {
        if (diagnostic.place.seed >= m_defects.size()) continue;
        if (diagnostic.code == DiagnosticCode::DuplicateSeed) m_defects[diagnostic.place.seed] = Defect::Duplicate;
        if (diagnostic.code == DiagnosticCode::SeedWithoutCell) m_defects[diagnostic.place.seed] = Defect::NoCell;
    }
    m_counts.duplicates = static_cast<std::size_t>(std::ranges::count(m_defects, Defect::Duplicate));
    m_counts.withoutCell = static_cast<std::size_t>(std::ranges::count(m_defects, Defect::NoCell));
}

void DrawablePattern::countOrigins() {
    for (const LayerSeeds& seedsOfLayer : m_layers) {
        const PatternLayer* layer = findLayer(m_baked->asset->pattern, seedsOfLayer.layer);
        const std::size_t all = seedsOfLayer.end - seedsOfLayer.begin;
        const std::size_t index = layerIndex(seedsOfLayer.begin);
        if (std::holds_alternative<PlacedSeeds>(layer->parameters)) {
            count(SeedOrigin::Placed, all, index);
            continue;
        }
        const auto moved =
            static_cast<std::size_t>(std::ranges::count_if(layer->overrides, [&](const SeedOverride& change) {
                return find({seedsOfLayer.layer, change.index}) != kNone;
            }));
        count(SeedOrigin::Moved, moved, index);
        count(SeedOrigin::Scattered, all - moved, index);
    }
}

void DrawablePattern::count(SeedOrigin origin, std::size_t seeds, std::size_t layer) {
    if (seeds == 0) return;
    std::size_t& total = origin == SeedOrigin::Scattered ? m_counts.scattered
                         : origin == SeedOrigin::Moved   ? m_counts.moved
                                                         : m_counts.placed;
    std::optional<std::size_t>& layerOfAll = m_counts.layers[static_cast<std::size_t>(origin)];
    layerOfAll = total == 0 ? std::optional(layer) : std::nullopt;
    total += seeds;
}

void DrawablePattern::measure(std::uint32_t piece) {
    const Partition& cells = partition();
    const Vec2 first = corner(cornersOf(cells, piece).begin);
    for (std::uint32_t ring = cells.ringsOfPiece[piece]; ring < cells.ringsOfPiece[piece + 1]; ++ring) {
        const std::uint32_t begin = cells.cornersOfRing[ring], end = cells.cornersOfRing[ring + 1];
        Vec2 from = corner(end - 1);
        for (std::uint32_t k = begin; k < end; ++k) {
            const Vec2 to = corner(k);
            const double part = cross(from - first, to - first) / 2.0;
            m_areas[piece] += part;
            m_centroids[piece] += part / 3.0 * (from + to - 2.0 * first);
            m_boxes[piece].include(to);
            from = to;
        }
    }
    m_centroids[piece] = first + (m_areas[piece] > 0.0 ? m_centroids[piece] / m_areas[piece] : Vec2(0.0));
}

double DrawablePattern::aspect(std::uint32_t piece) const { return aspectRatio(pieceOutline(partition(), piece)); }

std::vector<std::uint32_t> DrawablePattern::neighbours(std::uint32_t piece) const {
    std::vector<std::uint32_t> neighbours;
    for (const PieceContact& contact : contactsOf(partition(), piece, minimumEdge()))
        neighbours.push_back(contact.piece);
    return neighbours;
}

double DrawablePattern::minimumEdge() const { return minimumSharedEdge(*m_baked); }

std::string DrawablePattern::fragmentId(std::uint32_t piece) const {
    const std::string parent = m_baked->parent.empty() ? std::string() : m_baked->parent + "/";
    return std::to_string(m_baked->asset->id) + "/" + parent + pieceName(partition(), piece, seeds().ids);
}

SeedId DrawablePattern::cellOf(std::uint32_t piece) const { return cellId(partition(), piece, seeds().ids); }

IndexRange DrawablePattern::piecesOf(std::uint32_t seed) const {
    const std::uint32_t first = partition().pieceOfSeed[seed];
    if (first == kNone) return {};
    std::uint32_t end = first;
    while (end < partition().pieceCount() && partition().seedOfPiece[end] == seed) ++end;
    return {first, end};
}

Box2 DrawablePattern::boxOf(std::uint32_t seed) const {
    Box2 box;
    box.include(seeds().positions[seed]);
    const IndexRange pieces = piecesOf(seed);
    for (std::size_t piece = pieces.begin; piece < pieces.end; ++piece) include(box, m_boxes[piece]);
    return box;
}

std::uint32_t DrawablePattern::pieceAt(Vec2 point) const {
    for (std::uint32_t piece = 0; piece < partition().pieceCount(); ++piece) {
        if (!contains(m_boxes[piece], point)) continue;
        const Polygon outline = pieceOutline(partition(), piece);
        if (containment(outline, point - partition().origin) != Containment::Outside) return piece;
    }
    return kNone;
}

std::uint32_t DrawablePattern::nearestSeed(Vec2 point, double radius) const {
    std::uint32_t nearest = kNone;
    double least = radius * radius;
    for (std::uint32_t seed = 0; seed < seeds().positions.size(); ++seed) {
        const Vec2 apart = seeds().positions[seed] - point;
        const double distance = apart.x * apart.x + apart.y * apart.y;
        if (distance > least) continue;
        nearest = seed;
        least = distance;
    }
    return nearest;
}

std::uint32_t DrawablePattern::triangleAt(Vec2 point) const {
    const Delaunay& delaunay = m_baked->triangulation;
    for (std::uint32_t k = 0; k < delaunay.triangles.size(); ++k) {
        if (delaunay.triangles[k].isGhost()) continue;
        const auto& corner = delaunay.triangles[k].corner;
        const Vec2 a = site(corner[0]), b = site(corner[1]), c = site(corner[2]);
        if (orient2d(a, b, point) >= 0 && orient2d(b, c, point) >= 0 && orient2d(c, a, point) >= 0) return k;
    }
    return kNone;
}

std::uint32_t DrawablePattern::find(SeedId seed) const {
    const auto run = std::ranges::find(m_layers, seed.layer, &LayerSeeds::layer);
    if (run == m_layers.end()) return kNone;
    const auto begin = seeds().ids.begin() + run->begin, end = seeds().ids.begin() + run->end;
    const auto found = std::lower_bound(begin, end, seed);
    return found != end && *found == seed ? static_cast<std::uint32_t>(found - seeds().ids.begin()) : kNone;
}

SeedOrigin DrawablePattern::origin(std::uint32_t seed) const {
    const SeedId id = seeds().ids[seed];
    const PatternLayer* layer = findLayer(m_baked->asset->pattern, id.layer);
    if (std::holds_alternative<PlacedSeeds>(layer->parameters)) return SeedOrigin::Placed;
    const auto change = std::ranges::lower_bound(layer->overrides, id.index, {}, &SeedOverride::index);
    const bool isMoved = change != layer->overrides.end() && change->index == id.index;
    return isMoved ? SeedOrigin::Moved : SeedOrigin::Scattered;
}

std::size_t DrawablePattern::layerIndex(std::uint32_t seed) const {
    const std::vector<PatternLayer>& layers = m_baked->asset->pattern.layers;
    return static_cast<std::size_t>(std::ranges::find(layers, seeds().ids[seed].layer, &PatternLayer::id) -
                                    layers.begin());
}

double DrawablePattern::value(std::uint32_t piece, CellColouring colouring) const {
    switch (colouring) {
        case CellColouring::Area: return m_areas[piece];
        case CellColouring::Neighbours: return static_cast<double>(neighbours(piece).size());
        case CellColouring::Aspect: return aspect(piece);
        case CellColouring::Volume:
        case CellColouring::Mass: return volume(piece);
        case CellColouring::Threshold: return 1.0;
        case CellColouring::Level:
        case CellColouring::None:
        case CellColouring::Fragment:
        case CellColouring::Cluster: break;
    }
    return 0.0;
}

DrawablePattern::Range DrawablePattern::range(CellColouring colouring) const {
    if (!isQuantity(colouring) || colouring == CellColouring::Level || m_areas.empty()) return {};
    Range range{1e308, -1e308};
    for (std::uint32_t piece = 0; piece < partition().pieceCount(); ++piece) {
        const double number = value(piece, colouring);
        range = {std::min(range.least, number), std::max(range.most, number)};
    }
    return range;
}

QColor DrawablePattern::colour(std::uint32_t piece, CellColouring colouring, Range range) const {
    if (colouring == CellColouring::Fragment) return toQColor(fragmentColour(fragmentId(piece)));
    const double spread = range.most - range.least;
    const double fraction = spread > 0.0 ? (value(piece, colouring) - range.least) / spread : 0.5;
    return toQColor(rampColour(fraction));
}

void include(Box2& box, const Box2& other) {
    box.include(other.min);
    box.include(other.max);
}

Box2 differenceBox(const DrawablePattern& before, const DrawablePattern& after) {
    return Differences(before, after).box();
}

}  // namespace rubble
