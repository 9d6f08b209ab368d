#include "editor/actions/PlayActions.h"

#include "core/base/Version.h"
#include "core/io/animation/AnimationFile.h"
#include "core/io/play/ReplayFile.h"
#include "core/io/play/StateFile.h"
#include "editor/actions/EventActions.h"
#include "editor/actions/PlayContextMenu.h"
#include "editor/actions/SoundActions.h"
#include "editor/actions/TimelineActions.h"
#include "editor/actions/VideoActions.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/dialogs/MessageBoxes.h"
#include "editor/dialogs/OutputPath.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"
#include "editor/view3d/PlayView.h"
#include "editor/view3d/SceneView.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/widgets/Icon.h"
#include "editor/widgets/TaskDialog.h"
#include "editor/workspace/PlayToolStore.h"
#include "editor/workspace/PreferenceStore.h"
#include "editor/workspace/Workspace.h"
#include "viewport/widget/ViewportWidget.h"

#include <QActionGroup>
#include <QFileDialog>
#include <QLocale>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>
#include <QStandardPaths>

namespace rubble {

namespace {

constexpr double kSpeeds[] = {0.1, 0.25, 0.5, 1.0, 2.0};
constexpr int kStepRates[] = {30, 60, 120, 240};  // Hz

QString stateFilter() { return PlayActions::tr("States (*.rubblestate)"); }
QString glbFilter() { return PlayActions::tr("glTF (*.glb)"); }
QString usdFilter() { return PlayActions::tr("USD (*.usda)"); }
QString replayFilter() { return PlayActions::tr("Replays (*.replay)"); }

}  // namespace

PlayActions::PlayActions(Views& views, PreferenceStore& preferences, VideoActions& video)
    : QObject(&views.window()),
      m_views(views),
      m_workspace(views.workspace()),
      m_preferences(preferences),
      m_video(video),
      m_events(new EventActions(views)),
      m_menu(new QMenu(tr("&Play"), &views.window())) {
    keepPlayTools(m_workspace);
    addRun();
    m_menu->addSeparator();
    addTools();
    m_menu->addSeparator();
    addSpeeds();
    addTimeSteps();
    addOverlays();
    m_sound = new SoundActions(views, preferences, *m_menu);
    m_menu->setToolTipsVisible(true);  // they say why something is disabled
    m_menu->addSeparator();
    addShots();
    m_menu->addSeparator();
    addReplays();
    for (QAction* action : ownActions()) action->setEnabled(views.isProjectShown());
    connect(&views, &Views::projectShown, this, [this] {
        for (QAction* action : ownActions()) action->setEnabled(true);
        updateState();
    });
    connect(&controller(), &PlayController::stateChanged, this, &PlayActions::updateState);
    connect(&controller(), &PlayController::settingsChanged, this, &PlayActions::updateState);
    connect(&controller(), &PlayController::frameChanged, this, &PlayActions::updateRecorded);
    connect(&controller(), &PlayController::statusMessage, &views, &Views::showStatus);
    updateState();
}

/// The actions of the menu but those for the timeline, videos, events and sound, which enable themselves.
QList<QAction*> PlayActions::ownActions() const {
    QList<QAction*> actions = m_menu->actions();
    const QList<QAction*> others{m_timeline->stepBack(), m_timeline->menu()->menuAction(), m_video.action(),
                                 m_sound->action()};
    for (QAction* other : m_events->actions() + others) actions.removeOne(other);
    return actions;
}

PlayController& PlayActions::controller() const { return m_workspace.play(); }

void PlayActions::addRun() {
    const auto add = actionAdder(*m_menu, this);
    m_play =
        add({"play-start", tr("&Play"), tr("Start the simulation"), QKeySequence("Ctrl+P")}, &PlayActions::startOrStop);
    m_pause = add({"play-pause", tr("P&ause"), tr("Pause or resume the simulation"), QKeySequence(Qt::Key_P)},
                  &PlayActions::pauseOrResume);
    m_pause->setCheckable(true);
    m_step = makeAction(
        this, {"play-step", tr("S&tep"), tr("Advance the simulation by one step"), QKeySequence(Qt::Key_Period)});
    m_reset = makeAction(
        this, {"play-reset", tr("&Restart"), tr("Restart the simulation from the beginning"), QKeySequence(Qt::Key_R)});
    connect(m_step, &QAction::triggered, &controller(), &PlayController::stepOnce);
    connect(m_reset, &QAction::triggered, &controller(), &PlayController::reset);
    for (QAction* action : {m_pause, m_reset}) action->setAutoRepeat(false);
    for (QAction* action : {m_pause, m_step}) action->setPriority(QAction::LowPriority);  // icons alone in tool bars
    m_timeline = new TimelineActions(m_views, m_step);
    m_menu->addActions({m_step, m_timeline->stepBack(), m_reset});
    m_views.scene().playView().tool().setActions(
        {m_pause, m_step, m_timeline->stepBack(), m_reset, m_timeline->loop()});
    m_menu->addMenu(m_timeline->menu())->setIcon(iconNamed("dock-history"));
}

/// The view handles their keys, with the pointer and the charge of a throw. They have no mnemonics: the menu has more
/// items than its letters.
void PlayActions::addTools() {
    PlayTool& tool = m_views.scene().playView().tool();
    QAction* throwing = makeAction(this, {"play-throw", tr("Throw\tF"), tr("Throw the projectile at the pointer")});
    QAction* hammering =
        makeAction(this, {"play-hammer", tr("Hammer\tH"), tr("Hit what is at the pointer with a hammer")});
    QAction* blasting = makeAction(this, {"play-blast", tr("Blast\tX"), tr("Set off a blast at the pointer")});
    connect(throwing, &QAction::triggered, &tool, &PlayTool::throwAtPointer);
    connect(hammering, &QAction::triggered, &tool, &PlayTool::hammerAtPointer);
    connect(blasting, &QAction::triggered, &tool, &PlayTool::explodeAtPointer);
    m_tools = {throwing, hammering, blasting};
    m_menu->addActions(m_tools);
}

void PlayActions::addSpeeds() {
    QMenu* menu = m_menu->addMenu(iconNamed("play-speed"), tr("Playbac&k Speed"));
    m_speeds = new QActionGroup(this);
    for (const double speed : kSpeeds) {
        QAction* action = menu->addAction(tr("%1×").arg(QLocale().toString(speed)));
        action->setCheckable(true);
        action->setData(speed);
        action->setStatusTip(tr("Set the playback speed"));
        m_speeds->addAction(action);
        connect(action, &QAction::triggered, this, [this, speed] { controller().setTimeScale(speed); });
    }
}

/// Shorter steps follow fast motion more closely, and cost time in proportion.
void PlayActions::addTimeSteps() {
    QMenu* menu = m_menu->addMenu(iconNamed("play-step"), tr("Ti&me Step"));
    menu->setToolTipsVisible(true);
    m_timeSteps = new QActionGroup(this);
    for (const int rate : kStepRates) {
        QAction* action = menu->addAction(tr("%L1 Hz").arg(rate));
        action->setCheckable(true);
        action->setData(1.0 / rate);
        const QString cost = QLocale().toString(rate / 60.0);
        const QString tip = rate == 60 ? tr("Simulate 60 steps a second, as tests and the command line do")
                                       : tr("Simulate %L1 steps a second, at %2 times the computing time of 60 Hz; "
                                            "restarts the simulation")
                                             .arg(rate)
                                             .arg(cost);
        action->setToolTip(tip);
        action->setStatusTip(tip);
        m_timeSteps->addAction(action);
        connect(action, &QAction::triggered, this, [this, rate] { controller().setTimeStep(1.0 / rate); });
    }
    m_destruction = makeAction(this, {"play-destruction", tr("Destru&ction"), tr("Allow bodies to break")});
    m_destruction->setCheckable(true);
    m_menu->addAction(m_destruction);
    connect(m_destruction, &QAction::toggled, &controller(), &PlayController::setDestruction);
}

void PlayActions::addOverlays() {
    QMenu* menu = m_menu->addMenu(iconNamed("play-overlays"), tr("O&verlays"));
    const std::tuple<bool PlayOverlays::*, QString, QString> overlays[] = {
        {&PlayOverlays::hasHeat, tr("Threshold &Heat Map"),
         tr("Colour bodies by impact ÷ threshold of the aimed throw or of recent impacts")},
        {&PlayOverlays::hasCollapse, tr("&What Would Fall"),
         tr("Colour the body at the pointer, and what would fall if it were removed")},
        {&PlayOverlays::hasContacts, tr("&Contacts"), tr("Show contact points, overlapping ones in red")},
        {&PlayOverlays::hasNormals, tr("Contact &Normals"), tr("Show contact normals")},
        {&PlayOverlays::hasImpulses, tr("Contact &Impulses"), tr("Show contact impulses as arrows")},
        {&PlayOverlays::hasHulls, tr("H&ulls"), tr("Show the convex hulls used for collisions")},
        {&PlayOverlays::hasBoxes, tr("&Bounding Boxes"), tr("Show the bounding boxes of the broad phase")},
        {&PlayOverlays::hasBodies, tr("B&odies"),
         tr("Colour each body, so that it shows which fragments hold together")},
        {&PlayOverlays::hasBonds, tr("Bonds by &Damage"),
         tr("Show the bonds between the fragments of bonded assets, coloured by damage")},
        {&PlayOverlays::hasIslands, tr("I&slands"), tr("Colour bodies by the island they belong to")},
        {&PlayOverlays::hasSleep, tr("S&leeping Bodies"), tr("Show sleeping bodies in blue")}};
    for (const auto& [member, text, tip] : overlays) {
        QAction* action = menu->addAction(text);
        action->setCheckable(true);
        action->setStatusTip(tip);
        action->setToolTip(tip);
        if (member == &PlayOverlays::hasCollapse) m_contextMenu = new PlayContextMenu(m_views, action);
        connect(action, &QAction::toggled, this, [this, flag = member](bool isOn) {
            PlayOverlays shown = controller().overlays();
            shown.*flag = isOn;
            controller().setOverlays(shown);
        });
    }
    addStatistics(*menu);
}

/// The same in all windows, and kept.
void PlayActions::addStatistics(QMenu& menu) {
    QAction* action =
        makeAction(this, {"play-statistics", tr("S&tatistics"), tr("Show frame rate, bodies and computing times")});
    action->setCheckable(true);
    menu.addSeparator();
    menu.addAction(action);
    const auto show = [this, action] { action->setChecked(m_preferences.preferences().hasStatistics); };
    show();
    connect(&m_preferences, &PreferenceStore::changed, action, show);
    connect(action, &QAction::toggled, this, [this](bool isOn) {
        Preferences preferences = m_preferences.preferences();
        preferences.hasStatistics = isOn;
        m_preferences.setPreferences(preferences);
    });
}

void PlayActions::addShots() {
    m_shots = m_menu->addMenu(iconNamed("play-shot"), tr("Repeat Saved Thro&w"));
    connect(m_shots, &QMenu::aboutToShow, this, &PlayActions::fillShots);
    m_saveShot =
        actionAdder(*m_menu, this)({"play-save-shot", tr("Save Last Throw"),
                                    tr("Save the last throw, hit or blast in the project"), QKeySequence("Ctrl+K")},
                                   &PlayActions::saveShot);
}

void PlayActions::addReplays() {
    const auto add = actionAdder(*m_menu, this);
    m_saveReplay = add({"play-save-replay", tr("Save Repla&y…"), tr("Save this simulation as a replay")},
                       &PlayActions::saveReplay);
    add({"play-open-replay", tr("&Open Replay…"), tr("Play a saved replay")}, &PlayActions::openReplay);
    addStates();
    m_menu->addActions(m_events->actions());
    m_exportAnimation = add({"play-export-animation", tr("E&xport Animation…"),
                             tr("Save the motion of all fragments for other 3D programs, as GLB or USD")},
                            &PlayActions::exportAnimation);
    m_menu->addAction(m_video.action());
}

void PlayActions::addStates() {
    const auto add = actionAdder(*m_menu, this);
    m_saveState =
        add({"play-save-state", tr("Save Stat&e…"), tr("Save the displayed moment"), QKeySequence(Qt::Key_F6)},
            &PlayActions::saveState);
    add({"play-load-state", tr("&Load State…"), tr("Go on from a saved moment of a simulation"),
         QKeySequence(Qt::Key_F9)},
        &PlayActions::openState);
}

void PlayActions::startOrStop() {
    if (controller().isInPlay()) return controller().stop();
    start();
}

void PlayActions::start() {
    m_views.setSceneVisible(true);
    m_views.scene().viewport().setFocus();
    controller().play();
}

void PlayActions::pauseOrResume() { controller().isPlaying() ? controller().pause() : controller().play(); }

void PlayActions::fillShots() {
    m_shots->clear();
    for (const Shot& shot : m_workspace.project().shots) {
        QAction* action = m_shots->addAction(menuText(nameText(shot.name)));
        action->setStatusTip(tr("Repeat this throw"));
        connect(action, &QAction::triggered, this, [this, shot] {
            if (!controller().isInPlay()) start();
            controller().fire(shot);
        });
    }
    if (m_shots->isEmpty()) m_shots->addAction(tr("No Saved Throws in This Project"))->setEnabled(false);
}

void PlayActions::saveShot() {
    if (!controller().lastShot()) return;
    const ShotInput& shot = *controller().lastShot();
    Addition added = addShot(m_workspace.project(), shot.name, shot.action);
    if (!m_workspace.document().push(std::move(added.edit))) return;
    m_views.showStatus(tr("Saved the last throw in the project."));
}

void PlayActions::saveReplay() {
    controller().pause();
    QFileDialog dialog(&m_views.window(), tr("Save Replay"), {}, replayFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix("replay");
    suggestOutput(dialog, m_workspace.file(), ".replay");
    const QString path = askForOutput(dialog, m_workspace.file(), {".replay"});
    if (path.isEmpty()) return;
    controller().requestScript([this, path](const PlayScript& script) { writeReplay(path, script); });
}

void PlayActions::writeReplay(const QString& path, const PlayScript& script) {
    const std::shared_ptr<const PlayScene> scene = controller().scene();
    const ContentHash project = projectHash(controller().startProject());
    TaskDialog task(tr("Saving the replay…"), &m_views.window());
    const Status saved = task.run<Status>([&](const TaskContext& context) -> Status {
        const Result<Replay> replay =
            recordReplay(scene, script.settings, script.inputs, script.steps, programVersion(), project, context);
        if (!replay) return replay.error();
        return rubble::saveReplay(toPath(path), *replay);
    });
    if (saved) return m_views.showStatus(tr("Saved %1.").arg(fileNameText(path)));
    if (saved.error().code != ErrorCode::Cancelled) showError(&m_views.window(), saved.error());
}

void PlayActions::exportAnimation() {
    controller().pause();
    QFileDialog dialog(&m_views.window(), tr("Export Animation"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    offerKinds(dialog, {{glbFilter(), "glb"}, {usdFilter(), "usda"}});
    suggestOutput(dialog, m_workspace.file(), ".glb");
    const QString path = askForOutput(dialog, m_workspace.file(), {".glb", ".usda"});
    if (path.isEmpty()) return;
    controller().requestScript([this, path](PlayScript script) { writeAnimation(path, std::move(script)); });
}

void PlayActions::writeAnimation(const QString& path, PlayScript script) {
    const std::shared_ptr<const PlayScene> scene = controller().scene();
    TaskDialog task(tr("Exporting the animation…"), &m_views.window());
    const Status saved = task.run<Status>([&](const TaskContext& context) -> Status {
        Result<Session> session = startOf(scene, script);
        if (!session) return session.error();
        const Result<SessionTracks> tracks =
            recordTracks(std::move(*session), std::move(script.inputs), script.steps, context);
        if (!tracks) return tracks.error();
        return saveAnimation(toPath(path), scene->project, *tracks, context);
    });
    if (saved) return m_views.showStatus(tr("Exported the animation to %1.").arg(fileNameText(path)));
    if (saved.error().code != ErrorCode::Cancelled) showError(&m_views.window(), saved.error());
}

void PlayActions::openReplay() {
    const QString folder = outputDefaults(m_workspace.file(), QStandardPaths::DocumentsLocation).folder;
    const QString path = QFileDialog::getOpenFileName(&m_views.window(), tr("Open Replay"), folder, replayFilter());
    if (path.isEmpty()) return;
    const Result<Replay> replay = loadReplay(toPath(path));
    if (!replay) return showError(&m_views.window(), replay.error());
    if (replay->project != projectHash(m_workspace.project())) {
        m_views.showStatus(tr("The project has changed since the replay was recorded."));
    }
    m_views.setSceneVisible(true);
    m_views.scene().viewport().setFocus();
    controller().replay(scriptOf(*replay));
}

void PlayActions::saveState() {
    controller().pause();
    QFileDialog dialog(&m_views.window(), tr("Save State"), {}, stateFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix("rubblestate");
    suggestOutput(dialog, m_workspace.file(), ".rubblestate");
    const QString path = askForOutput(dialog, m_workspace.file(), {".rubblestate"});
    if (path.isEmpty()) return;
    controller().requestState([this, path](const std::shared_ptr<const SavedSession>& saved) {
        const Status written = rubble::saveState(toPath(path), *saved, sceneHash(m_workspace.project()));
        if (!written) return showError(&m_views.window(), written.error());
        m_views.showStatus(tr("Saved %1.").arg(fileNameText(path)));
    });
}

void PlayActions::openState() {
    const QString folder = outputDefaults(m_workspace.file(), QStandardPaths::DocumentsLocation).folder;
    const QString path = QFileDialog::getOpenFileName(&m_views.window(), tr("Load State"), folder, stateFilter());
    if (!path.isEmpty()) loadState(path);
}

void PlayActions::loadState(const QString& path) {
    Result<SavedSession> saved = loadSavedSession(toPath(path), sceneHash(m_workspace.project()));
    if (!saved) return showError(&m_views.window(), saved.error());
    m_views.setSceneVisible(true);
    m_views.scene().viewport().setFocus();
    controller().load(std::make_shared<const SavedSession>(std::move(*saved)));
}

void PlayActions::updateState() {
    const bool isOn = controller().isInPlay();
    m_play->setText(isOn ? tr("Sto&p") : tr("&Play"));
    m_play->setIcon(iconNamed(isOn ? "play-stop" : "play-start"));
    const QString tip = isOn ? tr("Stop the simulation and return to the project") : tr("Start the simulation");
    m_play->setStatusTip(tip);
    m_play->setToolTip(tip + " (" + m_play->shortcut().toString(QKeySequence::NativeText) + ')');
    for (QAction* action : m_tools + QList{m_pause, m_step, m_reset}) {
        action->setEnabled(m_views.isProjectShown() && isOn);
    }
    m_pause->setChecked(controller().state() == PlayState::Paused);
    m_destruction->setChecked(controller().hasDestruction());
    for (QAction* action : m_speeds->actions()) {
        action->setChecked(action->data().toDouble() == controller().timeScale());
    }
    for (QAction* action : m_timeSteps->actions()) {
        action->setChecked(action->data().toDouble() == controller().timeStep());
    }
    updateRecorded();
}

/// Enables the actions that save what was recorded.
void PlayActions::updateRecorded() {
    const bool isShown = m_views.isProjectShown();
    m_saveShot->setEnabled(isShown && controller().isInPlay() && controller().lastShot());
    const auto& frame = controller().frame();
    const bool isRecorded = isShown && controller().hasSession() && frame && frame->length > 0;
    m_saveReplay->setEnabled(isRecorded && controller().isFromStart());
    m_exportAnimation->setEnabled(isRecorded);
    m_saveState->setEnabled(isShown && controller().hasSession() && frame);
}

}  // namespace rubble

#include "moc_PlayActions.cpp"
