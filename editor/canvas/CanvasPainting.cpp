#include "editor/canvas/CanvasPainting.h"

#include "core/asset/PieceColours.h"
#include "core/fracture/Partition.h"
#include "editor/canvas/ChangePainting.h"
#include "editor/canvas/GridPainting.h"
#include "editor/canvas/VoronoiLines.h"

#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rubble {

namespace {

constexpr double kLargestSeed = 4.0;    // pixels
constexpr double kSmallestSign = 1.75;  // pixels; smaller seeds are points without a sign
constexpr double kSeedPart = 0.14;      // of the mean distance between seeds
constexpr double kFinestSpacing =
    10.0;  // pixels between seeds; lines of smaller cells are not smoothed: many times as fast
constexpr double kVoronoiReach = 10.0;     // times the extent of all seeds, to the end of rays
constexpr double kLineReach = 2.0;         // pixels that a line reaches beyond where it runs
constexpr double kWidestBond = 7.0;        // pixels
constexpr double kThinnestBond = 0.75;     // pixels
constexpr float kAround = 0.45F;           // how much is seen of what lies around a fragment
constexpr std::size_t kMostSmooth = 3000;  // edges around it; more are not smoothed
constexpr double kSeedSpacing = 5.0;       // pixels; where seeds stand closer, they would hide their cells

/// Which of the seeds are painted.
enum class Whose {
    Baked,  // all that were baked, but for those that moved seeds replace
    Moved,  // the others
};

/// Paints what lies in one part of the canvas.
class ContentsPainter {
public:
    ContentsPainter(QPainter& painter, const QRectF& part, const CanvasView& view, const CanvasContents& contents,
                    const CanvasColours& colours, Whose whose)
        : m_painter(painter),
          m_view(view),
          m_contents(contents),
          m_colours(colours),
          m_whose(whose),
          m_pattern(whose == Whose::Baked ? *contents.pattern : *contents.moved->pattern),
          m_partition(m_pattern.partition()),
          m_spacing(seedSpacing(*contents.pattern, view)) {
        const QPointF width(kLineReach, kLineReach);
        m_part.include(view.metres(part.topLeft() - width));
        m_part.include(view.metres(part.bottomRight() + width));
        for (std::uint32_t piece = 0; piece < m_partition.pieceCount(); ++piece) {
            if (isInPart(m_pattern.box(piece)) && isOwn(m_partition.seedOfPiece[piece])) m_pieces.push_back(piece);
        }
    }

    void fillCells() {
        m_painter.setRenderHint(QPainter::Antialiasing, false);
        m_painter.setPen(Qt::NoPen);
        const bool isColoured = m_contents.colouring() != CellColouring::None;
        for (const std::uint32_t piece : m_pieces) {
            const QColor colour = isColoured ? m_contents.colour(m_pattern, piece) : m_colours.cell;
            fill(piece, colour);
            if (isHidden(piece)) hatch(piece);
        }
    }

    void drawCellEdges() {
        m_painter.setBrush(Qt::NoBrush);
        drawLines(cellEdges(), isOnScale() ? m_colours.edgeOnScale : m_colours.cellEdge);
    }

    void paintTriangles() {
        const Delaunay& delaunay = m_pattern.baked().triangulation;
        QList<QLineF> lines;
        for (std::uint32_t triangle = 0; triangle < delaunay.triangles.size(); ++triangle) {
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t halfEdge = 4 * triangle + k;
                const std::uint32_t from = delaunay.origin(halfEdge);
                const std::uint32_t to = delaunay.origin(Delaunay::next(halfEdge));
                if (from == Delaunay::kGhost || to == Delaunay::kGhost || from > to) continue;
                addLine(m_pattern.site(from), m_pattern.site(to), lines);
            }
        }
        drawLines(lines, isOnScale() ? m_colours.triangleOnScale : m_colours.triangle);
    }

    void paintWholeVoronoi() {
        // Rays end far out, at the same place whatever part is painted: so parts join without a seam.
        const Asset& asset = *m_pattern.baked().asset;
        const std::optional<GrainMap> grain = GrainMap::of(asset.pattern, asset.prism.outline);
        Box2 box = boundsOf(m_pattern.baked().triangulation.sites);
        const Vec2 around(kVoronoiReach * box.diagonal());
        box = {box.min - around, box.max + around};
        QList<QLineF> lines;
        for (const auto& [from, to] : voronoiLines(m_pattern.baked().triangulation, box)) {
            addLine(grain ? grain->origin(from) : from, grain ? grain->origin(to) : to, lines);
        }
        drawLines(lines, m_colours.wholeVoronoi);
    }

