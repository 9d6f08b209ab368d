#pragma once

#include "editor/dialogs/ProjectExport.h"
#include "editor/document/jobs/BackgroundJob.h"

#include <memory>
#include <vector>

namespace rubble {

/// Repeats the exports of a project in the background after it was saved, where their options say so. Nothing is
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
    using Runs = Result<std::vector<Result<OutputExport>>>;  // one per job; an error of memory
    static Runs runAll(const std::vector<ExportJob>& jobs, const TaskContext& task);
    void deliver(const Runs& runs);

    Workspace& m_workspace;
    Messages& m_messages;
    std::shared_ptr<const std::vector<ExportJob>> m_exports;  // those that were started last
    BackgroundJob m_job;
};

}  // namespace rubble
