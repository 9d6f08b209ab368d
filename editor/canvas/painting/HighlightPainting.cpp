#include "editor/canvas/painting/HighlightPainting.h"

#include "core/fracture/pattern/AnisotropyMap.h"
#include "editor/canvas/painting/LabelPainting.h"
#include "editor/canvas/painting/RulerPainting.h"
#include "editor/canvas/painting/VoronoiEdges.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainterPath>

#include <algorithm>

namespace rubble {

namespace {

constexpr double kLargestCircle = 1e5;          // pixels; larger circles look like lines and are slow to draw
constexpr std::size_t kMaxDetailedSeeds = 600;  // more are marked by squares, which are faster
constexpr double kMessageMargin = 40.0;         // pixels
constexpr double kPointerMargin = 40.0;         // pixels, that a label keeps from the pointer
constexpr double kPanelWeight = 1e4;            // of what a label must not cover, against what it should not
constexpr double kPieceWeight = 100.0;
constexpr double kPromptMargin = 16.0;  // pixels, around a hint on the canvas
constexpr double kPromptHeight = 60.0;  // pixels, that a hint takes at most

struct HighlightPaintingTexts {
    Q_DECLARE_TR_FUNCTIONS(HighlightPainting)
};

QColor withAlpha(QColor colour, int alpha) {
    colour.setAlpha(alpha);
    return colour;
}

class SelectionPainter {
public:
    SelectionPainter(QPainter& painter, const CanvasView& view, const CanvasContents& contents,
                     const CanvasColours& colours)
        : m_painter(painter), m_view(view), m_contents(contents), m_colours(colours) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colours.accent, 2.0));
    }

    void paintSeeds(const FragmentSelection& selection) {
        const double radius = std::max(seedRadius(*m_contents.pattern, m_view), 2.0) + 2.5;
        const bool isFine = selection.seeds.size() <= kMaxDetailedSeeds;
        for (const SeedId id : selection.seeds) {
            const auto [shown, seed] = m_contents.find(id);
            if (seed == kNone) continue;
            const QPointF at = m_view.pixels(shown->seeds().positions[seed]);
            if (isFine) {
                paintPieces(*shown, id, seed, selection);
                m_painter.drawEllipse(at, radius, radius);
            } else {
                m_painter.fillRect(QRectF(at.x() - 2.0, at.y() - 2.0, 4.0, 4.0), m_colours.accent);
            }
        }
    }

    /// Highlights the selected cells of cut layers, which have no seed.
    void paintCells(const FragmentSelection& selection) {
        Selection::Seeds cells;
        for (const SeedId id : selection.seeds) {
            if (m_contents.find(id).second == kNone) cells.insert(id);
        }
        if (cells.empty() || !m_contents.overlays.hasCells) return;
        const DrawablePattern& pattern = *m_contents.pattern;
        m_painter.setBrush(withAlpha(m_colours.accent, kFillAlpha));
        for (std::uint32_t piece = 0; piece < pattern.partition().pieceCount(); ++piece) {
            if (pattern.partition().seedOfPiece[piece] == kNone && cells.contains(pattern.cellOf(piece)))
                m_painter.drawPath(pathOfPiece(pattern, piece, m_view));
        }
    }

private:
    static constexpr int kFillAlpha = 70;  // of 255

    /// Outlines all pieces of a seed and fills the selected ones.
    void paintPieces(const DrawablePattern& shown, SeedId id, std::uint32_t seed, const FragmentSelection& selection) {
        if (!m_contents.overlays.hasCells) return;
        const IndexRange pieces = shown.piecesOf(seed);
        for (std::size_t k = pieces.begin; k < pieces.end; ++k) {
            const auto piece = static_cast<std::uint32_t>(k);
            const bool isSelected = selection.contains(shown.baked().parent, id, shown.fragmentId(piece));
            m_painter.setBrush(isSelected ? QBrush(withAlpha(m_colours.accent, kFillAlpha)) : Qt::NoBrush);
            m_painter.drawPath(pathOfPiece(shown, piece, m_view));
        }
        m_painter.setBrush(Qt::NoBrush);
    }

    QPainter& m_painter;
    const CanvasView& m_view;
    const CanvasContents& m_contents;
    const CanvasColours& m_colours;
};

/// Paints wrapped text on a panel.
void paintTextPanel(QPainter& painter, const QString& text, const QRectF& area, Qt::Alignment alignment, QSizeF padding,
                    const CanvasColours& colours, const QColor& edge) {
    const int flags = static_cast<int>(alignment.toInt()) | Qt::TextWordWrap;
    const QRectF panel = QFontMetricsF(painter.font())
                             .boundingRect(area, flags, text)
                             .adjusted(-padding.width(), -padding.height(), padding.width(), padding.height());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(edge, 1.0));
    painter.setBrush(colours.panel);
    painter.drawRoundedRect(panel, 6.0, 6.0);
    painter.setPen(colours.text);
    painter.drawText(area, flags, text);
}

}  // namespace

