#include "core/io/pack/ExportFolder.h"

#include "core/base/MessageText.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/CreatedDirectories.h"
#include "core/io/system/FileErrors.h"
#include "core/io/system/FolderReading.h"
#include "core/io/system/Temporary.h"

#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <optional>
#include <system_error>
#include <vector>

namespace rubble {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifestFormat = "rubble-manifest";
constexpr std::uint32_t kManifestVersion = 1;
constexpr std::size_t kMaxFlushes = 16;  // of single files; above, the whole file system is flushed once
enum class Flush { SingleFiles, FileSystem };
/// Files that engines write beside those that they import: Godot, Unity.
constexpr std::array kEngineSuffixes{".import", ".uid", ".meta"};

struct ManifestEntry {
    std::string name;
    std::uint64_t size = 0;  // bytes
    std::string hash;
    bool operator==(const ManifestEntry&) const = default;
};

struct Manifest {
    std::string source;
    std::vector<ManifestEntry> files;
};

bool isLink(const fs::path& path) {
    std::error_code ignored;
    return fs::is_symlink(path, ignored);
}

bool isEngineFile(const fs::directory_entry& entry) {
    std::error_code ignored;
    const std::string suffix = entry.path().extension().string();
    const bool isFile = entry.symlink_status(ignored).type() == fs::file_type::regular;
    return std::ranges::find(kEngineSuffixes, suffix) != kEngineSuffixes.end() && isFile;
}

std::string manifestJson(const Manifest& manifest) {
    JsonWriter json;
    json.openObject();
    json.text("format", kManifestFormat);
    json.wholeNumber("version", std::uint64_t{kManifestVersion});
    json.text("source", manifest.source);
    json.openArray("files");
    for (const ManifestEntry& file : manifest.files) {
        json.openObject({}, JsonLayout::Inline);
        json.text("name", file.name);
        json.wholeNumber("size", file.size);
        json.text("hash", file.hash);
        json.close();
    }
    json.close();
    json.close();
    return std::move(json).finished();
}

/// Returns the manifest of a folder, if there is one that this version can read.
std::optional<Manifest> readManifest(const fs::path& folder) {
    const Result<std::string> text = readFile(folder / kManifestName, Links::Refused);
    if (!text) return std::nullopt;
    Result<JsonDocument> document = JsonDocument::parse(*text);
    if (!document) return std::nullopt;
    const JsonValue root = document->root();
    root.requireObject({"format", "version", "source", "files"});
    if (root["format"].text() != kManifestFormat || root["version"].index() != kManifestVersion) return std::nullopt;
    Manifest manifest;
    manifest.source = root["source"].text();
    for (const JsonValue file : root["files"].elements()) {
        file.requireObject({"name", "size", "hash"});
        manifest.files.push_back({file["name"].text(), file["size"].wholeNumber(), file["hash"].text()});
    }
    if (document->firstError()) return std::nullopt;
    const auto isInFolder = [](const ManifestEntry& file) {
        const fs::path name = file.name;
        return name == name.filename() && file.name != "." && file.name != "..";
    };
    if (!std::ranges::all_of(manifest.files, isInFolder)) return std::nullopt;
    return manifest;
}

ManifestEntry entryOf(const std::string& name, std::string_view bytes) {
    return {name, bytes.size(), contentHash(bytes).hex()};
}

Result<ManifestEntry> entryOfFile(const fs::path& folder, const std::string& name) {
    const Result<FileHash> file = hashOfFile(folder / name, Links::Refused);
    if (!file) return file.error();
    return ManifestEntry{name, file->size, file->hash.hex()};
}

/// Returns the name of a file in the folder that its manifest does not list and no engine wrote, if there is one.
Result<std::optional<std::string>> findUnexpectedFile(const fs::path& folder) {
    const std::optional<Manifest> manifest = readManifest(folder);
    const Result<std::vector<fs::directory_entry>> entries = entriesOf(folder);
    if (!entries) return entries.error();
    std::vector<std::string> unexpected;
    for (const fs::directory_entry& entry : *entries) {
        const std::string name = entry.path().filename().string();
        const auto isListed = [&](const ManifestEntry& file) { return file.name == name; };
        const bool isExpected = manifest && (name == kManifestName || std::ranges::any_of(manifest->files, isListed));
        std::error_code ignored;
        if (isExpected ? entry.is_directory(ignored) : !isEngineFile(entry)) unexpected.push_back(name);
    }
    if (unexpected.empty()) return std::optional<std::string>();
    return std::optional(*std::ranges::min_element(unexpected));
}

/// Returns the path of a file of the folder's manifest that was modified, if there is one. Missing files are not.
Result<std::optional<fs::path>> findEditedFile(const fs::path& folder) {
    const std::optional<Manifest> manifest = readManifest(folder);
    if (!manifest) return std::optional<fs::path>();
    for (const ManifestEntry& file : manifest->files) {
        if (isLink(folder / file.name)) return std::optional(folder / file.name);
        const Result<ManifestEntry> current = entryOfFile(folder, file.name);
        if (!current && current.error().code != ErrorCode::NotFound) return current.error();
        if (current && *current != file) return std::optional(folder / file.name);
    }
    return std::optional<fs::path>();
}

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

/// Locks a folder against others that replace folders in it, where the file system has locks, until it is closed.
Result<OpenFile> lockFolder(const fs::path& folder, const TaskContext& task) {
    constexpr int kLockPollMilliseconds = 10;
    OpenFile lock(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
    if (!lock.isOpen()) return cannotRead(folder, errno);
    while (::flock(lock.descriptor(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        if (task.isCancelled()) return TaskContext::cancelled();
        ::poll(nullptr, 0, kLockPollMilliseconds);
    }
    return lock;
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

/// Replaces a folder by a new one where the file system cannot exchange them: a process that is killed between the two
/// renames leaves the old folder to removeLeftovers().
Status moveAndReplace(const TemporaryFolder& replacement, const fs::path& folder) {
    const auto old = TemporaryFolder::createForOldContents(replacement);
    if (!old) return old.error();
    const fs::path earlier = (*old)->path() / folder.filename();
    std::error_code error;
    const bool hadEarlier = fs::exists(fs::symlink_status(folder, error));
    if (hadEarlier && ::rename(folder.c_str(), earlier.c_str()) != 0) return cannotWrite(folder, errno);
    int code = ::rename(replacement.path().c_str(), folder.c_str()) == 0 ? 0 : errno;
    if (code == 0) {
        code = syncFolder(folder.parent_path());  // before the old folder is removed
        if (code == 0) return success();
        if (::rename(folder.c_str(), replacement.path().c_str()) != 0) {
            (*old)->release();
            return cannotWrite(folder, code);
        }
    }
    if (hadEarlier && ::rename(earlier.c_str(), folder.c_str()) != 0) (*old)->release();
    return cannotWrite(folder, code);
}

/// Gives a new folder its name in one step that survives a power cut; afterwards `replacement` holds the old one, if
/// there was one.
Status replaceFolder(const TemporaryFolder& replacement, const fs::path& folder) {
    const auto rename = [&](unsigned flags) {
        return ::renameat2(AT_FDCWD, replacement.path().c_str(), AT_FDCWD, folder.c_str(), flags) == 0 ? 0 : errno;
    };
    int code = rename(RENAME_NOREPLACE);
    const bool isExchange = code == EEXIST;
    if (isExchange) code = rename(RENAME_EXCHANGE);
    if (code == EINVAL || code == ENOSYS) return moveAndReplace(replacement, folder);
    if (code != 0) return cannotWrite(folder, code);
    code = syncFolder(folder.parent_path());
    if (code == 0) return success();
    if (isExchange) {
        static_cast<void>(rename(RENAME_EXCHANGE));
    } else {
        static_cast<void>(::rename(folder.c_str(), replacement.path().c_str()));
    }
    return cannotWrite(folder, code);
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

/// Checks an earlier export and replaces it, without any other process doing so at the same time.
Status replaceExport(const TemporaryFolder& replacement, const fs::path& folder, EditedFiles edited, Flush flush,
                     const TaskContext& task) {
    const Result<OpenFile> lock = lockFolder(folder.parent_path(), task);
    if (!lock) return lock.error();
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

}  // namespace

bool isExportOf(const fs::path& folder, const ContentHash& source) {
    const std::optional<Manifest> manifest = readManifest(folder);
    if (!manifest || manifest->source != source.hex()) return false;
    return std::ranges::all_of(manifest->files, [&](const ManifestEntry& file) {
        const Result<ManifestEntry> current = entryOfFile(folder, file.name);
        return current && *current == file;
    });
}

std::optional<std::string> verifyExportFolder(const fs::path& folder) {
    const fs::path list = folder / kManifestName;
    if (isLink(list)) return quotedPath(list) + " is a link, which is not followed here; replace it by a file.";
    const std::optional<Manifest> manifest = readManifest(folder);
    if (!manifest) return "The folder " + quotedPath(folder) + " has no readable " + kManifestName + ".";
    for (const ManifestEntry& file : manifest->files) {
        const Result<ManifestEntry> current = entryOfFile(folder, file.name);
        if (!current) return current.error().message;
        if (*current != file) return quotedPath(folder / file.name) + " was modified after the export.";
    }
    const Result<std::optional<std::string>> unexpected = findUnexpectedFile(folder);
    if (!unexpected) return unexpected.error().message;
    if (!*unexpected) return std::nullopt;
    return "The folder " + quotedPath(folder) + " contains " + quotedPath(**unexpected) +
           ", which is not part of the export.";
}

Status writeExportFolder(const fs::path& path, const ContentHash& source, std::span<const ExportFile> files,
                         EditedFiles edited, const TaskContext& task) {
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
        manifest.files.push_back(entryOf(file.name, file.bytes));
    }
    const Status listed =
        writeExportedFile((*partial)->path(), folder, kManifestName, manifestJson(manifest), isFlushed);
    if (!listed) return listed;
    return replaceExport(**partial, folder, edited, flush, task);
}

}  // namespace rubble
