#include "editor/panels/docks/StepGraph.h"

#include "editor/widgets/AccessibleRole.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "editor/widgets/numbers/RoundStep.h"

#include <QLocale>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <array>

namespace rubble {

namespace {

struct Stage {
    const char* name;
    double StepCost::*cost;
    QColor colour;
};

/// Colours that colour-blind readers can tell apart. Source: Okabe, Ito, Color Universal Design (2008).
constexpr std::size_t kStageCount = 5;
const std::array<Stage, kStageCount> kStages{
    {{QT_TRANSLATE_NOOP("rubble::StepGraph", "Broad phase"), &StepCost::pairs, {86, 180, 233}},
     {QT_TRANSLATE_NOOP("rubble::StepGraph", "Narrow phase"), &StepCost::collide, {0, 114, 178}},
     {QT_TRANSLATE_NOOP("rubble::StepGraph", "Swaps"), &StepCost::swaps, {213, 94, 0}},
     {QT_TRANSLATE_NOOP("rubble::StepGraph", "Solver"), &StepCost::solve, {0, 158, 115}},
     {QT_TRANSLATE_NOOP("rubble::StepGraph", "Integration"), &StepCost::finish, {204, 121, 167}}}};

constexpr double kMinHeight = 0.2;  // ms
constexpr int kGraphMargin = 6;
constexpr int kLegendColumns = 2;

QString costText(double milliseconds) { return fixedQuantity(1e-3 * milliseconds, 5, Units::milliseconds()); }

}  // namespace

StepGraph::StepGraph(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Time per step"));
    setAccessibleRole(*this, QAccessible::Chart);
    setToolTip(
        tr("Computing time of the last steps in milliseconds, by stage; the numbers are those of the last step"));
}

void StepGraph::setCosts(const std::vector<StepCost>& costs, std::size_t capacity) {
    m_costs = costs;
    m_capacity = capacity;
    if (!costs.empty()) setAccessibleDescription(costText(costs.back().total()));
    update();
}

double StepGraph::highest() const {
    double highest = kMinHeight;
    for (const StepCost& cost : m_costs) highest = std::max(highest, cost.total());
    return roundStep(highest);
}

void StepGraph::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int line = fontMetrics().height();
    constexpr int kLegendRows = (static_cast<int>(kStageCount) + kLegendColumns - 1) / kLegendColumns;
    const QRect inside = rect().adjusted(kGraphMargin, kGraphMargin, -kGraphMargin, -kGraphMargin);
    const QRect graph = inside.adjusted(0, line + 2, 0, -kLegendRows * line - 4);
    painter.setPen(palette().color(QPalette::WindowText));
    const QString title = tr("Time per step (%1)").arg(Units::milliseconds().unit);
    painter.drawText(QRect(inside.left(), inside.top(), inside.width(), line), Qt::AlignVCenter | Qt::AlignLeft,
                     fontMetrics().elidedText(title, Qt::ElideRight, inside.width()));
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRect(QRectF(graph).adjusted(0.5, 0.5, -0.5, -0.5));
    const double top = highest();
    paintStages(painter, QRectF(graph).adjusted(1, 1, -1, -1), top);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(graph.adjusted(4, 1, -4, 0), Qt::AlignTop | Qt::AlignLeft, costText(top));
    paintLegend(painter, QRect(inside.left(), graph.bottom() + 4, inside.width(), kLegendRows * line));
}

/// The newest step is at the right.
void StepGraph::paintStages(QPainter& painter, const QRectF& place, double highest) const {
    if (m_costs.size() < 2) return;
    const double width = place.width() / static_cast<double>(m_capacity - 1);
    const auto across = [&](std::size_t k) {
        return place.right() - width * static_cast<double>(m_costs.size() - 1 - k);
    };
    std::vector<double> below(m_costs.size(), 0.0);
    painter.setPen(Qt::NoPen);
    for (const Stage& stage : kStages) {
        QPolygonF area;
        for (std::size_t k = 0; k < m_costs.size(); ++k) {
            area << QPointF(across(k), place.bottom() - place.height() * below[k] / highest);
        }
        for (std::size_t k = m_costs.size(); k-- > 0;) {
            below[k] += m_costs[k].*stage.cost;
            area << QPointF(across(k), place.bottom() - place.height() * below[k] / highest);
        }
        painter.setBrush(stage.colour);
        painter.drawPolygon(area);
    }
}

/// Long names are elided, times never: they are in the unit of the title.
void StepGraph::paintLegend(QPainter& painter, const QRect& place) const {
    const int line = fontMetrics().height(), square = line / 2, width = place.width() / kLegendColumns;
    painter.setPen(palette().color(QPalette::WindowText));
    for (std::size_t k = 0; k < kStages.size(); ++k) {
        const int row = static_cast<int>(k) / kLegendColumns, column = static_cast<int>(k) % kLegendColumns;
        const QPoint at(place.left() + column * width, place.top() + row * line);
        painter.fillRect(QRect(at.x(), at.y() + (line - square) / 2, square, square), kStages[k].colour);
        const QRect text(at.x() + square + 4, at.y(), width - square - 4 - kGraphMargin, line);
        const QString time = m_costs.empty() ? QString() : QLocale().toString(m_costs.back().*kStages[k].cost, 'f', 2);
        const int nameWidth = text.width() - fontMetrics().horizontalAdvance(time + ' ');
        painter.drawText(text, Qt::AlignVCenter | Qt::AlignLeft,
                         fontMetrics().elidedText(tr(kStages[k].name), Qt::ElideRight, nameWidth));
        painter.drawText(text, Qt::AlignVCenter | Qt::AlignRight, time);
    }
}

}  // namespace rubble

#include "moc_StepGraph.cpp"
