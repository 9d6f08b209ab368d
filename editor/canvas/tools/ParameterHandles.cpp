#include "editor/canvas/tools/ParameterHandles.h"

#include "core/base/math/Trigonometry.h"
#include "core/fracture/pattern/SeedEdits.h"
#include "editor/canvas/tools/Snapping.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/widgets/appearance/LayerText.h"

#include <QCoreApplication>

#include <cmath>

namespace rubble {

namespace {

// In pixels.
constexpr double kRadius = 7.0;             // of the ring
constexpr double kHandleGrabRadius = 10.0;  // within which a press grabs the handle
constexpr double kCross = 11.0;             // half the length of the cross
constexpr double kWidth = 1.75;
constexpr double kHaloWidth = 4.5;
constexpr double kAngleHandleDistance = 0.3;  // from the centre of the asset, of its diagonal
constexpr double kAngleHandleSpacing = 0.8;   // of the previous one: handles with equal angles do not overlap
constexpr std::string_view kDirection = "angle";

struct ParameterHandlesTexts {
    Q_DECLARE_TR_FUNCTIONS(ParameterHandles)
};

void paintHandle(QPainter& painter, QPointF at, const QColor& colour) {
    for (const QColor& penColour : {QColor(255, 255, 255, 200), colour}) {
        painter.setPen(QPen(penColour, penColour == colour ? kWidth : kHaloWidth));
        painter.drawEllipse(at, kRadius, kRadius);
        for (const QPointF towards : {QPointF(1.0, 0.0), QPointF(-1.0, 0.0), QPointF(0.0, 1.0), QPointF(0.0, -1.0)}) {
            painter.drawLine(at + towards * (kRadius - 3.0), at + towards * kCross);
        }
    }
}

/// Paints a line from the handle through the pivot.
void paintDirection(QPainter& painter, QPointF pivot, QPointF at, const QColor& colour) {
    for (const QColor& penColour : {QColor(255, 255, 255, 200), colour}) {
        painter.setPen(QPen(penColour, penColour == colour ? kWidth : kHaloWidth,
                            penColour == colour ? Qt::DashLine : Qt::SolidLine));
        painter.drawLine(pivot - (at - pivot), at);
    }
}

/// Whether a parameter is the angle of the layer's cuts or grain.
bool isDirection(const LayerParameter& parameter, const PatternLayer& layer) {
    const LayerRole role = kindOf(layer.parameters).role;
    return parameter.name == kDirection && (role == LayerRole::Cuts || role == LayerRole::Measures);
}

/// The parameter's value for a position of its handle.
ParameterValue valueAt(const ParameterHandle& handle, Vec2 position) {
    if (!handle.pivot) return position;
    const Vec2 along = position - *handle.pivot;
    return std::atan2(along.y, along.x);
}

QString stepText(const ParameterHandle& handle) {
    return (handle.pivot ? ParameterHandlesTexts::tr("Rotate %1") : ParameterHandlesTexts::tr("Move %1"))
        .arg(patternText(handle.parameter->caption));
}

}  // namespace

std::vector<ParameterHandle> parameterHandles(const Asset& asset) {
    std::vector<ParameterHandle> handles;
    const Box2 box = boundsOf(asset.prism().outline.outer);
    const Vec2 centre = (box.min + box.max) / 2.0;
    double distance = kAngleHandleDistance * box.diagonal();
    for (const PatternLayer& layer : asset.pattern.layers) {
        if (!layer.isOn) continue;
        for (const LayerParameter& parameter : kindOf(layer.parameters).parameters) {
            if (parameter.type == ParameterType::Point) {
                handles.push_back({layer.id, &parameter, std::get<Vec2>(parameter.read(layer.parameters))});
            } else if (isDirection(parameter, layer)) {
                const double angle = std::get<double>(parameter.read(layer.parameters));
                handles.push_back({layer.id, &parameter, centre + distance * Vec2(cosine(angle), sine(angle)), centre});
                distance *= kAngleHandleSpacing;
            }
        }
    }
    return handles;
}

std::optional<ParameterHandle> ParameterHandles::handleAt(QPointF pixels) const {
    std::optional<ParameterHandle> nearest;
    double least = kHandleGrabRadius * kHandleGrabRadius;
    if (!m_state.assetInItsPlane()) return nearest;
    for (const ParameterHandle& handle : parameterHandles(*m_state.assetInItsPlane())) {
        const QPointF off = m_state.view.pixels(handle.position) - pixels;
        const double squared = QPointF::dotProduct(off, off);
        if (squared > least) continue;
        least = squared;
        nearest = handle;
    }
    return nearest;
}

bool ParameterHandles::press(const CanvasPointer& pointer) {
    const std::optional<ParameterHandle> handle = handleAt(pointer.pixels);
    if (!handle) return false;
    m_drag = Drag{*m_state.asset(), *handle, m_state.document.newMergeKey()};
    return true;
}

void ParameterHandles::move(const CanvasPointer& pointer, bool hasMoved) {
    if (m_drag && hasMoved) push(*m_drag, snapped(m_state, pointer, outlineTargets(m_state)));
    m_hovered = m_drag ? m_drag->handle : handleAt(pointer.pixels);
}

void ParameterHandles::push(const Drag& drag, Vec2 position) {
    Asset asset = drag.before;
    if (PatternLayer* layer = findLayer(m_state.patternIn(asset), drag.handle.layer)) {
        drag.handle.parameter->write(layer->parameters, valueAt(drag.handle, position));
    }
    m_state.push(modify(stepText(drag.handle), std::move(asset), drag.mergeKey));
}

bool ParameterHandles::cancel() {
    if (!m_drag) return false;
    const Drag drag = *std::exchange(m_drag, std::nullopt);
    if (m_state.asset() && m_state.asset()->id == drag.before.id)
        m_state.push(modify(stepText(drag.handle), drag.before, drag.mergeKey));
    return true;
}

void ParameterHandles::paint(QPainter& painter, const CanvasColours& colours) const {
    if (!m_state.assetInItsPlane()) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const ParameterHandle& handle : parameterHandles(*m_state.assetInItsPlane())) {
        const bool isHovered =
            m_hovered && m_hovered->layer == handle.layer && m_hovered->parameter == handle.parameter;
        const QColor colour = isHovered ? colours.hover : colours.accent;
        if (handle.pivot)
            paintDirection(painter, m_state.view.pixels(*handle.pivot), m_state.view.pixels(handle.position), colour);
        paintHandle(painter, m_state.view.pixels(handle.position), colour);
    }
}

QString ParameterHandles::text() const {
    if (!m_hovered || !m_state.assetInItsPlane()) return {};
    const PatternLayer* layer = findLayer(m_state.assetInItsPlane()->pattern, m_hovered->layer);
    if (!layer) return {};
    return ParameterHandlesTexts::tr("%1 of %2")
        .arg(patternText(m_hovered->parameter->caption), layerKindName(layer->parameters).toLower());
}

}  // namespace rubble
