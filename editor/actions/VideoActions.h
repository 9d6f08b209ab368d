#pragma once

#include <QObject>

class QAction;
class QProgressBar;

namespace rubble {

struct VideoRequest;
class PlayController;
class Views;
class Workspace;

/// The action that exports the simulation as a video, and the progress bar with its Cancel button in the status bar.
/// The window stays usable during the export.
class VideoActions : public QObject {
    Q_OBJECT
public:
    explicit VideoActions(Views& views);

    QAction* action() const { return m_action; }
    /// Asks before closing the window stops an export. Returns false if the user lets it continue.
    bool confirmClose();

private:
    void exportWithDialog();
    bool confirmStop(const QString& question, const QString& action);
    void addProgress();
    void updateProgress();
    void showFinished(const VideoRequest& request);
    void showFailed(const QString& sentence);

    Views& m_views;
    Workspace& m_workspace;
    QAction* m_action;
    QProgressBar* m_progress = nullptr;
    QList<QWidget*> m_progressWidgets;
};

}  // namespace rubble
