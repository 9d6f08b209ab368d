#pragma once

#include "viewport/render/Renderer.h"
#include "viewport/widget/AdaptiveResolution.h"
#include "viewport/widget/ProgressiveRendering.h"

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>

#include <memory>
#include <optional>

namespace rubble {

/// The OpenGL surface of a viewport: renders a view of a scene, only when something has changed, and finds the body at
/// a point. While something moves, the resolution may be lower; at rest, the picture is refined.
class ViewportCanvas : public QOpenGLWidget {
    Q_OBJECT
public:
    explicit ViewportCanvas(QWidget* parent = nullptr);
    ~ViewportCanvas() override;

    void setScene(std::shared_ptr<const RenderScene> scene);
    /// The view's size is ignored: the widget's is used.
    void setView(const RenderView& view);
    void setProgressiveRendering(ProgressiveRendering mode);
    void setAdaptive(bool isOn) { m_isAdaptive = isOn; }

    /// The widget's size in device pixels.
    ImageSize imageSize() const;
    /// The body at a point of the widget, an index in RenderScene::picks.
    std::optional<std::uint32_t> bodyAt(QPointF point);

signals:
    /// Rendering is not possible, for the given reason.
    void failed(const QString& sentence);

protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;

private:
    void invalidate();
    bool canAccumulate() const;
    int sampleLimit() const;
    void draw();
    void measure();
    void rest();
    void release();
    RenderView sizedView() const;

    std::unique_ptr<Renderer> m_renderer;  // null before the widget is shown and while it moves to another window
    std::shared_ptr<const RenderScene> m_scene;
    RenderView m_view;
    bool m_hasGpu = false;  // known once there is a renderer
    ProgressiveRendering m_progressive = ProgressiveRendering::Never;
    enum class Drawn { Nothing, Moving, Resting };
    Drawn m_drawn = Drawn::Nothing;  // since the last change
    int m_samples = 0;               // accumulated since the last change
    bool m_isAdaptive = true;
    bool m_isMoving = false;  // changes follow one another
    bool m_isAtRest = false;  // since the last change, rest() was called
    AdaptiveResolution m_resolution;
    QElapsedTimer m_begun;  // since an image was begun, until it is shown
    QElapsedTimer m_shown;  // since one that a change made was
    QTimer m_idle;
};

}  // namespace rubble
