#include "editor/window/MainWindow.h"

#include "editor/actions/AssetActions.h"
#include "editor/actions/CompareActions.h"
#include "editor/actions/EditActions.h"
#include "editor/actions/FileActions.h"
#include "editor/actions/FragmentActions.h"
#include "editor/actions/HelpActions.h"
#include "editor/actions/InstanceActions.h"
#include "editor/actions/MaterialActions.h"
#include "editor/actions/PlayActions.h"
#include "editor/actions/SelectActions.h"
#include "editor/actions/VideoActions.h"
#include "editor/actions/ViewActions.h"
#include "editor/actions/VisibilityActions.h"
#include "editor/dialogs/FileFilters.h"
#include "editor/document/FragmentSelection.h"
#include "editor/document/ShownText.h"
#include "editor/view3d/SceneView.h"
#include "editor/views/FirstSteps.h"
#include "editor/views/Views.h"
#include "editor/widgets/Buttons.h"
#include "editor/widgets/ElidedLabel.h"
#include "editor/window/StartPage.h"
#include "viewport/widget/ViewportWidget.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QProgressBar>
#include <QScopedValueRollback>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

constexpr const char* kGeometryKey = "window/geometry";
constexpr int kStatusMilliseconds = 6000;
constexpr QSize kDefaultSize{1440, 900};
constexpr QSize kMinimumSize{800, 450};  // a screen of 1600 × 900 pixels at 2×
constexpr QSize kToolIconSize{20, 20};
constexpr int kProgressWidth = 140;  // pixels

constexpr const char* kStateSuffix = ".rubblestate";

/// Returns the path of a dropped project, mesh or state file; empty if there is none.
QString droppedFile(const QMimeData* data) {
    for (const QUrl& url : data->urls()) {
        const QString path = url.toLocalFile();
        if (path.endsWith(kProjectSuffix) || path.endsWith(kStateSuffix) || isMeshPath(path)) return path;
    }
    return {};
}

}  // namespace

MainWindow::MainWindow(Project project, PreferenceStore& preferences, RecentFiles& recentFiles)
    : m_preferences(preferences),
      m_recentFiles(recentFiles),
      m_workspace(std::move(project), backupFolder()),
      m_pages(new QStackedWidget),
      m_views(new Views(m_workspace, *this)) {
    addActions();
    addStartPage();
    m_pages->addWidget(&m_views->panes());
    setCentralWidget(m_pages);
    addToolBars();
    addStatusBar();
    setAcceptDrops(true);
    restoreWindow();
    connectWorkspace();
    connect(m_views, &Views::projectShown, this, &MainWindow::showProject);
    connect(m_views, &Views::presentingChanged, this, &MainWindow::present);
    connect(&m_workspace.videos(), &VideoExporter::changed, this, &MainWindow::updateStatusBar);
    connect(&preferences, &PreferenceStore::changed, this, &MainWindow::applyPreferences);
    const auto setLight = [this](SkyPreset sky, const QString& file, double exposure) {
        m_preferences.setPreferences(withLight(m_preferences.preferences(), sky, file, exposure));
    };
    connect(&m_views->scene(), &SceneView::lightSelected, this, setLight);
    connect(&m_views->scene(), &SceneView::skyFileRequested, this, [this, setLight] {
        const Preferences& current = m_preferences.preferences();
        const QString folder = QFileInfo(current.recentSkyFiles.value(0)).path();
        const QString file = QFileDialog::getOpenFileName(this, tr("Sky from File"), folder, skyFilter());
        if (!file.isEmpty()) setLight(SkyPreset::Studio, file, current.exposure);
    });
    applyPreferences();
    updateTitle();
    updateCounts();
}

MainWindow::~MainWindow() {
    // The views use the workspace until they are destroyed.
    delete m_pages;
    qDeleteAll(findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly));
}

