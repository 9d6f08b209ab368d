#pragma once

#include "viewport/Navigation.h"
#include "viewport/Refining.h"
#include "viewport/render/RenderSettings.h"
#include "viewport/scene/RenderScene.h"

#include <QVariantAnimation>
#include <QWidget>

#include <memory>
#include <optional>

class QLabel;
class QRubberBand;

namespace rubble {

class ViewportCanvas;

/// The 3D view: shows the scene that it is given, lets the user move around in it, and tells what is clicked. It asks
/// nobody and changes nothing but its camera. Where there is no OpenGL, a sentence stands in its place.
///
/// Mouse and keys: see NavigationStyle and viewKeyOf(). A click with the left button picks; a drag with it draws a box around
/// what is to be picked.
class ViewportWidget : public QWidget {
    Q_OBJECT
public:
    explicit ViewportWidget(QWidget* parent = nullptr);

    /// The scene that is shown from now on. The camera stays; the first scene that is not empty is framed.
    void setScene(std::shared_ptr<const RenderScene> scene);
    const RenderScene& scene() const { return *m_scene; }

    /// Which moment of a scene in motion is shown, in [0, 1]: 0 where bodies were a step before, 1 where they are.
    void setMoment(double moment);

    /// What lies behind a point of the widget.
    Ray rayAt(QPointF point) const;
    /// What is seen at a point of the widget; nothing where that is the background.
    std::optional<PickId> pickAt(QPointF point) const;
    /// Where a point of the world is seen in the widget; nothing where it lies behind the eye.
    std::optional<QPointF> pointOf(Vec3 place) const;

    void setSettings(const RenderSettings& settings);
    const RenderSettings& settings() const { return m_settings; }
    void setNavigation(NavigationStyle style) { m_style = style; }
    /// Whether views change by a short flight or at once.
    void setFlights(bool areOn) { m_hasFlights = areOn; }
    /// Whether light and edges become softer while nothing changes; slow without a graphics card.
    void setRefining(Refining refining);

    /// Where the camera is, or flies to.
    const Camera& camera() const { return m_goal; }
    /// From where the picture is seen now.
    const Camera& shownCamera() const { return m_camera; }
    /// Moves the camera at once.
    void setCamera(const Camera& camera);
    /// These fly.
    void turnTo(StandardView view);
    void setProjection(Projection projection);
    void frameAll();
    /// What is selected, or all.
    void frameSelected();
    void frame(const Box3& box);

    /// Its size in pixels of the display.
    PictureSize pictureSize() const;
    /// What keeps pictures from being drawn; empty where nothing does.
    QString fault() const;

    QSize sizeHint() const override { return {640, 480}; }

signals:
    /// Something was clicked; nothing where the background was.
    void picked(const std::optional<rubble::PickId>& pick, Qt::KeyboardModifiers modifiers);
    /// A box was drawn around the middles of these.
    void boxed(const std::vector<rubble::PickId>& picks, Qt::KeyboardModifiers modifiers);
    /// What lies under the pointer changed.
    void hovered(const std::optional<rubble::PickId>& pick);
    /// The camera's goal changed.
    void cameraChanged();

protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void showFault(const QString& sentence);
    void flyTo(const Camera& camera);
    void showFrom(const Camera& camera);
    void hover(std::optional<std::uint32_t> body);
    void apply(const ViewKey& key);
    Vec2 pixels(QPointF point) const;
    void endBox(Qt::KeyboardModifiers modifiers);
    std::optional<PickId> pickOf(std::optional<std::uint32_t> body) const;

    ViewportCanvas* m_canvas = nullptr;  // null where there is no OpenGL
    QLabel* m_fault = nullptr;           // null where there is
    std::shared_ptr<const RenderScene> m_scene;
    double m_moment = 1.0;
    RenderSettings m_settings;
    NavigationStyle m_style = NavigationStyle::Blender;
    bool m_hasFlights = true;
    bool m_isFramed = false;
    Camera m_camera;  // that is seen
    Camera m_start;   // of the flight
    Camera m_goal;
    QVariantAnimation m_flight;
    std::optional<Drag> m_drag;
    bool m_isClick = false;  // the left button is down and was not moved
    QRubberBand* m_box;      // visible while one is drawn
    QPointF m_pressedAt;
    QPointF m_lastAt;
    std::optional<std::uint32_t> m_hovered;
};

}  // namespace rubble
