#include "editor/canvas/MarkPainting.h"

#include "editor/canvas/GridPainting.h"
#include "editor/canvas/LabelPainting.h"
#include "editor/canvas/VoronoiLines.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainterPath>

#include <algorithm>

namespace rubble {

namespace {

constexpr double kLargestCircle = 1e5;    // pixels; larger ones look like lines and take long
constexpr std::size_t kMostRings = 600;   // more chosen seeds are marked by squares, which are painted faster
constexpr double kAroundSentence = 40.0;  // pixels

QString tr(const char* text) { return QCoreApplication::translate("MarkPainting", text); }

QColor washOf(QColor colour, int alpha) {
    colour.setAlpha(alpha);
    return colour;
}

class ChoicePainter {
public:
    ChoicePainter(QPainter& painter, const CanvasView& view, const CanvasContents& contents,
                  const CanvasColours& colours)
        : m_painter(painter), m_view(view), m_contents(contents), m_colours(colours) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colours.accent, 2.0));
    }

    void paintSeeds(const FragmentChoice& choice) {
        const double radius = std::max(seedRadius(*m_contents.pattern, m_view), 2.0) + 2.5;
        const bool isFine = choice.seeds.size() <= kMostRings;
        for (const SeedId id : choice.seeds) {
            const auto [shown, seed] = m_contents.find(id);
            if (seed == kNone) continue;
            const QPointF at = m_view.pixels(shown->seeds().positions[seed]);
            if (isFine) {
                paintPieces(*shown, id, seed, choice);
                m_painter.drawEllipse(at, radius, radius);
            } else {
                m_painter.fillRect(QRectF(at.x() - 2.0, at.y() - 2.0, 4.0, 4.0), m_colours.accent);
            }
        }
    }

    /// Cells of cut layers are chosen as seeds are, but no seed stands in them.
    void paintCells(const FragmentChoice& choice) {
        Selection::Seeds cells;
        for (const SeedId id : choice.seeds) {
            if (m_contents.find(id).second == kNone) cells.insert(id);
        }
        if (cells.empty() || !m_contents.layers.hasCells) return;
        const ShownPattern& pattern = *m_contents.pattern;
        m_painter.setBrush(washOf(m_colours.accent, kWash));
        for (std::uint32_t piece = 0; piece < pattern.partition().pieceCount(); ++piece) {
            if (pattern.partition().seedOfPiece[piece] == kNone && cells.contains(pattern.cellOf(piece)))
                m_painter.drawPath(pathOfPiece(pattern, piece, m_view));
        }
    }

private:
    static constexpr int kWash = 70;  // of 255

    /// All pieces of a seed; filled are those that are chosen, where only some of them are.
    void paintPieces(const ShownPattern& shown, SeedId id, std::uint32_t seed, const FragmentChoice& choice) {
        if (!m_contents.layers.hasCells) return;
        const IndexRange pieces = shown.piecesOf(seed);
        for (std::size_t k = pieces.begin; k < pieces.end; ++k) {
            const auto piece = static_cast<std::uint32_t>(k);
            const bool isChosen = choice.holds(shown.baked().inside, id, shown.fragmentId(piece));
            m_painter.setBrush(isChosen ? QBrush(washOf(m_colours.accent, kWash)) : Qt::NoBrush);
            m_painter.drawPath(pathOfPiece(shown, piece, m_view));
        }
        m_painter.setBrush(Qt::NoBrush);
    }

    QPainter& m_painter;
    const CanvasView& m_view;
    const CanvasContents& m_contents;
    const CanvasColours& m_colours;
};

}  // namespace

void paintOutline(QPainter& painter, const Polygon& outline, const CanvasView& view, const CanvasColours& colours) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.outline, 2.0, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawPath(pathOf(outline, view));
}

void paintChosen(QPainter& painter, const Selection& selection, const CanvasView& view, const CanvasContents& contents,
                 const CanvasColours& colours) {
    if (!contents.pattern || selection.seeds().empty()) return;
    ChoicePainter choice(painter, view, contents, colours);
    choice.paintSeeds(selection.choice());
    choice.paintCells(selection.choice());
}

void paintHovered(QPainter& painter, const ShownPattern& pattern, std::uint32_t piece, const CanvasView& view,
                  const CanvasColours& colours) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(washOf(colours.hover, 24));
    for (const std::uint32_t neighbour : pattern.neighbours(piece)) {
        painter.drawPath(pathOfPiece(pattern, neighbour, view));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.hover, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(pathOfPiece(pattern, piece, view));
}

void paintPieceLabel(QPainter& painter, const ShownPattern& pattern, std::uint32_t piece, QPointF beside,
                     const CanvasView& view, const CanvasColours& colours) {
    const std::size_t neighbours = pattern.neighbours(piece).size();
    const QStringList lines = {
        tr("Piece %1").arg(QString::fromStdString(pattern.fragmentId(piece))),
        areaText(pattern.area(piece)),
        neighbours == 1 ? tr("1 neighbour") : tr("%1 neighbours").arg(neighbours),
        tr("%1 times as long as wide").arg(QLocale().toString(pattern.aspect(piece), 'f', 1)),
    };
    paintLabel(painter, beside, lines, colours, colours.panelEdge, view);
}

void paintTriangleAt(QPainter& painter, Vec2 place, const CanvasView& view, const CanvasContents& contents,
                     const CanvasColours& colours) {
    const std::uint32_t triangle = contents.pattern->triangleAt(place);
    if (triangle == kNone) return;
    const Delaunay& delaunay = contents.pattern->baked().triangulation;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.circle, 1.5));
    const bool hasGrain = GrainMap::of(contents.asset()->pattern, contents.asset()->prism.outline).has_value();
    if (const std::optional<Circle> circle = circumcircle(delaunay, triangle); circle && !hasGrain) {
        const double radius = circle->radius * view.scale;
        if (radius < kLargestCircle) painter.drawEllipse(view.pixels(circle->centre), radius, radius);
    }
    painter.setBrush(washOf(colours.circle, 40));
    QPolygonF corners;
    for (const std::uint32_t corner : delaunay.triangles[triangle].corner) {
        corners.push_back(view.pixels(contents.pattern->site(corner)));
    }
    painter.drawPolygon(corners);
}

void paintSentence(QPainter& painter, const QString& sentence, const CanvasView& view, const CanvasColours& colours,
                   const QColor& edge) {
    const double before = kRulerWidth + kAroundSentence;
    const QRectF place = QRectF(QPointF(), view.size).adjusted(before, before, -kAroundSentence, -kAroundSentence);
    QRectF panel = QFontMetricsF(painter.font()).boundingRect(place, Qt::AlignCenter | Qt::TextWordWrap, sentence);
    panel.adjust(-16.0, -12.0, 16.0, 12.0);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(edge, 1.0));
    painter.setBrush(colours.panel);
    painter.drawRoundedRect(panel, 6.0, 6.0);
    painter.setPen(colours.text);
    painter.drawText(place, Qt::AlignCenter | Qt::TextWordWrap, sentence);
}

}  // namespace rubble
