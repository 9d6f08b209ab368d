#pragma once

#include "core/geometry/search/Box3.h"
#include "editor/document/sections/Sections.h"
#include "editor/widgets/numbers/Units.h"

#include <QWidget>

class QButtonGroup;
class QLabel;
class QSlider;

namespace rubble {

/// Sets the plane of the section that the canvas shows of a mesh: along which axis it is seen, and where it cuts.
class SectionBar : public QWidget {
    Q_OBJECT
public:
    SectionBar(Sections& sections, QWidget* parent);

    /// Shows the section of a mesh; hidden for null.
    void setAsset(const Asset* mesh);
    void setUnits(const Units& units);
    /// Places the bar below a height of its parent, in pixels, as wide as there is room.
    void placeBelow(double height);
    /// Moves the section by steps of the slider.
    void moveBy(int steps);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void refresh();

    Sections& m_sections;
    Id m_asset = 0;
    Box3 m_bounds;
    Units m_units;
    QButtonGroup* m_axes;
    QSlider* m_slider;
    QLabel* m_position;
};

}  // namespace rubble
