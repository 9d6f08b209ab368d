#include "editor/dialogs/ProjectExport.h"

#include "core/io/formats/ExportFormat.h"
#include "editor/dialogs/MessageBoxes.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/TaskDialog.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>

namespace rubble {

namespace {

constexpr const char* kTargetsKey = "targets";
constexpr const char* kFormatsKey = "formats";
constexpr std::size_t kMaxTargets = 8;

struct ExportTexts {
    Q_DECLARE_TR_FUNCTIONS(Export)
};

/// Returns the settings group of a project's last export; empty for a project without a file.
QString settingsGroup(const QString& projectPath) {
    const QString key = projectKey(projectPath);
    return key.isEmpty() ? key : "exports/" + key;
}

QString textOf(std::string_view word) { return QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size())); }

/// The formats of stored words; those that this version does not know are left out.
FormatSet formatsNamed(const QVariant& words) {
    FormatSet formats;
    for (const QString& word : words.toStringList()) {
        if (const ExportFormat* format = formatNamed(word.toStdString())) formats.insert(format->word);
    }
    return formats;
}

void write(QSettings& settings, const ExportOptions& options) {
    settings.setValue("folder", settingOf(options.folder));
    settings.setValue("target", textOf(options.target->word));
    settings.setValue("scene", options.isWithScene);
    settings.setValue("onSave", options.isRepeatedOnSave);
    QStringList formats;
    for (const std::string_view word : options.pack.meshes.formats) formats.append(textOf(word));
    settings.setValue(kFormatsKey, formats);
    for (const ExportOption* option : exportOptions())
        settings.setValue(textOf(option->word), textOf(option->values[option->get(options.pack)].word));
    if (!options.assets) return;
    QStringList assets;
    for (const Id asset : *options.assets) assets.append(QString::number(asset));
    settings.setValue("assets", assets);
}

/// Reads the options of a target. Assets that no longer exist are left out.
ExportOptions read(const QSettings& settings, const Project& project) {
    ExportOptions options{.folder = pathOf(settings.value("folder"))};
    if (const ExportTarget* target = targetNamed(settings.value("target").toString().toStdString()))
        options.target = target;
    options.pack = options.target->options();
    options.isWithScene = settings.value("scene", true).toBool();
    options.isRepeatedOnSave = settings.value("onSave").toBool();
    if (settings.contains(kFormatsKey)) options.pack.meshes.formats = formatsNamed(settings.value(kFormatsKey));
    for (const ExportOption* option : exportOptions()) {
        if (const auto value = valueNamed(*option, settings.value(textOf(option->word)).toString().toStdString()))
            option->set(options.pack, *value);
    }
    if (!settings.contains("assets")) return options;
    options.assets.emplace();
    for (const QString& asset : settings.value("assets").toStringList()) {
        if (findAsset(project, asset.toUInt())) options.assets->push_back(asset.toUInt());
    }
    return options;
}

void store(const QString& group, std::vector<ExportOptions> targets) {
    if (group.isEmpty()) return;
    QSettings settings;
    settings.remove(group);
    settings.beginGroup(group);
    settings.beginWriteArray(kTargetsKey);
    for (std::size_t k = 0; k < targets.size(); ++k) {
        settings.setArrayIndex(static_cast<int>(k));
        write(settings, targets[k]);
    }
    settings.endArray();
}

/// The targets without that of a folder.
std::vector<ExportOptions> without(std::vector<ExportOptions> targets, const QString& folder) {
    std::erase_if(targets, [&](const ExportOptions& one) { return one.folder == folder; });
    return targets;
}

/// Keeps the options of an export as the last ones.
void remember(Workspace& workspace, const ExportOptions& options) {
    std::vector<ExportOptions> targets = without(earlierExports(workspace), options.folder);
    targets.push_back(options);
    if (targets.size() > kMaxTargets) targets.erase(targets.begin());
    store(settingsGroup(workspace.file().path()), std::move(targets));
}

std::vector<Id> assetsToExport(const ExportOptions& options, const Project& project) {
    if (options.assets) return *options.assets;
    std::vector<Id> assets;
    for (const Asset& asset : project.assets) assets.push_back(asset.id);
    return assets;
}