    void paintBonds() {
        m_painter.setRenderHint(QPainter::Antialiasing, m_spacing >= kFinestSpacing);
        const double widest = kWidestBond * std::min(m_spacing / kFinestSpacing, 1.0);
        const double longest = longestShared();
        for (const std::uint32_t piece : m_pieces) {
            for (const PieceContact& contact : contactsOf(m_partition, piece, m_pattern.leastEdge())) {
                if (contact.piece < piece && isInPart(m_pattern.box(contact.piece))) continue;  // drawn from there
                if (isHidden(piece) || isHidden(contact.piece)) continue;
                const double width = std::max(widest * contact.length / longest, kThinnestBond);
                m_painter.setPen(QPen(m_colours.bond, width, Qt::SolidLine, Qt::RoundCap));
                m_painter.drawLine(m_view.pixels(m_pattern.middle(piece)),
                                   m_view.pixels(m_pattern.middle(contact.piece)));
            }
        }
    }

    void paintSeeds() {
        if (m_spacing < kSeedSpacing) return;
        const double radius = seedRadius(*m_contents.pattern, m_view);
        m_painter.setRenderHint(QPainter::Antialiasing, radius >= kSmallestSign);
        const double reach = (kLargestSeed + 6.0) / m_view.scale;
        const Box2 part{m_part.min - Vec2(reach), m_part.max + Vec2(reach)};
        const std::vector<Vec2>& positions = m_pattern.seeds().positions;
        for (std::uint32_t seed = 0; seed < positions.size(); ++seed) {
            const Vec2 at = positions[seed];
            if (at.x < part.min.x || at.x > part.max.x || at.y < part.min.y || at.y > part.max.y) continue;
            if (isOwn(seed)) paintSeed(seed, m_view.pixels(at), radius);
        }
    }

private:
    /// Of all pieces, so that parts of the canvas fit together.
    double longestShared() const {
        double longest = 0.0;
        for (std::uint32_t piece = 0; piece < m_partition.pieceCount(); ++piece) {
            for (const PieceContact& contact : contactsOf(m_partition, piece, m_pattern.leastEdge())) {
                longest = std::max(longest, contact.length);
            }
        }
        return longest;
    }

    bool isInPart(const Box2& box) const {
        return box.max.x >= m_part.min.x && box.min.x <= m_part.max.x && box.max.y >= m_part.min.y &&
               box.min.y <= m_part.max.y;
    }

    bool isOwn(std::uint32_t seed) const {
        if (!m_contents.moved || seed == kNone) return m_whose == Whose::Baked;
        return m_whose == Whose::Moved ? m_contents.moved->isShown[seed] : !m_contents.moved->replaces(seed);
    }

    bool isHidden(std::uint32_t piece) const {
        return !m_contents.hidden.isEmpty() &&
               m_contents.hidden.holds(m_pattern.baked().inside, m_pattern.cellOf(piece), m_pattern.fragmentId(piece));
    }

    void fill(std::uint32_t piece, const QBrush& brush) {
        m_painter.setBrush(brush);
        const std::uint32_t ring = m_partition.ringsOfPiece[piece];
        if (m_partition.ringsOfPiece[piece + 1] - ring > 1) {
            m_painter.drawPath(pathOfPiece(m_pattern, piece, m_view));
            return;
        }
        const std::uint32_t begin = m_partition.cornersOfRing[ring], end = m_partition.cornersOfRing[ring + 1];
        m_corners.clear();
        for (std::uint32_t corner = begin; corner < end; ++corner) {
            m_corners.push_back(m_view.pixels(m_pattern.corner(corner)));
        }
        m_painter.drawPolygon(m_corners.data(), static_cast<int>(m_corners.size()));
    }

    void hatch(std::uint32_t piece) {
        fill(piece, m_colours.background);
        fill(piece, QBrush(m_colours.label, Qt::BDiagPattern));
    }

