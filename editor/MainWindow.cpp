#include "editor/MainWindow.h"

#include "editor/Action.h"
#include "editor/AssetActions.h"
#include "editor/EditActions.h"
#include "editor/FileActions.h"
#include "editor/FilmExport.h"
#include "editor/FirstSteps.h"
#include "editor/FragmentActions.h"
#include "editor/HelpActions.h"
#include "editor/InstanceActions.h"
#include "editor/MaterialActions.h"
#include "editor/PlayActions.h"
#include "editor/Program.h"
#include "editor/SelectActions.h"
#include "editor/StartPage.h"
#include "editor/ViewActions.h"
#include "editor/Views.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

namespace rubble {

namespace {

constexpr const char* kGeometryKey = "window/geometry";
constexpr int kSayMilliseconds = 6000;
constexpr QSize kFirstSize{1440, 900};
constexpr QSize kToolIcon{20, 20};

/// The file that is dropped, where it is one that can be opened or imported.
QString droppedFile(const QMimeData* data) {
    for (const QUrl& url : data->urls()) {
        const QString path = url.toLocalFile();
        if (path.endsWith(kProjectSuffix) || isMeshPath(path)) return path;
    }
    return {};
}

}  // namespace

MainWindow::MainWindow(Program& program, Project project)
    : m_program(program), m_workspace(std::move(project), backupFolder()), m_pages(new QStackedWidget) {
    m_views = new Views(*this);
    m_fileActions = new FileActions(*this);
    m_editActions = new EditActions(*this);
    m_assetActions = new AssetActions(*this);
    m_materialActions = new MaterialActions(*this);
    m_assetActions->menu()->addSeparator();
    m_assetActions->menu()->addActions(m_materialActions->actions());
    m_views->setMaterialActions(m_materialActions->actions());
    m_fragmentActions = new FragmentActions(*this);
    m_instanceActions = new InstanceActions(*this);
    m_selectActions = new SelectActions(*this);  // whose keys come before those of instances
    m_views->setPieceActions({.places = m_fragmentActions->placeActions(),
                              .breaking = m_fragmentActions->breakingActions(),
                              .kin = m_selectActions->kinActions(),
                              .hiding = m_selectActions->hidingActions()});
    m_viewActions = new ViewActions(*this);
    m_playActions = new PlayActions(*this);
    m_helpActions = new HelpActions(*this);
    new FirstSteps(m_workspace.document(), m_views->canvas(),
                   m_assetActions->toolbarActions() + QList{m_fileActions->importAction()});
    for (QMenu* menu : {m_fileActions->menu(), m_editActions->menu(), m_selectActions->menu(), m_viewActions->menu(),
                        m_assetActions->menu(), m_fragmentActions->menu(), m_instanceActions->menu(),
                        m_playActions->menu(), m_helpActions->menu()}) {
        menuBar()->addMenu(menu);
    }
    auto* start = new StartPage(program.recentFiles());
    connect(start, &StartPage::newChosen, this, &MainWindow::showWork);
    connect(start, &StartPage::openChosen, m_fileActions->openAction(), &QAction::trigger);
    connect(start, &StartPage::importChosen, m_fileActions->importAction(), &QAction::trigger);
    connect(start, &StartPage::recentChosen, m_fileActions, &FileActions::take);
    connect(start, &StartPage::exampleChosen, this, [this](const QString& path) { m_program.openCopy(path, this); });
    m_pages->addWidget(start);
    m_pages->addWidget(&m_views->centre());
    setCentralWidget(m_pages);
    makeToolBars();
    makeStatusBar();
    m_views->showDocks(false);

    setAcceptDrops(true);
    setMinimumSize(800, 560);
    resize(kFirstSize);
    restoreGeometry(QSettings().value(kGeometryKey).toByteArray());
    connect(&m_workspace.document(), &Document::modifiedChanged, this, &MainWindow::updateTitle);
    connect(&m_workspace.file(), &DocumentFile::pathChanged, this, &MainWindow::updateTitle);
    connect(&m_workspace.file(), &DocumentFile::changedOnDisk, this, &MainWindow::askAboutChangeOnDisk,
            Qt::QueuedConnection);
    connect(&m_workspace.autosave(), &Autosave::failed, this, &MainWindow::say);
    connect(&m_workspace.baker(), &Baker::progressed, this, &MainWindow::showProgress);
    connect(&m_workspace.bakes(), &Bakes::changed, this, &MainWindow::updateCounts);
    connect(&m_workspace.bakes(), &Bakes::patternChanged, this, [this] {
        if (!m_workspace.selection().inside().empty()) updateCounts();
    });
    connect(&m_workspace.selection(), &Selection::assetChanged, this, &MainWindow::updateCounts);
    connect(&m_workspace.selection(), &Selection::seedsChanged, this, &MainWindow::updateCounts);
    const auto takePreferences = [this] {
        m_workspace.autosave().setInterval(std::chrono::seconds(m_program.preferences().autosaveSeconds));
        m_views->takePreferences(m_program.preferences());
    };
    connect(&program, &Program::preferencesChanged, this, takePreferences);
    takePreferences();
    updateTitle();
    updateCounts();
}

MainWindow::~MainWindow() {
    // What is shown looks at the workspace to its last event.
    delete m_pages;
    qDeleteAll(findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly));
}

bool MainWindow::isPristine() const { return !m_isShowingWork; }

void MainWindow::showWork() {
    if (m_isShowingWork) return;
    m_isShowingWork = true;
    m_pages->setCurrentIndex(1);
    for (QToolBar* bar : m_toolBars) bar->show();
    nameTools();
    m_views->showDocks(true);
    m_viewActions->setWorking(true);
    m_playActions->setWorking(true);
    m_views->fit();
}