OutputRequest outputRequest(Workspace& workspace, const ExportOptions& options) {
    return {.folder = toPath(options.folder),
            .project = indexName(toPath(workspace.file().path())),
            .options = options.pack,
            .target = options.target,
            .hasAllAssets = !options.assets,
            .isWithScene = options.isWithScene};
}

/// Whether nothing was written because a file was changed after the last export.
bool isEdited(const Status& status) { return !status && status.error().code == ErrorCode::Edited; }

/// Asks whether to replace what an export kept: nothing was written, or folders with changed files are as they were.
bool confirmReplacing(const Result<OutputExport>& run, QWidget* parent) {
    const QString replace = ExportTexts::tr("Replace");
    const Status whole = run ? run->finished : Status(run.error());
    if (isEdited(whole))
        return confirmLoss(parent, QString::fromStdString(whole.error().message), replace,
                           ExportTexts::tr("Do Not Export"));
    QStringList folders;
    for (const AssetExport& asset : run ? run->packs : std::vector<AssetExport>()) {
        if (isEdited(asset.status)) folders.append('"' + fileNameText(fromPath(asset.folder)) + '"');
    }
    if (folders.isEmpty()) return false;
    const QString changed = ExportTexts::tr("Files in the %n folder(s) %1 were changed after the last export.", nullptr,
                                            static_cast<int>(folders.size()))
                                .arg(folders.join(", "));
    return confirmLoss(parent, changed + ' ' + ExportTexts::tr("Replacing them discards these changes."), replace,
                       ExportTexts::tr("Keep Changed Files"));
}

/// Adds a message for each asset that failed or was kept, and returns the summary of the others. Files that the user
/// keeps are no failure.
ExportSummary summaryOf(const OutputExport& run, const QString& folder, Messages& messages) {
    ExportSummary summary;
    int written = 0, unchanged = 0, kept = 0;
    const auto keep = [&](const Error& edited, Id asset) {
        ++kept;
        messages.add({.severity = Severity::Warning, .text = QString::fromStdString(edited.message), .asset = asset});
    };
    for (const AssetExport& asset : run.packs) {
        if (asset.status) {
            ++(asset.isUnchanged ? unchanged : written);
            continue;
        }
        if (isEdited(asset.status)) {
            keep(asset.status.error(), asset.asset);
            continue;
        }
        summary.assetErrors.append(QString::fromStdString(asset.status.error().message));
        messages.add({.severity = Severity::Error, .text = summary.assetErrors.last(), .asset = asset.asset});
    }
    if (isEdited(run.finished)) {
        keep(run.finished.error(), {});
    } else if (!run.finished) {
        summary.failure = QString::fromStdString(run.finished.error().message);
        messages.add({.severity = Severity::Error, .text = summary.failure});
    }
    summary.isExported = written + unchanged > 0;
    summary.sentence = ExportTexts::tr("Exported %n asset(s) to %1", nullptr, written).arg(pathText(folder));
    if (unchanged > 0) summary.sentence += ExportTexts::tr("; %L1 unchanged").arg(unchanged);
    if (kept > 0) summary.sentence += ExportTexts::tr("; %L1 kept as changed").arg(kept);
    for (const RenamedFolder& renamed : run.renamed)
        summary.sentence += ExportTexts::tr("; the folder \"%1\" is \"%2\" now")
                                .arg(fileNameText(QString::fromStdString(renamed.from)),
                                     fileNameText(QString::fromStdString(renamed.to)));
    for (const std::string& stale : run.stale)
        summary.sentence += ExportTexts::tr("; the folder \"%1\" is of an asset that is gone, remove it yourself")
                                .arg(fileNameText(QString::fromStdString(stale)));
    summary.sentence += '.';
    return summary;
}

}  // namespace

