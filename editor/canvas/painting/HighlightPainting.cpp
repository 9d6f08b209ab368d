#include "editor/canvas/painting/HighlightPainting.h"

#include "core/fracture/pattern/AnisotropyMap.h"
#include "editor/canvas/painting/LabelPainting.h"
#include "editor/canvas/painting/RulerPainting.h"
#include "editor/canvas/painting/VoronoiEdges.h"
#include "editor/document/CellSelection.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainterPath>

#include <algorithm>

namespace rubble {

namespace {

constexpr double kLargestCircle = 1e5;    // pixels; larger circles look like lines and are slow to draw
constexpr double kMinRingSpacing = 12.0;  // pixels between seeds; closer ones would be covered by their rings
constexpr double kMessageMargin = 40.0;   // pixels
constexpr double kPointerMargin = 40.0;   // pixels, that a label keeps from the pointer
constexpr double kPanelWeight = 1e4;      // of what a label must not cover, against what it should not
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

/// Paints what is selected in one pattern: the baked one, or the cells that were changed since.
class SelectionPainter {
public:
    SelectionPainter(QPainter& painter, const CanvasView& view, const CanvasContents& contents,
                     const CanvasColours& colours, const DrawablePattern& pattern)
        : m_painter(painter),
          m_view(view),
          m_contents(contents),
          m_colours(colours),
          m_pattern(pattern),
          m_isMoved(contents.moved && &pattern == contents.moved->pattern.get()) {}

    /// Fills the selected fragments, and outlines areas of them: no lines are drawn between two that are selected.
    void paintFragments(const FragmentSelection& selection) {
        const std::vector<bool> isSelected = selectedPieces(m_pattern.baked(), selection);
        QList<QLineF> border;
        m_painter.setRenderHint(QPainter::Antialiasing, false);  // the fills of neighbours would overlap
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(withAlpha(m_colours.accent, kFillAlpha));
        for (std::uint32_t piece = 0; piece < isSelected.size(); ++piece) {
            if (!isSelected[piece] || !isOwn(piece)) continue;
            m_painter.drawPath(pathOfPiece(m_pattern, piece, m_view));
            addBorder(piece, isSelected, border);
        }
        m_painter.setRenderHint(QPainter::Antialiasing);
        m_painter.setPen(QPen(m_colours.accent, kBorderWidth, Qt::SolidLine, Qt::RoundCap));
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawLines(border);
    }

private:
    static constexpr int kFillAlpha = 70;  // of 255
    static constexpr double kBorderWidth = 2.0;

    /// Whether the piece is drawn from this pattern.
    bool isOwn(std::uint32_t piece) const {
        const std::uint32_t seed = m_pattern.partition().seedOfPiece[piece];
        if (!m_contents.moved || seed == kNone) return !m_isMoved;
        return m_isMoved ? m_contents.moved->isShown[seed] : !m_contents.moved->replaces(seed);
    }

    void addBorder(std::uint32_t piece, const std::vector<bool>& isSelected, QList<QLineF>& border) const {
        const Partition& partition = m_pattern.partition();
        forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
            if (neighbour != kNone && isSelected[neighbour]) return;
            border.push_back({m_view.pixels(partition.origin + partition.points[from]),
                              m_view.pixels(partition.origin + partition.points[to])});
        });
    }

    QPainter& m_painter;
    const CanvasView& m_view;
    const CanvasContents& m_contents;
    const CanvasColours& m_colours;
    const DrawablePattern& m_pattern;
    const bool m_isMoved;
};

/// Rings around the selected seeds, if they can be told apart.
void paintSelectedSeeds(QPainter& painter, const Selection::Seeds& seeds, const CanvasView& view,
                        const CanvasContents& contents, const CanvasColours& colours) {
    if (seedSpacing(*contents.pattern, view) < kMinRingSpacing) return;
    const double radius = std::max(seedRadius(*contents.pattern, view), 2.0) + 2.5;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.accent, 2.0));
    for (const SeedId id : seeds) {
        const auto [shown, seed] = contents.find(id);
        if (seed != kNone) painter.drawEllipse(view.pixels(shown->seeds().positions[seed]), radius, radius);
    }
}

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
    if (contents.overlays.hasCells) {
        for (const DrawablePattern* pattern :
             {contents.pattern.get(), contents.moved ? contents.moved->pattern.get() : nullptr}) {
            if (!pattern) continue;
            SelectionPainter(painter, view, contents, colours, *pattern).paintFragments(selection.fragments());
        }
    }
    paintSelectedSeeds(painter, selection.seeds(), view, contents, colours);
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
    const Box2 outline = boundsOf(contents.asset()->prism().outline.outer);
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
    const bool hasGrain = AnisotropyMap::of(contents.asset()->pattern, contents.asset()->prism().outline).has_value();
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
