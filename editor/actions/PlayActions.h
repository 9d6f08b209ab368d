#pragma once

#include <QObject>

class QAction;
class QActionGroup;
class QMenu;

namespace rubble {

class EventActions;
class SoundActions;
class TimelineActions;
class VideoActions;
class PlayContextMenu;
class PlayController;
class PreferenceStore;
struct PlayScript;
class Views;
class Workspace;

/// The Play menu: running the simulation, its shots, replays and videos.
class PlayActions : public QObject {
    Q_OBJECT
public:
    PlayActions(Views& views, PreferenceStore& preferences, VideoActions& video);

    QMenu* menu() const { return m_menu; }
    QList<QAction*> toolbarActions() const { return {m_play, m_pause, m_step, m_reset}; }

    /// Starts the simulation in the 3D view, which gets the keyboard focus.
    void start();
    /// Pauses the simulation at the moment of a state file.
    void loadState(const QString& path);

private:
    void addRun();
    void addTools();
    void addSpeeds();
    void addTimeSteps();
    void addOverlays();
    void addStatistics(QMenu& menu);
    void addShots();
    void addReplays();
    void startOrStop();
    void pauseOrResume();
    void fillShots();
    void saveShot();
    void saveReplay();
    void writeReplay(const QString& path, const PlayScript& script);
    void openReplay();
    void exportAnimation();
    void writeAnimation(const QString& path, PlayScript script);
    void addStates();
    void saveState();
    void openState();
    void updateState();
    void updateRecorded();
    QList<QAction*> ownActions() const;
    PlayController& controller() const;

    Views& m_views;
    Workspace& m_workspace;
    PreferenceStore& m_preferences;
    VideoActions& m_video;
    TimelineActions* m_timeline = nullptr;
    EventActions* m_events;
    QMenu* m_menu;
    QAction* m_play = nullptr;
    QAction* m_pause = nullptr;
    QAction* m_step = nullptr;
    QAction* m_reset = nullptr;
    QList<QAction*> m_tools;  // throw, hammer and blast
    QAction* m_destruction = nullptr;
    PlayContextMenu* m_contextMenu = nullptr;
    SoundActions* m_sound = nullptr;
    QAction* m_saveShot = nullptr;
    QAction* m_saveReplay = nullptr;
    QAction* m_saveState = nullptr;
    QAction* m_exportAnimation = nullptr;
    QMenu* m_shots = nullptr;
    QActionGroup* m_speeds = nullptr;
    QActionGroup* m_timeSteps = nullptr;
};

}  // namespace rubble
