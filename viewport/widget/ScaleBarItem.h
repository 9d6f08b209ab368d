#pragma once

#include "viewport/render/ScaleBar.h"
#include "viewport/widget/ViewportOverlay.h"

namespace rubble {

/// The scale bar in the lower right corner of an outdoor scene with a grid, labelled in the font of the interface.
class ScaleBarItem : public OverlayItem {
    Q_OBJECT
public:
    explicit ScaleBarItem(ViewportWidget& viewport);

    /// The width at the right edge that it never exceeds, points.
    static int maxWidth();

    void setUnit(ScaleUnit unit);

    QString accessibleText() const override;
    void paint(QPainter& painter, QSize size) const override;
    std::vector<QRect> plates(QSize size, const QFont& font) const override;

private:
    bool isShown() const;
    ScaleBarLength length() const;

    ViewportWidget& m_viewport;
    ScaleUnit m_unit;
};

}  // namespace rubble
