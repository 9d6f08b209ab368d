#pragma once

#include "core/base/Hash.h"
#include "core/base/Result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace rubble {

/// Whether what killed processes left in a folder is removed before a file is written into it. Kept is for series of
/// files in one folder, which would list it each time.
enum class Leftovers { Removed, Kept };

/// Writes a file atomically: to a temporary file beside it, flushed to disk, then renamed over it. On an error the old
/// file is unchanged and the temporary one removed; or, which the error says, the new file is in place, but its folder
/// cannot be flushed, or the old bytes are in the copy only. Symbolic links, owner and permissions are kept. Never
/// waits: pipes and devices are refused. What killed processes left in the folder is removed, see removeLeftovers().
///
/// A file with several hard links, an access control list or an owner that cannot be given to a new file is written in
/// place, after a copy of it: see copyBeforeSave().
///
/// Errors: Io, with the path and the system's reason, and for a file whose saving was interrupted; NotFound and Limit,
/// as readFile(), where a file that is written in place cannot be copied first.
Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes,
                           Leftovers leftovers = Leftovers::Removed);

/// The same, but pipes and devices are written to directly. Opening a pipe waits for its reader.
///
/// Errors: those of writeFileAtomically().
Status writeFileOrStream(const std::filesystem::path& path, std::string_view bytes);

/// Returns what a path leads to if it is a symbolic link, whether it exists or not; else the path.
std::filesystem::path linkTarget(std::filesystem::path path);

/// Returns the path of the copy that exists while a file is written in place: "house.rubble.before-save", beside what a
/// symbolic link leads to. It stays if the process is killed meanwhile.
std::filesystem::path copyBeforeSave(const std::filesystem::path& path);

/// Returns whether a process was killed while it wrote these bytes of a file in place. They are marked: a mixture of
/// old and new could be mistaken for a whole file.
bool isInterruptedSave(std::string_view bytes);
/// What a user can do about a file that isInterruptedSave(): sentences that name the copy, if it is there.
std::string interruptedSaveText(const std::filesystem::path& path);

/// What reading does with a path that is a symbolic link itself.
enum class Links { Followed, Refused };

/// Returns the contents of a regular file. Never waits: pipes and devices are refused.
///
/// Errors, with the path: NotFound; Io, also for links that are refused; Limit above 1 GiB.
Result<std::string> readFile(const std::filesystem::path& path, Links links = Links::Followed);

struct FileHash {
    std::uint64_t size = 0;  // bytes
    ContentHash hash;        // as contentHash() of the bytes
};

/// The size and the hash of a file, without keeping its bytes in memory.
///
/// Errors: those of readFile().
Result<FileHash> hashOfFile(const std::filesystem::path& path, Links links = Links::Followed);

}  // namespace rubble
