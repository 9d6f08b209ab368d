#pragma once

#include "editor/play/PlayFrame.h"

#include <QWidget>

namespace rubble {

/// How long the last steps took, stage upon stage, with what each colour means and how long it takes now.
class StepGraph : public QWidget {
    Q_OBJECT
public:
    explicit StepGraph(QWidget* parent = nullptr);

    /// `most`: how many steps the graph is wide.
    void setCosts(const std::vector<StepCost>& costs, std::size_t most);

    QSize sizeHint() const override { return {280, 150}; }
    QSize minimumSizeHint() const override { return {160, 110}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintLegend(class QPainter& painter, const QRect& place) const;
    void paintStages(QPainter& painter, const QRectF& place, double highest) const;
    double highest() const;

    std::vector<StepCost> m_costs;
    std::size_t m_most = 1;
};

}  // namespace rubble