    /// Each edge once, from the lower of its two pieces; where the other one's seed did not move, it is the baked one's.
    QList<QLineF> cellEdges() const {
        QList<QLineF> lines;
        for (const std::uint32_t piece : m_pieces) {
            for (std::uint32_t ring = m_partition.ringsOfPiece[piece]; ring < m_partition.ringsOfPiece[piece + 1];
                 ++ring) {
                const std::uint32_t begin = m_partition.cornersOfRing[ring], end = m_partition.cornersOfRing[ring + 1];
                for (std::uint32_t corner = begin; corner < end; ++corner) {
                    if (isDrawnFrom(m_partition.across[corner], piece)) continue;
                    addLine(m_pattern.corner(corner), m_pattern.corner(corner + 1 < end ? corner + 1 : begin), lines);
                }
            }
        }
        return lines;
    }

    bool isDrawnFrom(std::uint32_t across, std::uint32_t piece) const {
        if (across == kNone) return false;
        if (!isOwn(m_partition.seedOfPiece[across])) return m_whose == Whose::Moved;
        return across < piece && isInPart(m_pattern.box(across));
    }

    void addLine(Vec2 from, Vec2 to, QList<QLineF>& lines) const {
        // Smoothing depends on the direction, and that on the order of the pieces, which changes.
        if (std::pair(to.x, to.y) < std::pair(from.x, from.y)) std::swap(from, to);
        Box2 box;
        box.include(from);
        box.include(to);
        if (isInPart(box)) lines.push_back({m_view.pixels(from), m_view.pixels(to)});
    }

    /// Fainter where they crowd, so that what they part is still seen.
    void drawLines(const QList<QLineF>& lines, QColor colour) {
        const bool isFine = m_spacing >= kFinestSpacing;
        if (!isFine) colour.setAlphaF(colour.alphaF() * static_cast<float>(std::max(m_spacing / kFinestSpacing, 0.15)));
        m_painter.setRenderHint(QPainter::Antialiasing, isFine);
        m_painter.setPen(QPen(colour, isFine ? 1.0 : 0.0));
        m_painter.drawLines(lines);
    }

    /// Cells have the colours of a scale, of which some are dark.
    bool isOnScale() const {
        return m_contents.layers.hasCells && !m_contents.compared && m_contents.range.most > m_contents.range.least;
    }

    void paintSeed(std::uint32_t seed, QPointF at, double radius) {
        const QColor colour = layerColour(m_pattern.layerNumber(seed));
        if (radius < kSmallestSign) {
            m_painter.fillRect(QRectF(at.x() - radius, at.y() - radius, 2.0 * radius, 2.0 * radius), colour);
        } else {
            const bool isEmpty = m_pattern.hasNoCell(seed);
            m_painter.setPen(QPen(isEmpty ? colour : m_colours.halo, isEmpty ? 1.5 : 1.0));
            m_painter.setBrush(isEmpty ? m_colours.background : colour);
            paintSeedSign(m_painter, at, radius, m_pattern.origin(seed));
        }
        if (m_pattern.isDuplicate(seed)) {
            m_painter.setBrush(Qt::NoBrush);
            m_painter.setPen(QPen(m_colours.fault, 1.5));
            m_painter.drawEllipse(at, radius + 3.5, radius + 3.5);
        }
    }

    QPainter& m_painter;
    const CanvasView& m_view;
    const CanvasContents& m_contents;
    const CanvasColours& m_colours;
    const Whose m_whose;
    const ShownPattern& m_pattern;
    const Partition& m_partition;
    double m_spacing;                     // pixels between seeds, about
    Box2 m_part;                          // m
    std::vector<std::uint32_t> m_pieces;  // that reach into the part
    std::vector<QPointF> m_corners;
};

void paintPattern(QPainter& painter, const QRectF& part, const CanvasView& view, const CanvasContents& contents,
                  const CanvasColours& colours) {
    ContentsPainter baked(painter, part, view, contents, colours, Whose::Baked);
    std::optional<ContentsPainter> moved;
    if (contents.moved) moved.emplace(painter, part, view, contents, colours, Whose::Moved);
    const CanvasLayers& layers = contents.layers;
    if (layers.hasCells) {
        baked.fillCells();
        if (moved) moved->fillCells();
        baked.drawCellEdges();
        if (moved) moved->drawCellEdges();
    }
    if (contents.compared) paintChanges(painter, view, *contents.compared, colours);
    if (layers.hasWholeVoronoi) baked.paintWholeVoronoi();
    if (layers.hasTriangles) baked.paintTriangles();
    if (layers.hasBonds) baked.paintBonds();
    if (layers.hasSeeds) baked.paintSeeds();
    if (layers.hasSeeds && moved) moved->paintSeeds();
}

