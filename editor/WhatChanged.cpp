#include "editor/WhatChanged.h"

#include "core/io/ProjectFile.h"
#include "editor/Action.h"
#include "editor/FileActions.h"
#include "editor/MainWindow.h"
#include "editor/SceneView.h"
#include "editor/Views.h"
#include "editor/canvas/PatternCanvas.h"
#include "editor/document/FragmentHiding.h"
#include "editor/panels/ChangesPanel.h"

#include <QApplication>
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

namespace rubble {

void ClosingDock::closeEvent(QCloseEvent* event) {
    QDockWidget::closeEvent(event);
    emit closed();
}

WhatChanged::WhatChanged(MainWindow& window)
    : QObject(&window),
      m_window(window),
      m_comparison(window.workspace().document(), window.workspace().selection(), window.workspace().bakes()),
      m_panel(new ChangesPanel(m_comparison, window.workspace().selection(), window.workspace().document())),
      m_dock(new ClosingDock(tr("What Changed"), &window)),
      m_sinceSaving(makeAction(this, {"asset-changes", tr("&What Changed Since Saving"),
                                      tr("Show which pieces are not as they were when the project was saved"),
                                      QKeySequence("Ctrl+Shift+D")})),
      m_sinceFile(
          makeAction(this, {"asset-compare", tr("&Compare with File…"),
                            tr("Show which pieces are not as they are in another saved state of the project")})) {
    m_dock->setObjectName("dock-changes");
    m_dock->setWidget(m_panel);
    m_dock->hide();
    connect(m_sinceSaving, &QAction::triggered, this, &WhatChanged::compareWithSaved);
    connect(m_sinceFile, &QAction::triggered, this, &WhatChanged::compareWithFile);
    connect(m_dock, &ClosingDock::closed, this, &WhatChanged::end);
    connect(m_panel, &ChangesPanel::dismissed, this, &WhatChanged::end);
    connect(m_panel, &ChangesPanel::jumpRequested, this, &WhatChanged::jump);
    connect(&window.views().canvas(), &PatternCanvas::comparisonDismissed, this, &WhatChanged::end);
    connect(&m_comparison, &StateComparison::changed, this, &WhatChanged::show);
    connect(&m_comparison, &StateComparison::said, &window, &MainWindow::say);
    connect(&window.workspace().file(), &DocumentFile::pathChanged, this, &WhatChanged::update);
    connect(&window.workspace().selection(), &Selection::assetChanged, this, &WhatChanged::update);
    update();
}

void WhatChanged::update() {
    const bool hasAsset = m_window.workspace().asset() != nullptr;
    m_sinceSaving->setEnabled(hasAsset && !m_window.workspace().file().path().isEmpty());
    m_sinceFile->setEnabled(hasAsset);
}

void WhatChanged::compareWithSaved() {
    if (m_comparison.isOn()) return end();
    const DocumentFile& file = m_window.workspace().file();
    compareWith(file.path(), tr("%1 as it was saved").arg(file.name()));
}

void WhatChanged::compareWithFile() {
    const QString folder = QFileInfo(m_window.workspace().file().path()).path();
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Compare with File"), folder, projectFilter());
    if (!path.isEmpty()) compareWith(path, QFileInfo(path).fileName());
}

void WhatChanged::compareWith(const QString& path, const QString& name) {
    Result<Project> earlier = loadProject(path.toStdString());
    if (!earlier) {
        QMessageBox::warning(&m_window, QApplication::applicationDisplayName(),
                             QString::fromStdString(earlier.error().message));
        return;
    }
    m_window.showWork();
    m_window.views().showCanvas(true);
    m_window.addDockWidget(Qt::RightDockWidgetArea, m_dock);
    m_dock->show();
    m_dock->raise();
    m_comparison.begin(std::make_shared<const Project>(std::move(*earlier)), name);
    m_window.views().canvas().setFocus();
}

void WhatChanged::end() {
    m_comparison.end();
    m_dock->hide();
}

void WhatChanged::show() { m_window.views().canvas().setCompared(m_comparison.asset()); }

/// Chooses a piece that is there and brings its place close, also where it is gone.
void WhatChanged::jump(const PieceDifference& piece) {
    Selection& selection = m_window.workspace().selection();
    const ComparedAsset& compared = *m_comparison.asset();
    const bool isThere = piece.after != kNone;
    const Bake& bake = isThere ? *compared.after : *compared.before;
    selection.setInside({});
    const Vec2 place{bake.fragment(isThere ? piece.after : piece.before).solid.offset()};
    if (isThere) {
        FragmentSet one(bake.fragmentCount(), false);
        one[piece.after] = true;
        selection.setChoice(choiceOf(one, bake));
        showChosen(selection, bake);
    } else {
        selection.setSeeds({});
    }
    m_window.views().canvas().frameChosen(place);
    if (isThere) m_window.views().scene().frameFragments();
}

}  // namespace rubble
