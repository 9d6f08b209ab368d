#pragma once

#include "core/base/Result.h"
#include "core/io/system/OpenFile.h"

#include <filesystem>
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
    /// Flushes the file to disk, renames it, and returns 0 or errno. The rename survives a power cut.
    int renameTo(const std::filesystem::path& target);

private:
    std::filesystem::path m_path;  // empty: nothing to remove
    std::unique_ptr<OpenFile> m_file;
};

/// A new hidden folder, named and locked as a TemporaryFile is. The destructor removes it with its contents.
class TemporaryFolder {
public:
    enum class Purpose {
        NewContents,  // a leftover is removed
        OldContents   // the entries of a leftover are moved back to where they are missing, see removeLeftovers()
    };
    /// Errors: Io, with the folder and the system's reason.
    static Result<std::unique_ptr<TemporaryFolder>> create(const std::filesystem::path& parent,
                                                           Purpose purpose = Purpose::NewContents);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return m_path; }
    int descriptor() const { return m_lock.descriptor(); }
    /// Keeps the destructor from removing it.
    void release() { m_path.clear(); }

private:
    TemporaryFolder(std::filesystem::path path, OpenFile lock) : m_path(std::move(path)), m_lock(std::move(lock)) {}

    std::filesystem::path m_path;
    OpenFile m_lock;
};

/// Writes all bytes to a descriptor and returns 0 or errno.
int writeAll(int descriptor, std::string_view bytes);

/// Flushes a folder, so that a rename in it survives a power cut. Errors are ignored: the renamed file is whole either
/// way.
void syncFolder(const std::filesystem::path& folder);

/// Removes the temporary files and folders that killed processes of this user left in a folder. Old contents that a
/// process had moved away when it was killed are moved back, unless their name is taken. Those of running processes
/// are locked and stay, as all do where the file system has no locks.
void removeLeftovers(const std::filesystem::path& folder);

}  // namespace rubble
