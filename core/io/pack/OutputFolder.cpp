#include "core/io/pack/OutputFolder.h"

#include "core/base/MessageText.h"
#include "core/io/output/ExportCheck.h"
#include "core/io/output/OutputFiles.h"
#include "core/io/pack/SceneFile.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/CreatedDirectories.h"
#include "core/io/system/FolderExchange.h"
#include "core/io/system/FolderReading.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace rubble {
namespace {

namespace fs = std::filesystem;

/// The names of the folders of all packs of a project, in its order.
std::vector<std::string> folderNames(const Project& project, const PackOptions& options) {
    std::vector<std::string> names;
    for (const auto& [variant, pack] : packNames(project, options)) names.push_back(pack.folder);
    return names;
}

/// Whether there is something at a path, be it a dangling link.
bool isThere(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(path, ignored));
}

/// The names of the files that name all packs: they are written only if all are in place.
std::vector<std::string> filesOfAllPacks(const OutputRequest& request, const Project& project) {
    std::vector<std::string> names;
    if (request.isWithScene && hasScene(project)) names.push_back(kSceneName);
    if (request.target) names.push_back(kReadmeName);
    if (request.target && !request.target->script.empty()) names.emplace_back(request.target->script);
    return names;
}

/// The scene file that is in place, if it is of the same source and was not edited: its bonds take a bake.
std::optional<std::string> presentScene(const OutputRequest& request, const Project& project,
                                        const std::optional<ExportIndex>& earlier) {
    const Result<std::string> bytes = readFile(request.folder / kSceneName);
    if (!earlier || !bytes) return std::nullopt;
    const bool isKept = std::ranges::find(earlier->files, manifestEntry(kSceneName, *bytes)) != earlier->files.end();
    if (!isKept) return std::nullopt;
    const std::string source = "\"source\":\"" + sceneSource(project, request.options).hex() + "\"";
    return bytes->find(source) != std::string::npos ? std::optional(*bytes) : std::nullopt;
}

Result<std::string> sceneBytes(const OutputRequest& request, const Project& project,
                               const std::optional<ExportIndex>& earlier, const TaskContext& task) {
    if (!hasSceneBonds(project)) return sceneFileJson(project, request.options);
    if (std::optional<std::string> present = presentScene(request, project, earlier)) return std::move(*present);
    const Result<std::shared_ptr<const PlayScene>> played = playScene(project, task);
    if (!played) return played.error();
    return sceneFileJson(project, request.options, played->get());
}

Result<std::string> bytesOf(const std::string& name, const OutputRequest& request, const Project& project,
                            const std::optional<ExportIndex>& earlier, const TaskContext& task) {
    if (name == kSceneName) return sceneBytes(request, project, earlier, task);
    if (name == request.target->script) return scriptOf(*request.target);
    return readmeOf(*request.target, request.options.meshes);
}

/// The files in the output folder itself.
Result<std::vector<ExportFile>> outputFiles(const OutputRequest& request, const Project& project,
                                            const std::optional<ExportIndex>& earlier, const TaskContext& task) {
    std::vector<ExportFile> files;
    for (const std::string& name : filesOfAllPacks(request, project)) {
        Result<std::string> bytes = bytesOf(name, request, project, earlier, task);
        if (!bytes) return bytes.error();
        files.push_back({name, std::move(*bytes)});
    }
    return files;
}

IndexedProject indexed(const OutputRequest& request, const Project& project) {
    return {request.project, project.identity};
}

/// Creates the output folder where it is missing, and locks it. An export that fails meanwhile may remove it again.
Result<OpenFile> lockOutput(const fs::path& folder, CreatedDirectories& created, const TaskContext& task) {
    for (;;) {
        if (const Status status = created.create(folder); !status) return status.error();
        Result<OpenFile> lock = lockFolder(folder, task);
        if (!lock && lock.error().code == ErrorCode::NotFound) continue;
        if (!lock) return lock.error();
        struct stat locked {};
        struct stat named {};
        const bool isThere = ::fstat(lock->descriptor(), &locked) == 0 && ::stat(folder.c_str(), &named) == 0;
        if (isThere && locked.st_ino == named.st_ino && locked.st_dev == named.st_dev) return lock;
    }
}

