#pragma once

#include "editor/panels/models/Histogram.h"
#include "editor/widgets/numbers/Units.h"

#include <QWidget>

#include <optional>

class QToolButton;

namespace rubble {

/// A histogram of the volumes of fragments with the selected ones highlighted. A click on a bar, a drag over several,
/// or the arrow keys (with Shift for several) select the fragments in them.
class VolumeHistogram : public QWidget {
    Q_OBJECT
public:
    explicit VolumeHistogram(QWidget* parent = nullptr);

    /// Volumes in m³; isSelected holds a flag per volume.
    void setVolumes(std::vector<double> volumes, std::vector<bool> isSelected);
    void setUnits(const Units& units);
    HistogramAxis axis() const { return m_axis; }
    void setAxis(HistogramAxis axis);
    const std::vector<HistogramBar>& bars() const { return m_bars; }
    /// The rectangle of a bar's slot, as high as the plot.
    QRectF barRect(int bar) const;

    QSize sizeHint() const override { return {230, 150}; }
    QSize minimumSizeHint() const override { return {140, 90}; }

signals:
    /// Select the fragments with a volume in [min, max], m³; isExtending: in addition to the selection.
    void rangeSelected(double min, double max, bool isExtending);

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
    void updateBars();
    QRectF plotRect() const;
    int barAt(double x) const;
    void selectRange(bool isExtending);
    QString volume(double value) const;
    void paintBars(class QPainter& painter) const;
    void paintTexts(QPainter& painter) const;

    std::vector<double> m_volumes;
    std::vector<bool> m_isSelected;
    std::vector<HistogramBar> m_bars;
    HistogramAxis m_axis = HistogramAxis::Logarithmic;
    Units m_units;
    QToolButton* m_axisButton;
    struct Range {
        int from = 0, to = 0;  // bars, in either order
    };
    std::optional<Range> m_range;  // last dragged over or reached by keys
    bool m_isDragging = false;
};

}  // namespace rubble
