#include "editor/dialogs/ExportOnSave.h"

#include "editor/widgets/TaskDialog.h"

namespace rubble {

ExportOnSave::ExportOnSave(Workspace& workspace, Messages& messages, QObject* parent)
    : QObject(parent), m_workspace(workspace), m_messages(messages) {}

void ExportOnSave::start() {
    cancel();
    const std::optional<ExportOptions> options = lastExportOptions(m_workspace);
    const bool areAssetsGone = options && options->assets && options->assets->empty();
    if (!options || !options->isRepeatedOnSave || areAssetsGone) return;
    m_folder = options->folder;
    m_export = std::make_shared<const ExportJob>(exportJob(m_workspace, *options));
    m_job.start([job = m_export](const TaskContext& task) { return runExport(*job, task); },
                [this](const Result<OutputExport>& run) { deliver(run); });
}

void ExportOnSave::complete(QWidget* parent) {
    if (!isRunning()) return;
    cancel();
    TaskDialog dialog(tr("Exporting…"), parent);
    deliver(
        dialog.run<Result<OutputExport>>([job = m_export](const TaskContext& task) { return runExport(*job, task); }));
}

void ExportOnSave::deliver(const Result<OutputExport>& run) {
    emit finished(addMessages(m_messages, run, m_folder).sentence);
}

}  // namespace rubble

#include "moc_ExportOnSave.cpp"