/// Creates the menus.
void MainWindow::addActions() {
    m_fileActions = new FileActions(*m_views, m_preferences, m_recentFiles);
    m_editActions = new EditActions(*m_views, m_preferences);
    m_assetActions = new AssetActions(*m_views);
    auto* materials = new MaterialActions(*m_views);
    auto* fragments = new FragmentActions(*m_views);
    auto* visibility = new VisibilityActions(*m_views);
    auto* instances = new InstanceActions(*m_views, *visibility);
    auto* select = new SelectActions(*m_views, m_preferences, *visibility);
    m_viewActions = new ViewActions(*m_views);
    m_videoActions = new VideoActions(*m_views);
    m_playActions = new PlayActions(*m_views, m_preferences, *m_videoActions);
    auto* help = new HelpActions(*this);
    m_assetActions->menu()->addSeparator();
    m_assetActions->menu()->addActions(materials->actions());
    m_views->setMaterialActions(materials->library(), materials->save());
    m_views->setAddActions(m_assetActions->additions() +
                           QList{m_assetActions->addInstanceAction(), materials->library()});
    m_views->setFragmentActions({.navigation = fragments->navigationActions(),
                                 .editing = fragments->editingActions(),
                                 .selection = select->relatedActions(),
                                 .visibility = visibility->fragmentActions()});
    new FirstSteps(m_workspace.document(), m_views->canvas(),
                   m_assetActions->additions() + QList{m_fileActions->importAction()});
    for (QMenu* menu :
         {m_fileActions->menu(), m_editActions->menu(), select->menu(), m_viewActions->menu(), m_assetActions->menu(),
          fragments->menu(), instances->menu(), m_playActions->menu(), help->menu()}) {
        menuBar()->addMenu(menu);
    }
    connect(m_fileActions, &FileActions::newProjectRequested, this, [this] {
        if (!isUntouched()) return void(emit newProjectRequested());
        if (!isPristine()) showStatus(tr("This project is new and empty."));
        m_views->showProject();
    });
    connect(m_fileActions, &FileActions::openProjectRequested, this, &MainWindow::openProjectRequested);
    connect(m_fileActions, &FileActions::exampleRequested, this, &MainWindow::openCopyRequested);
    connect(m_fileActions, &FileActions::quitRequested, this, &MainWindow::quitRequested);
    connect(m_fileActions, &FileActions::compareRequested, &m_assetActions->comparison(),
            &CompareActions::compareWithFileOnDisk);
}

void MainWindow::addStartPage() {
    auto* page = new StartPage(m_recentFiles);
    connect(page, &StartPage::newProjectRequested, m_views, &Views::showProject);
    connect(page, &StartPage::openRequested, m_fileActions->openAction(), &QAction::trigger);
    connect(page, &StartPage::importRequested, m_fileActions->importAction(), &QAction::trigger);
    connect(page, &StartPage::recentRequested, m_fileActions, &FileActions::openFile);
    connect(page, &StartPage::exampleRequested, this, &MainWindow::openCopyRequested);
    connect(page, &StartPage::demoRequested, this, &MainWindow::playDemoRequested);
    auto* scroll = new QScrollArea;  // on small screens
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    m_pages->addWidget(scroll);
}

void MainWindow::addToolBars() {
    const auto add = [this](const char* name, const QString& title, const QList<QAction*>& actions) {
        QToolBar* bar = addToolBar(title);
        bar->setObjectName(name);
        bar->setIconSize(kToolIconSize);
        bar->addActions(actions);
        bar->hide();
        m_toolBars.append(bar);
        return bar;
    };
    add("bar-file", tr("File"), m_fileActions->toolbarActions());
    add("bar-edit", tr("Edit"), m_editActions->toolbarActions());
    add("bar-asset", tr("Asset"), m_assetActions->additions());
    QToolBar* play = add("bar-play", tr("Play"), m_playActions->toolbarActions());
    QToolBar* tools = add("bar-tools", tr("Tools"), m_viewActions->toolActions());
    add("bar-canvas", tr("Canvas"), m_viewActions->canvasActions());
    m_bondBar = add("bar-bonds", tr("Bonds"), m_viewActions->bondActions());
    connect(m_viewActions->bondActions().front(), &QAction::enabledChanged, this, &MainWindow::updateBondBar);
    m_labelledToolBars = {play, tools};
    QList<QAction*> labelled = tools->actions();
    labelled.prepend(play->actions().front());
    labelled += play->actions().mid(1);
    for (QAction* action : labelled) {
        QToolBar* bar = tools->actions().contains(action) ? tools : play;
        auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action));
        if (button != nullptr && action->priority() != QAction::LowPriority) m_labelledButtons.append({button});
    }
}

