#include "editor/panels/StepGraph.h"

#include <QLocale>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <array>
#include <cmath>

namespace rubble {

namespace {

struct Stage {
    const char* name;
    double StepCost::*cost;
    QColor colour;
};

/// Of colours that eyes of all kinds tell apart (Okabe, Ito 2008).
const std::array<Stage, 5> kStages{
    {{QT_TRANSLATE_NOOP("rubble::StepGraph", "pairs"), &StepCost::pairs, {86, 180, 233}},
     {QT_TRANSLATE_NOOP("rubble::StepGraph", "contacts"), &StepCost::collide, {0, 114, 178}},
     {QT_TRANSLATE_NOOP("rubble::StepGraph", "swaps"), &StepCost::swaps, {213, 94, 0}},
     {QT_TRANSLATE_NOOP("rubble::StepGraph", "solving"), &StepCost::solve, {0, 158, 115}},
     {QT_TRANSLATE_NOOP("rubble::StepGraph", "finish"), &StepCost::finish, {204, 121, 167}}}};

constexpr double kLeastHeight = 0.2;  // ms that the graph is high at least
constexpr int kMargin = 6;

QString milliseconds(double value) { return StepGraph::tr("%1 ms").arg(QLocale().toString(value, 'f', 2)); }

/// 1, 2 or 5 times a power of ten, at least a value.
double roundedUp(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= value) return factor * power;
    }
    return 10.0 * power;
}

}  // namespace

StepGraph::StepGraph(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Time a step"));
    setToolTip(tr("How long the last steps took to compute, by stage"));
}

void StepGraph::setCosts(const std::vector<StepCost>& costs, std::size_t most) {
    m_costs = costs;
    m_most = most;
    if (!costs.empty()) setAccessibleDescription(milliseconds(costs.back().total()));
    update();
}

double StepGraph::highest() const {
    double most = kLeastHeight;
    for (const StepCost& cost : m_costs) most = std::max(most, cost.total());
    return roundedUp(most);
}

void StepGraph::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int line = fontMetrics().height();
    const QRect inside = rect().adjusted(kMargin, kMargin, -kMargin, -kMargin);
    const QRect graph = inside.adjusted(0, 0, 0, -2 * line - 4);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRect(QRectF(graph).adjusted(0.5, 0.5, -0.5, -0.5));
    const double top = highest();
    paintStages(painter, QRectF(graph).adjusted(1, 1, -1, -1), top);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(graph.adjusted(4, 1, -4, 0), Qt::AlignTop | Qt::AlignLeft, milliseconds(top));
    paintLegend(painter, QRect(inside.left(), graph.bottom() + 4, inside.width(), 2 * line));
}

/// The newest step at the right.
void StepGraph::paintStages(QPainter& painter, const QRectF& place, double highest) const {
    if (m_costs.size() < 2) return;
    const double width = place.width() / static_cast<double>(m_most - 1);
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

void StepGraph::paintLegend(QPainter& painter, const QRect& place) const {
    const int line = fontMetrics().height(), square = line / 2;
    const int columns = 3, width = place.width() / columns;
    for (std::size_t k = 0; k < kStages.size(); ++k) {
        const int row = static_cast<int>(k) / columns, column = static_cast<int>(k) % columns;
        const QPoint at(place.left() + column * width, place.top() + row * line);
        painter.fillRect(QRect(at.x(), at.y() + (line - square) / 2, square, square), kStages[k].colour);
        QString text = tr(kStages[k].name);
        if (!m_costs.empty()) text += ' ' + QLocale().toString(m_costs.back().*kStages[k].cost, 'f', 2);
        painter.setPen(palette().color(QPalette::WindowText));
        const QRect room(at.x() + square + 4, at.y(), width - square - 6, line);
        painter.drawText(room, Qt::AlignVCenter, fontMetrics().elidedText(text, Qt::ElideRight, room.width()));
    }
}

}  // namespace rubble
