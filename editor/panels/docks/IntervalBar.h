#pragma once

#include "core/play/analysis/ThresholdInterval.h"

#include <QWidget>

namespace rubble {

/// Draws the interval of thresholds that meet all strength requirements on a logarithmic scale, the impulses of the
/// requirements, and the asset's threshold.
class IntervalBar : public QWidget {
    Q_OBJECT
public:
    explicit IntervalBar(QWidget* parent = nullptr);

    void setInterval(const std::vector<StrengthRequirement>& requirements, const ThresholdInterval& interval,
                     double threshold);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {140, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double positionOf(double impulse) const;

    std::vector<StrengthRequirement> m_requirements;
    ThresholdInterval m_interval;
    double m_threshold = 1.0;  // N·s
    double m_from = 1.0;       // N·s, the ends of the scale
    double m_to = 10.0;
};

}  // namespace rubble
