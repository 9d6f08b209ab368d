#pragma once

#include <QObject>

class QAction;
class QActionGroup;
class QComboBox;
class QMenu;

namespace rubble {

class FilmExport;
class MainWindow;
class PlayController;

/// Play menu: begins, pauses and ends the play, fires and keeps shots, and takes what was played to a file and back.
class PlayActions : public QObject {
    Q_OBJECT
public:
    explicit PlayActions(MainWindow& window);

    QMenu* menu() const { return m_menu; }
    QList<QAction*> toolbarActions() const { return {m_play, m_pause, m_step, m_reset}; }
    FilmExport& film() const { return *m_film; }
    /// On the start page there is nothing to play.
    void setWorking(bool isWorking);

private:
    void addRun();
    void addSpeeds();
    void addOverlays();
    void addShots();
    void addReplays();
    void toggle();
    void togglePause();
    void fillShots();
    void keepShot();
    void saveReplay();
    void openReplay();
    void update();
    void updateRecorded();
    PlayController& controller() const;

    MainWindow& m_window;
    FilmExport* m_film;
    QMenu* m_menu;
    QAction* m_play = nullptr;
    QAction* m_pause = nullptr;
    QAction* m_step = nullptr;
    QAction* m_reset = nullptr;
    QAction* m_destruction = nullptr;
    QAction* m_keep = nullptr;
    QAction* m_saveReplay = nullptr;
    QMenu* m_shots = nullptr;
    QActionGroup* m_speeds = nullptr;
    bool m_isWorking = false;
};

}  // namespace rubble
