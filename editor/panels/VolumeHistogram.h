#pragma once

#include "editor/panels/Histogram.h"
#include "editor/panels/Units.h"

#include <QWidget>

#include <optional>

class QToolButton;

namespace rubble {

/// How many fragments have which volume, the chosen ones marked. A click on a bar, or a drag over several, asks for the
/// fragments in it to be chosen; so do the arrow keys, with Shift for several.
class VolumeHistogram : public QWidget {
    Q_OBJECT
public:
    explicit VolumeHistogram(QWidget* parent = nullptr);

    /// m^3, and one mark each.
    void setVolumes(std::vector<double> volumes, std::vector<bool> isChosen);
    void setUnits(const Units& units);
    HistogramAxis axis() const { return m_axis; }
    void setAxis(HistogramAxis axis);
    const std::vector<HistogramBar>& bars() const { return m_bars; }
    /// Where a bar stands, its whole height.
    QRectF placeOf(int bar) const;

    QSize sizeHint() const override { return {230, 150}; }
    QSize minimumSizeHint() const override { return {140, 90}; }

signals:
    /// Those with a volume in [least, most] are to be chosen, m^3; `isMore`: besides what is chosen already.
    void ranged(double least, double most, bool isMore);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void placeAxisButton();
    void sortIntoBars();
    QRectF area() const;
    int barAt(double x) const;
    void choose(bool isMore);
    QString volume(double value) const;
    void paintBars(class QPainter& painter) const;
    void paintTexts(QPainter& painter) const;

    std::vector<double> m_volumes;
    std::vector<bool> m_isChosen;
    std::vector<HistogramBar> m_bars;
    HistogramAxis m_axis = HistogramAxis::Logarithmic;
    Units m_units;
    QToolButton* m_axisButton;
    struct Range {
        int from = 0, to = 0;  // bars, in the order they were touched
    };
    std::optional<Range> m_range;  // that was dragged or walked over last
    bool m_isDragging = false;
};

}  // namespace rubble
