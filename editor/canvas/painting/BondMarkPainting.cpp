#include "editor/canvas/painting/BondMarkPainting.h"

#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace rubble {

namespace {

// All in pixels.
constexpr double kSymbolSize = 12.0;
constexpr double kSymbolGap = 2.0;         // between two symbols
constexpr double kSymbolClearance = 14.0;  // of a symbol from the seed below it
constexpr double kMarkWidth = 2.0;         // of the border of marked fragments
constexpr double kClusterBorderWidth = 3.0;
constexpr double kNeutralWidth = 1.5;  // of bonds of factor 1
constexpr double kExtremeWidth = 3.5;  // of those at the ends of the scale
constexpr double kHaloWidth = 1.5;     // on each side
constexpr double kMinSpacing = 24.0;   // between seeds; bonds are thinner where they are closer

constexpr int kMarkAlpha = 60;  // of marked fragments, of 255
constexpr int kScaleSteps = 8;  // on each side of factor 1: bonds are drawn step by step

/// The place of a factor on the scale, from -1 to 1.
double scalePlace(double factor) {
    return factor <= kWeakestShown ? -1.0 : std::clamp(std::log10(factor) / std::log10(kStrongestShown), -1.0, 1.0);
}

QColor blended(const QColor& from, const QColor& to, double fraction) {
    const auto mix = [fraction](int a, int b) { return static_cast<int>(std::lround(a + fraction * (b - a))); };
    return {mix(from.red(), to.red()), mix(from.green(), to.green()), mix(from.blue(), to.blue())};
}

QColor colourAt(double place, const CanvasColours& colours) {
    return blended(colours.neutralBond, place < 0.0 ? colours.weakBond : colours.strongBond, std::abs(place));
}

QPen roundPen(const QColor& colour, double width) {
    return {colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

void paintSymbol(QPainter& painter, QPointF centre, const QPainterPath& path, const QColor& colour,
                 const QColor& halo) {
    const QPainterPath placed = path.translated(centre);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(roundPen(halo, 4.5));
    painter.drawPath(placed);
    painter.setPen(roundPen(colour, 1.75));
    painter.drawPath(placed);
}

/// Paints the marks of a pattern.
class BondMarkPainter {
public:
    BondMarkPainter(QPainter& painter, const CanvasView& view, const CanvasContents& contents,
                    const CanvasColours& colours)
        : m_painter(painter),
          m_view(view),
          m_contents(contents),
          m_colours(colours),
          m_pattern(*contents.pattern),
          m_marks(*contents.bondMarks) {}

    void paintFragments() {
        for (const bool isAnchorPass : {true, false}) {
            const std::vector<bool>& isMarked = isAnchorPass ? m_marks.isAnchored : m_marks.neverBreaks;
            paintAreas(isMarked, isAnchorPass ? m_colours.anchored : m_colours.neverBreaks,
                       isAnchorPass ? Qt::SolidLine : Qt::DashLine);
        }
    }

    /// The borders between clusters, in any colouring.
    void paintClusterBorders() {
        const std::vector<Colour>& colours = m_marks.clusterColours;
        const Partition& partition = m_pattern.partition();
        QList<QLineF> borders;
        for (std::uint32_t piece = 0; piece < colours.size(); ++piece) {
            if (!isShown(piece)) continue;
            forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
                if (neighbour == kNone || neighbour < piece || colours[neighbour] == colours[piece]) return;
                borders.push_back({m_view.pixels(partition.origin + partition.points[from]),
                                   m_view.pixels(partition.origin + partition.points[to])});
            });
        }
        m_painter.setRenderHint(QPainter::Antialiasing);
        m_painter.setPen(roundPen(m_colours.cellEdge, kClusterBorderWidth));
        m_painter.drawLines(borders);
    }

    void paintSymbols() {
        for (std::uint32_t piece = 0; piece < m_marks.isAnchored.size(); ++piece) {
            const bool isAnchored = m_marks.isAnchored[piece], neverBreaks = m_marks.neverBreaks[piece];
            if ((!isAnchored && !neverBreaks) || !isShown(piece)) continue;
            const double width = isAnchored && neverBreaks ? 2.0 * kSymbolSize + kSymbolGap : kSymbolSize;
            const std::optional<QPointF> place = symbolPlace(piece, width);
            if (!place) continue;
            const QPointF aside((width - kSymbolSize) / 2.0, 0.0);
            if (isAnchored) paintAnchorSymbol(m_painter, *place - aside, m_colours);
            if (neverBreaks) paintShieldSymbol(m_painter, *place + aside, m_colours);
        }
    }

    /// The halos first, so that none covers a bond. Those of factor 1 have none: only others shall stand out.
    void paintBonds() {
        const double thinning = std::clamp(seedSpacing(m_pattern, m_view) / kMinSpacing, 0.3, 1.0);
        std::map<int, QList<QLineF>> lines;  // by step of the scale; beyond it, those that never break
        for (const BondEdge& edge : m_marks.edges) {
            const int step = std::isinf(edge.factor)
                                 ? kScaleSteps + 1
                                 : static_cast<int>(std::lround(kScaleSteps * scalePlace(edge.factor)));
            if (isVisible(edge)) lines[step].push_back({m_view.pixels(edge.from), m_view.pixels(edge.to)});
        }
        m_painter.setRenderHint(QPainter::Antialiasing);
        for (const bool isHaloPass : {true, false}) {
            for (const auto& [step, ofStep] : lines) {
                if (isHaloPass && step == 0) continue;
                const double place = static_cast<double>(std::min(step, kScaleSteps)) / kScaleSteps;
                const double width = kNeutralWidth + std::abs(place) * (kExtremeWidth - kNeutralWidth);
                const QColor colour = step > kScaleSteps ? m_colours.neverBreaks : colourAt(place, m_colours);
                m_painter.setPen(isHaloPass ? roundPen(m_colours.halo, thinning * (width + 2.0 * kHaloWidth))
                                            : roundPen(colour, thinning * width));
                m_painter.drawLines(ofStep);
            }
        }
    }

private:
    /// Whether a piece is drawn where it was baked, not hidden and within the view.
    bool isShown(std::uint32_t piece) const {
        const Box2 visible = m_view.visibleBox();
        const Box2& box = m_pattern.box(piece);
        if (box.max.x < visible.min.x || box.min.x > visible.max.x || box.max.y < visible.min.y ||
            box.min.y > visible.max.y)
            return false;
        const std::uint32_t seed = m_pattern.partition().seedOfPiece[piece];
        if (m_contents.moved && seed != kNone && m_contents.moved->replaces(seed)) return false;
        return m_contents.hidden.isEmpty() ||
               !m_contents.hidden.contains(m_pattern.baked().parent, m_pattern.cellOf(piece),
                                           m_pattern.fragmentId(piece));
    }

    bool isVisible(const BondEdge& edge) const {
        const QRectF box = QRectF(m_view.pixels(edge.from), m_view.pixels(edge.to)).normalized();
        return box.adjusted(-kExtremeWidth, -kExtremeWidth, kExtremeWidth, kExtremeWidth)
            .intersects(QRectF({}, m_view.size));
    }

    /// Fills marked pieces, with a border around areas of them unless bonds are drawn there.
    void paintAreas(const std::vector<bool>& isMarked, const QColor& colour, Qt::PenStyle style) {
        QColor fill = colour;
        fill.setAlpha(kMarkAlpha);
        const Partition& partition = m_pattern.partition();
        QList<QLineF> border;
        m_painter.setRenderHint(QPainter::Antialiasing, false);  // the fills of neighbours would overlap
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(fill);
        for (std::uint32_t piece = 0; piece < isMarked.size(); ++piece) {
            if (!isMarked[piece] || !isShown(piece)) continue;
            m_painter.drawPath(pathOfPiece(m_pattern, piece, m_view));
            forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
                if (neighbour != kNone && isMarked[neighbour]) return;
                border.push_back({m_view.pixels(partition.origin + partition.points[from]),
                                  m_view.pixels(partition.origin + partition.points[to])});
            });
        }
        if (m_marks.showsStrengths) return;
        m_painter.setRenderHint(QPainter::Antialiasing);
        m_painter.setBrush(Qt::NoBrush);
        m_painter.setPen(roundPen(m_colours.halo, kMarkWidth + 2.0 * kHaloWidth));
        m_painter.drawLines(border);
        m_painter.setPen(QPen(colour, kMarkWidth, style, Qt::FlatCap));
        m_painter.drawLines(border);
    }

    /// A place for symbols beside the centre of a piece, where a seed may be, or there; none if there is no room.
    std::optional<QPointF> symbolPlace(std::uint32_t piece, double width) const {
        const QPainterPath path = pathOfPiece(m_pattern, piece, m_view);
        const QPointF centre = m_view.pixels(m_pattern.centroid(piece));
        for (const double aside : {kSymbolClearance, -kSymbolClearance, 0.0}) {
            const QPointF place = centre + QPointF(0.0, aside);
            const QPointF half(width / 2.0 + 1.0, kSymbolSize / 2.0 + 1.0);
            if (path.contains(QRectF(place - half, place + half))) return place;
        }
        return std::nullopt;
    }

    QPainter& m_painter;
    const CanvasView& m_view;
    const CanvasContents& m_contents;
    const CanvasColours& m_colours;
    const DrawablePattern& m_pattern;
    const BondMarks& m_marks;
};

}  // namespace