void MainWindow::addStatusBar() {
    m_hint = new ElidedLabel;
    m_hint->setObjectName("hint");
    m_position = new QLabel;
    m_counts = new QLabel;
    m_bakeProgress = new QProgressBar;
    m_bakeProgress->setMaximumWidth(kProgressWidth);
    m_bakeProgress->setTextVisible(false);
    m_bakeProgress->setAccessibleName(tr("Baking"));
    m_cancelBake = panelButton({}, tr("Cancel"), tr("Cancel baking and keep the last result"), this);
    m_cancelBake->setFocusPolicy(Qt::TabFocus);  // the view keeps the focus
    connect(m_cancelBake, &QToolButton::clicked, this, [this] { m_workspace.baker().cancel(); });
    statusBar()->addWidget(m_hint, 1);
    for (QWidget* widget : QWidgetList{m_bakeProgress, m_cancelBake}) {
        statusBar()->addPermanentWidget(widget);
        widget->hide();
    }
    m_readOnly = new QLabel(tr("Read-only"));
    m_readOnly->setObjectName("read-only");
    m_readOnly->hide();
    statusBar()->addPermanentWidget(m_readOnly);
    statusBar()->addPermanentWidget(m_position);
    statusBar()->addPermanentWidget(m_counts);
    connect(m_views, &Views::hintChanged, m_hint, &QLabel::setText);
    connect(m_views, &Views::positionChanged, m_position, &QLabel::setText);
    connect(m_views, &Views::statusMessage, this, &MainWindow::showStatus);
}

/// The layout does not set the least size: content that appears in play would make the window larger than the screen.
void MainWindow::restoreWindow() {
    setMinimumSize(kMinimumSize);
    resize(kDefaultSize);
    restoreGeometry(QSettings().value(kGeometryKey).toByteArray());
    resize(size().boundedTo(screen()->availableSize()));
}

void MainWindow::connectWorkspace() {
    connect(&m_workspace.play(), &PlayController::stateChanged, this, [this] {
        m_labelledWidth = 0;  // "Stop" is wider than "Play"
        if (!isPristine()) updateToolButtonStyle();
    });
    connect(&m_workspace.document(), &Document::modifiedChanged, this, &MainWindow::updateTitle);
    connect(&m_workspace.document(), &Document::memoryRanOut, this, [] {
        if (auto* application = qobject_cast<Application*>(QCoreApplication::instance()))
            application->noteOutOfMemory();
    });
    connect(&m_workspace.file(), &DocumentFile::pathChanged, this, &MainWindow::updateTitle);
    connect(&m_workspace.autosave(), &Autosave::failed, this, &MainWindow::showStatus);
    connect(&m_workspace.baker(), &Baker::progressed, this, &MainWindow::updateBakeProgress);
    connect(&m_workspace.bakes(), &Bakes::changed, this, &MainWindow::updateCounts);
    connect(&m_workspace.bakes(), &Bakes::patternChanged, this, [this] {
        if (!m_workspace.selection().enteredFragment().empty()) updateCounts();
    });
    connect(&m_workspace.selection(), &Selection::assetChanged, this, &MainWindow::updateCounts);
    connect(&m_workspace.selection(), &Selection::seedsChanged, this, &MainWindow::updateCounts);
}

bool MainWindow::isPristine() const { return !m_views->isProjectShown(); }

bool MainWindow::isUntouched() {
    Document& document = m_workspace.document();
    const bool isEdited = document.isModified() || document.undoStack().canRedo();
    if (isEdited || !m_workspace.file().path().isEmpty()) return false;
    return isPristine() || document.project().assets.empty();
}

