#include "editor/canvas/painting/CanvasPainting.h"

#include "core/asset/project/FragmentColours.h"
#include "core/fracture/partition/Partition.h"
#include "core/fracture/pattern/AnisotropyMap.h"
#include "editor/canvas/painting/ChangePainting.h"
#include "editor/canvas/painting/GridPainting.h"
#include "editor/canvas/painting/VoronoiEdges.h"
#include "editor/widgets/ColourConversion.h"

#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rubble {

namespace {

constexpr double kMaxSeedRadius = 4.0;         // pixels
constexpr double kMinMarkerRadius = 1.75;      // pixels; smaller seeds are drawn as points
constexpr double kSeedRadiusFraction = 0.14;   // of the mean distance between seeds
constexpr double kMinSmoothSpacing = 10.0;     // pixels; closer seeds turn off antialiasing, which is many times faster
constexpr double kVoronoiExtent = 10.0;        // length of rays, in diagonals of the sites' bounding box
constexpr double kLineMargin = 2.0;            // pixels that a line's width extends beyond its ends
constexpr double kMaxBondWidth = 7.0;          // pixels
constexpr double kMinBondWidth = 0.75;         // pixels
constexpr float kFaintOpacity = 0.45F;         // opacity of what lies around an entered fragment
constexpr std::size_t kMaxSmoothEdges = 3000;  // above it, surrounding edges are not antialiased
constexpr double kMinSeedSpacing = 5.0;        // pixels; closer seeds would hide their cells and are not drawn

/// The part of the pattern that is painted.
enum class PatternPart {
    Baked,  // the baked pattern, without the cells that MovedPart replaces
    Moved,  // the cells of MovedPart
};

/// Paints one part of the pattern into one part of the canvas.
class ContentsPainter {
public:
    ContentsPainter(QPainter& painter, const QRectF& part, const CanvasView& view, const CanvasContents& contents,
                    const CanvasColours& colours, PatternPart patternPart)
        : m_painter(painter),
          m_view(view),
          m_contents(contents),
          m_colours(colours),
          m_patternPart(patternPart),
          m_pattern(patternPart == PatternPart::Baked ? *contents.pattern : *contents.moved->pattern),
          m_partition(m_pattern.partition()),
          m_spacing(seedSpacing(*contents.pattern, view)) {
        const QPointF width(kLineMargin, kLineMargin);
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
        drawLines(cellEdges(), m_contents.isOnScale() ? m_colours.edgeOnScale : m_colours.cellEdge);
    }

    void paintTriangles() {
        const Delaunay& delaunay = m_pattern.baked().triangulation;
        QList<QLineF> lines;
        for (std::uint32_t triangle = 0; triangle < delaunay.triangles.size(); ++triangle) {
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t halfEdge = 4 * triangle + k;
                const std::uint32_t from = delaunay.origin(halfEdge);
                const std::uint32_t to = delaunay.origin(Delaunay::next(halfEdge));
                if (from == kGhost || to == kGhost || from > to) continue;
                addLine(m_pattern.site(from), m_pattern.site(to), lines);
            }
        }
        drawLines(lines, m_contents.isOnScale() ? m_colours.triangleOnScale : m_colours.triangle);
    }

    void paintWholeVoronoi() {
        // Rays end at the same point for every painted part, so that parts join seamlessly.
        const Asset& asset = *m_pattern.baked().asset;
        const std::optional<AnisotropyMap> grain = AnisotropyMap::of(asset.pattern, asset.prism().outline);
        Box2 box = boundsOf(m_pattern.baked().triangulation.sites);
        const Vec2 around(kVoronoiExtent * box.diagonal());
        box = {box.min - around, box.max + around};
        QList<QLineF> lines;
        for (const auto& [from, to] : voronoiEdges(m_pattern.baked().triangulation, box)) {
            addLine(grain ? grain->inverse(from) : from, grain ? grain->inverse(to) : to, lines);
        }
        drawLines(lines, m_colours.wholeVoronoi);
    }

    void paintBonds() {
        m_painter.setRenderHint(QPainter::Antialiasing, m_spacing >= kMinSmoothSpacing);
        const double widest = kMaxBondWidth * std::min(m_spacing / kMinSmoothSpacing, 1.0);
        const double longest = longestShared();
        for (const std::uint32_t piece : m_pieces) {
            for (const PieceContact& contact : contactsOf(m_partition, piece, m_pattern.minimumEdge())) {
                if (contact.piece < piece && isInPart(m_pattern.box(contact.piece)))
                    continue;  // drawn with the other piece
                if (isHidden(piece) || isHidden(contact.piece)) continue;
                const double width = std::max(widest * contact.length / longest, kMinBondWidth);
                m_painter.setPen(QPen(m_colours.bond, width, Qt::SolidLine, Qt::RoundCap));
                m_painter.drawLine(m_view.pixels(m_pattern.centroid(piece)),
                                   m_view.pixels(m_pattern.centroid(contact.piece)));
            }
        }
    }

