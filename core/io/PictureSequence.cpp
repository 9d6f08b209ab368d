#include "core/io/PictureSequence.h"

#include "core/io/AtomicFile.h"

#include <cstdio>
#include <system_error>

namespace rubble {

namespace fs = std::filesystem;

namespace {

fs::path pictureFile(const fs::path& folder, int picture) {
    char name[32];
    std::snprintf(name, sizeof name, PictureSequence::kNames, picture);
    return folder / name;
}

/// Refuses a folder in which the pictures of two films would be mixed.
Status unused(const fs::path& folder) {
    std::error_code ignored;  // a folder that is not there has nothing in it
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("frame-") || !name.ends_with(".png")) continue;
        return Error{ErrorCode::BadInput, folder.string() + " holds a film already: " + name +
                                              ". Give another folder, or remove its pictures."};
    }
    return success();
}

}  // namespace

Result<std::unique_ptr<PictureSequence>> PictureSequence::begun(const fs::path& folder) {
    if (const Status free = unused(folder); !free) return free.error();
    std::unique_ptr<PictureSequence> sequence(new PictureSequence(folder));
    if (const Status made = sequence->m_made.make(folder); !made) return made.error();
    return sequence;
}

PictureSequence::~PictureSequence() {
    if (m_isKept) return;
    std::error_code ignored;  // nobody is left to be told
    for (int picture = 0; picture < m_count; ++picture) fs::remove(pictureFile(m_folder, picture), ignored);
}

Status PictureSequence::add(std::string_view png) {
    if (const Status written = writeFileAtomically(pictureFile(m_folder, m_count), png); !written) return written;
    ++m_count;
    return success();
}

}  // namespace rubble
