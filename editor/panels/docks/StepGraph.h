#pragma once

#include "editor/play/PlayFrame.h"

#include <QWidget>

namespace rubble {

/// A stacked graph of the computing time of the last simulation steps by stage, with a legend and the current times.
class StepGraph : public QWidget {
    Q_OBJECT
public:
    explicit StepGraph(QWidget* parent = nullptr);

    /// `capacity`: the number of steps that the graph's width holds.
    void setCosts(const std::vector<StepCost>& costs, std::size_t capacity);

    QSize sizeHint() const override { return {280, 150}; }
    QSize minimumSizeHint() const override { return {160, 110}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintLegend(class QPainter& painter, const QRect& place) const;
    void paintStages(QPainter& painter, const QRectF& place, double highest) const;
    double highest() const;

    std::vector<StepCost> m_costs;
    std::size_t m_capacity = 1;
};

}  // namespace rubble
