#include "viewport/widget/ViewportCanvas.h"

#include "viewport/render/SceneMemory.h"

#include <QPainter>
#include <QWindow>

#include <new>
#include <utility>

namespace rubble {

ViewportCanvas::ViewportCanvas(QWidget* parent) : QWidget(parent), m_scene(std::make_shared<RenderScene>()) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::NoFocus);
    connect(&m_thread, &RenderThread::failed, this, &ViewportCanvas::failed);
    connect(&m_thread, &RenderThread::pictureChanged, this, [this] {
        m_picture = m_thread.picture();
        m_isNew = true;
        update();
    });
}

void ViewportCanvas::setScene(std::shared_ptr<const RenderScene> scene) {
    if (scene->batches != m_scene->batches && !isMemoryLeftFor(*scene)) throw std::bad_alloc();
    m_scene = std::move(scene);
    invalidate();
}

void ViewportCanvas::setView(const RenderView& view) {
    if (view == m_view) return;
    m_view = view;
    invalidate();
}

/// All changes of one event make one picture.
void ViewportCanvas::invalidate() {
    if (!std::exchange(m_isSynchronized, false)) return;
    QMetaObject::invokeMethod(this, &ViewportCanvas::synchronize, Qt::QueuedConnection);
}

/// Requests a picture of what has changed, if it can be seen; else when it can be.
void ViewportCanvas::synchronize() {
    if (m_isSynchronized) return;
    const QWindow* shownIn = window()->windowHandle();
    if (!isVisible() || shownIn == nullptr || !shownIn->isExposed()) return update();
    m_isSynchronized = true;
    m_thread.show(m_scene, sizedView());
}

void ViewportCanvas::resizeEvent(QResizeEvent*) { invalidate(); }
void ViewportCanvas::showEvent(QShowEvent*) { invalidate(); }

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

bool ViewportCanvas::isCurrent() {
    synchronize();
    return m_isSynchronized && m_thread.isCurrent() &&
           m_picture.image.cacheKey() == m_thread.picture().image.cacheKey();
}

bool ViewportCanvas::isFinished() { return isCurrent() && m_thread.isFinished(); }

/// A picture of another size is shown until there is one of this size.
void ViewportCanvas::paintEvent(QPaintEvent*) {
    synchronize();  // the window may have become visible, or have moved to another screen
    QPainter painter(this);
    if (m_picture.image.isNull())
        painter.fillRect(rect(), palette().window());
    else
        painter.drawImage(rect(), m_picture.image);
    if (std::exchange(m_isNew, false)) emit drawn();
}

}  // namespace rubble

#include "moc_ViewportCanvas.cpp"