void paintOutline(QPainter& painter, const Polygon& outline, const CanvasView& view, const CanvasColours& colours) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.outline, 2.0, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawPath(pathOf(outline, view));
}

void paintSelection(QPainter& painter, const Selection& selection, const CanvasView& view,
                    const CanvasContents& contents, const CanvasColours& colours) {
    if (!contents.pattern || selection.seeds().empty()) return;
    SelectionPainter highlights(painter, view, contents, colours);
    highlights.paintSeeds(selection.fragments());
    highlights.paintCells(selection.fragments());
}

void paintHovered(QPainter& painter, const DrawablePattern& pattern, std::uint32_t piece, const CanvasView& view,
                  const CanvasColours& colours) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(withAlpha(colours.hover, 24));
    for (const std::uint32_t neighbour : pattern.neighbours(piece)) {
        painter.drawPath(pathOfPiece(pattern, neighbour, view));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.hover, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(pathOfPiece(pattern, piece, view));
}

void paintFragmentLabel(QPainter& painter, const CanvasContents& contents, std::uint32_t piece, QPointF pointer,
                        std::span<const QRectF> panels, const CanvasView& view, const CanvasColours& colours) {
    const DrawablePattern& pattern = *contents.pattern;
    const int neighbours = static_cast<int>(pattern.neighbours(piece).size());
    const QStringList lines = {
        HighlightPaintingTexts::tr("Fragment %1").arg(nameText(pattern.fragmentId(piece))),
        localizedQuantity(QuantityKind::Area, contents.area(piece), contents.units),
        HighlightPaintingTexts::tr("%Ln neighbour(s)", nullptr, neighbours),
        HighlightPaintingTexts::tr("Aspect ratio %1").arg(QLocale().toString(pattern.aspect(piece), 'f', 1)),
    };
    const QPointF around(kPointerMargin, kPointerMargin);
    std::vector<LabelObstacle> obstacles{{QRectF(pointer - around, pointer + around), kPanelWeight},
                                         {pathOfPiece(pattern, piece, view).boundingRect(), kPieceWeight}};
    for (const QRectF& panel : panels) obstacles.push_back({panel, kPanelWeight});
    const Box2 outline = boundsOf(contents.asset()->prism.outline.outer);
    obstacles.push_back({QRectF(view.pixels(outline.min), view.pixels(outline.max)).normalized(), 1.0});
    paintCornerLabel(painter, lines, obstacles, colours, colours.panelEdge, view);
}

void paintTriangleAt(QPainter& painter, Vec2 point, const CanvasView& view, const CanvasContents& contents,
                     const CanvasColours& colours) {
    const std::uint32_t triangle = contents.pattern->triangleAt(point);
    if (triangle == kNone) return;
    const Delaunay& delaunay = contents.pattern->baked().triangulation;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.circle, 1.5));
    const bool hasGrain = AnisotropyMap::of(contents.asset()->pattern, contents.asset()->prism.outline).has_value();
    if (const std::optional<Circle> circle = circumcircle(delaunay, triangle); circle && !hasGrain) {
        const double radius = circle->radius * view.scale;
        if (radius < kLargestCircle) painter.drawEllipse(view.pixels(circle->centre), radius, radius);
    }
    painter.setBrush(withAlpha(colours.circle, 40));
    QPolygonF corners;
    for (const std::uint32_t corner : delaunay.triangles[triangle].corner) {
        corners.push_back(view.pixels(contents.pattern->site(corner)));
    }
    painter.drawPolygon(corners);
}

void paintMessage(QPainter& painter, const QString& message, const CanvasView& view, const CanvasColours& colours,
                  const QColor& edge) {
    const double margin = kRulerWidth + kMessageMargin;
    paintTextPanel(painter, message, QRectF({}, view.size).adjusted(margin, margin, -kMessageMargin, -kMessageMargin),
                   Qt::AlignCenter, {16.0, 12.0}, colours, edge);
}

void paintPrompt(QPainter& painter, const QString& text, double top, QPointF pointer, const CanvasView& view,
                 const CanvasColours& colours) {
    const QRectF area = QRectF({}, view.size)
                            .adjusted(kRulerWidth + kPromptMargin, top + kPromptMargin, -kPromptMargin, -kPromptMargin);
    const bool isInTheWay = pointer.y() < top + kPromptHeight;
    paintTextPanel(painter, text, area, Qt::AlignHCenter | (isInTheWay ? Qt::AlignBottom : Qt::AlignTop), {10.0, 5.0},
                   colours, colours.accent);
}

}  // namespace rubble
