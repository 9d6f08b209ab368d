#pragma once

#include <QObject>

class QAction;
class QProgressBar;

namespace rubble {

struct FilmOrder;
class MainWindow;
class PlayController;

/// The action that films what was played, and its progress in the status bar, with a way to cancel. The window stays usable
/// meanwhile.
class FilmExport : public QObject {
    Q_OBJECT
public:
    explicit FilmExport(MainWindow& window);

    QAction* action() const { return m_action; }
    /// Asks, where a film is being made that closing the window would stop; false where the user would rather wait.
    bool mayBeClosed();

private:
    void ask();
    bool mayBeStopped(const QString& question, const QString& yes);
    bool mayBeReplaced();
    void makeProgress();
    void updateProgress();
    void tellFinished(const FilmOrder& order);
    void tellFailed(const QString& sentence);
    PlayController& play() const;

    MainWindow& m_window;
    QAction* m_action;
    QProgressBar* m_progress = nullptr;
    QList<QWidget*> m_shownWhileBusy;
};

}  // namespace rubble
