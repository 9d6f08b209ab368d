#pragma once

#include "editor/widgets/numbers/Units.h"
#include "viewport/scene/SceneBuilder.h"
#include "viewport/widget/ViewportOverlay.h"

#include <QStringList>

#include <optional>

namespace rubble {

/// The legend of fragment colours and bond lines in a corner of the 3D view.
class SceneLegend : public OverlayItem {
    Q_OBJECT
public:
    using OverlayItem::OverlayItem;

    struct Content {
        SceneColouring colouring = SceneColouring::Material;
        std::optional<ValueRange> range;  // none: colours show no quantity
        double largestBondArea = 0.0;     // m²; 0: there are no lines
        bool operator==(const Content&) const = default;
    };
    void setContent(const Content& content);
    /// The units of volumes and areas.
    void setUnits(const Units& units);
    /// Its texts: the title, the values at both ends, and the area of the widest bond line.
    QStringList texts() const;

    void paint(QPainter& painter, QSize size) const override;
    std::vector<QRect> plates(QSize size, const QFont& font) const override;
    QString accessibleText() const override { return texts().join(", "); }

private:
    QStringList scaleTexts() const;
    QSize plateSize(const QFontMetrics& lines) const;

    Content m_content;
    Units m_units;
};

}  // namespace rubble
