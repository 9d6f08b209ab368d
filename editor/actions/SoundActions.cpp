#include "editor/actions/SoundActions.h"

#include "editor/play/PlayController.h"
#include "editor/sound/SoundPlayer.h"
#include "editor/view3d/SceneView.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/widgets/Icon.h"
#include "editor/workspace/PreferenceStore.h"
#include "editor/workspace/Workspace.h"
#include "viewport/video/CameraListener.h"
#include "viewport/widget/ViewportWidget.h"

#include <QActionGroup>
#include <QEvent>
#include <QLocale>
#include <QMainWindow>
#include <QMenu>

namespace rubble {

namespace {

constexpr int kVolumes[] = {25, 50, 75, 100};  // %

}  // namespace

SoundActions::SoundActions(Views& views, PreferenceStore& preferences, QMenu& menu)
    : QObject(&views.window()), m_views(views), m_preferences(preferences) {
    m_action = makeAction(this, {"play-sound", tr("&Sound"), tr("Hear what hits and breaks")});
    m_action->setCheckable(true);
    menu.addAction(m_action);
    addVolumes(menu);
    applyPreferences();
    connect(m_action, &QAction::triggered, this, &SoundActions::setOn);
    connect(&menu, &QMenu::aboutToShow, this, &SoundActions::createPlayer);
    connect(&preferences, &PreferenceStore::changed, this, &SoundActions::applyPreferences);
    const PlayController& play = views.workspace().play();
    connect(&play, &PlayController::stateChanged, this, &SoundActions::updateHearing);
    connect(&play, &PlayController::frameChanged, this, [this, &play] {
        updateListener();
        if (play.frame() && play.frame()->isAtRest != m_isAtRest) updateHearing();
    });
    connect(&views.scene().viewport(), &ViewportWidget::cameraChanged, this, &SoundActions::updateListener);
    views.window().installEventFilter(this);
}

SoundActions::~SoundActions() {
    if (!m_player) return;
    m_player->setHearing(false);
    m_player->output().stop();
}

void SoundActions::addVolumes(QMenu& menu) {
    QMenu* volumes = menu.addMenu(iconNamed("play-volume"), tr("Vol&ume"));
    m_volumes = new QActionGroup(this);
    for (const int volume : kVolumes) {
        QAction* action = volumes->addAction(tr("%L1 %").arg(volume));
        action->setCheckable(true);
        action->setData(volume);
        action->setStatusTip(tr("Set the volume of the sound"));
        m_volumes->addAction(action);
        connect(action, &QAction::triggered, this, [this, volume] {
            Preferences preferences = m_preferences.preferences();
            preferences.volume = volume;
            m_preferences.setPreferences(preferences);
        });
    }
}

/// The play thread may emit while this is destroyed: its connection keeps the player.
void SoundActions::createPlayer() {
    if (m_player) return;
    m_player = std::make_shared<SoundPlayer>();
    PlayThread& thread = m_views.workspace().play().thread();
    connect(
        &thread, &PlayThread::cuesPlayed, &thread,
        [player = m_player](const std::vector<SoundCue>& cues, double shownAfter) { player->play(cues, shownAfter); },
        Qt::DirectConnection);
    connect(&m_player->output(), &AudioOutput::changed, this, &SoundActions::updateAvailability);
    m_player->setVolume(m_preferences.preferences().volume / 100.0);
    updateAvailability();
}

void SoundActions::setOn(bool isOn) {
    Preferences preferences = m_preferences.preferences();
    preferences.hasSound = isOn;
    m_preferences.setPreferences(preferences);
    if (!isOn) return;
    createPlayer();
    if (const QString fault = m_player->output().fault(); !fault.isEmpty()) m_views.showStatus(fault);
}

void SoundActions::applyPreferences() {
    const Preferences& preferences = m_preferences.preferences();
    m_action->setChecked(preferences.hasSound);
    for (QAction* action : m_volumes->actions()) action->setChecked(action->data().toInt() == preferences.volume);
    if (m_player) m_player->setVolume(preferences.volume / 100.0);
    updateHearing();
}

/// Explains where there is no sound.
void SoundActions::updateAvailability() {
    const QString fault = m_player->output().fault();
    m_action->setEnabled(fault.isEmpty());
    const QString tip = fault.isEmpty() ? tr("Hear what hits and breaks") : fault;
    m_action->setStatusTip(tip);
    m_action->setToolTip(tr("Sound") + '\n' + tip);
}

bool SoundActions::isHeard() const {
    return m_preferences.preferences().hasSound && m_views.workspace().play().isPlaying();
}

bool SoundActions::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::WindowStateChange) updateHearing();
    return QObject::eventFilter(watched, event);
}

/// Nothing is heard of what is paused or sought. While something moves in a visible window, the device is ready for
/// what hits next.
void SoundActions::updateHearing() {
    const PlayController& play = m_views.workspace().play();
    m_isAtRest = play.frame() && play.frame()->isAtRest;
    const bool hasSound = m_preferences.preferences().hasSound;
    const bool isMoving = play.isPlaying() && !m_isAtRest && !m_views.window().isMinimized();
    if (hasSound && play.isInPlay()) createPlayer();
    if (!m_player) return;
    updateListener();
    m_player->setHearing(isHeard());
    m_player->setOutputUse(!hasSound ? OutputUse::Never : isMoving ? OutputUse::Always : OutputUse::WhileHeard);
}

void SoundActions::updateListener() {
    if (m_player) m_player->setListener(listenerAt(m_views.scene().viewport().shownCamera()));
}

}  // namespace rubble

#include "moc_SoundActions.cpp"
