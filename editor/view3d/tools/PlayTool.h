#pragma once

#include "core/geometry/hull/Ray.h"
#include "editor/widgets/numbers/Units.h"
#include "viewport/widget/ViewportTool.h"

#include <QAction>
#include <QList>
#include <QPointF>

#include <optional>

namespace rubble {

class PlayController;
class ViewportWidget;

/// The tool of play: F throws at the pointer, harder if it is held, and so does a click if that is set; H hits with a
/// hammer, X sets off a blast, dragging with the left button grabs a body; Escape stops. Inactive unless the
/// controller is in play.
class PlayTool : public ViewportTool {
    Q_OBJECT
public:
    PlayTool(PlayController& controller, ViewportWidget& viewport);

    /// The charge of the throw being charged, in [0, 1].
    std::optional<double> charge() const;
    void setUnits(const Units& units) { m_units = units; }
    /// Actions of the simulation whose shortcuts the tool takes in play, also while they are disabled: outside of play
    /// the view has other meanings for them.
    void setActions(const QList<QAction*>& actions) { m_actions = actions; }

    /// Act at the pointer; at the centre of the view while the pointer is elsewhere, as in a menu. Ignored unless in
    /// play.
    void throwAtPointer();
    void hammerAtPointer();
    void explodeAtPointer();

    /// Updates the aimed throw to the view and the charge.
    void updateAim();

    bool press(const QMouseEvent& event) override;
    /// The second of two quick clicks throws as the first one does.
    bool doubleClick(const QMouseEvent& event) override;
    bool move(const QMouseEvent& event) override;
    bool release(const QMouseEvent& event) override;
    /// With Ctrl, changes the radius of the blast.
    bool wheel(const QWheelEvent& event) override;
    bool keyPress(const QKeyEvent& event) override;
    bool keyRelease(const QKeyEvent& event) override;
    bool overridesShortcut(const QKeyEvent& event) const override;
    void enter(QPointF position) override;
    void leave() override;
    void focusLost() override;
    /// Cancels the charging of a throw.
    bool cancel() override;
    void paint(QPainter& /*painter*/, QSize /*size*/) const override {}  // see PlayHud

signals:
    /// A throw is being charged: see charge().
    void chargingStarted();

private:
    void throwCharged();
    void throwWith(double charge);
    Ray ray() const;
    QAction* actionOf(const QKeyEvent& event) const;

    PlayController& m_controller;
    ViewportWidget& m_viewport;
    QPointF m_pointer;
    bool m_isPointing = false;              // the pointer is in the view
    std::optional<double> m_chargingSince;  // clock time, s
    std::optional<QPointF> m_pressedAt;     // by the left button, until it is released or starts to grab
    bool m_isGrabbing = false;
    Units m_units;
    QList<QAction*> m_actions;
};

}  // namespace rubble