QColor bondColour(double factor, const CanvasColours& colours) {
    return std::isinf(factor) ? colours.neverBreaks : colourAt(scalePlace(factor), colours);
}

void paintBondMarks(QPainter& painter, const CanvasView& view, const CanvasContents& contents,
                    const CanvasColours& colours) {
    if (!contents.bondMarks || !contents.pattern || !contents.overlays.hasCells) return;
    BondMarkPainter marks(painter, view, contents, colours);
    marks.paintClusterBorders();
    marks.paintFragments();
    if (!contents.moved) marks.paintBonds();
    marks.paintSymbols();
}

void paintAnchorSymbol(QPainter& painter, QPointF centre, const CanvasColours& colours) {
    QPainterPath anchor;
    anchor.addEllipse(QPointF(0.0, -4.25), 1.5, 1.5);
    anchor.moveTo(0.0, -2.75);
    anchor.lineTo(0.0, 5.5);
    anchor.moveTo(-2.5, -0.75);
    anchor.lineTo(2.5, -0.75);
    anchor.moveTo(-5.0, 1.5);
    anchor.quadTo(-4.5, 5.5, 0.0, 5.5);
    anchor.quadTo(4.5, 5.5, 5.0, 1.5);
    paintSymbol(painter, centre, anchor, colours.anchored, colours.halo);
}

void paintShieldSymbol(QPainter& painter, QPointF centre, const CanvasColours& colours) {
    QPainterPath shield(QPointF(0.0, -5.5));
    shield.lineTo(4.75, -3.75);
    shield.lineTo(4.75, -0.5);
    shield.quadTo(4.5, 3.5, 0.0, 5.75);
    shield.quadTo(-4.5, 3.5, -4.75, -0.5);
    shield.lineTo(-4.75, -3.75);
    shield.closeSubpath();
    paintSymbol(painter, centre, shield, colours.neverBreaks, colours.halo);
}

}  // namespace rubble
