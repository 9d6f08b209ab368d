#pragma once

#include "viewport/render/RenderSettings.h"
#include "viewport/scene/RenderScene.h"
#include "viewport/widget/Navigation.h"
#include "viewport/widget/ProgressiveRendering.h"

#include <QRect>
#include <QVariantAnimation>
#include <QWidget>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

class QLabel;
class QRubberBand;

namespace rubble {

class OverlayItem;
class ScaleBarItem;
struct ScaleUnit;
class ViewportCanvas;
class ViewportOverlay;
class ViewportTool;

/// A 3D view of a render scene with camera navigation and picking. Without OpenGL it shows an error text instead.
///
/// Mouse and keys: see NavigationStyle and viewKeyOf(). A left click picks; a left drag draws a selection rectangle.
/// Tools receive all input first.
class ViewportWidget : public QWidget {
    Q_OBJECT
public:
    explicit ViewportWidget(QWidget* parent = nullptr);

    /// Sets the scene. The camera stays; the first scene that is not empty is framed.
    void setScene(std::shared_ptr<const RenderScene> scene);
    const RenderScene& scene() const { return *m_scene; }
    std::shared_ptr<const RenderScene> sharedScene() const { return m_scene; }

    /// Interpolates between the previous poses (0) and the current ones (1).
    void setStepFraction(double stepFraction);
    double stepFraction() const { return m_stepFraction; }

    /// The ray through a point of the widget.
    Ray rayAt(QPointF point) const;
    /// The body at a point of the widget; nothing for the background.
    std::optional<PickId> pickAt(QPointF point) const;
    /// Projects a point of the world to the widget; nothing if it lies behind the eye.
    std::optional<QPointF> pointOf(Vec3 position) const;
    /// What can be seen of a line in the world, with some that is beside the widget; nothing if there is none.
    std::optional<QLineF> lineOf(Vec3 from, Vec3 to) const;

    /// Sets the tools in the order in which they receive input. They must outlive the view's event handling.
    void setTools(std::vector<ViewportTool*> tools) { m_tools = std::move(tools); }
    /// Sets what is painted over the view, from first to last.
    void setOverlayItems(const std::vector<OverlayItem*>& items);

    /// The rectangles of texts at the edges of the view; none without overlays.
    std::vector<QRect> plates() const;

    /// While presenting, the view shows the scene alone, without overlays, outlines and marks. Escape ends it.
    void setPresenting(bool isOn);
    bool isPresenting() const { return m_isPresenting; }
    /// Whether overlays, outlines and marks are shown otherwise; initially they are.
    void setOverlaysOn(bool isOn);
    /// Whether they are shown now.
    bool hasOverlays() const { return m_settings.hasOverlays; }

    void setSettings(const RenderSettings& settings);
    const RenderSettings& settings() const { return m_settings; }
    void setNavigation(NavigationStyle style) { m_navigation = style; }
    /// The unit of the scale bar.
    void setScaleUnit(const ScaleUnit& unit);
    /// Whether camera changes are animated.
    void setCameraAnimation(bool isOn) { m_isAnimated = isOn; }
    void setProgressiveRendering(ProgressiveRendering mode);
    /// Sets what the view is refined to; initially good.
    void setQuality(RenderQuality quality);
    /// Whether the view may be drawn less sharply while something moves, to move smoothly. Without, pictures do not
    /// depend on the speed of the machine.
    void setAdaptive(bool isOn);

    /// The camera; during an animation, its goal.
    const Camera& camera() const { return m_goal; }
    /// The camera that the animation has reached; while the overlay is painted, that of the picture below it.
    const Camera& shownCamera() const { return m_painted ? *m_painted : m_camera; }
    /// Sets the camera without animation.
    void setCamera(const Camera& camera);
    /// The following changes of the camera are animated.
    void alignTo(StandardView view);
    void setProjection(Projection projection);
    void frameAll();
    /// Frames the selected bodies; all if there are none.
    void frameSelected();
    /// Frames a box between the plates. It stays framed when the size or the plates change, until the camera is moved.
    void frame(const Box3& box);
    /// The same, with the orientation of another camera.
    void frameFrom(const Camera& orientation, const Box3& box);

    /// Whether the picture shows the scene as it is now, sharply. Pictures are rendered on another thread.
    bool isPictureCurrent();
    /// Whether it will not be refined any further either.
    bool isPictureFinished();

    /// The size in device pixels.
    ImageSize imageSize() const;
    /// Why nothing can be rendered; empty if it can.
    QString errorText() const;

    QSize sizeHint() const override { return {640, 480}; }

signals:
    /// A body was clicked, or the background.
    void picked(const std::optional<rubble::PickId>& pick, Qt::KeyboardModifiers modifiers);
    /// The centres of these bodies lie in a selection rectangle.
    void boxSelected(const std::vector<rubble::PickId>& picks, Qt::KeyboardModifiers modifiers);
    /// The body under the pointer changed.
    void hovered(const std::optional<rubble::PickId>& pick);
    /// The camera's goal changed.
    void cameraChanged();
    /// A frame was drawn and shown.
    void drawn();
    void presentingChanged(bool isOn);
    /// hasOverlays() changed.
    void overlaysChanged(bool isOn);

protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    bool dispatchToTools(QEvent& event);
    bool endsPresenting(QEvent& event);
    void updateOverlays();
    Camera framed(const Camera& orientation, const Box3& box) const;
    void refit();
    void moveCamera(const Camera& camera);
    void showError(const QString& sentence);
    void animateTo(const Camera& camera);
    void showFrom(const Camera& camera);
    void hover(std::optional<std::uint32_t> body);
    void apply(const ViewKey& key);
    Vec2 pixels(QPointF point) const;
    void endBoxSelection(Qt::KeyboardModifiers modifiers);
    void cancelClick();
    std::optional<std::uint32_t> bodyAt(QPointF point) const;
    std::optional<PickId> pickOf(std::optional<std::uint32_t> body) const;

    ViewportCanvas* m_canvas = nullptr;  // null if there is no OpenGL
    QLabel* m_errorLabel = nullptr;      // null if there is
    ScaleBarItem* m_scaleBar;
    ViewportOverlay* m_overlay;
    bool m_isPresenting = false;
    bool m_areOverlaysOn = true;
    std::vector<ViewportTool*> m_tools;
    std::shared_ptr<const RenderScene> m_scene;
    double m_stepFraction = 1.0;
    RenderSettings m_settings;
    NavigationStyle m_navigation = NavigationStyle::Blender;
    bool m_isAnimated = true;
    bool m_isFramed = false;          // once, for the first scene
    std::optional<Box3> m_framed;     // by the camera, until it is moved
    ImageStrips m_strips;             // for which it was framed
    Camera m_camera;                  // on screen
    std::optional<Camera> m_painted;  // of the picture, while the overlay is painted
    friend class ViewportOverlay;
    Camera m_start;  // of the animation
    Camera m_goal;   // of the animation
    QVariantAnimation m_animation;
    std::optional<Drag> m_drag;
    bool m_isClick = false;     // the left button is down and the pointer has not moved
    QRubberBand* m_rubberBand;  // visible during box selection
    QPointF m_pressedAt;
    QPointF m_lastAt;
    std::optional<std::uint32_t> m_hovered;
};

}  // namespace rubble