/// Fails where a folder would be replaced that the index lists for another project.
Status checkFoldersOfOthers(const OutputRequest& request, const Project& project, std::span<const Id> assets,
                            const std::optional<ExportIndex>& earlier) {
    const bool isOfOther = earlier && !isIndexOf(earlier, indexed(request, project));
    if (!isOfOther || request.edited == EditedFiles::Replaced) return success();
    for (const auto& [variant, names] : packNames(project, request.options)) {
        const bool isExported = std::ranges::find(assets, variant.asset) != assets.end();
        const bool isListed = std::ranges::find(earlier->folders, names.folder) != earlier->folders.end();
        if (!isExported || !isListed || !isThere(request.folder / names.folder)) continue;
        return Error{ErrorCode::Edited,
                     quotedPath(request.folder / names.folder) + " is of the export of another project, " +
                         quotedName(earlier->project.name) + ", and would be lost; export elsewhere."};
    }
    return success();
}

/// Fails where a file would be replaced that is not of this project's export: before any pack is written.
Status checkFilesOfOthers(const OutputRequest& request, const Project& project,
                          const std::optional<ExportIndex>& earlier, const TaskContext& task) {
    if (!request.hasAllAssets) return success();
    const IndexedProject owner = indexed(request, project);
    const auto isOwn = [&](const std::string& name) {
        const Result<ManifestEntry> current = manifestEntryOfFile(request.folder, name);
        if (!current) return current.error().code == ErrorCode::NotFound;
        return isIndexOf(earlier, owner) && std::ranges::find(earlier->files, *current) != earlier->files.end();
    };
    if (std::ranges::all_of(filesOfAllPacks(request, project), isOwn)) return success();
    const Result<std::vector<ExportFile>> files = outputFiles(request, project, earlier, {.cancel = task.cancel});
    return files ? checkOutputFiles(request.folder, *files, earlier, owner, request.edited) : Status(files.error());
}

/// Sets the assets of an index's folders.
void listAssets(ExportIndex& index, const Project& project, const PackOptions& options,
                const std::optional<ExportIndex>& before) {
    std::map<std::string, IndexedAsset> known;
    if (before) known = before->assets;
    for (const auto& [variant, names] : packNames(project, options))
        known[names.folder] = {variant.asset, variant.variant};
    for (const std::string& folder : index.folders) {
        if (const auto found = known.find(folder); found != known.end()) index.assets.insert(*found);
    }
}

/// Renames the files of engines in a folder that are called after files of its former name.
void renameEngineFiles(const fs::path& folder, const RenamedFolder& names) {
    const Result<std::vector<fs::directory_entry>> entries = entriesOf(folder);
    for (const fs::directory_entry& entry : entries ? *entries : std::vector<fs::directory_entry>()) {
        const std::string name = entry.path().filename().string();
        const bool isCalledAfter = name.starts_with(names.from + '-') || name.starts_with(names.from + '.');
        const fs::path renamed = folder / (names.to + name.substr(std::min(names.from.size(), name.size())));
        if (isCalledAfter && isEngineFile(entry) && !isThere(renamed)) ::rename(entry.path().c_str(), renamed.c_str());
    }
}

/// Renames the folders of assets that have another name since an earlier export of the project, where nothing is in the
/// way: the packs are then written into these.
std::vector<RenamedFolder> renameFolders(const OutputRequest& request, const Project& project,
                                         std::span<const Id> assets, const std::optional<ExportIndex>& earlier) {
    std::vector<RenamedFolder> renamed;
    if (!isIndexOf(earlier, indexed(request, project))) return renamed;
    const std::vector<std::string> current = folderNames(project, request.options);
    for (const auto& [variant, names] : packNames(project, request.options)) {
        const IndexedAsset asset{variant.asset, variant.variant};
        const auto former = std::ranges::find(earlier->assets, asset, [](const auto& entry) { return entry.second; });
        if (std::ranges::find(assets, variant.asset) == assets.end() || former == earlier->assets.end()) continue;
        const RenamedFolder folders{former->first, names.folder};
        const fs::path from = request.folder / folders.from, to = request.folder / folders.to;
        std::error_code ignored;
        const bool isFree = !isThere(to) && std::ranges::find(current, folders.from) == current.end();
        if (folders.from == folders.to || !isFree || !fs::is_directory(fs::symlink_status(from, ignored))) continue;
        if (::rename(from.c_str(), to.c_str()) != 0) continue;  // it is exported anew
        renameEngineFiles(to, folders);
        renamed.push_back(folders);
    }
    return renamed;
}

