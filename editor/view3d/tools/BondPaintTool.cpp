#include "editor/view3d/tools/BondPaintTool.h"

#include "core/asset/project/AssetShape.h"
#include "core/structure/capacity/BondCapacities.h"
#include "editor/widgets/input/BrushRing.h"
#include "editor/workspace/Workspace.h"
#include "viewport/scene/SurfacePicking.h"
#include "viewport/widget/ViewportWidget.h"

namespace rubble {

namespace {

constexpr double kAnglePerWheelStep = 120.0;  // of QWheelEvent::angleDelta()
constexpr double kMarkRadius = 4.0;           // points
constexpr int kPaintAlpha = 110;              // of the stroke that is being painted, of 255
const QColor kPaintUnderline(10, 14, 20, 190);
const QColor kAnchorPaint(63, 214, 228);
const QColor kNeverBreaksPaint(211, 165, 255);
const QColor kWeakPaint(255, 149, 80);
const QColor kNeutralPaint(230, 228, 222);
const QColor kStrongPaint(127, 176, 255);

QColor colourOf(const BondBrushSettings& settings) {
    switch (settings.brush) {
        case BondBrush::Anchor: return kAnchorPaint;
        case BondBrush::Strength:
            return settings.strength == 1.0 ? kNeutralPaint : settings.strength < 1.0 ? kWeakPaint : kStrongPaint;
        case BondBrush::NeverBreaks: break;
    }
    return kNeverBreaksPaint;
}

/// Where a body of an asset would be if it were not exploded.
Vec3 assembled(const RenderScene& scene, const SurfaceHit& hit) { return hit.point - explodeOffset(scene, hit.body); }

/// The middle of the front or back of a fragment, whichever faces the eye, for its centre in the scene and the
/// direction and depth of its prism; nothing where the eye is between the planes of both and sees neither.
std::optional<Vec3> facingMiddle(const Camera& camera, Vec3 centre, Vec3 along, double depth) {
    for (const double side : {1.0, -1.0}) {
        const Vec3 middle = centre + 0.5 * side * depth * along;
        const Vec3 towardsEye =
            camera.projection == Projection::Orthographic ? axesOf(camera).back : eyeOf(camera) - middle;
        if (side * glm::dot(along, towardsEye) > 0.0) return middle;
    }
    return std::nullopt;
}

void paintMark(QPainter& painter, QPointF at, const QColor& colour) {
    painter.setPen(QPen(kPaintUnderline, 2.0));
    painter.setBrush(colour);
    painter.drawEllipse(at, kMarkRadius, kMarkRadius);
}

}  // namespace

BondPaintTool::BondPaintTool(Workspace& workspace, ViewportWidget& viewport)
    : ViewportTool(&viewport), m_workspace(workspace), m_viewport(viewport), m_painter(workspace.bondPainter()) {
    connect(&m_painter, &BondPainter::changed, this, &BondPaintTool::refresh);
    connect(&workspace.document(), &Document::changed, this, [this] {
        if (m_painter.isOn()) emit changed();
    });
}

/// Follows the brush, which the canvas switches on and off.
void BondPaintTool::refresh() {
    if (!m_painter.isOn()) m_pointer.reset();
    if (!m_painter.stroke()) m_drawn.clear();
    emit changed();
}

const Asset* BondPaintTool::asset() const {
    return m_painter.isOn() && !m_workspace.play().isInPlay() ? m_painter.asset() : nullptr;
}

std::optional<SurfaceHit> BondPaintTool::hitAt(QPointF pixel) const {
    return surfaceHit(m_viewport.scene(), m_viewport.rayAt(pixel));
}

std::optional<BondPaintTool::Place> BondPaintTool::placeAt(QPointF pixel) const {
    const std::optional<SurfaceHit> hit = hitAt(pixel);
    if (!hit || !asset()) return std::nullopt;
    const RenderScene& scene = m_viewport.scene();
    const PickId& pick = scene.picks[hit->body];
    if (pick.asset != asset()->id) return std::nullopt;
    const Instance* instance = findInstance(m_workspace.project(), pick.instance);
    if (instance && instance->isLocked) return std::nullopt;
    const Pose pose = instance ? instance->pose : Pose{};
    const Vec3 local = glm::conjugate(pose.orientation) * (assembled(scene, *hit) - pose.position);
    const Ray ray = m_viewport.rayAt(pixel), beside = m_viewport.rayAt(pixel + QPointF(1.0, 0.0));
    const Vec3 there = beside.at(glm::distance(ray.from, hit->point));
    return Place{Vec2{local}, glm::distance(hit->point, there)};
}

/// Elsewhere than on the active asset, a press is for the view.
bool BondPaintTool::press(const QMouseEvent& event) {
    if (!asset() || event.button() != Qt::LeftButton || event.modifiers().testFlag(Qt::AltModifier)) return false;
    const std::optional<Place> place = placeAt(event.position());
    if (!place) return false;
    if (const QString reason = m_painter.refusal(event.modifiers()); !reason.isEmpty()) {
        emit statusMessage(reason);
        return true;
    }
    m_painter.begin(place->point, m_painter.radiusPixels() * place->metresPerPixel, event.modifiers());
    m_drawn.push_back(event.position());
    return true;
}

/// While it paints, the stroke is led to the point of the asset under the pointer, if there is one.
bool BondPaintTool::move(const QMouseEvent& event) {
    if (!asset()) return false;
    const std::optional<Place> place = placeAt(event.position());
    m_pointer = isPainting() || place ? std::optional(event.position()) : std::nullopt;
    if (isPainting() && place) {
        m_drawn.push_back(event.position());
        m_painter.extend(place->point);
    } else {
        emit changed();
    }
    return isPainting();
}

bool BondPaintTool::release(const QMouseEvent& event) {
    if (!isPainting() || event.button() != Qt::LeftButton) return false;
    m_painter.finish();
    return true;
}

bool BondPaintTool::cancel() { return m_painter.cancel(); }

void BondPaintTool::leave() {
    m_pointer.reset();
    emit changed();
}

bool BondPaintTool::wheel(const QWheelEvent& event) {
    if (!asset() || !event.modifiers().testFlag(Qt::ControlModifier)) return false;
    m_painter.stepSize(event.angleDelta().y() / kAnglePerWheelStep);
    return true;
}

bool BondPaintTool::overridesShortcut(const QKeyEvent& event) const {
    if (!asset() || event.modifiers() != Qt::NoModifier) return false;
    return m_painter.handlesKey(event.key()) || (event.key() == Qt::Key_Escape && m_painter.stroke());
}

bool BondPaintTool::keyPress(const QKeyEvent& event) {
    return overridesShortcut(event) && (m_painter.key(event.key()) || cancel());
}

/// The fragments of a bake that are anchored or never break, with the stroke that is being painted.
const std::vector<bool>& BondPaintTool::markedFragments(const std::shared_ptr<const Bake>& bake) const {
    Asset shown = *asset();
    if (m_painter.stroke()) shown.bonding.strokes.push_back(*m_painter.stroke());
    if (m_marks.bake == bake && m_marks.brush == m_painter.settings().brush && m_marks.bonding == shown.bonding)
        return m_marks.isMarked;
    m_marks = {bake, m_painter.settings().brush, shown.bonding, std::vector<bool>(bake->fragmentCount(), false)};
    for (std::uint32_t fracture = 0; fracture < bake->fractures.size(); ++fracture) {
        const std::uint32_t first = bake->fractures[fracture].first;
        if (m_painter.settings().brush == BondBrush::Anchor) {
            for (const std::uint32_t k : anchoredFragments(shown, *bake, fracture)) m_marks.isMarked[first + k] = true;
        } else {
            const std::vector<bool> never = neverBreaking(shown, *bake, fracture);
            for (std::uint32_t k = 0; k < never.size(); ++k) m_marks.isMarked[first + k] = never[k];
        }
    }
    return m_marks.isMarked;
}

/// Marks the fragments of the base variant that are anchored or never break.
void BondPaintTool::paintMarks(QPainter& painter) const {
    const auto baked = m_workspace.bakes().find(asset()->id);
    if (!baked || !baked->bake || m_painter.settings().brush == BondBrush::Strength) return;
    const std::vector<bool>& isMarked = markedFragments(baked->bake);
    const RenderScene& scene = m_viewport.scene();
    for (std::uint32_t body = 0; body < scene.picks.size(); ++body) {
        const PickId& pick = scene.picks[body];
        const Instance* instance = findInstance(m_workspace.project(), pick.instance);
        const bool isBase = !instance || instance->variant == 0;
        if (pick.asset != asset()->id || !isBase || pick.fragment >= isMarked.size()) continue;
        if (!isMarked[pick.fragment] || (scene.appearances[body].marks & kHidden) != 0) continue;
        const Vec3 centre = scene.origin + Vec3(glm::vec3(scene.poses[body].position)) + explodeOffset(scene, body);
        const Vec3 along = (instance ? instance->pose.orientation : Quat(1.0, 0.0, 0.0, 0.0)) * Vec3(0.0, 0.0, 1.0);
        const auto middle = facingMiddle(m_viewport.shownCamera(), centre, along, sizeOf(*asset()).z);
        const std::optional<QPointF> at = middle ? m_viewport.pointOf(*middle) : std::nullopt;
        if (at) paintMark(painter, *at, colourOf(m_painter.settings()));
    }
}

void BondPaintTool::paint(QPainter& painter, QSize) const {
    if (!asset()) return;
    painter.setRenderHint(QPainter::Antialiasing);
    paintMarks(painter);
    painter.setBrush(Qt::NoBrush);
    const BondStroke* current = m_painter.stroke();
    const bool isErasing = current ? current->isErasing : m_painter.settings().isErasing;
    const QColor colour = isErasing ? kNeutralPaint : colourOf(m_painter.settings());
    if (!m_drawn.empty()) {
        QPolygonF line(m_drawn.begin(), m_drawn.end());
        if (line.size() == 1) line.push_back(line.front());
        QColor fill = colour;
        fill.setAlpha(kPaintAlpha);
        painter.setPen(QPen(fill, 2.0 * m_painter.radiusPixels(), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
    }
    if (!m_pointer) return;
    paintBrushRing(painter, *m_pointer, m_painter.radiusPixels(), colour, kPaintUnderline, isErasing);
}

}  // namespace rubble

#include "moc_BondPaintTool.cpp"
