#pragma once

#include "core/fracture/DensityImage.h"
#include "editor/canvas/CanvasTool.h"
#include "editor/commands/PicturePainting.h"

#include <optional>

namespace rubble {

/// Paints where pieces are small: the density image of the asset's last layer of that kind that is on, or of a new one. All that is
/// painted while the button is held is one step.
class BrushTool : public CanvasTool {
    Q_OBJECT
public:
    using CanvasTool::CanvasTool;

    void press(const CanvasPointer& pointer) override;
    void move(const CanvasPointer& pointer) override;
    void release(const CanvasPointer& pointer) override;
    void doubleClick(const CanvasPointer& pointer) override { press(pointer); }
    bool key(const QKeyEvent& event) override;
    bool ownsKey(int key) const override;
    bool cancel() override;
    void letGo() override;
    void paint(QPainter& painter, const CanvasColours& colours) const override;
    Qt::CursorShape cursor() const override { return Qt::BlankCursor; }
    QString hint() const override;
    void fillMenu(QMenu& menu, const CanvasPointer& pointer) override;

    double radiusPixels() const { return m_radiusPixels; }
    void setRadiusPixels(double radius);
    double strength() const { return m_strength; }
    void setStrength(double strength);

private:
    struct Painting {
        Asset before;
        Id layer = 0;
        std::shared_ptr<const GreyImage> picture;  // as it is now
        Vec2 last{0.0, 0.0};
        quint64 stroke = 0;
        Id newId = 0;  // of the layer, where there was none
    };
    const PatternLayer* layer() const;
    void dabTo(const CanvasPointer& pointer);
    void push(std::shared_ptr<const GreyImage> picture);
    void paintPicture(QPainter& painter, const CanvasColours& colours) const;

    double m_radiusPixels = 30.0;
    double m_strength = 0.4;
    bool m_isErasing = false;
    std::optional<Painting> m_painting;
    std::optional<CanvasPointer> m_pointer;
};

}  // namespace rubble
