#pragma once

#include "viewport/widget/ViewportOverlay.h"

#include <QDropEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

namespace rubble {

/// Handles the input of a 3D view before its navigation and picking, and paints over it. See
/// ViewportWidget::setTools().
///
/// The handlers of mouse, wheel, keys and drops return true if they consume the event: then neither tools of lower
/// priority nor the view itself receive it.
class ViewportTool : public OverlayItem {
    Q_OBJECT
public:
    using OverlayItem::OverlayItem;

    virtual bool press(const QMouseEvent& /*event*/) { return false; }
    virtual bool doubleClick(const QMouseEvent& event) { return press(event); }
    /// Also called while no button is held.
    virtual bool move(const QMouseEvent& /*event*/) { return false; }
    virtual bool release(const QMouseEvent& /*event*/) { return false; }
    virtual bool wheel(const QWheelEvent& /*event*/) { return false; }
    virtual bool keyPress(const QKeyEvent& /*event*/) { return false; }
    virtual bool keyRelease(const QKeyEvent& /*event*/) { return false; }
    /// Whether the tool handles this key in place of an action that has it as shortcut.
    virtual bool overridesShortcut(const QKeyEvent& /*event*/) const { return false; }
    /// Whether the tool suppresses the context menu about to be opened.
    virtual bool suppressesContextMenu() { return false; }

    /// Something is dragged over the view, or dropped (see event.type()).
    virtual bool drag(QDropEvent& /*event*/) { return false; }
    virtual void dragLeave() {}

    virtual void enter(QPointF /*position*/) {}
    virtual void leave() {}
    virtual void focusLost() {}

    /// Cancels the current action and restores the state before it; false if there is none.
    virtual bool cancel() { return false; }

signals:
    /// The status bar's hint on what the tool can do now; empty if there is none.
    void hintChanged(const QString& hint);
    /// A message for the status bar.
    void statusMessage(const QString& message);
};

}  // namespace rubble
