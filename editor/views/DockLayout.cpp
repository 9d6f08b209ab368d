#include "editor/views/DockLayout.h"

#include "editor/widgets/Icon.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QSettings>

#include <span>

namespace rubble {

namespace {

constexpr const char* kStateKey = "window/state";
constexpr int kStateVersion = 4;    // to be increased when docks are added, removed or renamed
constexpr int kProjectWidth = 240;  // pixels in the default layout, as the next two
constexpr int kInspectorWidth = 336;
constexpr int kFragmentsHeight = 240;

struct DockPlace {
    const char* name;  // object name and icon name
    Qt::DockWidgetArea area;
    int leastWidth;  // pixels, that labels and fields fit in; docks at the bottom scroll
};

/// Indexed by DockId. Docks of an area lie in this order before they are tabbed.
constexpr DockPlace kPlaces[kDockCount] = {
    {"dock-project", Qt::LeftDockWidgetArea, 150},     {"dock-history", Qt::LeftDockWidgetArea, 150},
    {"dock-inspector", Qt::RightDockWidgetArea, 320},  {"dock-strength", Qt::RightDockWidgetArea, 276},
    {"dock-play-tools", Qt::RightDockWidgetArea, 320}, {"dock-fragments", Qt::BottomDockWidgetArea, 0},
    {"dock-problems", Qt::BottomDockWidgetArea, 0},    {"dock-messages", Qt::BottomDockWidgetArea, 0},
    {"dock-play", Qt::BottomDockWidgetArea, 0},        {"dock-tests", Qt::BottomDockWidgetArea, 0}};

/// Docks behind one another in the default layout; the first one is in front.
constexpr DockId kRightTabs[] = {DockId::Inspector, DockId::Strength, DockId::PlayTools};
constexpr DockId kBottomTabs[] = {DockId::Fragments, DockId::Problems, DockId::Messages, DockId::Play, DockId::Tests};

/// A dock behind another one is visible for Qt, but lies outside of the window.
bool isInFront(const QDockWidget& dock) { return dock.isVisible() && !dock.visibleRegion().isEmpty(); }

}  // namespace

DockLayout::DockLayout(QMainWindow& window) : m_window(window) {}

QDockWidget& DockLayout::add(DockId id, const QString& title, QWidget* content) {
    const auto index = static_cast<std::size_t>(id);
    auto* dock = new QDockWidget(title, &m_window);
    dock->setObjectName(kPlaces[index].name);
    dock->setWidget(content);
    if (kPlaces[index].leastWidth > 0) content->setMinimumWidth(kPlaces[index].leastWidth);
    m_window.addDockWidget(kPlaces[index].area, dock);
    m_docks[index] = dock;
    addAction(*dock);
    return *dock;
}

/// The action raises a dock that is hidden behind another one; it hides only a dock that is in front.
void DockLayout::addAction(QDockWidget& dock) {
    auto* action = new QAction(iconNamed(dock.objectName()), dock.windowTitle(), this);
    action->setStatusTip(tr("Show or hide the %1 dock").arg(dock.windowTitle()));
    action->setCheckable(true);
    connect(&dock, &QDockWidget::visibilityChanged, action, [action, &dock] { action->setChecked(!dock.isHidden()); });
    connect(action, &QAction::triggered, this, [action, &dock] {
        const bool isShown = isInFront(dock);
        dock.setVisible(!isShown);
        if (!isShown) dock.raise();
        action->setChecked(!isShown);
    });
    m_actions.append(action);
}

void DockLayout::reset() {
    for (std::size_t index = 0; index < kDockCount; ++index) {
        m_docks[index]->setFloating(false);
        m_window.addDockWidget(kPlaces[index].area, m_docks[index]);
        m_docks[index]->show();
    }
    m_window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    m_window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    const auto tabify = [this](std::span<const DockId> tabs) {
        for (std::size_t k = 1; k < tabs.size(); ++k) m_window.tabifyDockWidget(&dock(tabs[k - 1]), &dock(tabs[k]));
        dock(tabs.front()).raise();
    };
    tabify(kBottomTabs);
    tabify(kRightTabs);
    QDockWidget *project = &dock(DockId::Project), *inspector = &dock(DockId::Inspector);
    m_window.resizeDocks({project, inspector}, {kProjectWidth, kInspectorWidth}, Qt::Horizontal);
    m_window.resizeDocks({project, &dock(DockId::History)}, {3, 1}, Qt::Vertical);
    m_window.resizeDocks({&dock(DockId::Fragments)}, {kFragmentsHeight}, Qt::Vertical);
}

void DockLayout::hideAll() {
    for (QDockWidget* dock : m_docks) dock->hide();
}

void DockLayout::toggle() {
    const QList<QDockWidget*> visible = shown(), front = inFront();
    for (QDockWidget* dock : visible.isEmpty() ? m_toggled : visible) dock->setHidden(!visible.isEmpty());
    if (visible.isEmpty()) raise(m_toggledInFront);
    m_toggled = visible;
    m_toggledInFront = front;
}

QList<QDockWidget*> DockLayout::shown() const {
    QList<QDockWidget*> docks = m_window.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly);
    docks.removeIf([](const QDockWidget* dock) { return dock->isHidden(); });
    return docks;
}

QList<QDockWidget*> DockLayout::inFront() const {
    QList<QDockWidget*> docks = shown();
    docks.removeIf([](const QDockWidget* dock) { return !isInFront(*dock); });
    return docks;
}

void DockLayout::raise(const QList<QDockWidget*>& docks) {
    for (QDockWidget* dock : docks) {
        if (!dock->isHidden()) dock->raise();
    }
}

void DockLayout::save() const { QSettings().setValue(kStateKey, m_window.saveState(kStateVersion)); }

bool DockLayout::restore() { return m_window.restoreState(QSettings().value(kStateKey).toByteArray(), kStateVersion); }

}  // namespace rubble

#include "moc_DockLayout.cpp"
