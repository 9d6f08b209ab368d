#include "editor/actions/FilmActions.h"

#include "editor/dialogs/FilmDialog.h"
#include "editor/dialogs/MessageBoxes.h"
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

FilmSubject subjectOf(Workspace& workspace) {
    const QString path = workspace.file().path();
    return {.name = path.isEmpty() ? workspace.file().name() : QFileInfo(path).completeBaseName(),
            .folder = path.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::MoviesLocation)
                                     : QFileInfo(path).absolutePath(),
            .length = workspace.play().frame()->length,
            .stepLength = workspace.play().thread().stepLength(),
            .speed = workspace.play().timeScale()};
}

/// The view of the 3D view, at the film's resolution and without the axes.
RenderView viewOf(const ViewportWidget& viewport, ImageSize size) {
    RenderView view{.camera = viewport.camera(), .size = size, .settings = viewport.settings()};
    view.settings.scale = 1.0;
    view.settings.hasAxes = false;
    view.settings.hasScaleBar = true;
    return view;
}

FilmPlan planOf(const FilmOptions& options, double stepLength, const ViewportWidget& viewport) {
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

FilmActions::FilmActions(Views& views)
    : QObject(&views.window()),
      m_views(views),
      m_workspace(views.workspace()),
      m_action(makeAction(
          this, {"play-film", tr("Export Fil&m…"), tr("Export the simulation as a film or a sequence of images")})) {
    addProgress();
    FilmExporter& films = m_workspace.films();
    connect(m_action, &QAction::triggered, this, &FilmActions::exportWithDialog);
    connect(&films, &FilmExporter::changed, this, &FilmActions::updateProgress);
    connect(&films, &FilmExporter::progressed, this,
            [this](double fraction) { m_progress->setValue(static_cast<int>(100.0 * fraction)); });
    connect(&films, &FilmExporter::finished, this, &FilmActions::showFinished);
    connect(&films, &FilmExporter::failed, this, &FilmActions::showFailed);
}

void FilmActions::addProgress() {
    m_progress = new QProgressBar;
    m_progress->setObjectName("film-progress");
    m_progress->setMaximumWidth(kProgressWidth);
    m_progress->setFormat(tr("Film %p %"));
    m_progress->setAccessibleName(tr("Film export"));
    auto* cancel = new QToolButton;
    cancel->setObjectName("film-cancel");
    cancel->setText(tr("Cancel"));
    cancel->setToolTip(tr("Cancel the film and delete its files"));
    cancel->setAutoRaise(true);
    connect(cancel, &QToolButton::clicked, this, [this] {
        m_workspace.films().cancel();
        m_views.showStatus(tr("Cancelled the film and deleted its files."));
    });
    m_progressWidgets = {m_progress, cancel};
    for (QWidget* widget : m_progressWidgets) m_views.window().statusBar()->addPermanentWidget(widget);
    updateProgress();
}

void FilmActions::updateProgress() {
    for (QWidget* widget : m_progressWidgets) widget->setVisible(m_workspace.films().isBusy());
}

void FilmActions::exportWithDialog() {
    PlayController& play = m_workspace.play();
    play.pause();
    if (!confirmStop(tr("A film is being exported. Cancel it and export another one?"), tr("Export Another"))) return;
    FilmDialog dialog(subjectOf(m_workspace), &m_views.window());
    if (dialog.exec() != QDialog::Accepted || !play.hasSession()) return;
    const FilmOptions options = dialog.options();
    play.requestScript([this, &play, options](PlayScript script) {
        m_workspace.films().start({.scene = play.scene(),
                                   .script = std::move(script),
                                   .overlays = play.overlays(),
                                   .plan = planOf(options, play.thread().stepLength(), m_views.scene().viewport()),
                                   .isCompared = options.isCompared,
                                   .path = toPath(options.path)});
    });
}

bool FilmActions::confirmStop(const QString& question, const QString& action) {
    if (!m_workspace.films().isBusy()) return true;
    return confirmLoss(&m_views.window(), question, action, tr("Continue Export"));
}

bool FilmActions::confirmClose() {
    return confirmStop(tr("A film is being exported. Cancel it and close the window?"), tr("Close Window"));
}

void FilmActions::showFinished(const FilmRequest& request) {
    const QString place = pathText(fromPath(request.path));
    m_views.showStatus(tr("Exported %n frame(s) to %1.", nullptr, request.plan.frames).arg(place));
}

void FilmActions::showFailed(const QString& sentence) { showError(&m_views.window(), sentence); }

}  // namespace rubble

#include "moc_FilmActions.cpp"
