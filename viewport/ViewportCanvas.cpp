#include "viewport/ViewportCanvas.h"

#include <QOpenGLContext>

#include <chrono>

namespace rubble {
namespace {

using namespace std::chrono_literals;

constexpr auto kIdle = 250ms;  // before refining begins
constexpr int kMostSamples = 32;
constexpr int kFewestShown = 8;  // fewer are more uneven than none

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
    connect(&m_idle, &QTimer::timeout, this, &ViewportCanvas::refine);
}

ViewportCanvas::~ViewportCanvas() {
    // First of all: the context's last signal would find a widget that is half gone.
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
    // A widget that moves to another window gets another context.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &ViewportCanvas::release);
    Result<std::unique_ptr<Renderer>> renderer = Renderer::made();
    if (!renderer) {
        emit failed(QString::fromStdString(renderer.error().message));
        return;
    }
    m_renderer = std::move(*renderer);
    m_renderer->setScene(m_scene);
    m_hasCard = !m_renderer->isSoftware();
    m_samples = 0;
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

void ViewportCanvas::setView(const PictureView& view) {
    if (view == m_view) return;
    m_view = view;
    invalidate();
}

void ViewportCanvas::setRefining(Refining refining) {
    if (refining == m_refining) return;
    m_refining = refining;
    invalidate();
}

bool ViewportCanvas::mayRefine() const {
    return m_refining == Refining::Always || (m_refining == Refining::WithCard && m_hasCard);
}

void ViewportCanvas::invalidate() {
    m_samples = 0;
    update();
}

PictureSize ViewportCanvas::pictureSize() const {
    const QSizeF pixels = QSizeF(size()) * devicePixelRatioF();
    return {std::max(1, qRound(pixels.width())), std::max(1, qRound(pixels.height()))};
}

PictureView ViewportCanvas::sizedView() const {
    PictureView view = m_view;
    view.size = pictureSize();
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
    if (m_samples > kFewestShown)
        m_renderer->showMean(sizedView(), defaultFramebufferObject());
    else
        m_renderer->draw(sizedView(), defaultFramebufferObject());
    if (mayRefine() && m_samples == 0) m_idle.start(kIdle);
}

void ViewportCanvas::refine() {
    if (!m_renderer || !mayRefine() || m_samples >= kMostSamples) return;
    makeCurrent();
    m_renderer->addSample(sizedView(), m_samples++);
    doneCurrent();
    if (m_samples > kFewestShown) update();
    m_idle.start(0ms);
}

}  // namespace rubble
