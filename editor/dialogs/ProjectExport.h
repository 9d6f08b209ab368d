#pragma once

#include "core/io/formats/ExportTarget.h"
#include "core/io/pack/OutputFolder.h"
#include "editor/document/Messages.h"
#include "editor/workspace/Workspace.h"

class QWidget;

namespace rubble {

/// The contents and the destination of an export.
struct ExportOptions {
    QString folder;
    std::optional<std::vector<Id>> assets;  // none: all assets of the project at the time of the export
    const ExportTarget* target = &exportTargets().front();
    PackOptions pack = target->options();
    bool isWithScene = true;  // with scene.json, if all assets are exported and the project has a scene
    bool isRepeatedOnSave = false;
};

/// Returns the options of the project's exports, one per output folder, the last one last; QSettings keep up to eight
/// by the project's path. Assets that no longer exist are left out.
std::vector<ExportOptions> earlierExports(Workspace& workspace);
/// Those of the last export; none if it was never exported.
std::optional<ExportOptions> lastExportOptions(Workspace& workspace);
/// The folder to export to first: "packs" beside the project, or "house-packs" where another project exports to that.
QString defaultExportFolder(Workspace& workspace);
/// Exports to a folder no more, until it is exported there anew.
void forgetExport(Workspace& workspace, const QString& folder);

/// The folders and files that an export writes.
struct ExportListing {
    QString folder;
    std::vector<PackListing> packs;
    std::vector<std::string> files;  // beside the folders of the packs
};
/// Returns what an export of the project writes, as far as it is known before assets are fractured.
ExportListing exportListing(Workspace& workspace, const ExportOptions& options);

/// An export with all that it reads, so that it can run in the background.
struct ExportJob {
    OutputRequest request;
    Project project;
    std::vector<Id> assets;
};
ExportJob exportJob(Workspace& workspace, const ExportOptions& options);

/// Errors: those of exportToFolder(). Those of single assets, and of what is beside the packs, are in the result.
Result<OutputExport> runExport(const ExportJob& job, const TaskContext& task);

/// What an export did, for the user.
struct ExportSummary {
    QString sentence;
    bool isExported = false;  // at least one asset was exported or had been before
    QString failure;          // of the export, or of what is beside the packs; empty: none
    QStringList assetErrors;
};
/// Returns the summary of an export to a folder, and adds it to `messages` after a message for each asset that failed,
/// or whose files were changed and kept.
ExportSummary addMessages(Messages& messages, const Result<OutputExport>& run, const QString& folder);

/// Exports the project with a progress dialog and, where that can be done, stores the options as its last ones. Errors
/// are shown in a message box, and everything is added to `messages`.
ExportSummary exportProject(Workspace& workspace, const ExportOptions& options, Messages& messages, QWidget* parent);

}  // namespace rubble
