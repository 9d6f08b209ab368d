#include "editor/canvas/PointHandles.h"

#include "core/base/Trigonometry.h"
#include "core/fracture/SeedEdits.h"
#include "editor/canvas/Snapping.h"
#include "editor/commands/LayerKind.h"
#include "editor/commands/ProjectEdits.h"

#include <QCoreApplication>

#include <cmath>

namespace rubble {

namespace {

constexpr double kRadius = 7.0;  // pixels, as these: of the ring that is drawn
constexpr double kReach = 10.0;  // from its middle within which a press takes it
constexpr double kCross = 11.0;  // how far its cross reaches
constexpr double kWidth = 1.75;
constexpr double kHaloWidth = 4.5;
constexpr double kReachOfAngle = 0.3;  // of the asset's diameter: from its middle to a handle that turns
constexpr double kNextAngle = 0.8;     // of the one before: handles of one angle lie beside each other
constexpr std::string_view kDirection = "angle";

QString tr(const char* text) { return QCoreApplication::translate("PointHandles", text); }

void paintHandle(QPainter& painter, QPointF at, const QColor& colour) {
    for (const QColor& stroke : {QColor(255, 255, 255, 200), colour}) {
        painter.setPen(QPen(stroke, stroke == colour ? kWidth : kHaloWidth));
        painter.drawEllipse(at, kRadius, kRadius);
        for (const QPointF towards : {QPointF(1.0, 0.0), QPointF(-1.0, 0.0), QPointF(0.0, 1.0), QPointF(0.0, -1.0)}) {
            painter.drawLine(at + towards * (kRadius - 3.0), at + towards * kCross);
        }
    }
}

/// A line through the pivot to where the direction is held.
void paintDirection(QPainter& painter, QPointF pivot, QPointF at, const QColor& colour) {
    for (const QColor& stroke : {QColor(255, 255, 255, 200), colour}) {
        painter.setPen(
            QPen(stroke, stroke == colour ? kWidth : kHaloWidth, stroke == colour ? Qt::DashLine : Qt::SolidLine));
        painter.drawLine(pivot - (at - pivot), at);
    }
}

/// Whether a parameter is the angle in which all cuts of the layer, or its grain, run.
bool isDirection(const LayerParameter& parameter, const PatternLayer& layer) {
    const LayerRole role = kindOf(layer.parameters).role;
    return parameter.name == kDirection && (role == LayerRole::Cuts || role == LayerRole::Measures);
}

/// What a handle's parameter is where the handle is held.
ParameterValue valueAt(const PointHandle& handle, Vec2 position) {
    if (!handle.pivot) return position;
    const Vec2 along = position - *handle.pivot;
    return std::atan2(along.y, along.x);
}

QString stepText(const PointHandle& handle) {
    return (handle.pivot ? tr("Turn %1") : tr("Move %1")).arg(patternText(handle.parameter->caption).toLower());
}

}  // namespace

std::vector<PointHandle> pointHandles(const Asset& asset) {
    std::vector<PointHandle> handles;
    const Box2 box = boundsOf(asset.prism.outline.outer);
    const Vec2 middle = (box.min + box.max) / 2.0;
    double reach = kReachOfAngle * box.diagonal();
    for (const PatternLayer& layer : asset.pattern.layers) {
        if (!layer.isOn) continue;
        for (const LayerParameter& parameter : kindOf(layer.parameters).parameters) {
            if (parameter.type == ParameterType::Point) {
                handles.push_back({layer.id, &parameter, std::get<Vec2>(parameter.read(layer.parameters))});
            } else if (isDirection(parameter, layer)) {
                const double angle = std::get<double>(parameter.read(layer.parameters));
                handles.push_back({layer.id, &parameter, middle + reach * Vec2(cosine(angle), sine(angle)), middle});
                reach *= kNextAngle;
            }
        }
    }
    return handles;
}

std::optional<PointHandle> PointHandles::handleAt(QPointF pixels) const {
    std::optional<PointHandle> nearest;
    double least = kReach * kReach;
    if (!m_state.shown()) return nearest;
    for (const PointHandle& handle : pointHandles(*m_state.shown())) {
        const QPointF off = m_state.view.pixels(handle.position) - pixels;
        const double squared = QPointF::dotProduct(off, off);
        if (squared > least) continue;
        least = squared;
        nearest = handle;
    }
    return nearest;
}

bool PointHandles::press(const CanvasPointer& pointer) {
    const std::optional<PointHandle> handle = handleAt(pointer.pixels);
    if (!handle) return false;
    m_drag = Drag{*m_state.asset(), *handle, m_state.document.newStroke()};
    return true;
}

void PointHandles::move(const CanvasPointer& pointer, bool hasMoved) {
    if (m_drag && hasMoved) push(*m_drag, snapped(m_state, pointer, outlineTargets(m_state)));
    m_hovered = m_drag ? m_drag->handle : handleAt(pointer.pixels);
}

void PointHandles::push(const Drag& drag, Vec2 position) {
    Asset asset = drag.before;
    if (PatternLayer* layer = findLayer(m_state.patternIn(asset), drag.handle.layer)) {
        drag.handle.parameter->write(layer->parameters, valueAt(drag.handle, position));
    }
    m_state.document.push(altered(stepText(drag.handle), std::move(asset), drag.stroke));
}

bool PointHandles::cancel() {
    if (!m_drag) return false;
    const Drag drag = *std::exchange(m_drag, std::nullopt);
    if (m_state.asset() && m_state.asset()->id == drag.before.id)
        m_state.document.push(altered(stepText(drag.handle), drag.before, drag.stroke));
    return true;
}

void PointHandles::paint(QPainter& painter, const CanvasColours& colours) const {
    if (!m_state.shown()) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const PointHandle& handle : pointHandles(*m_state.shown())) {
        const bool isHovered =
            m_hovered && m_hovered->layer == handle.layer && m_hovered->parameter == handle.parameter;
        const QColor colour = isHovered ? colours.hover : colours.accent;
        if (handle.pivot)
            paintDirection(painter, m_state.view.pixels(*handle.pivot), m_state.view.pixels(handle.position), colour);
        paintHandle(painter, m_state.view.pixels(handle.position), colour);
    }
}

QString PointHandles::text() const {
    if (!m_hovered || !m_state.shown()) return {};
    const PatternLayer* layer = findLayer(m_state.shown()->pattern, m_hovered->layer);
    if (!layer) return {};
    return tr("%1 of %2").arg(patternText(m_hovered->parameter->caption), kindText(layer->parameters).toLower());
}

}  // namespace rubble
