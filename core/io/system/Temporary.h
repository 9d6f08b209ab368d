#pragma once

#include "core/base/Result.h"
#include "core/io/system/OpenFile.h"

#include <sys/stat.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>

namespace rubble {

/// A new file that is written beside its target and then renamed to it: ".rubble-<process>-<random>.tmp". Its writer
/// holds a flock() on it: one that nobody locks was left by a process that was killed. The destructor removes it.
class TemporaryFile {
public:
    /// Creates the file in a folder ("": the current one), empty, and returns 0 or errno. Call once.
    int create(const std::filesystem::path& folder, mode_t permissions);
    TemporaryFile() = default;
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    int descriptor() const { return m_file->descriptor(); }
    const std::filesystem::path& path() const { return m_path; }
    /// Flushes the file to disk and renames it, so that the rename survives a power cut. The errors name `path`, which
    /// may be a link to the target.
    ///
    /// Errors: Io, with the system's reason; that of flushRenamed(), with which the file has been renamed.
    Status renameTo(const std::filesystem::path& target, const std::filesystem::path& path);

private:
    std::filesystem::path m_path;  // empty: nothing to remove
    std::unique_ptr<OpenFile> m_file;
};

/// A new hidden folder, named and locked as a TemporaryFile is, that only its user may read. The destructor removes it
/// with its contents.
class TemporaryFolder {
public:
    /// Errors: Io, with the folder and the system's reason.
    static Result<std::unique_ptr<TemporaryFolder>> create(const std::filesystem::path& parent);
    /// A folder beside `replacement` for what is moved out of its way, ".rubble-<process>-<random>.old", of the same
    /// process and random number. The entries of a leftover are moved back, see removeLeftovers().
    ///
    /// Errors: Io, with the folder and the system's reason.
    static Result<std::unique_ptr<TemporaryFolder>> createForOldContents(const TemporaryFolder& replacement);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return m_path; }
    int descriptor() const { return m_lock.descriptor(); }
    /// The permissions that a new folder has here.
    mode_t permissionsOfNew() const { return m_permissionsOfNew; }
    /// Keeps the destructor from removing it.
    void release() { m_path.clear(); }

private:
    static Result<std::unique_ptr<TemporaryFolder>> create(const std::filesystem::path& parent,
                                                           const std::function<std::filesystem::path()>& pathOfAttempt);
    TemporaryFolder(std::filesystem::path path, OpenFile lock, mode_t permissionsOfNew)
        : m_path(std::move(path)), m_lock(std::move(lock)), m_permissionsOfNew(permissionsOfNew & 07777) {}

    std::filesystem::path m_path;
    OpenFile m_lock;
    mode_t m_permissionsOfNew;
};

/// Writes all bytes to a descriptor and returns 0 or errno.
int writeAll(int descriptor, std::string_view bytes);

/// Gives a new file or folder the permissions and the group of an old one, and its owner where the user may. Returns 0
/// or errno.
int inheritFrom(const struct stat& old, int created);

/// Flushes a folder, so that a rename in it survives a power cut, and returns 0 or errno. A file system that cannot
/// flush folders, and a folder that may not be read, are no error.
int syncFolder(const std::filesystem::path& folder);

/// Flushes the folder of `target`, to which a file was renamed. The error names `path`, which may be a link to it.
///
/// Errors: Io, with the system's reason.
Status flushRenamed(const std::filesystem::path& target, const std::filesystem::path& path);

/// Whether a name is that of a TemporaryFile or a TemporaryFolder, of a running process or a leftover.
bool isTemporaryName(const std::string& name);

/// Removes the temporary files and folders that killed processes of this user left in a folder. Old contents that a
/// process had moved away when it was killed are moved back; if their name is taken, they are removed only if it was
/// taken by their replacement. Those of running processes are locked and stay, as all do where the file system has no
/// locks.
void removeLeftovers(const std::filesystem::path& folder);

}  // namespace rubble
