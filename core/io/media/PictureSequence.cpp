#include "core/io/media/PictureSequence.h"

#include "core/base/MessageText.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/FileErrors.h"
#include "core/io/system/FolderReading.h"
#include "core/io/system/Temporary.h"

#include <sys/file.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace rubble {

namespace fs = std::filesystem;

namespace {

fs::path pictureFile(const fs::path& folder, int picture) {
    char name[32];
    std::snprintf(name, sizeof name, PictureSequence::kFileNameFormat, picture);
    return folder / name;
}

/// Fails if a folder already holds the pictures of a video.
Status checkHoldsNoVideo(const fs::path& folder) {
    const Result<std::vector<fs::directory_entry>> entries = entriesOf(folder);
    if (!entries) return entries.error();
    for (const fs::directory_entry& entry : *entries) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("frame-") || !name.ends_with(".png")) continue;
        return Error{ErrorCode::BadInput, quotedPath(folder) + " already contains a video: " + name +
                                              ". Choose another folder, or remove its pictures."};
    }
    return success();
}

}  // namespace

Result<std::unique_ptr<PictureSequence>> PictureSequence::create(const fs::path& folder, fs::path shown) {
    std::unique_ptr<PictureSequence> sequence(new PictureSequence(folder, std::move(shown)));
    if (const Status created = sequence->m_created.create(folder); !created) return created.error();
    sequence->m_lock = std::make_unique<OpenFile>(folder, O_RDONLY | O_DIRECTORY);
    if (!sequence->m_lock->isOpen()) return cannotRead(folder, errno);
    if (::flock(sequence->m_lock->descriptor(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        return Error{ErrorCode::BadInput,
                     "Another video is being written to " + quotedPath(folder) + ". Choose another folder, or wait."};
    }
    if (const Status free = checkHoldsNoVideo(folder); !free) return free.error();
    removeLeftovers(folder);
    return sequence;
}

PictureSequence::~PictureSequence() {
    if (m_isKept) return;
    std::error_code ignored;  // a destructor cannot report errors
    for (int picture = 0; picture < m_count; ++picture) fs::remove(pictureFile(m_folder, picture), ignored);
}

Status PictureSequence::add(std::string_view png) {
    const fs::path file = pictureFile(m_folder, m_count);
    if (const Status written = writeFileAtomically(file, png, Leftovers::Kept); !written) {
        return m_shown.empty() ? written : Status(namedAs(m_shown, file, written.error()));
    }
    ++m_count;
    return success();
}

}  // namespace rubble
