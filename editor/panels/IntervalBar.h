#pragma once

#include "core/play/Intent.h"

#include <QWidget>

namespace rubble {

/// The thresholds that satisfy all intents of an asset, drawn along a logarithmic scale with what bounds them, and the threshold that
/// it has.
class IntervalBar : public QWidget {
    Q_OBJECT
public:
    explicit IntervalBar(QWidget* parent = nullptr);

    void setInterval(const std::vector<Intent>& intents, const ThresholdInterval& interval, double threshold);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {140, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double placeOf(double impulse) const;

    std::vector<Intent> m_intents;
    ThresholdInterval m_interval;
    double m_threshold = 1.0;  // N s
    double m_from = 1.0;       // N s, the ends of the scale
    double m_to = 10.0;
};

}  // namespace rubble