/// A window stays open under a dialog or a task, which belongs to it and runs an event loop in a function of it. Both
/// would be destroyed meanwhile when the program quits from another window or the session ends.
bool MainWindow::confirmStop() {
    if (m_isBlocked) activateWindow();
    return !m_isBlocked && m_videoActions->confirmClose();
}

bool MainWindow::confirmClose() { return confirmStop() && m_fileActions->confirmClose(); }

void MainWindow::playDemo() {
    PlayController& play = m_workspace.play();
    PlayToolSettings tools = play.toolSettings();
    tools.throwsOnClick = true;
    play.setToolSettings(tools);
    m_playActions->start();
}

bool MainWindow::closeWithoutSaving() {
    const QScopedValueRollback discarding(m_isDiscarding, true);
    return close();
}

void MainWindow::showProject() {
    m_pages->setCurrentWidget(&m_views->panes());
    for (QToolBar* bar : m_toolBars) bar->show();
    updateBondBar();
}

/// Hides the bars, or shows those that were shown before. The keys of a menu bar that is hidden would not work.
void MainWindow::present(bool isOn) {
    if (isOn) {
        m_barsBeforePresenting = m_toolBars;
        m_barsBeforePresenting.removeIf([](const QToolBar* bar) { return bar->isHidden(); });
    }
    for (QToolBar* bar : m_barsBeforePresenting) bar->setHidden(isOn);
    menuBar()->setMaximumHeight(isOn ? 0 : QWIDGETSIZE_MAX);
    updateStatusBar();
    if (!isOn) updateBondBar();
}

/// While presenting, it is shown for the progress of a video only.
void MainWindow::updateStatusBar() {
    statusBar()->setVisible(!m_views->scene().viewport().isPresenting() || m_workspace.videos().isBusy());
}

void MainWindow::showStatus(const QString& sentence) { statusBar()->showMessage(sentence, kStatusMilliseconds); }

/// Shrinks and moves the window so that it lies on the screen with its frame, which is known once it is active.
void MainWindow::fitToScreen() {
    if (isMaximized() || isFullScreen()) return;
    const QRect available = screen()->availableGeometry();
    const QSize frame = frameGeometry().size() - size();
    resize(size().boundedTo(available.size() - frame));
    QRect outer = frameGeometry();
    outer.moveRight(std::min(outer.right(), available.right()));
    outer.moveBottom(std::min(outer.bottom(), available.bottom()));
    outer.moveTopLeft({std::max(outer.left(), available.left()), std::max(outer.top(), available.top())});
    if (outer.topLeft() != frameGeometry().topLeft()) move(outer.topLeft());
}