std::vector<ExportOptions> earlierExports(Workspace& workspace) {
    const QString group = settingsGroup(workspace.file().path());
    QSettings settings;
    if (group.isEmpty()) return {};
    settings.beginGroup(group);
    std::vector<ExportOptions> targets;
    const int count = settings.beginReadArray(kTargetsKey);
    for (int k = 0; k < count; ++k) {
        settings.setArrayIndex(k);
        targets.push_back(read(settings, workspace.project()));
    }
    settings.endArray();
    return targets;
}

QString defaultExportFolder(Workspace& workspace) {
    const QString path = workspace.file().path();
    if (path.isEmpty()) return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/packs";
    const QFileInfo file(path);
    const QString folder = file.absolutePath() + "/packs";
    const Result<std::optional<ExportIndex>> index = readExportIndex(toPath(folder));
    const IndexedProject project{indexName(toPath(path)), workspace.project().identity};
    const bool isOfOther = index && *index && !isIndexOf(*index, project);
    return isOfOther ? file.absolutePath() + '/' + file.completeBaseName() + "-packs" : folder;
}

std::optional<ExportOptions> lastExportOptions(Workspace& workspace) {
    std::vector<ExportOptions> targets = earlierExports(workspace);
    return targets.empty() ? std::nullopt : std::optional(std::move(targets.back()));
}

void forgetExport(Workspace& workspace, const QString& folder) {
    store(settingsGroup(workspace.file().path()), without(earlierExports(workspace), folder));
}

ExportListing exportListing(Workspace& workspace, const ExportOptions& options) {
    const Project& project = workspace.project();
    const OutputRequest request = outputRequest(workspace, options);
    return {.folder = options.folder,
            .packs = packListings(project, assetsToExport(options, project), request.options),
            .files = outputFileNames(request, project)};
}

ExportJob exportJob(Workspace& workspace, const ExportOptions& options) {
    const Project& project = workspace.project();
    return {outputRequest(workspace, options), project, assetsToExport(options, project)};
}

Result<OutputExport> runExport(const ExportJob& job, const TaskContext& task) {
    return exportToFolder(job.request, job.project, job.assets, task);
}

ExportSummary addMessages(Messages& messages, const Result<OutputExport>& run, const QString& folder) {
    if (run) {
        ExportSummary summary = summaryOf(*run, folder, messages);
        messages.add({.text = summary.sentence});
        return summary;
    }
    if (run.error().code == ErrorCode::Cancelled)
        return {.sentence = ExportTexts::tr("Export cancelled. No incomplete files were left.")};
    const QString sentence = QString::fromStdString(run.error().message);
    if (isEdited(run.error())) {  // and the user keeps it
        messages.add({.severity = Severity::Warning, .text = sentence});
        const QString nothing =
            ExportTexts::tr("Nothing was exported to %1: what is there is kept.").arg(pathText(folder));
        messages.add({.text = nothing});
        return {.sentence = nothing};
    }
    messages.add({.severity = Severity::Error, .text = sentence});
    return {.sentence = sentence, .failure = sentence};
}

ExportSummary exportProject(Workspace& workspace, const ExportOptions& options, Messages& messages, QWidget* parent) {
    ExportJob job = exportJob(workspace, options);
    const auto run = [&] {
        TaskDialog dialog(ExportTexts::tr("Exporting…"), parent);
        return dialog.run<Result<OutputExport>>([&](const TaskContext& task) { return runExport(job, task); });
    };
    Result<OutputExport> outcome = run();
    if (confirmReplacing(outcome, parent)) {
        job.request.edited = EditedFiles::Replaced;
        outcome = run();
    }
    ExportSummary summary = addMessages(messages, outcome, options.folder);
    if (outcome) remember(workspace, options);
    if (!summary.failure.isEmpty()) showError(parent, summary.failure);
    if (!summary.assetErrors.isEmpty()) {
        const int failed = static_cast<int>(summary.assetErrors.size());
        const QString others = ExportTexts::tr("%n more asset(s) could not be exported.", nullptr, failed - 1);
        const QString& first = summary.assetErrors.first();
        showError(parent, failed == 1 ? first : first + ' ' + others,
                  failed == 1 ? QStringList() : summary.assetErrors);
    }
    return summary;
}

}  // namespace rubble
