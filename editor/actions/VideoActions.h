#pragma once

#include "core/base/Diagnostic.h"

#include <QElapsedTimer>
#include <QObject>

class QAction;
class QProgressBar;

namespace rubble {

struct VideoOptions;
struct VideoRequest;
class PlayController;
class VideoEstimate;
class Views;
class Workspace;

/// The action that exports what was simulated, or a saved throw, as a video, and the progress bar with its Cancel
/// button in the status bar. The window stays usable during the export.
class VideoActions : public QObject {
    Q_OBJECT
public:
    explicit VideoActions(Views& views);

    QAction* action() const { return m_action; }
    /// Asks before closing the window stops an export. Returns false if the user lets it continue.
    bool confirmClose();

private:
    void exportWithDialog();
    void openPresentMenu(const QPoint& point);
    bool confirmStop(const QString& question, const QString& action);
    void exportRecording(const VideoOptions& options);
    void exportThrow(const VideoOptions& options);
    bool isRecorded() const;
    void updateEnabled();
    void addProgress();
    void showProgress(double fraction);
    void updateProgress();
    void showFinished(const VideoRequest& request);
    void showFailed(const QString& sentence);
    void report(Severity severity, const QString& sentence);

    Views& m_views;
    Workspace& m_workspace;
    QAction* m_action;
    VideoEstimate* m_estimate;
    QProgressBar* m_progress = nullptr;
    QList<QWidget*> m_progressWidgets;
    QElapsedTimer m_clock;      // since the progress was m_clockStart
    double m_clockStart = 0.0;  // in [0, 1]
};

}  // namespace rubble
