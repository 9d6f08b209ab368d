#include "editor/actions/CompareActions.h"

#include "core/io/project/ProjectFile.h"
#include "editor/canvas/widget/PatternCanvas.h"
#include "editor/dialogs/FileFilters.h"
#include "editor/dialogs/MessageBoxes.h"
#include "editor/document/FilePath.h"
#include "editor/document/FragmentVisibility.h"
#include "editor/document/ShownText.h"
#include "editor/panels/docks/ChangesPanel.h"
#include "editor/view3d/SceneView.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/workspace/Workspace.h"

#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>

namespace rubble {

void ClosableDock::closeEvent(QCloseEvent* event) {
    QDockWidget::closeEvent(event);
    emit closed();
}

CompareActions::CompareActions(Views& views)
    : QObject(&views.window()),
      m_views(views),
      m_workspace(views.workspace()),
      m_comparison(m_workspace.document(), m_workspace.selection(), m_workspace.bakes()),
      m_panel(new ChangesPanel(m_comparison, m_workspace.selection(), m_workspace.document())),
      m_dock(new ClosableDock(tr("Changes"), &views.window())),
      m_compareWithSaved(
          makeAction(this, {"asset-changes", tr("C&ompare with Saved State"),
                            tr("Show what changed since the project was saved"), QKeySequence("Ctrl+Shift+D")})),
      m_compareWithFile(makeAction(this, {"asset-compare", tr("Compare with &File…"),
                                          tr("Compare the active asset with another project file")})) {
    m_dock->setObjectName("dock-changes");
    m_dock->setWidget(m_panel);
    m_dock->hide();
    connect(m_compareWithSaved, &QAction::triggered, this, &CompareActions::compareWithSaved);
    connect(m_compareWithFile, &QAction::triggered, this, &CompareActions::compareWithFile);
    connect(m_dock, &ClosableDock::closed, this, &CompareActions::end);
    connect(m_panel, &ChangesPanel::dismissed, this, &CompareActions::end);
    connect(m_panel, &ChangesPanel::jumpRequested, this, &CompareActions::reveal);
    connect(&views.canvas(), &PatternCanvas::comparisonDismissed, this, &CompareActions::end);
    connect(&m_comparison, &StateComparison::changed, this, &CompareActions::updateCanvas);
    connect(&views, &Views::layoutRestored, m_dock, &QDockWidget::hide);  // what it compared is not saved
    connect(&m_comparison, &StateComparison::failed, &views, &Views::showStatus);
    connect(&m_workspace.file(), &DocumentFile::pathChanged, this, &CompareActions::updateEnabled);
    connect(&m_workspace.selection(), &Selection::assetChanged, this, &CompareActions::updateEnabled);
    updateEnabled();
}

void CompareActions::updateEnabled() {
    const bool hasAsset = m_workspace.asset() != nullptr;
    m_compareWithSaved->setEnabled(hasAsset && !m_workspace.file().path().isEmpty());
    m_compareWithFile->setEnabled(hasAsset);
}

void CompareActions::compareWithSaved() {
    if (m_comparison.isOn()) return end();
    compareWithFileOnDisk();
}

void CompareActions::compareWithFileOnDisk() {
    const DocumentFile& file = m_workspace.file();
    compareWith(file.path(), tr("%1 as saved").arg(file.name()));
}

void CompareActions::compareWithFile() {
    const QString folder = QFileInfo(m_workspace.file().path()).path();
    const QString path =
        QFileDialog::getOpenFileName(&m_views.window(), tr("Compare with File"), folder, projectFilter());
    if (!path.isEmpty()) compareWith(path, fileNameText(path));
}

void CompareActions::compareWith(const QString& path, const QString& name) {
    std::vector<Diagnostic> notes;
    Result<Project> other = loadProject(toPath(path), &notes);
    if (!other) return showError(&m_views.window(), other.error());
    m_views.showProject();
    m_views.setCanvasVisible(true);
    m_views.window().addDockWidget(Qt::RightDockWidgetArea, m_dock);
    m_dock->show();
    m_dock->raise();
    if (!notes.empty()) m_views.showStatus(noteText(notes.front(), *other));
    m_comparison.begin(std::make_shared<const Project>(std::move(*other)), name);
    m_views.canvas().setFocus();
}

void CompareActions::end() {
    m_comparison.end();
    m_dock->hide();
}

void CompareActions::updateCanvas() { m_views.canvas().setCompared(m_comparison.value()); }

/// Selects a fragment and frames it; frames the former place of a removed one.
void CompareActions::reveal(const FragmentDifference& fragment) {
    Selection& selection = m_workspace.selection();
    const ComparedAsset& compared = *m_comparison.value();
    const bool exists = fragment.after != kNone;
    const Bake& bake = exists ? *compared.after : *compared.before;
    selection.setEnteredFragment({});
    const Vec2 place{bake.fragment(exists ? fragment.after : fragment.before).solid.offset()};
    if (exists) {
        FragmentSet marked(bake.fragmentCount(), false);
        marked[fragment.after] = true;
        selection.setFragments(selectionOf(marked, bake));
        showSelected(selection, bake);
    } else {
        selection.setSeeds({});
    }
    m_views.canvas().frameSelected(place);
    if (exists) m_views.scene().frameFragments();
}

}  // namespace rubble

#include "moc_CompareActions.cpp"