bool MainWindow::event(QEvent* event) {
    if (event->type() == QEvent::WindowActivate && !std::exchange(m_isFitted, true)) fitToScreen();
    if (event->type() == QEvent::ThemeChange) emit desktopThemeChanged();
    if (event->type() == QEvent::WindowBlocked) m_isBlocked = true;
    if (event->type() == QEvent::WindowUnblocked) m_isBlocked = false;
    return QMainWindow::event(event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if ((m_isBlocked || !m_isDiscarding) && !confirmClose()) return event->ignore();
    m_views->scene().viewport().setPresenting(false);  // the layout that is saved is that of editing
    QSettings().setValue(kGeometryKey, saveGeometry());
    if (!isPristine()) m_views->saveLayout();
    event->accept();
}

/// In play, Return in a field of a dock gives the keys back to the simulation.
void MainWindow::keyPressEvent(QKeyEvent* event) {
    const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!isReturn || !m_workspace.play().isInPlay()) return QMainWindow::keyPressEvent(event);
    m_views->scene().viewport().setFocus();
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    if (!isPristine()) updateToolButtonStyle();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!droppedFile(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QString path = droppedFile(event->mimeData());
    event->acceptProposedAction();
    const auto open = [this, path] {
        path.endsWith(kStateSuffix) ? m_playActions->loadState(path) : m_fileActions->openFile(path);
    };
    QMetaObject::invokeMethod(this, open, Qt::QueuedConnection);
}

/// The bar takes the room of texts, so it is shown only where there is something to paint.
void MainWindow::updateBondBar() {
    m_bondBar->setVisible(!isPristine() && !m_views->scene().viewport().isPresenting() &&
                          m_viewActions->bondActions().front()->isEnabled());
    m_labelledWidth = 0;
    if (!isPristine()) updateToolButtonStyle();
}

/// The width of all toolbars that are shown.
int MainWindow::toolBarWidth() const {
    int width = 0;
    for (const QToolBar* bar : m_toolBars) {
        if (!bar->isHidden()) width += bar->sizeHint().width();
    }
    return width;
}

/// Measures the toolbars with texts and without, and each text.
void MainWindow::measureToolBars() {
    for (QToolBar* bar : m_labelledToolBars) bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_labelledWidth = toolBarWidth();
    for (QToolBar* bar : m_labelledToolBars) bar->setToolButtonStyle(Qt::ToolButtonIconOnly);
    for (LabelledButton& labelled : m_labelledButtons) {
        labelled.button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        labelled.textWidth = labelled.button->sizeHint().width();
        labelled.button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        labelled.textWidth -= labelled.button->sizeHint().width();
    }
    m_plainWidth = toolBarWidth();
}

/// The most used tool buttons show texts: all if the window is wide enough, else the first for which there is room.
void MainWindow::updateToolButtonStyle() {
    if (m_labelledWidth == 0) measureToolBars();
    const bool hasRoom = width() >= m_labelledWidth;
    for (QToolBar* bar : m_labelledToolBars)
        bar->setToolButtonStyle(hasRoom ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    if (hasRoom) return;
    int room = width() - m_plainWidth;
    for (const LabelledButton& labelled : m_labelledButtons) {
        room -= labelled.textWidth;
        labelled.button->setToolButtonStyle(room >= 0 ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    }
}

void MainWindow::applyPreferences() {
    const Preferences& preferences = m_preferences.preferences();
    m_workspace.autosave().setInterval(std::chrono::seconds(preferences.autosaveSeconds));
    m_views->applyPreferences(preferences);
}

void MainWindow::updateTitle() {
    const DocumentFile& file = m_workspace.file();
    const QString name = file.name() + "[*]" + (file.isReadOnly() ? tr(" (read-only)") : QString());
    setWindowTitle(name + " – " + QApplication::applicationDisplayName());
    m_readOnly->setVisible(file.isReadOnly());
    m_readOnly->setToolTip(toolTipText(file.readOnlyReason()));
    setWindowModified(m_workspace.document().isModified());
    setWindowFilePath(file.path());
}

void MainWindow::updateCounts() {
    const Selection& selection = m_workspace.selection();
    const auto pattern = m_workspace.bakes().findPattern(selection.asset(), selection.enteredFragment());
    const auto baked = m_workspace.bakes().find(selection.asset());
    if (!pattern || !baked || !baked->bake) return m_counts->clear();
    const BakedFracture& whole = baked->bake->fractures.front();
    const std::size_t seeds = pattern->section ? whole.seeds.ids.size() : pattern->seeds.positions.size();
    QStringList counts = {
        tr("%Ln seed(s)", nullptr, static_cast<int>(seeds)),
        tr("%Ln fragment(s)", nullptr, static_cast<int>(baked->bake->fragmentCount())),
    };
    const FragmentSet selected = fragmentsOf(selection.fragments(), *baked->bake);
    if (const auto count = std::ranges::count(selected, true); count > 0) counts.append(tr("%L1 selected").arg(count));
    m_counts->setText(counts.join(" · "));
}

void MainWindow::updateBakeProgress(Id asset, double fraction) {
    const bool isBaking = asset != 0 && fraction > 0.0;
    m_bakeProgress->setVisible(isBaking);
    m_cancelBake->setVisible(isBaking);
    m_bakeProgress->setValue(static_cast<int>(100.0 * fraction));
    if (const Asset* baked = findAsset(m_workspace.project(), asset)) {
        m_bakeProgress->setToolTip(toolTipText(tr("Baking %1").arg(nameText(baked->name))));
    }
}

}  // namespace rubble

#include "moc_MainWindow.cpp"
