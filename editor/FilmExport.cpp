#include "editor/FilmExport.h"

#include "editor/Action.h"
#include "editor/FilmDialog.h"
#include "editor/MainWindow.h"
#include "editor/SceneView.h"
#include "editor/Views.h"
#include "viewport/ViewportWidget.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QStandardPaths>
#include <QStatusBar>
#include <QToolButton>

namespace rubble {

namespace {

FilmSubject subjectOf(Workspace& workspace) {
    const QString path = workspace.file().path();
    return {.name = QFileInfo(workspace.file().name()).completeBaseName(),
            .folder = path.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::MoviesLocation)
                                     : QFileInfo(path).absolutePath(),
            .length = workspace.play().frame()->length,
            .stepLength = workspace.play().thread().stepLength(),
            .speed = workspace.play().timeScale()};
}

/// As the 3D view shows it, without what belongs to a window only.
PictureView viewOf(const ViewportWidget& viewport, PictureSize size) {
    PictureView view{.camera = viewport.camera(), .size = size, .settings = viewport.settings()};
    view.settings.scale = 1.0;
    view.settings.hasAxes = false;
    return view;
}

FilmPlan planOf(const FilmChoice& choice, double stepLength, const ViewportWidget& viewport) {
    const auto first = static_cast<double>(choice.first), last = static_cast<double>(choice.last);
    const double every = choice.every(stepLength);
    return {.view = viewOf(viewport, choice.size),
            .samples = choice.samples,
            .first = first,
            .every = every,
            .pictures = picturesBetween(first, last, every),
            .rate = choice.rate};
}

}  // namespace

FilmExport::FilmExport(MainWindow& window)
    : QObject(&window),
      m_window(window),
      m_action(makeAction(this, {"play-film", tr("Export Fil&m…"),
                                 tr("Write what was played as a film, or as a sequence of pictures")})) {
    makeProgress();
    FilmMaker& films = window.workspace().films();
    connect(m_action, &QAction::triggered, this, &FilmExport::ask);
    connect(&films, &FilmMaker::changed, this, &FilmExport::updateProgress);
    connect(&films, &FilmMaker::progressed, this,
            [this](double fraction) { m_progress->setValue(static_cast<int>(100.0 * fraction)); });
    connect(&films, &FilmMaker::finished, this, &FilmExport::tellFinished);
    connect(&films, &FilmMaker::failed, this, &FilmExport::tellFailed);
}

PlayController& FilmExport::play() const { return m_window.workspace().play(); }

void FilmExport::makeProgress() {
    m_progress = new QProgressBar;
    m_progress->setObjectName("film-progress");
    m_progress->setMaximumWidth(140);
    m_progress->setFormat(tr("Film %p %"));
    m_progress->setAccessibleName(tr("Film"));
    auto* cancel = new QToolButton;
    cancel->setObjectName("film-cancel");
    cancel->setText(tr("Cancel"));
    cancel->setToolTip(tr("Stop making the film; nothing of it stays"));
    cancel->setAutoRaise(true);
    connect(cancel, &QToolButton::clicked, this, [this] {
        m_window.workspace().films().cancel();
        m_window.say(tr("Cancelled; nothing of the film was left."));
    });
    m_shownWhileBusy = {m_progress, cancel};
    for (QWidget* widget : m_shownWhileBusy) m_window.statusBar()->addPermanentWidget(widget);
    updateProgress();
}

void FilmExport::updateProgress() {
    const bool isBusy = m_window.workspace().films().isBusy();
    for (QWidget* widget : m_shownWhileBusy) widget->setVisible(isBusy);
}

void FilmExport::ask() {
    play().pause();
    if (!mayBeReplaced()) return;
    FilmDialog dialog(subjectOf(m_window.workspace()), &m_window);
    if (dialog.exec() != QDialog::Accepted || !play().isUnderWay()) return;
    const FilmChoice choice = dialog.choice();
    m_window.workspace().films().make(
        {.scene = play().scene(),
         .script = play().script(),
         .overlays = play().overlays(),
         .plan = planOf(choice, play().thread().stepLength(), m_window.views().scene().viewport()),
         .isCompared = choice.isCompared,
         .place = choice.place.toStdString()});
}

bool FilmExport::mayBeStopped(const QString& question, const QString& yes) {
    if (!m_window.workspace().films().isBusy()) return true;
    QMessageBox box(QMessageBox::Question, QApplication::applicationDisplayName(), question, QMessageBox::NoButton,
                    &m_window);
    QPushButton* stop = box.addButton(yes, QMessageBox::DestructiveRole);
    box.setDefaultButton(box.addButton(tr("Wait for it"), QMessageBox::RejectRole));
    box.exec();
    return box.clickedButton() == stop;
}

bool FilmExport::mayBeReplaced() {
    return mayBeStopped(tr("A film is being made. Another one stops it, and nothing of it stays."), tr("Stop it"));
}

bool FilmExport::mayBeClosed() {
    return mayBeStopped(tr("A film is being made. Closing the window stops it, and nothing of it stays."),
                        tr("Close the window"));
}

void FilmExport::tellFinished(const FilmOrder& order) {
    const QString place = QDir::toNativeSeparators(QString::fromStdString(order.place.string()));
    m_window.say(tr("%L1 pictures in %2.").arg(order.plan.pictures).arg(place));
}

void FilmExport::tellFailed(const QString& sentence) {
    QMessageBox::warning(&m_window, QApplication::applicationDisplayName(), sentence);
}

}  // namespace rubble
