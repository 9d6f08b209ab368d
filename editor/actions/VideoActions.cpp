#include "editor/actions/VideoActions.h"

#include "editor/dialogs/MessageBoxes.h"
#include "editor/dialogs/VideoDialog.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"
#include "editor/view3d/SceneView.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/workspace/Workspace.h"
#include "viewport/widget/ViewportWidget.h"

#include <QFileInfo>
#include <QMainWindow>
#include <QProgressBar>
#include <QStandardPaths>
#include <QStatusBar>
#include <QToolButton>

namespace rubble {

namespace {

constexpr int kProgressWidth = 140;  // pixels

VideoSubject subjectOf(Workspace& workspace) {
    const QString path = workspace.file().path();
    return {.name = path.isEmpty() ? workspace.file().name() : QFileInfo(path).completeBaseName(),
            .folder = path.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::MoviesLocation)
                                     : QFileInfo(path).absolutePath(),
            .length = workspace.play().frame()->length,
            .stepLength = workspace.play().thread().stepLength(),
            .speed = workspace.play().timeScale()};
}

/// The view of the 3D view, at the video's resolution and without the axes.
RenderView viewOf(const ViewportWidget& viewport, ImageSize size) {
    RenderView view{.camera = viewport.camera(), .size = size, .settings = viewport.settings()};
    view.settings.scale = 1.0;
    view.settings.hasAxes = false;
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
            .frameRate = options.frameRate};
}

}  // namespace

VideoActions::VideoActions(Views& views)
    : QObject(&views.window()),
      m_views(views),
      m_workspace(views.workspace()),
      m_action(
          makeAction(this, {"play-video", tr("Export V&ideo…"), tr("Export the simulation as a video or images")})) {
    addProgress();
    VideoExporter& videos = m_workspace.videos();
    connect(m_action, &QAction::triggered, this, &VideoActions::exportWithDialog);
    connect(&videos, &VideoExporter::changed, this, &VideoActions::updateProgress);
    connect(&videos, &VideoExporter::progressed, this,
            [this](double fraction) { m_progress->setValue(static_cast<int>(100.0 * fraction)); });
    connect(&videos, &VideoExporter::finished, this, &VideoActions::showFinished);
    connect(&videos, &VideoExporter::failed, this, &VideoActions::showFailed);
}

void VideoActions::addProgress() {
    m_progress = new QProgressBar;
    m_progress->setObjectName("video-progress");
    m_progress->setMaximumWidth(kProgressWidth);
    m_progress->setFormat(tr("Video %p %"));
    m_progress->setAccessibleName(tr("Video export"));
    auto* cancel = new QToolButton;
    cancel->setObjectName("video-cancel");
    cancel->setText(tr("Cancel"));
    cancel->setToolTip(tr("Cancel the video and delete its files"));
    cancel->setAutoRaise(true);
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

void VideoActions::exportWithDialog() {
    PlayController& play = m_workspace.play();
    play.pause();
    if (!confirmStop(tr("A video is being exported. Cancel it and export another one?"), tr("Export Another"))) return;
    VideoDialog dialog(subjectOf(m_workspace), &m_views.window());
    if (dialog.exec() != QDialog::Accepted || !play.hasSession()) return;
    const VideoOptions options = dialog.options();
    play.requestScript([this, &play, options](PlayScript script) {
        m_workspace.videos().start({.scene = play.scene(),
                                    .script = std::move(script),
                                    .overlays = play.overlays(),
                                    .plan = planOf(options, play.thread().stepLength(), m_views.scene().viewport()),
                                    .isCompared = options.isCompared,
                                    .path = toPath(options.path)});
    });
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
    m_views.showStatus(tr("Exported %n frame(s) to %1.", nullptr, request.plan.frames).arg(place));
}

void VideoActions::showFailed(const QString& sentence) { showError(&m_views.window(), sentence); }

}  // namespace rubble

#include "moc_VideoActions.cpp"
