#include "viewport/widget/RenderThread.h"

#include "core/base/OutOfMemory.h"
#include "viewport/render/PictureBuffer.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QThread>

#include <algorithm>
#include <bit>
#include <new>
#include <utility>

namespace rubble {
namespace {

using namespace std::chrono_literals;

constexpr auto kIdle = 140ms;             // after the last change, until the picture is refined
constexpr auto kMotion = 120ms;           // a change so soon after the last picture is part of a motion
constexpr double kSlow = 0.25;            // s: pictures that take longer are preceded by a quick one, or abandoned
constexpr int kGoodSoftwareSamples = 12;  // a picture of so many differs from one of 256 by 0.4 %
constexpr int kMinShownSamples = 4;       // fewer look noisier than the image in one pass
constexpr int kMovingSkyMaps = 8, kMovingSoftwareSkyMaps = 2;  // rendered for each image of a motion

QSurfaceFormat coreFormat() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    return format;
}

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

RenderThread::RenderThread(QObject* parent)
    : QObject(parent),
      m_surface(std::make_unique<QOffscreenSurface>()),
      m_context(std::make_unique<QOpenGLContext>()),
      m_thread(QThread::create([this] { run(); })) {
    m_request.scene = std::make_shared<RenderScene>();
    m_surface->setFormat(coreFormat());
    m_surface->create();
    m_context->setFormat(coreFormat());
    m_context->create();
    m_context->moveToThread(m_thread.get());
    m_thread->setObjectName("Rendering");
    m_thread->start();
}

RenderThread::~RenderThread() {
    {
        const std::lock_guard lock(m_mutex);
        m_isStopped = true;
        invalidate();
    }
    m_thread->wait();
}

/// The request has changed, under the lock.
void RenderThread::invalidate() {
    const auto now = Clock::now();
    const bool isPending = m_shown.revision != m_request.revision;
    m_request.isMoving = m_request.isAdaptive && (isPending || (m_motionShown && now - *m_motionShown < kMotion));
    m_request.changed = now;
    m_revision = ++m_request.revision;
    m_changed.notify_all();
}

void RenderThread::show(const std::shared_ptr<const RenderScene>& scene, const RenderView& view) {
    const std::lock_guard lock(m_mutex);
    RenderView unmarked = view;
    unmarked.hovered = m_request.view.hovered;
    const bool isOther = scene != m_request.scene || unmarked != m_request.view;
    m_request.scene = scene;
    m_request.view = view;
    if (isOther) return invalidate();
    m_changed.notify_all();  // a hovered body is marked over the picture
}

void RenderThread::setProgressiveRendering(ProgressiveRendering mode) {
    const std::lock_guard lock(m_mutex);
    if (mode == m_request.progressive) return;
    m_request.progressive = mode;
    if (m_request.revision > 0) invalidate();
}

void RenderThread::setQuality(RenderQuality quality) {
    const std::lock_guard lock(m_mutex);
    if (quality == m_request.quality) return;
    m_request.quality = quality;
    if (m_request.revision > 0) invalidate();
}

void RenderThread::setAdaptive(bool isOn) {
    const std::lock_guard lock(m_mutex);
    m_request.isAdaptive = isOn;
}

RenderedPicture RenderThread::picture() const {
    const std::lock_guard lock(m_mutex);
    return m_picture;
}

bool RenderThread::isCurrent() const {
    const std::lock_guard lock(m_mutex);
    return m_shown.revision == m_request.revision && m_shown.hovered == m_request.view.hovered && m_shown.isSharp;
}

bool RenderThread::isFinished() const {
    const std::lock_guard lock(m_mutex);
    return m_shown.revision == m_request.revision && m_shown.hovered == m_request.view.hovered && isRefined();
}

/// Whether the picture of the request cannot become better.
bool RenderThread::isRefined() const {
    const bool isOn = m_request.progressive == ProgressiveRendering::Always ||
                      (m_request.progressive == ProgressiveRendering::WithGpu && m_hasGpu);
    return m_shown.isSharp && !m_areTexturesPending && (!isOn || m_shown.samples >= maxSamples(m_request.quality));
}

int RenderThread::maxSamples(RenderQuality quality) const {
    const bool isSoftwareGood = quality == RenderQuality::Good && !m_hasGpu;
    return isSoftwareGood ? kGoodSoftwareSamples : samplesOf(quality);
}

bool RenderThread::makeRenderer() {
    if (!m_context->makeCurrent(m_surface.get())) {
        emit failed(tr("The 3D view is unavailable: this display does not support OpenGL."));
        return false;
    }
    Result<std::unique_ptr<Renderer>> renderer = Renderer::create();
    if (!renderer) {
        emit failed(QString::fromStdString(renderer.error().message));
        return false;
    }
    m_renderer = std::move(*renderer);
    m_renderer->setTextureListener([this] {
        const std::lock_guard lock(m_mutex);
        m_isTextureDecoded = true;
        m_changed.notify_all();
    });
    m_buffer = std::make_unique<PictureBuffer>();
    const std::lock_guard lock(m_mutex);
    m_hasGpu = !m_renderer->isSoftware();
    return true;
}

void RenderThread::run() {
    try {
        std::unique_lock lock(m_mutex, std::defer_lock);
        if (makeRenderer()) {
            lock.lock();
            while (!m_isStopped) {
                if (!work(lock)) m_changed.wait(lock);
            }
        }
    } catch (const std::bad_alloc&) {
        abandonContext();
        emit failed(QString::fromStdString(outOfMemory("drawing the fragments").message));
        return;
    }
    m_buffer.reset();
    m_renderer.reset();
    m_context->doneCurrent();
    m_context->moveToThread(thread());
}

/// Leaks the context with all that is in it: where the exception came out of the driver, the driver may hold locks that
/// it never releases, and any call that deletes something would wait for them forever.
void RenderThread::abandonContext() {
    static_cast<void>(m_buffer.release());
    static_cast<void>(m_renderer.release());
    static_cast<void>(m_context.release());
    static_cast<void>(m_surface.release());
}

/// Does what comes next, without the lock; false if there is nothing to do.
bool RenderThread::work(std::unique_lock<std::mutex>& lock) {
    const Request request = m_request;
    const Shown shown = m_shown;
    const auto unlocked = [&](auto draw) {
        lock.unlock();
        draw();
        lock.lock();
        return true;
    };
    if (request.revision == 0) return false;  // nothing to show yet
    if (shown.revision != request.revision) return unlocked([&] { drawChange(request); });
    if (shown.hovered != request.view.hovered) return unlocked([&] { drawHovered(request, shown); });
    if (std::exchange(m_isTextureDecoded, false)) return unlocked([&] { updateTextures(); });
    if (isRefined() || (shown.isSharp && m_areTexturesPending)) return false;
    const auto due = request.changed + kIdle;
    const bool isAtRest = Clock::now() >= due || (!request.isMoving && !shown.isSharp);
    if (!isAtRest) {
        m_changed.wait_until(lock, due);
        return true;
    }
    return unlocked([&] { shown.isSharp ? refine(request) : drawSharp(request); });
}

/// Images that have been decoded are in the next picture.
void RenderThread::updateTextures() {
    const bool isNew = m_renderer->updateTextures();
    const bool arePending = m_renderer->areTexturesPending();
    const std::lock_guard lock(m_mutex);
    m_areTexturesPending = arePending;
    if (isNew) m_shown.isSharp = false;
    if (isNew) m_shown.samples = 0;
}

/// Draws to the buffer; false if it was interrupted.
bool RenderThread::draw(const RenderView& view, std::function<bool()> isInterrupted) {
    m_buffer->resize(view.size);
    m_renderer->setInterruption(std::move(isInterrupted));
    const bool isDone = m_renderer->draw(view, m_buffer->framebuffer());
    if (isDone) m_renderer->finish();
    m_renderer->setInterruption({});
    return isDone;
}

/// In a motion, or if a sharp picture takes long, as fast as it needs to be.
void RenderThread::drawChange(const Request& request) {
    if (request.scene != m_scene) {
        m_renderer->setScene(request.scene);
        m_scene = request.scene;
        updateTextures();
    }
    const bool isQuick = request.isMoving || (request.isAdaptive && m_sharpSeconds > kSlow);
    if (!isQuick) return drawSharp(request);
    RenderView view = request.view;
    view.skyMaps = m_hasGpu ? kMovingSkyMaps : kMovingSoftwareSkyMaps;
    if (!m_hasGpu) {
        view.resolution = m_quality.resolution();
        view.minFragmentPixels = m_quality.minFragmentPixels();
    }
    const auto start = Clock::now();
    const bool isLast = m_quality.isLowest();
    const bool isDone = draw(view, [&] {
        const bool isOutdated = !isLast && m_revision != request.revision && secondsSince(start) > kSlow;
        return isOutdated || m_isStopped;
    });
    if (!m_hasGpu) m_quality.add(secondsSince(start));
    if (isDone) publish(request, {.revision = request.revision, .hovered = request.view.hovered});
}

void RenderThread::drawSharp(const Request& request) {
    const auto start = Clock::now();
    const bool isDone = draw(request.view, [&] { return m_revision != request.revision; });
    m_sharpSeconds = isDone ? secondsSince(start) : std::max(m_sharpSeconds, secondsSince(start));
    if (isDone) publish(request, {.revision = request.revision, .hovered = request.view.hovered, .isSharp = true});
}

/// Marks another body in the last picture.
void RenderThread::drawHovered(const Request& request, Shown shown) {
    if (shown.samples >= kMinShownSamples)
        m_renderer->drawMean(request.view, m_buffer->framebuffer());
    else
        m_renderer->drawAgain(request.view, m_buffer->framebuffer());
    shown.hovered = request.view.hovered;
    publish(request, shown);
}

/// Adds a sample. Shown are those numbers of samples between which a difference is seen.
void RenderThread::refine(const Request& request) {
    Shown shown;
    {
        const std::lock_guard lock(m_mutex);
        shown = m_shown;
    }
    m_renderer->setInterruption([&] { return m_revision != request.revision; });
    const bool isDone = m_renderer->addSample(request.view, shown.samples);
    m_renderer->finish();
    m_renderer->setInterruption({});
    if (!isDone) return;
    ++shown.samples;
    const bool isShown =
        shown.samples >= kMinShownSamples &&
        (std::has_single_bit(static_cast<unsigned>(shown.samples)) || shown.samples == maxSamples(request.quality));
    if (!isShown) {
        const std::lock_guard lock(m_mutex);
        m_shown.samples = shown.samples;
        return;
    }
    m_renderer->drawMean(request.view, m_buffer->framebuffer());
    publish(request, shown);
}

/// Reads the buffer into an image that nobody else holds any more.
void RenderThread::publish(const Request& request, Shown shown) {
    const QSize size(request.view.size.width, request.view.size.height);
    const auto isFree = [&](const QImage& image) { return image.isDetached() && image.size() == size; };
    auto free = std::ranges::find_if(m_images, isFree);
    if (free == m_images.end()) {
        std::erase_if(m_images, [&](const QImage& image) { return image.size() != size; });
        free = m_images.insert(m_images.end(), QImage(size, QImage::Format_RGB32));
        if (free->isNull()) throw std::bad_alloc();
    }
    m_buffer->read(free->bits(), static_cast<std::size_t>(free->bytesPerLine()));
    {
        const std::lock_guard lock(m_mutex);
        const bool isChange = m_shown.revision != shown.revision;
        m_shown = shown;
        m_picture = {*free, request.view.camera};
        if (isChange)
            m_motionShown = Clock::now();
        else if (shown.isSharp)
            m_motionShown.reset();
    }
    emit pictureChanged();
}

}  // namespace rubble

#include "moc_RenderThread.cpp"
