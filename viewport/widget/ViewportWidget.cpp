#include "viewport/widget/ViewportWidget.h"

#include "viewport/scene/BodiesWithin.h"
#include "viewport/scene/SurfacePicking.h"
#include "viewport/widget/OpenGlProbe.h"
#include "viewport/widget/ScaleBarItem.h"
#include "viewport/widget/ViewportCanvas.h"
#include "viewport/widget/ViewportOverlay.h"
#include "viewport/widget/ViewportTool.h"

#include <QApplication>
#include <QEasingCurve>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QRubberBand>
#include <QStackedLayout>
#include <QWheelEvent>

#include <algorithm>

namespace rubble {
namespace {

constexpr int kAnimationMilliseconds = 220;
constexpr double kKeyZoom = 1.25;

Qt::CursorShape cursorOf(Drag drag) {
    switch (drag) {
        case Drag::Pan: return Qt::ClosedHandCursor;
        case Drag::Zoom: return Qt::SizeVerCursor;
        case Drag::Orbit: break;
    }
    return Qt::SizeAllCursor;
}

}  // namespace

ViewportWidget::ViewportWidget(QWidget* parent)
    : QWidget(parent),
      m_scene(std::make_shared<RenderScene>()),
      m_rubberBand(new QRubberBand(QRubberBand::Rectangle, this)) {
    setAccessibleName(tr("3D view"));
    setAccessibleDescription(
        tr("The fragments in 3D. Arrow keys orbit, with Shift they pan; plus and minus zoom; Home frames all, F the "
           "selection; 1, 3 and 7 align the view to the front, right and top."));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    auto* layout = new QStackedLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    if (const std::optional<QString> sentence = openGlError()) {
        showError(*sentence);
    } else {
        m_canvas = new ViewportCanvas(this);
        layout->addWidget(m_canvas);
        connect(m_canvas, &ViewportCanvas::drawn, this, &ViewportWidget::drawn);
        connect(m_canvas, &ViewportCanvas::failed, this, &ViewportWidget::showError);
    }
    m_scaleBar = new ScaleBarItem(*this);
    m_overlay = new ViewportOverlay(*this);
    m_overlay->raise();
    m_settings.hasScaleBar = false;  // the overlay's has the font of the interface
    setOverlayItems({});
    connect(m_overlay, &ViewportOverlay::itemsChanged, this, [this] {
        if (m_framed && m_overlay->strips(size()) != m_strips) frame(Box3(*m_framed));
    });
    m_animation.setStartValue(0.0);
    m_animation.setEndValue(1.0);
    m_animation.setDuration(kAnimationMilliseconds);
    m_animation.setEasingCurve(QEasingCurve::OutCubic);
    connect(&m_animation, &QVariantAnimation::valueChanged, this,
            [this](const QVariant& fraction) { showFrom(interpolated(m_start, m_goal, fraction.toDouble())); });
    m_goal = m_camera = alignedTo(Camera{}, StandardView::Isometric);
    showFrom(m_camera);
}

void ViewportWidget::showError(const QString& sentence) {
    if (m_canvas != nullptr) m_canvas->deleteLater();
    m_canvas = nullptr;
    m_errorLabel = new QLabel(sentence, this);
    m_errorLabel->setAlignment(Qt::AlignCenter);
    m_errorLabel->setWordWrap(true);
    m_errorLabel->setMargin(24);
    layout()->addWidget(m_errorLabel);
    static_cast<QStackedLayout*>(layout())->setCurrentWidget(m_errorLabel);
}

QString ViewportWidget::errorText() const { return m_errorLabel != nullptr ? m_errorLabel->text() : QString(); }

void ViewportWidget::setOverlayItems(const std::vector<OverlayItem*>& items) {
    std::vector<OverlayItem*> all{m_scaleBar};
    all.insert(all.end(), items.begin(), items.end());
    m_overlay->setItems(all);
}

std::vector<QRect> ViewportWidget::plates() const {
    return hasOverlays() ? m_overlay->plates(size()) : std::vector<QRect>();
}

void ViewportWidget::setPresenting(bool isOn) {
    if (isOn == isPresenting()) return;
    m_isPresenting = isOn;
    updateOverlays();
    emit presentingChanged(isOn);
}

void ViewportWidget::setOverlaysOn(bool isOn) {
    m_areOverlaysOn = isOn;
    updateOverlays();
}

void ViewportWidget::updateOverlays() {
    const bool isOn = m_areOverlaysOn && !m_isPresenting;
    if (isOn == hasOverlays()) return;
    m_settings.hasOverlays = isOn;
    m_overlay->setVisible(isOn);
    hover(std::nullopt);
    showFrom(m_camera);
    emit overlaysChanged(isOn);
}

void ViewportWidget::setScene(std::shared_ptr<const RenderScene> scene) {
    if (*scene == *m_scene) return;  // at rest: the picture can be refined
    m_scene = std::move(scene);
    m_hovered.reset();
    if (m_canvas != nullptr) m_canvas->setScene(m_scene);
    const Box3 bounds = boundsOf(*m_scene);
    if (!m_isFramed && !bounds.isEmpty()) {
        m_isFramed = true;
        m_framed = bounds;
        refit();
    }
    showFrom(m_camera);
    m_overlay->update();  // the scale bar depends on the scene
}

void ViewportWidget::setStepFraction(double stepFraction) {
    if (m_stepFraction == stepFraction) return;
    m_stepFraction = stepFraction;
    showFrom(m_camera);
}

Ray ViewportWidget::rayAt(QPointF point) const { return rayThrough(shownCamera(), pixels(point), imageSize()); }

std::optional<QPointF> ViewportWidget::pointOf(Vec3 position) const {
    const std::optional<Vec2> pixel = pixelOf(shownCamera(), position, imageSize());
    if (!pixel) return std::nullopt;
    return QPointF(pixel->x, pixel->y) / devicePixelRatioF();
}

std::optional<QLineF> ViewportWidget::lineOf(Vec3 from, Vec3 to) const {
    const auto pixels = pixelsOf(shownCamera(), from, to, imageSize());
    if (!pixels) return std::nullopt;
    const auto& [start, end] = *pixels;
    return QLineF(QPointF(start.x, start.y) / devicePixelRatioF(), QPointF(end.x, end.y) / devicePixelRatioF());
}

void ViewportWidget::setSettings(const RenderSettings& settings) {
    m_settings = settings;
    showFrom(m_camera);
}

void ViewportWidget::setProgressiveRendering(ProgressiveRendering mode) {
    if (m_canvas != nullptr) m_canvas->setProgressiveRendering(mode);
}

void ViewportWidget::setQuality(RenderQuality quality) {
    if (m_canvas != nullptr) m_canvas->setQuality(quality);
}

void ViewportWidget::setAdaptive(bool isOn) {
    if (m_canvas != nullptr) m_canvas->setAdaptive(isOn);
}

bool ViewportWidget::isPictureCurrent() { return m_canvas != nullptr && m_canvas->isCurrent(); }
bool ViewportWidget::isPictureFinished() { return m_canvas != nullptr && m_canvas->isFinished(); }

ImageSize ViewportWidget::imageSize() const {
    return m_canvas != nullptr ? m_canvas->imageSize() : ImageSize{std::max(1, width()), std::max(1, height())};
}

Vec2 ViewportWidget::pixels(QPointF point) const { return devicePixelRatioF() * Vec2(point.x(), point.y()); }

void ViewportWidget::showFrom(const Camera& camera) {
    m_camera = camera;
    if (m_canvas == nullptr) return;
    m_canvas->setView(
        {.camera = camera, .size = {}, .settings = m_settings, .hovered = m_hovered, .stepFraction = m_stepFraction});
}

void ViewportWidget::setCamera(const Camera& camera) {
    m_framed.reset();
    moveCamera(camera);
}

void ViewportWidget::moveCamera(const Camera& camera) {
    m_animation.stop();
    m_goal = camera;
    showFrom(camera);
    emit cameraChanged();
}

void ViewportWidget::animateTo(const Camera& camera) {
    m_framed.reset();
    if (!m_isAnimated || !isVisible()) return moveCamera(camera);
    m_animation.stop();
    m_start = m_camera;
    m_goal = camera;
    m_animation.start();
    emit cameraChanged();
}

void ViewportWidget::alignTo(StandardView view) { animateTo(alignedTo(m_goal, view)); }

void ViewportWidget::setProjection(Projection projection) {
    Camera camera = m_goal;
    camera.projection = projection;
    setCamera(camera);
}

void ViewportWidget::setScaleUnit(const ScaleUnit& unit) { m_scaleBar->setUnit(unit); }

void ViewportWidget::frame(const Box3& box) { frameFrom(m_goal, box); }

void ViewportWidget::frameFrom(const Camera& orientation, const Box3& box) {
    if (box.isEmpty()) return;
    m_strips = m_overlay->strips(size());
    animateTo(framed(orientation, box));
    m_framed = box;
}

Camera ViewportWidget::framed(const Camera& orientation, const Box3& box) const {
    const ImageStrips strips = m_overlay->strips(size());
    const double scale = devicePixelRatioF();
    return framing(orientation, box, imageSize(), {scale * strips.top, scale * strips.bottom});
}

/// Frames again what was framed, for another size or other plates.
void ViewportWidget::refit() {
    if (!m_framed) return;
    m_strips = m_overlay->strips(size());
    moveCamera(framed(m_goal, *m_framed));
}
void ViewportWidget::frameAll() { frame(boundsOf(*m_scene)); }
void ViewportWidget::frameSelected() {
    const Box3 selected = boundsOf(*m_scene, kSelected);
    frame(selected.isEmpty() ? boundsOf(*m_scene) : selected);
}

std::optional<std::uint32_t> ViewportWidget::bodyAt(QPointF point) const {
    if (m_canvas == nullptr) return std::nullopt;
    const std::optional<SurfaceHit> hit = surfaceHit(*m_scene, rayAt(point), m_stepFraction);
    return hit ? std::optional(hit->body) : std::nullopt;
}

std::optional<PickId> ViewportWidget::pickAt(QPointF point) const { return pickOf(bodyAt(point)); }

std::optional<PickId> ViewportWidget::pickOf(std::optional<std::uint32_t> body) const {
    if (!body || *body >= m_scene->picks.size()) return std::nullopt;
    return m_scene->picks[*body];
}

void ViewportWidget::hover(std::optional<std::uint32_t> body) {
    if (!hasOverlays()) body.reset();
    if (body == m_hovered) return;
    m_hovered = body;
    showFrom(m_camera);
    emit hovered(pickOf(body));
}

void ViewportWidget::mousePressEvent(QMouseEvent* event) {
    m_pressedAt = m_lastAt = event->position();
    m_drag = dragOf(m_navigation, event->button(), event->modifiers());
    m_isClick = !m_drag && event->button() == Qt::LeftButton;
    if (m_drag) {
        setCursor(cursorOf(*m_drag));
        hover(std::nullopt);
    } else if (!m_isClick) {
        event->ignore();  // leaves the context menu to the parent
    }
}

void ViewportWidget::mouseMoveEvent(QMouseEvent* event) {
    const QPointF moved = event->position() - m_lastAt;
    m_lastAt = event->position();
    if (!event->buttons().testFlag(Qt::LeftButton)) cancelClick();  // its release went elsewhere
    if (m_drag) return setCamera(dragged(m_camera, *m_drag, pixels(moved), imageSize()));
    const int far = (event->position() - m_pressedAt).toPoint().manhattanLength();
    if (m_isClick && far >= QApplication::startDragDistance() && m_canvas != nullptr) {
        m_isClick = false;
        hover(std::nullopt);
        m_rubberBand->raise();
        m_rubberBand->show();
    }
    if (m_rubberBand->isVisible())
        m_rubberBand->setGeometry(QRectF(m_pressedAt, event->position()).normalized().toRect());
    if (event->buttons() == Qt::NoButton && m_canvas != nullptr && m_animation.state() != QAbstractAnimation::Running) {
        hover(bodyAt(event->position()));
    }
}

void ViewportWidget::mouseReleaseEvent(QMouseEvent* event) {
    if (m_drag) unsetCursor();
    m_drag.reset();
    if (m_rubberBand->isVisible() && event->button() == Qt::LeftButton) return endBoxSelection(event->modifiers());
    if (!m_isClick || event->button() != Qt::LeftButton) return;
    m_isClick = false;
    if (m_canvas != nullptr) emit picked(pickAt(event->position()), event->modifiers());
}

/// Ends a click or a box selection without a selection.
void ViewportWidget::cancelClick() {
    m_isClick = false;
    m_rubberBand->hide();
}

void ViewportWidget::endBoxSelection(Qt::KeyboardModifiers modifiers) {
    m_rubberBand->hide();
    const Vec2 from = pixels(m_rubberBand->geometry().topLeft()), to = pixels(m_rubberBand->geometry().bottomRight());
    std::vector<PickId> picks;
    for (const std::uint32_t body : bodiesWithin(*m_scene, m_camera, imageSize(), {from, to})) {
        picks.push_back(m_scene->picks[body]);
    }
    emit boxSelected(picks, modifiers);
}

void ViewportWidget::wheelEvent(QWheelEvent* event) {
    const double factor = wheelFactor(event->angleDelta().y());
    setCamera(dollied(m_camera, factor, pixels(event->position()), imageSize()));
}

void ViewportWidget::leaveEvent(QEvent*) { hover(std::nullopt); }

void ViewportWidget::resizeEvent(QResizeEvent*) {
    m_overlay->resize(size());
    refit();
}

void ViewportWidget::apply(const ViewKey& key) {
    const ImageSize size = imageSize();
    if (key.view) return alignTo(*key.view);
    if (key.orbit != Vec2(0.0)) return animateTo(orbited(m_goal, key.orbit.x, key.orbit.y));
    if (key.panPoints != Vec2(0.0)) return animateTo(panned(m_goal, devicePixelRatioF() * key.panPoints, size));
    const Vec2 centre = 0.5 * Vec2(size.width, size.height);
    switch (key.action.value_or(ViewAction::FrameAll)) {
        case ViewAction::FrameAll: return frameAll();
        case ViewAction::FrameSelected: return frameSelected();
        case ViewAction::ZoomIn: return animateTo(dollied(m_goal, 1.0 / kKeyZoom, centre, size));
        case ViewAction::ZoomOut: return animateTo(dollied(m_goal, kKeyZoom, centre, size));
        case ViewAction::ToggleProjection:
            return setProjection(m_goal.projection == Projection::Perspective ? Projection::Orthographic
                                                                              : Projection::Perspective);
    }
}

void ViewportWidget::keyPressEvent(QKeyEvent* event) {
    const auto key = viewKeyOf(m_navigation, event->key(), event->modifiers());
    if (event->key() == Qt::Key_Escape && m_rubberBand->isVisible()) return cancelClick();
    if (!key) return QWidget::keyPressEvent(event);
    apply(*key);
}

/// True if a tool has consumed the event.
bool ViewportWidget::dispatchToTools(QEvent& event) {
    const auto isConsumed = [&](auto handle) {
        const bool isDone = std::ranges::any_of(m_tools, [&](ViewportTool* tool) { return handle(*tool); });
        if (isDone) event.accept();
        return isDone;
    };
    // A press that was not consumed may become a click, unless a tool goes on with it.
    const auto endsClick = [&](bool isDone) {
        if (isDone) cancelClick();
        return isDone;
    };
    const auto forEachTool = [&](auto notify) {
        std::ranges::for_each(m_tools, [&](ViewportTool* tool) { notify(*tool); });
        return false;
    };
    const auto mouse = [&]() -> const QMouseEvent& { return static_cast<const QMouseEvent&>(event); };
    const auto key = [&]() -> const QKeyEvent& { return static_cast<const QKeyEvent&>(event); };
    switch (event.type()) {
        case QEvent::MouseButtonPress: return isConsumed([&](ViewportTool& tool) { return tool.press(mouse()); });
        case QEvent::MouseButtonDblClick:
            return isConsumed([&](ViewportTool& tool) { return tool.doubleClick(mouse()); });
        case QEvent::MouseMove: return endsClick(isConsumed([&](ViewportTool& tool) { return tool.move(mouse()); }));
        case QEvent::MouseButtonRelease:
            return endsClick(isConsumed([&](ViewportTool& tool) { return tool.release(mouse()); }));
        case QEvent::Wheel:
            return isConsumed([&](ViewportTool& tool) { return tool.wheel(static_cast<const QWheelEvent&>(event)); });
        case QEvent::ShortcutOverride:
            return isConsumed([&](ViewportTool& tool) { return tool.overridesShortcut(key()); });
        case QEvent::KeyPress: return isConsumed([&](ViewportTool& tool) { return tool.keyPress(key()); });
        case QEvent::KeyRelease: return isConsumed([&](ViewportTool& tool) { return tool.keyRelease(key()); });
        case QEvent::ContextMenu: return isConsumed([](ViewportTool& tool) { return tool.suppressesContextMenu(); });
        case QEvent::DragEnter:
        case QEvent::DragMove:
        case QEvent::Drop:
            return std::ranges::any_of(m_tools,
                                       [&](ViewportTool* tool) { return tool->drag(static_cast<QDropEvent&>(event)); });
        case QEvent::DragLeave: return forEachTool([](ViewportTool& tool) { tool.dragLeave(); });
        case QEvent::Enter:
            return forEachTool([&](ViewportTool& tool) { tool.enter(static_cast<QEnterEvent&>(event).position()); });
        case QEvent::Leave: return forEachTool([](ViewportTool& tool) { tool.leave(); });
        case QEvent::FocusOut: return forEachTool([](ViewportTool& tool) { tool.focusLost(); });
        default: return false;
    }
}

/// Escape shows the overlays again before any tool gets it.
bool ViewportWidget::endsPresenting(QEvent& event) {
    const bool isKey = event.type() == QEvent::ShortcutOverride || event.type() == QEvent::KeyPress;
    if (!isPresenting() || !isKey || static_cast<QKeyEvent&>(event).key() != Qt::Key_Escape) return false;
    event.accept();
    if (event.type() == QEvent::KeyPress) setPresenting(false);
    return true;
}

bool ViewportWidget::event(QEvent* event) {
    if (endsPresenting(*event)) return true;
    if (dispatchToTools(*event)) return true;
    // While it has the focus, its keys take precedence over the window's shortcuts.
    if (event->type() == QEvent::ShortcutOverride) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (viewKeyOf(m_navigation, key->key(), key->modifiers())) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

}  // namespace rubble

#include "moc_ViewportWidget.cpp"
