#pragma once

#include "core/geometry/polygon/OutlineCombination.h"
#include "editor/canvas/tools/CanvasTool.h"
#include "editor/canvas/tools/OutlineDraft.h"

#include <optional>

namespace rubble {

/// Draws a shape that becomes an outline, or is added to or cut from the active asset's outline. Each is one undo step.
/// All functions but begin(), isActive() and cancel() require that it is active; this is asserted.
class ShapeDrawing : public CanvasTool {
    Q_OBJECT
public:
    /// What the shape is drawn for.
    enum class Purpose {
        Replace,  // it replaces the asset's outline and its holes
        NewAsset,
        Add,  // to the outline
        Cut,  // from the outline
    };

    using CanvasTool::CanvasTool;

    /// Starts drawing. A polygon is closed by Enter, a double click or a click on its first corner, other shapes by
    /// their second point; Esc cancels. All but new assets need an active asset.
    void begin(Purpose purpose, DraftShape shape);
    bool isActive() const { return m_draft.has_value(); }

    void press(const CanvasPointer& pointer) override;
    void move(const CanvasPointer& pointer) override;
    void release(const CanvasPointer& pointer) override;
    void doubleClick(const CanvasPointer& pointer) override;
    bool key(const QKeyEvent& event) override;
    bool cancel() override;
    void paint(QPainter& painter, const CanvasColours& colours) const override;
    Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
    QString hint() const override;
    bool isPrompting() const override { return isActive(); }
    void fillMenu(QMenu& menu, const CanvasPointer& pointer) override;

private:
    OutlineDraft& draft();
    const OutlineDraft& draft() const;
    void add();
    void close();
    QString nextStep() const;
    bool refuse(const Error& error);
    bool pushNewAsset();
    bool pushOutline(const QString& text, const Result<Polygon>& outline);

    std::optional<OutlineDraft> m_draft;
    Purpose m_purpose = Purpose::Replace;
    QPointF m_pressed;
    QString m_fault;  // why the shape could not be closed; empty after the next input
};

}  // namespace rubble
