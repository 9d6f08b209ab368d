#pragma once

#include "viewport/Refining.h"
#include "viewport/render/Renderer.h"

#include <QOpenGLWidget>
#include <QTimer>

#include <memory>
#include <optional>

namespace rubble {

/// The part of a viewport that OpenGL draws: shows a view of a scene and tells what lies at a point. Draws when something
/// changed, and never else.
class ViewportCanvas : public QOpenGLWidget {
    Q_OBJECT
public:
    explicit ViewportCanvas(QWidget* parent = nullptr);
    ~ViewportCanvas() override;

    void setScene(std::shared_ptr<const RenderScene> scene);
    /// The size is the widget's own, whatever the view's is.
    void setView(const PictureView& view);
    /// Whether light and edges become softer while nothing changes.
    void setRefining(Refining refining);

    /// The widget's size in pixels of the display.
    PictureSize pictureSize() const;
    /// The body at a point of the widget, as an index in RenderScene::picks.
    std::optional<std::uint32_t> bodyAt(QPointF point);

signals:
    /// There is nothing to draw with, for the reason that the sentence says.
    void failed(const QString& sentence);

protected:
    void initializeGL() override;
    void paintGL() override;

private:
    void invalidate();
    bool mayRefine() const;
    void refine();
    void release();
    PictureView sizedView() const;

    std::unique_ptr<Renderer> m_renderer;  // null before the widget is shown and while it changes its window
    std::shared_ptr<const RenderScene> m_scene;
    PictureView m_view;
    bool m_hasCard = false;  // once there is a renderer
    Refining m_refining = Refining::Never;
    int m_samples = 0;  // taken since something changed
    QTimer m_idle;
};

}  // namespace rubble
