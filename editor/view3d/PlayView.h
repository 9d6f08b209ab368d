#pragma once

#include "editor/play/PlayController.h"
#include "editor/view3d/PlayHud.h"
#include "editor/view3d/tools/PlayTool.h"

#include <QTimer>

namespace rubble {

class ViewportWidget;

/// Shows a session in a 3D view: its frames, interpolated, with a head-up display.
class PlayView : public QObject {
    Q_OBJECT
public:
    PlayView(PlayController& controller, ViewportWidget& viewport);

    /// Draws the current frame; called automatically about sixty times a second while the view is shown and anything
    /// moves in it.
    void refresh();

    /// Whether frame rate, bodies and computing times are shown; initially not.
    void setStatisticsShown(bool isOn);

    PlayTool& tool() { return m_tool; }
    PlayHud& hud() { return *m_hud; }

    /// Whether refresh() is called again and again.
    bool isTicking() const { return m_timer.isActive(); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void updateState();
    void updateTimer();
    bool isShown() const;
    bool isAnimated() const;
    void showFrame();
    PlayHud::Content content() const;
    static QString collapseText(const CollapseForecast& collapse);
    void setGrab(PlayHud::Content& content, const GrabbedBody& grabbed) const;
    QStringList statisticsLines() const;
    void updateFrameRate();
    void restartCount();

    PlayController& m_controller;
    ViewportWidget& m_viewport;
    PlayTool m_tool;
    PlayHud* m_hud;
    QTimer m_timer;
    bool m_isInPlay = false;
    const RenderScene* m_shown = nullptr;
    double m_countedSince = 0.0;           // s
    int m_counted = 0;                     // frames drawn since
    std::optional<int> m_framesPerSecond;  // none before it was measured, and while nothing changes
    bool m_hasStatistics = false;
};

}  // namespace rubble
