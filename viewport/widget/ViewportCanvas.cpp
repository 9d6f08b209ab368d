#include "viewport/widget/ViewportCanvas.h"

#include <QOpenGLContext>

#include <chrono>

namespace rubble {
namespace {

using namespace std::chrono_literals;

constexpr auto kIdle = 250ms;  // before samples are accumulated
constexpr int kMaxSamples = 32;
constexpr int kMinShownSamples = 8;  // fewer look noisier than the one-pass image

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
    connect(&m_idle, &QTimer::timeout, this, &ViewportCanvas::accumulate);
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
}

/// The samples have the former size.
void ViewportCanvas::resizeGL(int /*width*/, int /*height*/) { m_samples = 0; }

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
    m_view = view;
    invalidate();
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

void ViewportCanvas::invalidate() {
    m_samples = 0;
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
    if (m_samples > kMinShownSamples)
        m_renderer->drawMean(sizedView(), defaultFramebufferObject());
    else
        m_renderer->draw(sizedView(), defaultFramebufferObject());
    if (canAccumulate() && m_samples == 0) m_idle.start(kIdle);
}

void ViewportCanvas::accumulate() {
    if (!m_renderer || !canAccumulate() || m_samples >= kMaxSamples) return;
    makeCurrent();
    m_renderer->addSample(sizedView(), m_samples++);
    doneCurrent();
    if (m_samples > kMinShownSamples) update();
    m_idle.start(0ms);
}

}  // namespace rubble

#include "moc_ViewportCanvas.cpp"
