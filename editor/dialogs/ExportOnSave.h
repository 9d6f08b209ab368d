#pragma once

#include "editor/dialogs/ProjectExport.h"
#include "editor/document/jobs/BackgroundJob.h"

#include <memory>

namespace rubble {

/// Repeats the last export of a project in the background after it was saved, where its options say so. Nothing is
/// asked: errors and files that were changed since, which are kept, become messages.
class ExportOnSave : public QObject {
    Q_OBJECT
public:
    ExportOnSave(Workspace& workspace, Messages& messages, QObject* parent);

    bool isRunning() const { return m_job.isRunning(); }
    /// Starts the export, instead of one that is running.
    void start();
    /// Cancels a running export and waits; it leaves no incomplete files.
    void cancel() { m_job.cancelAndWait(); }
    /// Completes a running export, with its progress and Cancel where that takes long.
    void complete(QWidget* parent);

signals:
    void finished(const QString& sentence);

private:
    void deliver(const Result<OutputExport>& run);

    Workspace& m_workspace;
    Messages& m_messages;
    QString m_folder;
    std::shared_ptr<const ExportJob> m_export;  // the last one that was started
    BackgroundJob m_job;
};

}  // namespace rubble
