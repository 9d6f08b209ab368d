#include "editor/dialogs/ExportOnSave.h"

#include "editor/document/FilePath.h"
#include "editor/widgets/TaskDialog.h"

namespace rubble {

ExportOnSave::ExportOnSave(Workspace& workspace, Messages& messages, QObject* parent)
    : QObject(parent), m_workspace(workspace), m_messages(messages) {}

void ExportOnSave::start() {
    cancel();
    std::vector<ExportJob> jobs;
    for (const ExportOptions& options : earlierExports(m_workspace)) {
        const bool areAssetsGone = options.assets && options.assets->empty();
        if (options.isRepeatedOnSave && !areAssetsGone) jobs.push_back(exportJob(m_workspace, options));
    }
    if (jobs.empty()) return;
    m_exports = std::make_shared<const std::vector<ExportJob>>(std::move(jobs));
    m_job.start([jobs = m_exports](const TaskContext& task) { return runAll(*jobs, task); },
                [this](const Runs& runs) { deliver(runs); });
}

void ExportOnSave::complete(QWidget* parent) {
    if (!isRunning()) return;
    cancel();
    TaskDialog dialog(tr("Exporting…"), parent);
    deliver(dialog.run<Runs>([jobs = m_exports](const TaskContext& task) { return runAll(*jobs, task); }));
}

ExportOnSave::Runs ExportOnSave::runAll(const std::vector<ExportJob>& jobs, const TaskContext& task) {
    std::vector<Result<OutputExport>> runs;
    for (std::size_t k = 0; k < jobs.size(); ++k) {
        const double from = static_cast<double>(k), count = static_cast<double>(jobs.size());
        runs.push_back(runExport(jobs[k], task.stage(from / count, (from + 1.0) / count)));
    }
    return runs;
}

void ExportOnSave::deliver(const Runs& runs) {
    QStringList sentences;
    for (std::size_t k = 0; k < m_exports->size(); ++k) {
        const QString folder = fromPath((*m_exports)[k].request.folder);
        const Result<OutputExport> run = runs ? (*runs)[k] : Result<OutputExport>(runs.error());
        sentences += addMessages(m_messages, run, folder).sentence;
    }
    emit finished(sentences.join(' '));
}

}  // namespace rubble

#include "moc_ExportOnSave.cpp"
