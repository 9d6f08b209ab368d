#pragma once

#include "viewport/widget/RenderThread.h"

#include <QWidget>

namespace rubble {

/// Shows the pictures of a RenderThread, which has work to do only while they can be seen.
class ViewportCanvas : public QWidget {
    Q_OBJECT
public:
    explicit ViewportCanvas(QWidget* parent = nullptr);

    /// Errors: throws std::bad_alloc if there is not the memory to draw a scene with new geometry in software.
    void setScene(std::shared_ptr<const RenderScene> scene);
    /// The view's size is ignored: the widget's is used.
    void setView(const RenderView& view);
    void setProgressiveRendering(ProgressiveRendering mode) { m_thread.setProgressiveRendering(mode); }
    void setQuality(RenderQuality quality) { m_thread.setQuality(quality); }
    void setAdaptive(bool isOn) { m_thread.setAdaptive(isOn); }

    /// The widget's size in device pixels.
    ImageSize imageSize() const;
    /// The camera of the picture on screen.
    const Camera& shownCamera() const { return m_picture.camera; }
    bool hasPicture() const { return !m_picture.image.isNull(); }

    /// Whether the picture shows the scene and the view as they are now, sharply.
    bool isCurrent();
    /// Whether it will not be refined any further either.
    bool isFinished();

signals:
    /// A picture is on screen.
    void drawn();
    /// Rendering is not possible, for the given reason.
    void failed(const QString& sentence);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void invalidate();
    void synchronize();
    RenderView sizedView() const;

    RenderThread m_thread;
    std::shared_ptr<const RenderScene> m_scene;
    RenderView m_view;
    bool m_isSynchronized = false;
    RenderedPicture m_picture;
    bool m_isNew = false;  // the picture has not been painted yet
};

}  // namespace rubble
