#include "viewport/widget/ViewportCanvas.h"

#include <QOpenGLContext>

#include <bit>
#include <chrono>

namespace rubble {
namespace {

using namespace std::chrono_literals;

constexpr auto kIdle = 140ms;                              // after the last change, until the picture is refined
constexpr int kMovingMilliseconds = 120;                   // a change so soon after the last image is part of a motion
constexpr int kMaxSamples = 32, kMaxSoftwareSamples = 12;  // a picture of 12 differs from one of 256 by 0.4 %
constexpr int kMinShownSamples = 4;                        // fewer look noisier than the image in one pass
constexpr int kMovingSkyMaps = 8, kMovingSoftwareSkyMaps = 2;  // rendered for each image of a motion

}  // namespace

ViewportCanvas::ViewportCanvas(QWidget* parent)
    : QOpenGLWidget(parent), m_scene(std::make_shared<RenderScene>()), m_idle(this) {
    QSurfaceFormat surface;
    surface.setVersion(3, 3);
    surface.setProfile(QSurfaceFormat::CoreProfile);
    setFormat(surface);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    m_idle.setSingleShot(true);
    connect(this, &QOpenGLWidget::frameSwapped, this, &ViewportCanvas::measure);
    connect(&m_idle, &QTimer::timeout, this, &ViewportCanvas::rest);
}

ViewportCanvas::~ViewportCanvas() {
    // First of all: the context's last signal must not reach a partly destroyed widget.
    if (context()) disconnect(context(), nullptr, this, nullptr);
    release();
}

void ViewportCanvas::release() {
    if (!m_renderer) return;
    makeCurrent();
    m_renderer.reset();
    doneCurrent();
}

void ViewportCanvas::initializeGL() {
    // A widget that moves to another window gets a new context.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &ViewportCanvas::release);
    Result<std::unique_ptr<Renderer>> renderer = Renderer::create();
    if (!renderer) {
        emit failed(QString::fromStdString(renderer.error().message));
        return;
    }
    m_renderer = std::move(*renderer);
    m_renderer->setScene(m_scene);
    m_hasGpu = !m_renderer->isSoftware();
    m_samples = 0;
    m_drawn = Drawn::Nothing;
}

/// What was drawn has the former size.
void ViewportCanvas::resizeGL(int /*width*/, int /*height*/) {
    m_samples = 0;
    m_drawn = Drawn::Nothing;
}

void ViewportCanvas::setScene(std::shared_ptr<const RenderScene> scene) {
    m_scene = std::move(scene);
    if (m_renderer) {
        makeCurrent();
        m_renderer->setScene(m_scene);
        doneCurrent();
    }
    invalidate();
}

void ViewportCanvas::setView(const RenderView& view) {
    if (view == m_view) return;
    RenderView same = view;
    same.hovered = m_view.hovered;
    const bool isOther = same != m_view;
    m_view = view;
    isOther ? invalidate() : update();  // a hovered body is marked over the picture
}

void ViewportCanvas::setProgressiveRendering(ProgressiveRendering mode) {
    if (mode == m_progressive) return;
    m_progressive = mode;
    invalidate();
}

bool ViewportCanvas::canAccumulate() const {
    return m_progressive == ProgressiveRendering::Always ||
           (m_progressive == ProgressiveRendering::WithGpu && m_hasGpu);
}

int ViewportCanvas::sampleLimit() const { return m_hasGpu ? kMaxSamples : kMaxSoftwareSamples; }

void ViewportCanvas::invalidate() {
    m_isAtRest = false;
    m_isMoving = m_isAdaptive && m_shown.isValid() && m_shown.elapsed() < kMovingMilliseconds;
    m_samples = 0;
    m_drawn = Drawn::Nothing;
    m_idle.stop();
    update();
}

ImageSize ViewportCanvas::imageSize() const {
    const QSizeF pixels = QSizeF(size()) * devicePixelRatioF();
    return {std::max(1, qRound(pixels.width())), std::max(1, qRound(pixels.height()))};
}

RenderView ViewportCanvas::sizedView() const {
    RenderView view = m_view;
    view.size = imageSize();
    view.settings.scale = devicePixelRatioF();
    return view;
}

std::optional<std::uint32_t> ViewportCanvas::bodyAt(QPointF point) {
    if (!m_renderer) return std::nullopt;
    const QPointF pixel = point * devicePixelRatioF();
    makeCurrent();
    const std::optional<std::uint32_t> body =
        m_renderer->bodyAt(sizedView(), static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
    doneCurrent();
    return body;
}

void ViewportCanvas::paintGL() {
    if (!m_renderer) return;
    if (m_samples >= kMinShownSamples)
        m_renderer->drawMean(sizedView(), defaultFramebufferObject());
    else if (m_drawn != Drawn::Nothing)
        m_renderer->drawAgain(sizedView(), defaultFramebufferObject());
    else
        draw();
    if (m_samples == 0 && (canAccumulate() || m_drawn == Drawn::Moving) && !m_idle.isActive()) m_idle.start(kIdle);
}

/// In a motion, as fast as it needs to be.
void ViewportCanvas::draw() {
    RenderView view = sizedView();
    if (m_isMoving) view.skyMaps = m_hasGpu ? kMovingSkyMaps : kMovingSoftwareSkyMaps;
    if (m_isMoving && !m_hasGpu) view.resolution = m_resolution.value();
    m_begun.start();
    m_renderer->draw(view, defaultFramebufferObject());
    m_drawn = m_isMoving ? Drawn::Moving : Drawn::Resting;
}

/// The time of an image includes that for showing it.
void ViewportCanvas::measure() {
    if (m_isMoving && !m_hasGpu && m_begun.isValid())
        m_resolution.add(1e-9 * static_cast<double>(m_begun.nsecsElapsed()));
    m_begun.invalidate();
    m_isAtRest ? m_shown.invalidate() : m_shown.start();
}

/// Nothing has changed for a while: draws at full resolution what was not, then refines it step by step. Shown are
/// those numbers of samples between which a difference is seen.
void ViewportCanvas::rest() {
    if (!m_renderer) return;
    m_isMoving = false;
    m_isAtRest = true;
    if (m_drawn != Drawn::Resting) {
        m_drawn = Drawn::Nothing;
        return update();
    }
    if (!canAccumulate() || m_samples >= sampleLimit()) return;
    makeCurrent();
    if (m_renderer->continueSample(sizedView(), m_samples)) ++m_samples;
    m_renderer->finish();  // else the next step would wait for this one
    doneCurrent();
    if (m_samples >= kMinShownSamples && std::has_single_bit(static_cast<unsigned>(m_samples))) update();
    if (m_samples < sampleLimit()) m_idle.start(0ms);
}

}  // namespace rubble

#include "moc_ViewportCanvas.cpp"
