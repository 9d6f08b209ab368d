#include "editor/actions/VideoActions.h"

#include "editor/background/VideoEstimate.h"
#include "editor/dialogs/MessageBoxes.h"
#include "editor/dialogs/VideoDialog.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"
#include "editor/view3d/SceneView.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/widgets/Buttons.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "editor/workspace/Workspace.h"
#include "viewport/widget/ViewportWidget.h"

#include <QMainWindow>
#include <QMenu>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr int kProgressWidth = 200;  // pixels, at least
constexpr int kProgressMargin = 24;  // pixels, around the text

VideoSubject subjectOf(Workspace& workspace) {
    const auto& frame = workspace.play().frame();
    VideoSubject subject{.defaults = outputDefaults(workspace.file(), QStandardPaths::MoviesLocation),
                         .length = workspace.play().hasSession() && frame ? frame->length : 0,
                         .stepLength = workspace.play().timeStep(),
                         .speed = workspace.play().timeScale()};
    if (subject.length > 0) subject.stepLength = workspace.play().thread().stepLength();
    if (subject.length > 0) subject.stepCost = 1e-3 * frame->statistics.cost.total();
    for (const Shot& shot : workspace.project().shots) subject.throws.append(nameText(shot.name));
    return subject;
}

/// The remaining time of an export, rounded.
QString durationText(double seconds) {
    if (seconds < 60.0) return fixedQuantity(std::ceil(seconds), 0, Units::seconds());
    return VideoActions::tr("%1 min").arg(std::round(seconds / 60.0));
}

/// "Video 12 %, 3 min left", as a format of a progress bar.
QString progressFormat(double secondsLeft) {
    return VideoActions::tr("Video %p %, %1 left").arg(durationText(secondsLeft));
}

/// The width of the longest text of the progress.
int widestText(const QFontMetrics& metrics) {
    const double seconds = 59.0, minutes = 60.0 * 999.0;
    const auto width = [&](double left) {
        return metrics.horizontalAdvance(progressFormat(left).replace("%p", QStringLiteral("100")));
    };
    return std::max(width(seconds), width(minutes));
}

/// The view of the 3D view, at the video's resolution and without the axes.
RenderView viewOf(const ViewportWidget& viewport, ImageSize size) {
    RenderView view{.camera = viewport.camera(), .size = size, .settings = viewport.settings()};
    view.settings.scale = 1.0;
    view.settings.hasAxes = false;
    view.settings.hasScaleBar = true;
    return view;
}

VideoPlan planOf(const VideoOptions& options, double stepLength, const ViewportWidget& viewport) {
    const auto first = static_cast<double>(options.first), last = static_cast<double>(options.last);
    const double stepsPerFrame = options.stepsPerFrame(stepLength);
    return {.view = viewOf(viewport, options.size),
            .samples = options.samples,
            .first = first,
            .stepsPerFrame = stepsPerFrame,
            .frames = frameCount(first, last, stepsPerFrame),
            .frameRate = options.frameRate,
            .hasSound = options.hasSound};
}

}  // namespace

VideoActions::VideoActions(Views& views)
    : QObject(&views.window()),
      m_views(views),
      m_workspace(views.workspace()),
      m_action(makeAction(this, {"play-video", tr("Export Vi&deo…"), {}, QKeySequence("Ctrl+Alt+V")})),
      m_estimate(new VideoEstimate(this)) {
    addProgress();
    connect(&views.scene().viewport(), &QWidget::customContextMenuRequested, this, &VideoActions::openPresentMenu);
    VideoExporter& videos = m_workspace.videos();
    connect(m_action, &QAction::triggered, this, &VideoActions::exportWithDialog);
    connect(&videos, &VideoExporter::changed, this, &VideoActions::updateProgress);
    connect(&videos, &VideoExporter::progressed, this, &VideoActions::showProgress);
    connect(&videos, &VideoExporter::finished, this, &VideoActions::showFinished);
    connect(&videos, &VideoExporter::failed, this, &VideoActions::showFailed);
    connect(&views, &Views::projectShown, this, &VideoActions::updateEnabled);
    connect(&m_workspace.play(), &PlayController::stateChanged, this, &VideoActions::updateEnabled);
    connect(&m_workspace.play(), &PlayController::frameChanged, this, &VideoActions::updateEnabled);
    connect(&m_workspace.document(), &Document::changed, this, &VideoActions::updateEnabled);
    updateEnabled();
}

void VideoActions::addProgress() {
    m_progress = new QProgressBar;
    m_progress->setObjectName("video-progress");
    m_progress->setFixedWidth(std::max(kProgressWidth, widestText(m_progress->fontMetrics()) + kProgressMargin));
    m_progress->setAccessibleName(tr("Video export"));
    QToolButton* cancel = panelButton({}, tr("Cancel"), tr("Cancel the video and delete its files"), &m_views.window());
    cancel->setObjectName("video-cancel");
    cancel->setFocusPolicy(Qt::TabFocus);  // the view keeps the focus
    connect(cancel, &QToolButton::clicked, this, [this] {
        m_workspace.videos().cancel();
        m_views.showStatus(tr("Cancelled the video and deleted its files."));
    });
    m_progressWidgets = {m_progress, cancel};
    for (QWidget* widget : m_progressWidgets) m_views.window().statusBar()->addPermanentWidget(widget);
    updateProgress();
}

void VideoActions::updateProgress() {
    for (QWidget* widget : m_progressWidgets) widget->setVisible(m_workspace.videos().isBusy());
}