/// Updates the index and writes how to use the export; the scene only if all packs are in place, else that of before
/// stays. `earlier` is the index before the packs were written.
///
/// Errors: those of writeOutputFiles() and changeExportIndex(); those of playScene() of a scene with bonds.
Status finishExport(const OutputRequest& request, const Project& project, std::span<const AssetExport> packs,
                    const std::optional<ExportIndex>& earlier, const TaskContext& task) {
    const auto isInPlace = [](const AssetExport& pack) { return pack.status.hasValue(); };
    const std::vector<std::string> current = folderNames(project, request.options);
    std::set<std::string> exported;
    for (const AssetExport& pack : packs) {
        if (pack.status) exported.insert(pack.folder.filename().string());
    }
    const IndexedProject owner = indexed(request, project);
    std::vector<ManifestEntry> kept;  // files of before that this export leaves as they are
    const auto list = [&](std::optional<std::span<const ManifestEntry>> files) {
        const auto change = [&](const std::optional<ExportIndex>& before) {
            const std::vector<std::string> stale = stalePacks(request, project, before);
            ExportIndex index = indexAfterExport(before, owner, current, exported, stale);
            if (files) {
                index.files.assign(files->begin(), files->end());
                index.files.insert(index.files.end(), kept.begin(), kept.end());
            }
            listAssets(index, project, request.options, before);
            return index;
        };
        return changeExportIndex(request.folder, change);
    };
    const Status listed = list(std::nullopt);  // whatever fails from here on
    if (!request.hasAllAssets || !listed || (exported.empty() && !packs.empty())) return listed;
    OutputRequest complete = request;
    std::optional<ExportIndex> replaced = earlier;
    if (!std::ranges::all_of(packs, isInPlace)) {
        complete.isWithScene = false;
        const auto isScene = [](const ManifestEntry& file) { return file.name == kSceneName; };
        if (earlier) std::ranges::copy_if(earlier->files, std::back_inserter(kept), isScene);
        if (replaced) std::erase_if(replaced->files, isScene);
    }
    const Result<std::vector<ExportFile>> files = outputFiles(complete, project, earlier, task);
    if (!files) return files.error();
    const Result<std::vector<ManifestEntry>> written =
        writeOutputFiles(request.folder, *files, replaced, owner, request.edited, list);
    return written ? list(*written) : Status(written.error());
}

}  // namespace

std::string indexName(const fs::path& project) { return printableText(project.filename().string()); }

std::vector<std::string> outputFileNames(const OutputRequest& request, const Project& project) {
    std::vector<std::string> names;
    if (request.hasAllAssets) names = filesOfAllPacks(request, project);
    names.push_back(kIndexName);
    return names;
}

Result<OutputExport> exportToFolder(const OutputRequest& request, const Project& project, std::span<const Id> assets,
                                    const TaskContext& task) {
    CreatedDirectories created;
    const Result<OpenFile> lock = lockOutput(request.folder, created, task);
    if (!lock) return lock.error();
    const Result<std::optional<ExportIndex>> earlier = readExportIndex(request.folder);
    if (!earlier) return earlier.error();
    if (const Status free = checkFoldersOfOthers(request, project, assets, *earlier); !free) return free.error();
    if (const Status free = checkFilesOfOthers(request, project, *earlier, task); !free) return free.error();
    OutputExport result{.renamed = renameFolders(request, project, assets, *earlier)};
    Result<std::vector<AssetExport>> packs =
        exportPacks(project, assets, request.folder, request.options, request.edited, task, FolderLocking::ByCaller);
    if (!packs) return packs.error();
    result.packs = std::move(*packs);
    result.stale = stalePacks(request, project, *earlier);
    for (const std::string& name : request.isPruning ? std::exchange(result.stale, {}) : std::vector<std::string>()) {
        const fs::path folder = request.folder / name;
        result.pruned.push_back({folder, removeExportFolder(folder, {.cancel = task.cancel}, FolderLocking::ByCaller)});
    }
    result.finished = finishExport(request, project, result.packs, *earlier, task);
    return result;
}

std::vector<std::string> stalePacks(const OutputRequest& request, const Project& project,
                                    const std::optional<ExportIndex>& earlier) {
    const fs::path& folder = request.folder;
    const std::vector<std::string> current = folderNames(project, request.options);
    std::vector<std::string> stale = staleFolders(earlier, indexed(request, project), current);
    std::erase_if(stale, [&](const std::string& one) {
        const auto isSame = [&](const std::string& other) {
            std::error_code error;  // where one of them is missing
            return fs::equivalent(folder / other, folder / one, error) && !error;
        };
        return !isThere(folder / one) || std::ranges::any_of(current, isSame);
    });
    return stale;
}

}  // namespace rubble
