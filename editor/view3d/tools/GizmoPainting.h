#pragma once

#include "viewport/widget/Gizmo.h"

#include <QPainter>
#include <QString>

#include <array>
#include <vector>

namespace rubble {

class ViewportWidget;

/// Paints a handle of a gizmo in widget coordinates.
void paintHandle(QPainter& painter, GizmoHandle handle, const GizmoView& view, bool isHighlighted);

/// Paints edges between points of the world; those behind the eye are left out.
void paintEdges(QPainter& painter, const std::vector<std::array<Vec3, 2>>& edges, const ViewportWidget& viewport);

/// Paints text beside the pointer, within the view.
void paintPointerLabel(QPainter& painter, QPointF pointer, const QString& text, QSize viewSize);

}  // namespace rubble