/// Faintly: it is not what is edited.
void paintAround(QPainter& painter, const QRectF& part, const CanvasView& view,
                 const std::vector<std::array<Vec2, 2>>& edges, const CanvasColours& colours) {
    QList<QLineF> lines;
    for (const auto& [from, to] : edges) {
        const QLineF line(view.pixels(from), view.pixels(to));
        const QRectF box = QRectF(line.p1(), line.p2()).normalized().adjusted(-1.0, -1.0, 1.0, 1.0);
        if (box.intersects(part)) lines.push_back(line);
    }
    QColor colour = colours.label;
    colour.setAlphaF(kAround);
    painter.setRenderHint(QPainter::Antialiasing, edges.size() < kMostSmooth);
    painter.setPen(QPen(colour, 1.0));
    painter.drawLines(lines);
}

void addRing(const Ring& ring, const CanvasView& view, QPainterPath& path) {
    if (ring.empty()) return;
    path.moveTo(view.pixels(ring[0]));
    for (std::size_t k = 1; k < ring.size(); ++k) path.lineTo(view.pixels(ring[k]));
    path.closeSubpath();
}

}  // namespace

QColor CanvasContents::colour(const ShownPattern& shown, std::uint32_t piece) const {
    if (layers.colouring != CellColouring::Level) return shown.colour(piece, layers.colouring, range);
    const auto depth = depths.find(shown.fragmentId(piece));
    const double share = range.most > 0.0 && depth != depths.end() ? depth->second / range.most : 0.0;
    return QColor(packed(rampColour(share)));
}

const Asset* CanvasContents::asset() const {
    if (!pattern) return nullptr;
    return (moved ? moved->pattern : pattern)->baked().asset.get();
}

std::pair<const ShownPattern*, std::uint32_t> CanvasContents::find(SeedId seed) const {
    if (moved) {
        const std::uint32_t place = moved->pattern->find(seed);
        if (place != kNone && moved->isShown[place]) return {moved->pattern.get(), place};
    }
    return {pattern.get(), pattern->find(seed)};
}

void paintContents(QPainter& painter, const QRectF& part, const CanvasView& view, const CanvasContents& contents,
                   const CanvasColours& colours) {
    painter.save();
    painter.setClipRect(part);
    painter.fillRect(part, colours.background);
    if (contents.layers.hasGrid) paintGrid(painter, part, view, colours);
    if (contents.layers.hasCells) paintAround(painter, part, view, contents.around, colours);
    if (contents.pattern) paintPattern(painter, part, view, contents, colours);
    painter.restore();
}

QPainterPath pathOf(const Polygon& polygon, const CanvasView& view) {
    QPainterPath path;
    addRing(polygon.outer, view, path);
    for (const Ring& hole : polygon.holes) addRing(hole, view, path);
    return path;
}

QPainterPath pathOfPiece(const ShownPattern& pattern, std::uint32_t piece, const CanvasView& view) {
    Polygon outline = pieceOutline(pattern.partition(), piece);
    CanvasView shifted = view;
    shifted.centre -= pattern.partition().origin;
    return pathOf(outline, shifted);
}

double seedSpacing(const ShownPattern& pattern, const CanvasView& view) {
    const auto count = static_cast<double>(std::max<std::size_t>(pattern.seeds().positions.size(), 1));
    return std::sqrt(area(pattern.baked().asset->prism.outline) / count) * view.scale;
}

double seedRadius(const ShownPattern& pattern, const CanvasView& view) {
    return std::clamp(kSeedPart * seedSpacing(pattern, view), 0.75, kLargestSeed);
}

void paintSeedSign(QPainter& painter, QPointF centre, double radius, SeedOrigin origin) {
    if (origin == SeedOrigin::Scattered) return painter.drawEllipse(centre, radius, radius);
    if (origin == SeedOrigin::Placed) {
        const double half = 0.9 * radius;
        return painter.drawRect(QRectF(centre.x() - half, centre.y() - half, 2.0 * half, 2.0 * half));
    }
    const double half = 1.3 * radius;
    const QPointF corners[] = {centre + QPointF(half, 0.0), centre + QPointF(0.0, half), centre - QPointF(half, 0.0),
                               centre - QPointF(0.0, half)};
    painter.drawPolygon(corners, 4);
}

}  // namespace rubble
