#pragma once

#include "core/geometry/Ray.h"

#include <QObject>
#include <QPointF>

#include <optional>

class QKeyEvent;
class QMouseEvent;

namespace rubble {

class PlayController;
class ViewportWidget;

/// What mouse and keys do in the 3D view while a project is played: F, held to charge, throws at the pointer; H strikes, X
/// blows up, dragging with the left button draws what is there about; P, . and R pause, step and reset, Escape stops. All else
/// is the view's own.
class PlayHands : public QObject {
    Q_OBJECT
public:
    PlayHands(PlayController& controller, ViewportWidget& viewport);

    /// Of a throw that is being charged, in (0, 1].
    std::optional<double> charge() const;
    /// Says again what is aimed at: the view or the charge may have changed.
    void aimAgain();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool press(const QKeyEvent& event);
    bool release(const QKeyEvent& event);
    bool pressButton(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool releaseButton(const QMouseEvent& event);
    void letThrowGo();
    Ray ray() const;

    PlayController& m_controller;
    ViewportWidget& m_viewport;
    QPointF m_pointer;
    bool m_isPointing = false;              // the pointer is in the view
    std::optional<double> m_chargingSince;  // s
    std::optional<QPointF> m_pressedAt;     // by the left button, until it lets go or grabs
    bool m_isGrabbing = false;
};

}  // namespace rubble