void MainWindow::say(const QString& sentence) { statusBar()->showMessage(sentence, kSayMilliseconds); }

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!m_playActions->film().mayBeClosed() || !m_fileActions->mayBeClosed()) return event->ignore();
    QSettings().setValue(kGeometryKey, saveGeometry());
    if (m_isShowingWork) m_views->keepLayout();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!droppedFile(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QString path = droppedFile(event->mimeData());
    event->acceptProposedAction();
    QMetaObject::invokeMethod(
        this, [this, path] { m_fileActions->take(path); }, Qt::QueuedConnection);
}

void MainWindow::makeToolBars() {
    const auto add = [this](const char* name, const QString& title, const QList<QAction*>& actions) {
        QToolBar* bar = addToolBar(title);
        bar->setObjectName(name);
        bar->setIconSize(kToolIcon);
        bar->addActions(actions);
        m_toolBars.append(bar);
    };
    add("bar-file", tr("File"), m_fileActions->toolbarActions());
    add("bar-edit", tr("Edit"), m_editActions->toolbarActions());
    add("bar-asset", tr("Asset"), m_assetActions->toolbarActions());
    add("bar-play", tr("Play"), m_playActions->toolbarActions());
    add("bar-tools", tr("Tools"), m_viewActions->toolActions());
    add("bar-canvas", tr("Canvas"), m_viewActions->canvasActions());
    for (QToolBar* bar : m_toolBars) bar->hide();
    m_namedBars = {m_toolBars[3], m_toolBars[4]};
}

/// Names stand beside the icons that are used most, where the window has room for them.
void MainWindow::nameTools() {
    const auto setStyle = [this](Qt::ToolButtonStyle style) {
        for (QToolBar* bar : m_namedBars) bar->setToolButtonStyle(style);
    };
    if (m_namedWidth == 0) {
        setStyle(Qt::ToolButtonTextBesideIcon);
        for (const QToolBar* bar : m_toolBars) m_namedWidth += bar->sizeHint().width();
    }
    setStyle(width() >= m_namedWidth ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    if (m_isShowingWork) nameTools();
}

void MainWindow::makeStatusBar() {
    m_hint = new QLabel;
    m_hint->setObjectName("hint");
    m_place = new QLabel;
    m_counts = new QLabel;
    m_progress = new QProgressBar;
    m_progress->setMaximumWidth(140);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Baking"));
    auto* cancel = new QToolButton;
    cancel->setText(tr("Cancel"));
    cancel->setToolTip(tr("Stop baking; the last finished result stays"));
    cancel->setAutoRaise(true);
    connect(cancel, &QToolButton::clicked, this, [this] { m_workspace.baker().cancel(); });
    m_cancelBake = cancel;
    statusBar()->addWidget(m_hint, 1);
    for (QWidget* widget : QWidgetList{m_progress, m_cancelBake}) {
        statusBar()->addPermanentWidget(widget);
        widget->hide();
    }
    statusBar()->addPermanentWidget(m_place);
    statusBar()->addPermanentWidget(m_counts);
    connect(m_views, &Views::hintChanged, m_hint, &QLabel::setText);
    connect(m_views, &Views::placeChanged, m_place, &QLabel::setText);
    connect(m_views, &Views::said, this, &MainWindow::say);
}

void MainWindow::updateTitle() {
    const bool isModified = m_workspace.document().isModified();
    setWindowTitle(m_workspace.file().name() + "[*] – " + QApplication::applicationDisplayName());
    setWindowModified(isModified);
    setWindowFilePath(m_workspace.file().path());
}

void MainWindow::updateCounts() {
    const Id asset = m_workspace.selection().asset();
    const auto pattern = m_workspace.bakes().findPattern(asset, m_workspace.selection().inside());
    const auto baked = m_workspace.bakes().find(asset);
    if (!pattern || !baked || !baked->bake) return m_counts->clear();
    QString text =
        tr("%L1 seeds · %L2 fragments").arg(pattern->seeds.positions.size()).arg(baked->bake->fragmentCount());
    if (const std::size_t chosen = m_workspace.selection().seeds().size(); chosen > 0) {
        text += tr(" · %L1 chosen").arg(chosen);
    }
    m_counts->setText(text);
}

void MainWindow::showProgress(Id asset, double fraction) {
    const bool isLong = asset != 0 && fraction > 0.0;
    m_progress->setVisible(isLong);
    m_cancelBake->setVisible(isLong);
    m_progress->setValue(static_cast<int>(100.0 * fraction));
    if (const Asset* known = findAsset(m_workspace.project(), asset)) {
        m_progress->setToolTip(tr("Baking %1").arg(QString::fromStdString(known->name)));
    }
}

void MainWindow::askAboutChangeOnDisk() {
    const QString name = m_workspace.file().name();
    QMessageBox box(QMessageBox::Question, QApplication::applicationDisplayName(),
                    tr("%1 was changed by another program.").arg(name), QMessageBox::NoButton, this);
    box.setInformativeText(m_workspace.document().isModified()
                               ? tr("Reading it again drops what you have changed here.")
                               : tr("You have changed nothing here since it was read."));
    QPushButton* reload = box.addButton(tr("Read it again"), QMessageBox::AcceptRole);
    box.addButton(tr("Keep what is here"), QMessageBox::RejectRole);
    box.exec();
    if (box.clickedButton() != reload) return m_workspace.document().setUnsaved();
    if (const Status read = m_workspace.file().reload(); !read) {
        QMessageBox::warning(this, QApplication::applicationDisplayName(),
                             QString::fromStdString(read.error().message));
        m_workspace.document().setUnsaved();
    }
}

}  // namespace rubble
