#pragma once

#include "viewport/Gizmo.h"

#include <QString>
#include <QWidget>

namespace rubble {

class ViewportWidget;

/// What is drawn over the 3D view to move, turn and place instances: a gizmo, the edges of what is about to be placed, and how
/// far something was moved. It lets all events through.
class GizmoOverlay : public QWidget {
    Q_OBJECT
public:
    explicit GizmoOverlay(ViewportWidget& viewport);

    struct Content {
        std::optional<Vec3> middle;  // where the gizmo stands; none: there is none
        GizmoMode mode = GizmoMode::Move;
        std::optional<GizmoHandle> hot;          // under the pointer, or held
        bool isDragging = false;                 // the other handles are left out
        std::vector<std::array<Vec3, 2>> edges;  // of what is about to be placed
        QString label;                           // beside the pointer
        QPointF pointer;
    };
    void setContent(const Content& content);
    const Content& content() const { return m_content; }
    /// The view that the gizmo is drawn in; nothing where there is none.
    std::optional<GizmoView> view() const;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow();
    void paintHandle(class QPainter& painter, GizmoHandle handle, const GizmoView& view) const;
    void paintEdges(QPainter& painter) const;
    void paintLabel(QPainter& painter) const;

    ViewportWidget& m_viewport;
    Content m_content;
    Camera m_painted;
};

}  // namespace rubble
