// Tests editor/window/MainWindow.cpp with all docks as assistive technologies see them: through the tree of
// QAccessible, which Qt exports to AT-SPI.
#include "core/asset/library/StarterProject.h"
#include "editor/views/Views.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/EditorStory.h"

#include <QAccessible>
#include <QDockWidget>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>

#include <set>

using namespace rubble;

namespace {

QWidget* widgetOf(const QAccessibleInterface& item) { return qobject_cast<QWidget*>(item.object()); }

QString nameOf(const QAccessibleInterface& item) { return item.text(QAccessible::Name).trimmed(); }

/// Whether a user can operate it: what takes the keyboard focus, and buttons and tabs that do not.
bool isControl(const QAccessibleInterface& item) {
    static const std::set<QAccessible::Role> kOperated = {
        QAccessible::Button,   QAccessible::ButtonMenu,   QAccessible::ButtonDropDown,
        QAccessible::CheckBox, QAccessible::ComboBox,     QAccessible::RadioButton,
        QAccessible::Slider,   QAccessible::SpinBox,      QAccessible::PageTab,
        QAccessible::MenuItem, QAccessible::EditableText, QAccessible::Tree,
        QAccessible::List,     QAccessible::Table,        QAccessible::Dial};
    if (kOperated.contains(item.role())) return true;
    return widgetOf(item) && item.state().focusable;
}

bool isGeneric(QAccessible::Role role) {
    return role == QAccessible::NoRole || role == QAccessible::Client || role == QAccessible::Pane ||
           role == QAccessible::Grouping || role == QAccessible::Whitespace || role == QAccessible::Window;
}

/// A scroll area that contains the widget; null if there is none.
const QAbstractScrollArea* scrollAreaAround(const QWidget& widget) {
    for (const QWidget* at = widget.parentWidget(); at && !at->isWindow(); at = at->parentWidget()) {
        if (const auto* area = qobject_cast<const QAbstractScrollArea*>(at)) return area;
    }
    return nullptr;
}

/// Whether the item lies within its window, apart from what a scroll area can show.
bool isInWindow(const QAccessibleInterface& item) {
    const QWidget* widget = widgetOf(item);
    if (!widget || widget->visibleRegion().isEmpty() || scrollAreaAround(*widget)) return true;
    const QRect window(widget->window()->mapToGlobal(QPoint(0, 0)), widget->window()->size());
    return !item.rect().isEmpty() && window.contains(item.rect());
}

/// "window / Inspector / QSpinBox width".
QString placeOf(const QAccessibleInterface& item) {
    QStringList parts;
    for (const QAccessibleInterface* at = &item; at; at = at->parent()) {
        const QObject* object = at->object();
        if (object && object->objectName() == "main-window") break;
        const QString type = object ? object->metaObject()->className() : "item";
        parts.prepend(
            QString("%1 %2 %3").arg(type, object ? object->objectName() : QString(), nameOf(*at)).simplified());
    }
    return QStringList(parts.mid(parts.size() - 4)).join(" / ");
}

}  // namespace

class AccessibilityTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        openBaked(starterProject());
        window().views().docks().reset();
        window().resize(1440, 900);
        QTRY_COMPARE_WITH_TIMEOUT(window().size(), QSize(1440, 900), kPatience);
    }
    void cleanupTestCase() { close(); }
    void init() { m_faults.clear(); }

    void docksHaveNames() {
        for (std::size_t k = 0; k < kDockCount; ++k) {
            QDockWidget& dock = window().views().docks().dock(static_cast<DockId>(k));
            QCOMPARE(nameOf(*QAccessible::queryAccessibleInterface(&dock)), dock.windowTitle());
        }
    }
    void controlsAreNamedAndWithinTheWindow_data() {
        QTest::addColumn<QString>("subject");
        for (const char* subject : {"asset", "fragments", "instance"}) QTest::newRow(subject) << subject;
    }
    void controlsAreNamedAndWithinTheWindow() {
        QFETCH(const QString, subject);
        if (subject == "fragments") action("select-all")->trigger();
        if (subject == "asset") selection().setAsset(project().assets.front().id);
        if (subject == "instance") selection().setInstances(project(), {project().instances.front().id});
        m_controls = 0;
        for (std::size_t k = 0; k < kDockCount; ++k) {
            QDockWidget& dock = window().views().docks().dock(static_cast<DockId>(k));
            dock.raise();
            for (int n = 0; n < 3; ++n) QCoreApplication::processEvents();  // wrapped texts have a second layout
            walk(*QAccessible::queryAccessibleInterface(&dock));
        }
        walk(*QAccessible::queryAccessibleInterface(&window()));
        for (const QString& fault : std::as_const(m_faults)) qWarning("%s", qPrintable(fault));
        QVERIFY(m_faults.isEmpty());
        QVERIFY(m_controls > 100);
    }

private:
    void walk(const QAccessibleInterface& item) {
        // The window keeps a tab bar without tabs for docks that are stacked later; Qt names a bar by its current tab.
        const auto* tabs = qobject_cast<QTabBar*>(item.object());
        const bool isSpare = tabs && tabs->count() == 0;
        if (isControl(item) && !isSpare) check(item);
        for (int k = 0; k < item.childCount(); ++k) {
            const QAccessibleInterface* child = item.child(k);
            if (child && child->isValid() && !child->state().invisible) walk(*child);
        }
    }
    void check(const QAccessibleInterface& item) {
        ++m_controls;
        if (nameOf(item).isEmpty()) addFault("no name", item);
        if (isGeneric(item.role())) addFault("no role", item);
        if (!isInWindow(item)) addFault("outside its window", item);
    }
    void addFault(const QString& what, const QAccessibleInterface& item) {
        const QString fault = QString("%1: %2").arg(placeOf(item), what);
        if (!m_faults.contains(fault)) m_faults << fault;
    }

    QStringList m_faults;
    int m_controls = 0;
};

RUBBLE_TEST_WITH(AccessibilityTest, QApplication)
#include "AccessibilityTest.moc"
