#pragma once

#include "core/fracture/kinds/DensityImage.h"
#include "editor/canvas/tools/CanvasTool.h"
#include "editor/commands/BrushSize.h"
#include "editor/commands/ImageBrush.h"

#include <QImage>

#include <memory>
#include <optional>

namespace rubble {

/// Paints the density of seeds: into the image of the last enabled density layer, or of a new one. The layer's count
/// follows what is painted, so that seeds per area stay where nothing is painted. Everything painted while the button
/// is held is one undo step.
class BrushTool : public CanvasTool {
    Q_OBJECT
public:
    using CanvasTool::CanvasTool;

    void press(const CanvasPointer& pointer) override;
    void move(const CanvasPointer& pointer) override;
    void release(const CanvasPointer& pointer) override;
    bool key(const QKeyEvent& event) override;
    bool controlWheel(double notches) override;
    bool overridesShortcut(int key) const override;
    bool cancel() override;
    void endDrag() override;
    void leave() override;
    void paint(QPainter& painter, const CanvasColours& colours) const override;
    Qt::CursorShape cursor() const override { return Qt::BlankCursor; }
    QString hint() const override;
    void fillMenu(QMenu& menu, const CanvasPointer& pointer) override;

    double radiusPixels() const { return m_size.radiusPixels(); }
    void setRadiusPixels(double radius);
    double strength() const { return m_strength; }
    void setStrength(double strength);

private:
    struct Painting {
        Asset before;
        Id layer = 0;
        std::shared_ptr<const GreyImage> picture;  // current state
        Vec2 last{0.0, 0.0};
        double seedsPerArea = 0.0;  // 1/m², at the highest density
        quint64 mergeKey = 0;
        Id newId = 0;  // of a layer that the tool added; 0: none
    };
    /// The density over the cells, as painted last.
    struct Overlay {
        std::shared_ptr<const GreyImage> image;  // null: nothing was painted yet
        DenseWhere dense = DenseWhere::Dark;
        QColor colour;
        QImage picture;
    };
    /// The layer that is painted; null if there is none yet.
    const PatternLayer* layer() const;
    /// The outline whose bounding box the image covers.
    const Polygon& imageOutline() const;
    double seedsPerArea(const PatternLayer* target) const;
    void stepSize(double steps);
    void paintTo(const CanvasPointer& pointer);
    void push(std::shared_ptr<const GreyImage> picture);
    void paintPicture(QPainter& painter, const CanvasColours& colours) const;

    BrushSize m_size;
    double m_strength = 0.4;
    bool m_isErasing = false;
    std::optional<Painting> m_painting;
    std::optional<CanvasPointer> m_pointer;
    mutable Overlay m_overlay;  // a cache
};

}  // namespace rubble