    void paintSeeds() {
        if (m_spacing < kMinSeedSpacing) return;
        const double radius = seedRadius(*m_contents.pattern, m_view);
        m_painter.setRenderHint(QPainter::Antialiasing, radius >= kMinMarkerRadius);
        const double margin = (kMaxSeedRadius + 6.0) / m_view.scale;
        const Box2 part{m_part.min - Vec2(margin), m_part.max + Vec2(margin)};
        const std::vector<Vec2>& positions = m_pattern.seeds().positions;
        for (std::uint32_t seed = 0; seed < positions.size(); ++seed) {
            const Vec2 at = positions[seed];
            if (at.x < part.min.x || at.x > part.max.x || at.y < part.min.y || at.y > part.max.y) continue;
            if (isOwn(seed)) paintSeed(seed, m_view.pixels(at), radius);
        }
    }

private:
    /// The longest edge shared by any two pieces of the whole pattern, m; the same for every painted part.
    double longestShared() const {
        double longest = 0.0;
        for (std::uint32_t piece = 0; piece < m_partition.pieceCount(); ++piece) {
            for (const PieceContact& contact : contactsOf(m_partition, piece, m_pattern.minimumEdge())) {
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
        if (!m_contents.moved || seed == kNone) return m_patternPart == PatternPart::Baked;
        return m_patternPart == PatternPart::Moved ? m_contents.moved->isShown[seed]
                                                   : !m_contents.moved->replaces(seed);
    }

    bool isHidden(std::uint32_t piece) const {
        return !m_contents.hidden.isEmpty() &&
               m_contents.hidden.contains(m_pattern.baked().parent, m_pattern.cellOf(piece),
                                          m_pattern.fragmentId(piece));
    }

    void fill(std::uint32_t piece, const QBrush& brush) {
        m_painter.setBrush(brush);
        if (m_partition.ringCount(piece) > 1) {
            m_painter.drawPath(pathOfPiece(m_pattern, piece, m_view));
            return;
        }
        const std::uint32_t ring = m_partition.outerRing(piece);
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

    /// Each edge once, from the piece with the lower index; an edge to a cell that did not move belongs to the baked
    /// pattern.
    QList<QLineF> cellEdges() const {
        QList<QLineF> lines;
        for (const std::uint32_t piece : m_pieces) {
            for (std::uint32_t ring = m_partition.ringsOfPiece[piece]; ring < m_partition.ringsOfPiece[piece + 1];
                 ++ring) {
                const std::uint32_t begin = m_partition.cornersOfRing[ring], end = m_partition.cornersOfRing[ring + 1];
                for (std::uint32_t corner = begin; corner < end; ++corner) {
                    if (isDrawnFrom(m_partition.neighbours[corner], piece)) continue;
                    addLine(m_pattern.corner(corner), m_pattern.corner(corner + 1 < end ? corner + 1 : begin), lines);
                }
            }
        }
        return lines;
    }

    bool isDrawnFrom(std::uint32_t neighbour, std::uint32_t piece) const {
        if (neighbour == kNone) return false;
        if (!isOwn(m_partition.seedOfPiece[neighbour])) return m_patternPart == PatternPart::Moved;
        return neighbour < piece && isInPart(m_pattern.box(neighbour));
    }

    void addLine(Vec2 from, Vec2 to, QList<QLineF>& lines) const {
        // Antialiasing depends on the direction of a line, which depends on the order of the pieces.
        if (std::pair(to.x, to.y) < std::pair(from.x, from.y)) std::swap(from, to);
        Box2 box;
        box.include(from);
        box.include(to);
        if (isInPart(box)) lines.push_back({m_view.pixels(from), m_view.pixels(to)});
    }

    /// Fainter where lines are dense, so that the cells stay visible.
    void drawLines(const QList<QLineF>& lines, QColor colour) {
        const bool isFine = m_spacing >= kMinSmoothSpacing;
        if (!isFine)
            colour.setAlphaF(colour.alphaF() * static_cast<float>(std::max(m_spacing / kMinSmoothSpacing, 0.15)));
        m_painter.setRenderHint(QPainter::Antialiasing, isFine);
        m_painter.setPen(QPen(colour, isFine ? 1.0 : 0.0));
        m_painter.drawLines(lines);
    }

    void paintSeed(std::uint32_t seed, QPointF at, double radius) {
        const QColor colour = layerColour(m_pattern.layerIndex(seed));
        if (radius < kMinMarkerRadius) {
            m_painter.fillRect(QRectF(at.x() - radius, at.y() - radius, 2.0 * radius, 2.0 * radius), colour);
        } else {
            const bool isEmpty = m_pattern.hasNoCell(seed);
            m_painter.setPen(QPen(isEmpty ? colour : m_colours.halo, isEmpty ? 1.5 : 1.0));
            m_painter.setBrush(isEmpty ? m_colours.background : colour);
            paintSeedMarker(m_painter, at, radius, m_pattern.origin(seed));
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
    const PatternPart m_patternPart;
    const DrawablePattern& m_pattern;
    const Partition& m_partition;
    double m_spacing;                     // approximate distance between seeds, pixels
    Box2 m_part;                          // m
    std::vector<std::uint32_t> m_pieces;  // that intersect the part
    std::vector<QPointF> m_corners;
};

/// Paints edges that cannot be edited here.
void paintFaintEdges(QPainter& painter, const QRectF& part, const CanvasView& view,
                     const std::vector<std::array<Vec2, 2>>& edges, QColor colour) {
    QList<QLineF> lines;
    for (const auto& [from, to] : edges) {
        const QLineF line(view.pixels(from), view.pixels(to));
        const QRectF box = QRectF(line.p1(), line.p2()).normalized().adjusted(-1.0, -1.0, 1.0, 1.0);
        if (box.intersects(part)) lines.push_back(line);
    }
    colour.setAlphaF(kFaintOpacity);
    painter.setRenderHint(QPainter::Antialiasing, edges.size() < kMaxSmoothEdges);
    painter.setPen(QPen(colour, 1.0));
    painter.drawLines(lines);
}

void addRing(const Ring& ring, const CanvasView& view, QPainterPath& path) {
    if (ring.empty()) return;
    path.moveTo(view.pixels(ring[0]));
    for (std::size_t k = 1; k < ring.size(); ++k) path.lineTo(view.pixels(ring[k]));
    path.closeSubpath();
}

/// Paints the gaps between fragments: the outline without the shrunk pieces. Of one that vanished, all is gap.
void paintGaps(QPainter& painter, const CanvasView& view, const CanvasContents& contents,
               const CanvasColours& colours) {
    const Partition& shrunk = *contents.shrunk;
    CanvasView shifted = view;
    shifted.centre -= shrunk.origin;
    QPainterPath path = pathOf(contents.asset()->prism().outline, view);
    for (std::uint32_t piece = 0; piece < shrunk.pieceCount(); ++piece) {
        const Polygon outline = pieceOutline(shrunk, piece);
        addRing(outline.outer, shifted, path);
        for (const Ring& hole : outline.holes) addRing(hole, shifted, path);
    }
    path.setFillRule(Qt::OddEvenFill);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.background);
    painter.drawPath(path);
}

void paintPattern(QPainter& painter, const QRectF& part, const CanvasView& view, const CanvasContents& contents,
                  const CanvasColours& colours) {
    ContentsPainter baked(painter, part, view, contents, colours, PatternPart::Baked);
    std::optional<ContentsPainter> moved;
    if (contents.moved) moved.emplace(painter, part, view, contents, colours, PatternPart::Moved);
    const CanvasOverlays& overlays = contents.overlays;
    if (overlays.hasCells) {
        baked.fillCells();
        if (moved) moved->fillCells();
        baked.drawCellEdges();
        if (moved) moved->drawCellEdges();
        if (contents.shrunk && !moved) paintGaps(painter, view, contents, colours);
        paintFaintEdges(painter, part, view, contents.deeperEdges, colours.cellEdge);
    }
    if (contents.compared) paintChanges(painter, view, *contents.compared, colours);
    if (overlays.hasWholeVoronoi) baked.paintWholeVoronoi();
    if (overlays.hasTriangles) baked.paintTriangles();
    if (overlays.hasBonds) baked.paintBonds();
    if (overlays.hasSeeds) baked.paintSeeds();
    if (overlays.hasSeeds && moved) moved->paintSeeds();
}

}  // namespace

void paintContents(QPainter& painter, const QRectF& part, const CanvasView& view, const CanvasContents& contents,
                   const CanvasColours& colours) {
    painter.save();
    painter.setClipRect(part);
    painter.fillRect(part, colours.background);
    if (contents.overlays.hasGrid) paintGrid(painter, part, view, contents.units, colours);
    if (contents.overlays.hasCells) paintFaintEdges(painter, part, view, contents.surroundings, colours.label);
    if (contents.pattern) paintPattern(painter, part, view, contents, colours);
    painter.restore();
}

QPainterPath pathOf(const Polygon& polygon, const CanvasView& view) {
    QPainterPath path;
    addRing(polygon.outer, view, path);
    for (const Ring& hole : polygon.holes) addRing(hole, view, path);
    return path;
}

QPainterPath pathOfPiece(const DrawablePattern& pattern, std::uint32_t piece, const CanvasView& view) {
    Polygon outline = pieceOutline(pattern.partition(), piece);
    CanvasView shifted = view;
    shifted.centre -= pattern.partition().origin;
    return pathOf(outline, shifted);
}

double seedSpacing(const DrawablePattern& pattern, const CanvasView& view) {
    const auto count = static_cast<double>(std::max<std::size_t>(pattern.seeds().positions.size(), 1));
    return std::sqrt(area(pattern.baked().asset->prism().outline) / count) * view.scale;
}

double seedRadius(const DrawablePattern& pattern, const CanvasView& view) {
    return std::clamp(kSeedRadiusFraction * seedSpacing(pattern, view), 0.75, kMaxSeedRadius);
}

void paintSeedMarker(QPainter& painter, QPointF centre, double radius, SeedOrigin origin) {
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
