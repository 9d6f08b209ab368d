#pragma once

#include "viewport/render/Renderer.h"
#include "viewport/widget/AdaptiveQuality.h"
#include "viewport/widget/ProgressiveRendering.h"

#include <QImage>
#include <QObject>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

class QOffscreenSurface;
class QOpenGLContext;
class QThread;

namespace rubble {

class PictureBuffer;

/// A picture that a RenderThread has finished.
struct RenderedPicture {
    QImage image;  // device pixels; null before the first one
    Camera camera;
};

/// Renders a scene on a thread of its own, so that the window responds however long a picture takes. While changes
/// follow one another, pictures are as sharp as the time for them allows; at rest they are refined step by step. A
/// picture that shows what is no longer wanted is abandoned if it takes long.
///
/// All functions are called in the thread of the application.
class RenderThread : public QObject {
    Q_OBJECT
public:
    explicit RenderThread(QObject* parent = nullptr);
    ~RenderThread() override;

    /// Sets what pictures show from now on.
    void show(const std::shared_ptr<const RenderScene>& scene, const RenderView& view);
    void setProgressiveRendering(ProgressiveRendering mode);
    /// Sets what pictures are refined to; initially good.
    void setQuality(RenderQuality quality);
    /// Whether pictures of a motion may be less sharp.
    void setAdaptive(bool isOn);

    /// The last finished picture.
    RenderedPicture picture() const;
    /// Whether that shows the scene and the view that were set last, sharply.
    bool isCurrent() const;
    /// Whether it will not be refined any further either.
    bool isFinished() const;

signals:
    void pictureChanged();
    /// Nothing can be rendered any more, for the given reason.
    void failed(const QString& sentence);

private:
    using Clock = std::chrono::steady_clock;

    /// What pictures shall show.
    struct Request {
        std::shared_ptr<const RenderScene> scene;
        RenderView view;
        ProgressiveRendering progressive = ProgressiveRendering::Never;
        RenderQuality quality = RenderQuality::Good;
        std::uint64_t revision = 0;  // counts changes of all but the hovered body
        bool isMoving = false;       // changes follow one another
        bool isAdaptive = true;
        Clock::time_point changed;
    };
    /// What the last picture shows.
    struct Shown {
        std::uint64_t revision = 0;
        std::optional<std::uint32_t> hovered;
        bool isSharp = false;
        int samples = 0;  // accumulated, though shown only now and then
    };

    void invalidate();
    bool isRefined() const;
    int maxSamples(RenderQuality quality) const;
    void updateTextures();

    void run();
    bool makeRenderer();
    void abandonContext();
    bool work(std::unique_lock<std::mutex>& lock);
    void drawChange(const Request& request);
    void drawSharp(const Request& request);
    void refine(const Request& request);
    bool draw(const RenderView& view, std::function<bool()> isInterrupted);
    void drawHovered(const Request& request, Shown shown);
    void publish(const Request& request, Shown shown);

    std::unique_ptr<QOffscreenSurface> m_surface;
    std::unique_ptr<QOpenGLContext> m_context;

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::atomic<std::uint64_t> m_revision = 0;  // of the request, as is the next
    std::atomic<bool> m_isStopped = false;
    // Guarded by the mutex:
    Request m_request;
    Shown m_shown;
    RenderedPicture m_picture;
    std::optional<Clock::time_point> m_motionShown;  // when the last picture of a change was finished
    bool m_hasGpu = false;
    bool m_isTextureDecoded = false;  // since the last look
    bool m_areTexturesPending = false;

    // Of the thread:
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<PictureBuffer> m_buffer;
    std::shared_ptr<const RenderScene> m_scene;
    std::vector<QImage> m_images;  // of which one is on screen and one was before
    AdaptiveQuality m_quality;
    double m_sharpSeconds = 0.0;  // that the last sharp picture took
    std::unique_ptr<QThread> m_thread;
};

}  // namespace rubble
