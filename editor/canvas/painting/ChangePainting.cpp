#include "editor/canvas/painting/ChangePainting.h"

#include "core/structure/bonds/FragmentSilhouette.h"
#include "editor/canvas/painting/CanvasPainting.h"

#include <QCoreApplication>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace rubble {

namespace {

constexpr double kOutlineWidth = 2.0;  // of outlines, pixels
constexpr double kArrowHead = 5.0;     // pixels
constexpr double kMinArrow = 3.0;      // pixels; shorter moves have no arrow
constexpr int kFillAlpha = 60;         // of 255

struct CanvasChangesTexts {
    Q_DECLARE_TR_FUNCTIONS(CanvasChanges)
};

QColor colourOf(FragmentChange change, const CanvasColours& colours) {
    switch (change) {
        case FragmentChange::Gone: return colours.gone;
        case FragmentChange::Added: return colours.added;
        case FragmentChange::Moved: return colours.moved;
        case FragmentChange::Reshaped: break;
    }
    return colours.reshaped;
}

Qt::BrushStyle hatchOf(FragmentChange change) {
    return change == FragmentChange::Added ? Qt::BDiagPattern : Qt::Dense6Pattern;
}

QPen ghostPen(const QColor& colour) {
    QPen pen(colour, kOutlineWidth, Qt::CustomDashLine, Qt::FlatCap, Qt::MiterJoin);
    pen.setDashPattern({3.0, 2.0});
    return pen;
}

/// Neighbouring ghosts draw their shared edges twice: always from the same end, so that the dashes coincide.
void drawGhost(QPainter& painter, const QPainterPath& ghost, const QColor& colour) {
    painter.setPen(ghostPen(colour));
    for (const QPolygonF& ring : ghost.toSubpathPolygons()) {
        for (qsizetype k = 0; k + 1 < ring.size(); ++k) {
            const QPointF &from = ring[k], &to = ring[k + 1];
            const bool isForward = std::pair(from.x(), from.y()) < std::pair(to.x(), to.y());
            painter.drawLine(isForward ? from : to, isForward ? to : from);
        }
    }
}

QPainterPath pathOf(const Bake& bake, std::uint32_t number, const CanvasView& view) {
    const Fragment solid = bake.fragment(number).solid;
    CanvasView shifted = view;
    shifted.centre -= Vec2{solid.offset()};
    return pathOf(silhouetteOf(solid), shifted);
}

QPointF centroidOf(const Bake& bake, std::uint32_t number, const CanvasView& view) {
    return view.pixels(Vec2{bake.fragment(number).solid.offset()});
}

void paintArrow(QPainter& painter, QPointF from, QPointF to, const QColor& colour) {
    const QPointF offset = to - from;
    const double length = std::hypot(offset.x(), offset.y());
    if (length < kMinArrow) return;
    const QPointF along = offset / length * std::min(kArrowHead, length), across(-along.y(), along.x());
    painter.setPen(QPen(colour, kOutlineWidth, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(from, to);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF{to, to - along + 0.6 * across, to - along - 0.6 * across});
}

/// Paints the changed fragments one by one.
class ChangesPainter {
public:
    ChangesPainter(QPainter& painter, const CanvasView& view, const ComparedAsset& compared,
                   const CanvasColours& colours)
        : m_painter(painter), m_view(view), m_compared(compared), m_colours(colours) {
        for (const FragmentDifference& piece : compared.fragments.fragments) m_changed.insert(piece.path);
    }

    void paint() {
        for (const FragmentDifference& piece : m_compared.fragments.fragments) {
            if (piece.level > 0 && m_changed.contains(parentOf(piece.path))) continue;
            paint(piece);
        }
    }

private:
    void paint(const FragmentDifference& piece) {
        const QColor colour = colourOf(piece.change, m_colours);
        const bool isShape = piece.change == FragmentChange::Added || piece.change == FragmentChange::Reshaped;
        if (isShape) {
            const QPainterPath path = pathOf(*m_compared.after, piece.after, m_view);
            QColor fill = colour;
            fill.setAlpha(kFillAlpha);
            m_painter.fillPath(path, fill);
            m_painter.fillPath(path, QBrush(colour, hatchOf(piece.change)));
            m_painter.strokePath(path, QPen(colour, kOutlineWidth));
            return;
        }
        const QPainterPath ghost = pathOf(*m_compared.before, piece.before, m_view);
        if (piece.change == FragmentChange::Gone) {
            QColor fill = colour;
            fill.setAlpha(kFillAlpha);
            m_painter.fillPath(ghost, fill);
        }
        drawGhost(m_painter, ghost, colour);
        if (piece.change != FragmentChange::Moved) return;
        paintArrow(m_painter, centroidOf(*m_compared.before, piece.before, m_view),
                   centroidOf(*m_compared.after, piece.after, m_view), colour);
    }

    QPainter& m_painter;
    const CanvasView& m_view;
    const ComparedAsset& m_compared;
    const CanvasColours& m_colours;
    std::set<FragmentPath> m_changed;
};

}  // namespace

void paintChanges(QPainter& painter, const CanvasView& view, const ComparedAsset& compared,
                  const CanvasColours& colours) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    ChangesPainter(painter, view, compared, colours).paint();
    painter.restore();
}

void paintChangeMarker(QPainter& painter, QPointF centre, FragmentChange change, const CanvasColours& colours) {
    const QRectF box(centre.x() - 8.0, centre.y() - 4.5, 16.0, 9.0);
    const QColor colour = colourOf(change, colours);
    QColor fill = colour;
    fill.setAlpha(kFillAlpha);
    const bool isShape = change == FragmentChange::Added || change == FragmentChange::Reshaped;
    if (change != FragmentChange::Moved) painter.fillRect(box, fill);
    if (isShape) painter.fillRect(box, QBrush(colour, hatchOf(change)));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(isShape ? QPen(colour, kOutlineWidth) : ghostPen(colour));
    painter.drawRect(box);
    if (change == FragmentChange::Moved)
        paintArrow(painter, centre - QPointF(4.0, 0.0), centre + QPointF(5.0, 0.0), colour);
}

QString changeText(FragmentChange change, std::size_t count) {
    switch (change) {
        case FragmentChange::Gone: return CanvasChangesTexts::tr("removed: %L1").arg(count);
        case FragmentChange::Added: return CanvasChangesTexts::tr("added: %L1").arg(count);
        case FragmentChange::Moved: return CanvasChangesTexts::tr("moved: %L1").arg(count);
        case FragmentChange::Reshaped: break;
    }
    return CanvasChangesTexts::tr("reshaped: %L1").arg(count);
}

}  // namespace rubble
