#pragma once

#include <QList>
#include <QObject>

#include <array>

class QAction;
class QDockWidget;
class QMainWindow;
class QWidget;

namespace rubble {

enum class DockId { Project, History, Inspector, Strength, PlayTools, Fragments, Problems, Messages, Play, Tests };
inline constexpr std::size_t kDockCount = 10;

/// The docks of a window and their layout: the default one, and the user's, which is kept in QSettings.
class DockLayout : public QObject {
    Q_OBJECT
public:
    explicit DockLayout(QMainWindow& window);

    /// Creates a dock, and the action that shows and hides it. Each dock is added once, before any other call.
    QDockWidget& add(DockId id, const QString& title, QWidget* content);
    QDockWidget& dock(DockId id) { return *m_docks[static_cast<std::size_t>(id)]; }
    /// Returns an action per dock that shows or hides it, in the order they were added.
    const QList<QAction*>& actions() const { return m_actions; }

    /// Arranges all docks in the default layout and shows them.
    void reset();
    void hideAll();
    /// Hides all docks, or shows those again that were hidden by the last call, with the same tabs in front.
    void toggle();

    /// Returns the docks that are shown, also behind others.
    QList<QDockWidget*> shown() const;
    /// Returns the docks that can be seen: of docks that share tabs, the one in front.
    QList<QDockWidget*> inFront() const;
    /// Raises those of `docks` that are shown in front of the docks that they share tabs with.
    static void raise(const QList<QDockWidget*>& docks);

    void save() const;
    /// Restores the saved layout; false if there is none.
    bool restore();

private:
    void addAction(QDockWidget& dock);

    QMainWindow& m_window;
    std::array<QDockWidget*, kDockCount> m_docks{};
    QList<QAction*> m_actions;
    QList<QDockWidget*> m_toggled;         // hidden by toggle()
    QList<QDockWidget*> m_toggledInFront;  // of m_toggled
};

}  // namespace rubble