/// Estimates the remaining time once there are frames.
void VideoActions::showProgress(double fraction) {
    constexpr double kFirstFrames = 0.07;  // after baking, whose speed is another
    m_progress->setValue(static_cast<int>(100.0 * fraction));
    if (fraction < kFirstFrames) {
        m_clock.start();
        m_clockStart = fraction;
        return m_progress->setFormat(tr("Video %p %"));
    }
    const double elapsed = 1e-3 * static_cast<double>(m_clock.elapsed());
    const double left = elapsed * (1.0 - fraction) / (fraction - m_clockStart);
    m_progress->setFormat(progressFormat(left));
}

bool VideoActions::isRecorded() const {
    const auto& frame = m_workspace.play().frame();
    return m_workspace.play().hasSession() && frame && frame->length > 0;
}

/// Without a recording, a saved throw can be simulated.
void VideoActions::updateEnabled() {
    const Project& project = m_workspace.project();
    const bool hasThrow = !project.instances.empty() && !project.shots.empty();
    m_action->setEnabled(m_views.isProjectShown() && (isRecorded() || hasThrow));
    const QString tip = m_action->isEnabled() ? tr("Export the simulation as a video or images")
                                              : tr("Start the simulation, or save a throw, to export a video");
    m_action->setStatusTip(tip);
    m_action->setToolTip(tip);
}

void VideoActions::exportWithDialog() {
    PlayController& play = m_workspace.play();
    play.pause();
    if (!confirmStop(tr("A video is being exported. Cancel it and export another one?"), tr("Export Another"))) return;
    const bool wasRecorded = isRecorded();
    VideoDialog dialog(subjectOf(m_workspace), &m_views.window());
    connect(&dialog, &VideoDialog::estimateNeeded, this, [this](const VideoOptions& options) {
        const ViewportWidget& viewport = m_views.scene().viewport();
        const auto scene = std::make_shared<const RenderScene>(viewport.scene());
        m_estimate->measure(scene, viewOf(viewport, options.size), options.samples);
    });
    connect(m_estimate, &VideoEstimate::changed, &dialog,
            [this, &dialog] { dialog.setFrameCost(m_estimate->secondsPerFrame(), m_estimate->isMeasuring()); });
    dialog.requestEstimate();
    if (dialog.exec() != QDialog::Accepted) return;
    wasRecorded ? exportRecording(dialog.options()) : exportThrow(dialog.options());
}

/// Menus are hidden while presenting. What is recorded then is what is seen: the scene alone.
void VideoActions::openPresentMenu(const QPoint& point) {
    ViewportWidget& viewport = m_views.scene().viewport();
    if (!viewport.isPresenting()) return;
    auto* menu = new QMenu(&viewport);
    menu->setObjectName("present-menu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QAction* record = menu->addAction(tr("&Record Video…"), m_action, &QAction::trigger);
    record->setEnabled(m_action->isEnabled());
    menu->addAction(tr("&Stop Presenting"), &viewport, [&viewport] { viewport.setPresenting(false); });
    menu->popup(viewport.mapToGlobal(point));
}

void VideoActions::exportRecording(const VideoOptions& options) {
    PlayController& play = m_workspace.play();
    if (!play.hasSession()) return m_views.showStatus(tr("Nothing was exported: the simulation was stopped."));
    play.requestScript([this, &play, options](PlayScript script) {
        m_workspace.videos().start({.scene = play.scene(),
                                    .script = std::move(script),
                                    .overlays = play.shownOverlays(),
                                    .plan = planOf(options, play.thread().stepLength(), m_views.scene().viewport()),
                                    .isCompared = options.isCompared,
                                    .path = toPath(options.path)});
    });
}

void VideoActions::exportThrow(const VideoOptions& options) {
    const Project& project = m_workspace.project();
    const auto index = static_cast<std::size_t>(options.savedThrow);
    if (index >= project.shots.size()) return;
    const Shot& shot = project.shots[index];
    PlayScript script{.settings = m_workspace.play().nextSettings(),
                      .inputs = std::vector<TimedInput>{{0, ShotInput{shot.name, shot.action}}},
                      .steps = options.last};
    const double stepLength = script.settings.dt;
    m_workspace.videos().start({.project = project,
                                .script = std::move(script),
                                .overlays = m_workspace.play().shownOverlays(),
                                .plan = planOf(options, stepLength, m_views.scene().viewport()),
                                .isCompared = options.isCompared,
                                .path = toPath(options.path)});
}

bool VideoActions::confirmStop(const QString& question, const QString& action) {
    if (!m_workspace.videos().isBusy()) return true;
    return confirmLoss(&m_views.window(), question, action, tr("Continue Export"));
}

bool VideoActions::confirmClose() {
    return confirmStop(tr("A video is being exported. Cancel it and close the window?"), tr("Close Window"));
}

void VideoActions::showFinished(const VideoRequest& request) {
    const QString place = pathText(fromPath(request.path));
    report(Severity::Note, tr("Exported %n frame(s) to %1.", nullptr, request.plan.frames).arg(place));
}

void VideoActions::showFailed(const QString& sentence) { report(Severity::Error, sentence); }

/// Shows the outcome without a box, which would take the keys in the middle of something else.
void VideoActions::report(Severity severity, const QString& sentence) {
    m_views.messages().add({.severity = severity, .text = sentence});
    m_views.showStatus(sentence);
}

}  // namespace rubble

#include "moc_VideoActions.cpp"
