#pragma once

#include "editor/PlayHands.h"
#include "editor/PlayHud.h"
#include "editor/play/PlayController.h"

#include <QTimer>

namespace rubble {

class ViewportWidget;

/// Shows what is played in a 3D view: its moments as they come, and between them where things are on their way; figures over it.
class PlayView : public QObject {
    Q_OBJECT
public:
    PlayView(PlayController& controller, ViewportWidget& viewport);

    /// Draws what there is now. Done by itself some sixty times a second.
    void refresh();

private:
    void takeState();
    void showFrame();
    PlayHud::Content content() const;
    QStringList figures() const;
    void countPicture();

    PlayController& m_controller;
    ViewportWidget& m_viewport;
    PlayHands m_hands;
    PlayHud* m_hud;
    QTimer m_timer;
    const RenderScene* m_shown = nullptr;
    double m_countedSince = 0.0;  // s
    int m_counted = 0;            // pictures since
    int m_picturesPerSecond = 0;
};

}  // namespace rubble
