#include "editor/PlayActions.h"

#include "core/base/Version.h"
#include "core/io/ReplayFile.h"
#include "editor/Action.h"
#include "editor/FilmExport.h"
#include "editor/MainWindow.h"
#include "editor/SceneView.h"
#include "editor/TaskDialog.h"
#include "editor/Views.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/icons/Icon.h"
#include "viewport/ViewportWidget.h"

#include <QActionGroup>
#include <QApplication>
#include <QFileDialog>
#include <QLocale>
#include <QMessageBox>

namespace rubble {

namespace {

constexpr double kSpeeds[] = {0.1, 0.25, 0.5, 1.0, 2.0};

QString replayFilter() { return PlayActions::tr("Replays (*.replay)"); }

}  // namespace

PlayActions::PlayActions(MainWindow& window)
    : QObject(&window), m_window(window), m_film(new FilmExport(window)), m_menu(new QMenu(tr("&Play"), &window)) {
    addRun();
    m_menu->addSeparator();
    addSpeeds();
    addOverlays();
    m_menu->addSeparator();
    addShots();
    m_menu->addSeparator();
    addReplays();
    connect(&controller(), &PlayController::stateChanged, this, &PlayActions::update);
    connect(&controller(), &PlayController::rulesChanged, this, &PlayActions::update);
    connect(&controller(), &PlayController::framed, this, &PlayActions::updateRecorded);
    connect(&controller(), &PlayController::said, &window, &MainWindow::say);
    update();
}

PlayController& PlayActions::controller() const { return m_window.workspace().play(); }

void PlayActions::setWorking(bool isWorking) {
    m_isWorking = isWorking;
    for (QAction* action : m_menu->actions()) action->setEnabled(isWorking);
    update();
}

void PlayActions::addRun() {
    const auto add = addingTo(*m_menu, this);
    m_play = add(
        {"play-start", tr("&Play"), tr("Let the scene come to life and throw things at it"), QKeySequence("Ctrl+P")},
        &PlayActions::toggle);
    m_pause = add({"play-pause", tr("P&ause	P"), tr("Stand still, or go on; P in the 3D view")},
                  &PlayActions::togglePause);
    m_pause->setCheckable(true);
    m_step = makeAction(this, {"play-step", tr("S&tep	."), tr("Go on by one step; . in the 3D view")});
    m_reset =
        makeAction(this, {"play-reset", tr("&Reset	R"), tr("Put everything back as it was; R in the 3D view")});
    connect(m_step, &QAction::triggered, &controller(), &PlayController::stepOnce);
    connect(m_reset, &QAction::triggered, &controller(), &PlayController::reset);
    m_menu->addActions({m_step, m_reset});
}

void PlayActions::addSpeeds() {
    QMenu* menu = m_menu->addMenu(iconNamed("play-speed"), tr("&Speed"));
    m_speeds = new QActionGroup(this);
    for (const double speed : kSpeeds) {
        QAction* action = menu->addAction(tr("%1×").arg(QLocale().toString(speed)));
        action->setCheckable(true);
        action->setData(speed);
        action->setStatusTip(tr("Let time pass so fast"));
        m_speeds->addAction(action);
        connect(action, &QAction::triggered, this, [this, speed] { controller().setTimeScale(speed); });
    }
    m_destruction =
        makeAction(this, {"play-destruction", tr("&Destruction"), tr("Let things break, or nothing, to compare")});
    m_destruction->setCheckable(true);
    m_menu->addAction(m_destruction);
    connect(m_destruction, &QAction::toggled, &controller(), &PlayController::setDestruction);
}

void PlayActions::addOverlays() {
    QMenu* menu = m_menu->addMenu(iconNamed("play-overlays"), tr("S&how"));
    const std::tuple<bool PlayOverlays::*, QString, QString> overlays[] = {
        {&PlayOverlays::hasHeat, tr("Threshold &Heat"),
         tr("Colour each body by impact ÷ threshold: of what is aimed, wherever it would hit; else of the last "
            "impacts")},
        {&PlayOverlays::hasContacts, tr("&Contacts"), tr("Show where bodies touch, red where they overlap")},
        {&PlayOverlays::hasNormals, tr("&Normals"), tr("Show the directions in which contacts push")},
        {&PlayOverlays::hasImpulses, tr("&Impulses"), tr("Show how hard contacts push, as arrows")},
        {&PlayOverlays::hasHulls, tr("H&ulls"), tr("Show the convex hulls that collide")},
        {&PlayOverlays::hasBoxes, tr("&Bounding Boxes"), tr("Show the boxes by which neighbours are found")},
        {&PlayOverlays::hasIslands, tr("I&slands"), tr("Colour what hangs together by contacts")},
        {&PlayOverlays::hasSleep, tr("S&leep"), tr("Colour what sleeps blue")}};
    for (const auto& [member, text, tip] : overlays) {
        QAction* action = menu->addAction(text);
        action->setCheckable(true);
        action->setStatusTip(tip);
        action->setToolTip(tip);
        connect(action, &QAction::toggled, this, [this, flag = member](bool isOn) {
            PlayOverlays shown = controller().overlays();
            shown.*flag = isOn;
            controller().setOverlays(shown);
        });
    }
}

void PlayActions::addShots() {
    m_shots = m_menu->addMenu(iconNamed("play-shot"), tr("&Fire Shot"));
    connect(m_shots, &QMenu::aboutToShow, this, &PlayActions::fillShots);
    m_keep = addingTo(*m_menu, this)(
        {"play-keep", tr("&Keep Last Shot"),
         tr("Save what was thrown last in the project, to fire it again and to test with it"), QKeySequence("Ctrl+K")},
        &PlayActions::keepShot);
}

void PlayActions::addReplays() {
    const auto add = addingTo(*m_menu, this);
    m_saveReplay =
        add({"play-save", tr("Save R&eplay…"), tr("Write down what was played, to play it again bit for bit")},
            &PlayActions::saveReplay);
    add({"play-open", tr("&Open Replay…"), tr("Play what was written down, on the project as it is")},
        &PlayActions::openReplay);
    m_menu->addAction(m_film->action());
}

void PlayActions::toggle() {
    if (controller().isOn()) return controller().stop();
    m_window.views().showScene(true);
    m_window.views().scene().viewport().setFocus();
    controller().play();
}

void PlayActions::togglePause() { controller().isPlaying() ? controller().pause() : controller().play(); }

void PlayActions::fillShots() {
    m_shots->clear();
    for (const Shot& shot : m_window.workspace().project().shots) {
        QAction* action = m_shots->addAction(QString::fromStdString(shot.name));
        action->setStatusTip(tr("Fire this shot now"));
        connect(action, &QAction::triggered, this, [this, shot] {
            if (!controller().isOn()) toggle();
            controller().fire(shot);
        });
    }
    if (m_shots->isEmpty()) m_shots->addAction(tr("The project has no shots"))->setEnabled(false);
}

void PlayActions::keepShot() {
    if (!controller().lastShot()) return;
    const Addition added =
        addShot(m_window.workspace().project(), controller().lastShot()->name, controller().lastShot()->action);
    m_window.workspace().document().push(added.edit);
    m_window.say(tr("Kept as a shot of the project."));
}

void PlayActions::saveReplay() {
    controller().pause();
    QFileDialog dialog(&m_window, tr("Save Replay"), {}, replayFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix("replay");
    if (dialog.exec() != QDialog::Accepted) return;
    const PlayScript script = controller().script();
    const std::shared_ptr<const PlayScene> scene = controller().scene();
    const std::filesystem::path file = dialog.selectedFiles().first().toStdString();
    TaskDialog task(tr("Writing down what was played…"), &m_window);
    const Status saved = task.run<Status>([&](const TaskContext& context) -> Status {
        const Result<Replay> replay = recorded(scene, script.settings, script.inputs, script.steps, programVersion(),
                                               projectHash(controller().begunWith()), context);
        if (!replay) return replay.error();
        return rubble::saveReplay(file, *replay);
    });
    if (saved) return m_window.say(tr("Saved %1.").arg(QFileInfo(dialog.selectedFiles().first()).fileName()));
    if (saved.error().code == ErrorCode::Cancelled) return;
    QMessageBox::warning(&m_window, QApplication::applicationDisplayName(),
                         QString::fromStdString(saved.error().message));
}

void PlayActions::openReplay() {
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Open Replay"), {}, replayFilter());
    if (path.isEmpty()) return;
    const Result<Replay> replay = loadReplay(path.toStdString());
    if (!replay) {
        QMessageBox::warning(&m_window, QApplication::applicationDisplayName(),
                             QString::fromStdString(replay.error().message));
        return;
    }
    if (replay->project != projectHash(m_window.workspace().project())) {
        m_window.say(tr("The project is not as it was when this was recorded."));
    }
    m_window.views().showScene(true);
    m_window.views().scene().viewport().setFocus();
    controller().replay(scriptOf(*replay));
}

void PlayActions::update() {
    const bool isOn = controller().isOn();
    m_play->setText(isOn ? tr("Sto&p") : tr("&Play"));
    m_play->setIcon(iconNamed(isOn ? "play-stop" : "play-start"));
    const QString tip =
        isOn ? tr("Back to the project as it is") : tr("Let the scene come to life and throw things at it");
    m_play->setStatusTip(tip);
    m_play->setToolTip(tip + " (" + m_play->shortcut().toString(QKeySequence::NativeText) + ')');
    for (QAction* action : {m_pause, m_step, m_reset}) action->setEnabled(m_isWorking && isOn);
    m_pause->setChecked(controller().state() == PlayState::Paused);
    m_destruction->setChecked(controller().hasDestruction());
    for (QAction* action : m_speeds->actions())
        action->setChecked(action->data().toDouble() == controller().timeScale());
    updateRecorded();
}

/// What is there to be kept or written down.
void PlayActions::updateRecorded() {
    m_keep->setEnabled(m_isWorking && controller().isOn() && controller().lastShot());
    const bool isRecorded =
        m_isWorking && controller().isUnderWay() && controller().frame() && controller().frame()->length > 0;
    for (QAction* action : {m_saveReplay, m_film->action()}) action->setEnabled(isRecorded);
}

}  // namespace rubble
