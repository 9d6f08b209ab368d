#include "viewport/ViewportWidget.h"

#include "viewport/OpenGlProbe.h"
#include "viewport/ViewportCanvas.h"
#include "viewport/scene/BodiesWithin.h"

#include <QApplication>
#include <QEasingCurve>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QRubberBand>
#include <QStackedLayout>
#include <QWheelEvent>

namespace rubble {
namespace {

constexpr int kFlightMilliseconds = 220;
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
    : QWidget(parent), m_scene(std::make_shared<RenderScene>()), m_box(new QRubberBand(QRubberBand::Rectangle, this)) {
    setAccessibleName(tr("3D view"));
    setAccessibleDescription(
        tr("The pieces in 3D. Arrow keys turn the view, with Shift they move it, plus and minus "
           "zoom; Home shows everything, F what is selected; 1, 3 and 7 look from the front, the "
           "right and above."));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    auto* layout = new QStackedLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    if (const std::optional<QString> sentence = openGlFault()) {
        showFault(*sentence);
    } else {
        m_canvas = new ViewportCanvas(this);
        layout->addWidget(m_canvas);
        // Queued: it is said while the canvas is being shown.
        connect(m_canvas, &ViewportCanvas::failed, this, &ViewportWidget::showFault, Qt::QueuedConnection);
    }
    m_flight.setStartValue(0.0);
    m_flight.setEndValue(1.0);
    m_flight.setDuration(kFlightMilliseconds);
    m_flight.setEasingCurve(QEasingCurve::OutCubic);
    connect(&m_flight, &QVariantAnimation::valueChanged, this,
            [this](const QVariant& share) { showFrom(between(m_start, m_goal, share.toDouble())); });
    m_goal = m_camera = turnedTo(Camera{}, StandardView::Isometric);
    showFrom(m_camera);
}

void ViewportWidget::showFault(const QString& sentence) {
    if (m_canvas != nullptr) m_canvas->deleteLater();
    m_canvas = nullptr;
    m_fault = new QLabel(sentence, this);
    m_fault->setAlignment(Qt::AlignCenter);
    m_fault->setWordWrap(true);
    m_fault->setMargin(24);
    layout()->addWidget(m_fault);
    static_cast<QStackedLayout*>(layout())->setCurrentWidget(m_fault);
}

QString ViewportWidget::fault() const { return m_fault != nullptr ? m_fault->text() : QString(); }

void ViewportWidget::setScene(std::shared_ptr<const RenderScene> scene) {
    m_scene = std::move(scene);
    m_hovered.reset();
    if (m_canvas != nullptr) m_canvas->setScene(m_scene);
    const Box3 bounds = boundsOf(*m_scene);
    if (!m_isFramed && !bounds.isEmpty()) {
        m_isFramed = true;
        setCamera(framing(m_goal, bounds, pictureSize()));
    }
    showFrom(m_camera);
}

void ViewportWidget::setMoment(double moment) {
    if (m_moment == moment) return;
    m_moment = moment;
    showFrom(m_camera);
}

Ray ViewportWidget::rayAt(QPointF point) const { return rayThrough(m_camera, pixels(point), pictureSize()); }

std::optional<QPointF> ViewportWidget::pointOf(Vec3 place) const {
    const std::optional<Vec2> pixel = pixelOf(m_camera, place, pictureSize());
    if (!pixel) return std::nullopt;
    return QPointF(pixel->x, pixel->y) / devicePixelRatioF();
}

void ViewportWidget::setSettings(const RenderSettings& settings) {
    m_settings = settings;
    showFrom(m_camera);
}

void ViewportWidget::setRefining(Refining refining) {
    if (m_canvas != nullptr) m_canvas->setRefining(refining);
}

PictureSize ViewportWidget::pictureSize() const {
    return m_canvas != nullptr ? m_canvas->pictureSize() : PictureSize{std::max(1, width()), std::max(1, height())};
}

Vec2 ViewportWidget::pixels(QPointF point) const { return devicePixelRatioF() * Vec2(point.x(), point.y()); }

void ViewportWidget::showFrom(const Camera& camera) {
    m_camera = camera;
    if (m_canvas == nullptr) return;
    m_canvas->setView({.camera = camera, .size = {}, .settings = m_settings, .hovered = m_hovered, .moment = m_moment});
}

void ViewportWidget::setCamera(const Camera& camera) {
    m_flight.stop();
    m_goal = camera;
    showFrom(camera);
    emit cameraChanged();
}

void ViewportWidget::flyTo(const Camera& camera) {
    if (!m_hasFlights || !isVisible()) return setCamera(camera);
    m_flight.stop();
    m_start = m_camera;
    m_goal = camera;
    m_flight.start();
    emit cameraChanged();
}

void ViewportWidget::turnTo(StandardView view) { flyTo(turnedTo(m_goal, view)); }

void ViewportWidget::setProjection(Projection projection) {
    Camera camera = m_goal;
    camera.projection = projection;
    setCamera(camera);
}

void ViewportWidget::frame(const Box3& box) {
    if (!box.isEmpty()) flyTo(framing(m_goal, box, pictureSize()));
}
void ViewportWidget::frameAll() { frame(boundsOf(*m_scene)); }
void ViewportWidget::frameSelected() {
    const Box3 selected = boundsOf(*m_scene, kSelected);
    frame(selected.isEmpty() ? boundsOf(*m_scene) : selected);
}

std::optional<PickId> ViewportWidget::pickAt(QPointF point) const {
    return m_canvas != nullptr ? pickOf(m_canvas->bodyAt(point)) : std::nullopt;
}

std::optional<PickId> ViewportWidget::pickOf(std::optional<std::uint32_t> body) const {
    if (!body || *body >= m_scene->picks.size()) return std::nullopt;
    return m_scene->picks[*body];
}

void ViewportWidget::hover(std::optional<std::uint32_t> body) {
    if (body == m_hovered) return;
    m_hovered = body;
    showFrom(m_camera);
    emit hovered(pickOf(body));
}

void ViewportWidget::mousePressEvent(QMouseEvent* event) {
    m_pressedAt = m_lastAt = event->position();
    m_drag = dragOf(m_style, event->button(), event->modifiers());
    m_isClick = !m_drag && event->button() == Qt::LeftButton;
    if (m_drag) {
        setCursor(cursorOf(*m_drag));
        hover(std::nullopt);
    } else if (!m_isClick) {
        event->ignore();  // a context menu is somebody else's
    }
}

void ViewportWidget::mouseMoveEvent(QMouseEvent* event) {
    const QPointF moved = event->position() - m_lastAt;
    m_lastAt = event->position();
    if (m_drag) return setCamera(dragged(m_camera, *m_drag, pixels(moved), pictureSize()));
    const int far = (event->position() - m_pressedAt).toPoint().manhattanLength();
    if (m_isClick && far >= QApplication::startDragDistance() && m_canvas != nullptr) {
        m_isClick = false;
        hover(std::nullopt);
        m_box->raise();
        m_box->show();
    }
    if (m_box->isVisible()) m_box->setGeometry(QRectF(m_pressedAt, event->position()).normalized().toRect());
    if (event->buttons() == Qt::NoButton && m_canvas != nullptr && m_flight.state() != QAbstractAnimation::Running) {
        hover(m_canvas->bodyAt(event->position()));
    }
}

void ViewportWidget::mouseReleaseEvent(QMouseEvent* event) {
    if (m_drag) unsetCursor();
    m_drag.reset();
    if (m_box->isVisible() && event->button() == Qt::LeftButton) return endBox(event->modifiers());
    if (!m_isClick || event->button() != Qt::LeftButton) return;
    m_isClick = false;
    if (m_canvas != nullptr) emit picked(pickAt(event->position()), event->modifiers());
}

void ViewportWidget::endBox(Qt::KeyboardModifiers modifiers) {
    m_box->hide();
    const Vec2 from = pixels(m_box->geometry().topLeft()), to = pixels(m_box->geometry().bottomRight());
    std::vector<PickId> picks;
    for (const std::uint32_t body : bodiesWithin(*m_scene, m_camera, pictureSize(), {from, to})) {
        picks.push_back(m_scene->picks[body]);
    }
    emit boxed(picks, modifiers);
}

void ViewportWidget::wheelEvent(QWheelEvent* event) {
    const double factor = wheelFactor(event->angleDelta().y());
    setCamera(dollied(m_camera, factor, pixels(event->position()), pictureSize()));
}

void ViewportWidget::leaveEvent(QEvent*) { hover(std::nullopt); }

void ViewportWidget::apply(const ViewKey& key) {
    const PictureSize size = pictureSize();
    if (key.view) return turnTo(*key.view);
    if (key.orbit != Vec2(0.0)) return flyTo(orbited(m_goal, key.orbit.x, key.orbit.y));
    if (key.panPoints != Vec2(0.0)) return flyTo(panned(m_goal, devicePixelRatioF() * key.panPoints, size));
    const Vec2 middle = 0.5 * Vec2(size.width, size.height);
    switch (key.action.value_or(ViewAction::FrameAll)) {
        case ViewAction::FrameAll: return frameAll();
        case ViewAction::FrameSelected: return frameSelected();
        case ViewAction::ZoomIn: return flyTo(dollied(m_goal, 1.0 / kKeyZoom, middle, size));
        case ViewAction::ZoomOut: return flyTo(dollied(m_goal, kKeyZoom, middle, size));
        case ViewAction::ToggleProjection:
            return setProjection(m_goal.projection == Projection::Perspective ? Projection::Orthographic
                                                                              : Projection::Perspective);
    }
}

void ViewportWidget::keyPressEvent(QKeyEvent* event) {
    const auto key = viewKeyOf(m_style, event->key(), event->modifiers());
    if (event->key() == Qt::Key_Escape && m_box->isVisible()) return m_box->hide();
    if (!key) return QWidget::keyPressEvent(event);
    apply(*key);
}

bool ViewportWidget::event(QEvent* event) {
    // While it has the focus, its keys come before shortcuts of the window.
    if (event->type() == QEvent::ShortcutOverride) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (viewKeyOf(m_style, key->key(), key->modifiers())) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

}  // namespace rubble
