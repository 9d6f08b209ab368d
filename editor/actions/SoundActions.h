#pragma once

#include <QObject>

#include <memory>

class QAction;
class QActionGroup;
class QMenu;

namespace rubble {

class PreferenceStore;
class SoundPlayer;
class Views;

/// The switch of the sound in play and its volume, which are the same in all windows and kept. The audio device is
/// asked for when the simulation starts or the menu is shown, since that may take a moment.
class SoundActions : public QObject {
    Q_OBJECT
public:
    /// Adds the actions to the Play menu.
    SoundActions(Views& views, PreferenceStore& preferences, QMenu& menu);
    ~SoundActions() override;

    QAction* action() const { return m_action; }
    /// What plays; null until it is needed.
    SoundPlayer* player() const { return m_player.get(); }

private:
    void addVolumes(QMenu& menu);
    void createPlayer();
    void setOn(bool isOn);
    void applyPreferences();
    void updateAvailability();
    void updateHearing();
    void updateListener();
    bool isHeard() const;
    bool eventFilter(QObject* watched, QEvent* event) override;

    Views& m_views;
    PreferenceStore& m_preferences;
    QAction* m_action = nullptr;
    QActionGroup* m_volumes = nullptr;
    std::shared_ptr<SoundPlayer> m_player;
    bool m_isAtRest = false;  // nothing moves in the simulation that could be heard
};

}  // namespace rubble
