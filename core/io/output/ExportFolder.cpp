#include "core/io/output/ExportFolder.h"

#include "core/base/MessageText.h"
#include "core/io/output/ExportCheck.h"
#include "core/io/output/ExportManifest.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/CreatedDirectories.h"
#include "core/io/system/FileErrors.h"
#include "core/io/system/FolderExchange.h"
#include "core/io/system/FolderReading.h"
#include "core/io/system/Temporary.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <optional>
#include <system_error>
#include <vector>

namespace rubble {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFlushes = 16;  // of single files; above, the whole file system is flushed once
enum class Flush { SingleFiles, FileSystem };

/// Writes a file into the folder that will be `folder`; the errors name the latter.
Status writeExportedFile(const fs::path& partial, const fs::path& folder, const std::string& name,
                         std::string_view bytes, bool isFlushed) {
    OpenFile file(partial / name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, 0666);
    if (!file.isOpen()) return cannotWrite(folder / name, errno);
    if (const int code = writeAll(file.descriptor(), bytes)) return cannotWrite(folder / name, code);
    if (isFlushed && ::fsync(file.descriptor()) != 0) return cannotWrite(folder / name, errno);
    if (file.close() != 0) return cannotWrite(folder / name, errno);
    return success();
}

/// Makes the files of a new export those of the old one's owner and group; files of the same name inherit their own,
/// and permissions.
Status inheritFiles(const fs::path& folder, const struct stat& folderStatus, const fs::path& replacement) {
    const Result<std::vector<fs::directory_entry>> entries = entriesOf(replacement);
    if (!entries) return namedAs(folder, replacement, entries.error());
    for (const fs::directory_entry& entry : *entries) {
        const fs::path earlier = folder / entry.path().filename();
        const OpenFile file(entry.path(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
        struct stat status {};
        if (!file.isOpen() || ::fstat(file.descriptor(), &status) != 0) return cannotWrite(earlier, errno);
        struct stat old = folderStatus;
        old.st_mode = status.st_mode;
        if (struct stat found{}; ::lstat(earlier.c_str(), &found) == 0 && S_ISREG(found.st_mode)) old = found;
        if (const int code = inheritFrom(old, file.descriptor())) return cannotWrite(earlier, code);
    }
    return success();
}

/// Fails where the folder or a file of its manifest may not be written to, which a rename would ignore.
Status checkWritable(const fs::path& folder) {
    if (::faccessat(AT_FDCWD, folder.c_str(), W_OK, AT_EACCESS) != 0) return cannotWrite(folder, errno);
    const std::optional<Manifest> manifest = readManifest(folder);
    if (!manifest) return success();
    std::vector<std::string> names{kManifestName};
    for (const ManifestEntry& file : manifest->files) names.push_back(file.name);
    for (const std::string& name : names) {
        const fs::path path = folder / name;
        if (isLink(path)) continue;  // it is replaced, not written to
        if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0 && errno != ENOENT)
            return cannotWrite(path, errno);
    }
    return success();
}

/// Adds what engines wrote in `folder` to the export that will replace it: as links to the same files, or as copies
/// where the file system has no links.
Status keepEngineFiles(const fs::path& folder, const fs::path& replacement) {
    const Result<std::vector<fs::directory_entry>> entries = entriesOf(folder);
    if (!entries) return entries.error();
    for (const fs::directory_entry& entry : *entries) {
        std::error_code error;
        const fs::path kept = replacement / entry.path().filename();
        if (!isEngineFile(entry) || fs::exists(kept, error)) continue;
        if (::link(entry.path().c_str(), kept.c_str()) == 0) continue;
        fs::copy_file(entry.path(), kept, error);
        if (error) return cannotWrite(entry.path(), error.value());
        const OpenFile copy(kept, O_RDONLY);
        if (!copy.isOpen() || ::fsync(copy.descriptor()) != 0) return cannotWrite(entry.path(), errno);
    }
    return success();
}

Status checkReplaceable(const fs::path& folder, EditedFiles edited) {
    std::error_code ignored;
    if (!fs::exists(folder, ignored)) return success();
    if (!fs::is_directory(folder, ignored)) {
        return Error{ErrorCode::BadInput,
                     quotedPath(folder) + " is a file, not a folder; move it first or export elsewhere."};
    }
    const Result<std::optional<std::string>> unexpected = findUnexpectedFile(folder);
    if (!unexpected) return unexpected.error();
    if (*unexpected) {
        return Error{ErrorCode::BadInput, "The folder " + quotedPath(folder) + " contains " + quotedPath(**unexpected) +
                                              ", which is not part of an export; move it first or export elsewhere."};
    }
    if (edited == EditedFiles::Replaced) return success();
    const Result<std::optional<fs::path>> file = findEditedFile(folder);
    if (!file) return file.error();
    if (!*file) return success();
    return Error{ErrorCode::Edited, quotedPath(**file) +
                                        " was modified after the export and would be lost; move it first or export "
                                        "elsewhere."};
}

/// Checks an earlier export and replaces it. The folder's parent is locked.
Status replaceExport(const TemporaryFolder& replacement, const fs::path& folder, EditedFiles edited, Flush flush) {
    if (const Status free = checkReplaceable(folder, edited); !free) return free;
    struct stat old {};
    const bool hasOld = ::stat(folder.c_str(), &old) == 0;
    if (hasOld) {
        if (const Status writable = checkWritable(folder); !writable) return writable;
        if (const Status inherited = inheritFiles(folder, old, replacement.path()); !inherited) return inherited;
        if (const Status kept = keepEngineFiles(folder, replacement.path()); !kept) return kept;
    }
    const int code = hasOld ? inheritFrom(old, replacement.descriptor())
                     : ::fchmod(replacement.descriptor(), replacement.permissionsOfNew()) != 0 ? errno
                                                                                               : 0;
    if (code != 0) return cannotWrite(folder, code);
    const bool isSingle = flush == Flush::SingleFiles;
    if ((isSingle ? ::fsync(replacement.descriptor()) : ::syncfs(replacement.descriptor())) != 0)
        return cannotWrite(folder, errno);
    return replaceFolder(replacement, folder);
}

/// Whether the caller's lock covers a folder, be it the target of the link `path`.
bool isLockedByCaller(const fs::path& path, const fs::path& folder, FolderLocking locking) {
    std::error_code ignored;
    const auto parentOf = [](const fs::path& child) { return child.has_parent_path() ? child.parent_path() : "."; };
    return locking == FolderLocking::ByCaller && fs::equivalent(parentOf(path), parentOf(folder), ignored);
}

}  // namespace

Status writeExportFolder(const fs::path& path, const ContentHash& source, std::span<const ExportFile> files,
                         EditedFiles edited, const TaskContext& task, FolderLocking locking) {
    const fs::path folder = linkTarget(path);
    CreatedDirectories parents;
    if (folder.has_parent_path()) {
        if (const Status created = parents.create(folder.parent_path()); !created) return created;
    }
    if (folder != path) removeLeftovers(folder.parent_path());  // the caller knows of the link's folder only
    const auto partial = TemporaryFolder::create(folder.parent_path());
    if (!partial) return partial.error();

    Manifest manifest{source.hex(), {}};
    const Flush flush = files.size() <= kMaxFlushes ? Flush::SingleFiles : Flush::FileSystem;
    const bool isFlushed = flush == Flush::SingleFiles;
    for (const ExportFile& file : files) {
        if (task.isCancelled()) return TaskContext::cancelled();
        const Status written = writeExportedFile((*partial)->path(), folder, file.name, file.bytes, isFlushed);
        if (!written) return written;
        manifest.files.push_back(manifestEntry(file.name, file.bytes));
    }
    const Status listed =
        writeExportedFile((*partial)->path(), folder, kManifestName, manifestJson(manifest), isFlushed);
    if (!listed) return listed;
    const Result<OpenFile> lock =
        isLockedByCaller(path, folder, locking) ? OpenFile() : lockFolder(folder.parent_path(), task);
    if (!lock) return lock.error();
    return replaceExport(**partial, folder, edited, flush);
}

Status checkExportFolder(const fs::path& path, EditedFiles edited) {
    const fs::path folder = linkTarget(path);
    if (const Status free = checkReplaceable(folder, edited); !free) return free;
    std::error_code ignored;
    return fs::exists(folder, ignored) ? checkWritable(folder) : success();
}

Status checkRemovable(const fs::path& folder) {
    if (isLink(folder)) {
        return Error{ErrorCode::BadInput,
                     quotedPath(folder) + " is a link, which is not followed; remove it yourself."};
    }
    const auto kept = [&](const fs::path& file, const std::string& reason) {
        return Error{ErrorCode::Edited,
                     quotedPath(folder) + " is not removed: " + quotedPath(file) + reason + "; move it or remove it."};
    };
    const Result<std::optional<std::string>> unexpected = findUnexpectedFile(folder);
    if (!unexpected) return unexpected.error();
    if (*unexpected) return kept(folder / **unexpected, " is not part of the export");
    const Result<std::optional<fs::path>> file = findEditedFile(folder);
    if (!file) return file.error();
    return *file ? kept(**file, " was modified after the export") : success();
}

Status removeExportFolder(const fs::path& folder, const TaskContext& task, FolderLocking locking) {
    const bool isLocked = locking == FolderLocking::ByCaller;
    const Result<OpenFile> lock = isLocked ? OpenFile() : lockFolder(folder.parent_path(), task);
    if (!lock) return lock.error();
    if (const Status removable = checkRemovable(folder); !removable) return removable;
    const auto removed = TemporaryFolder::create(folder.parent_path());
    if (!removed) return removed.error();
    if (::rename(folder.c_str(), ((*removed)->path() / folder.filename()).c_str()) != 0)
        return cannotWrite(folder, errno);
    if (const int code = syncFolder(folder.parent_path())) return cannotWrite(folder.parent_path(), code);
    return success();
}

}  // namespace rubble
