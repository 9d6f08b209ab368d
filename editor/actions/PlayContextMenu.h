#pragma once

#include "viewport/scene/RenderScene.h"

#include <QMenu>

#include <optional>

namespace rubble {

class Views;

/// The menu of a right click on a body in play: removing it, what would fall without it, framing it, and keeping its
/// instance from breaking.
class PlayContextMenu : public QObject {
    Q_OBJECT
public:
    /// `whatWouldFall`: the action of the overlay.
    PlayContextMenu(Views& views, QAction* whatWouldFall);

private:
    void open(const QPoint& point);
    void fill(const PickId& pick, const QPoint& point);
    void frame(const PickId& pick);
    void setUnbreakable(Id instance, bool isUnbreakable);

    Views& m_views;
    QAction* m_whatWouldFall;
    QMenu* m_menu;
};

}  // namespace rubble
