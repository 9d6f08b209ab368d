#pragma once

#include "core/io/system/CreatedDirectories.h"
#include "core/io/system/OpenFile.h"

#include <memory>
#include <string_view>

namespace rubble {

inline constexpr int kMaxPictures = 10'000;  // of a video: names have four digits

/// Writes the pictures of a video to FOLDER/frame-0000.png and so on, each atomically. The destructor removes them, and
/// the folders created for them, unless keep() was called.
class PictureSequence {
public:
    /// Creates the folder if it is missing, and locks it against other videos where the file system has locks. Errors
    /// of writing name `shown` instead of the picture, where given: of a hidden folder, the user knows nothing.
    ///
    /// Errors: BadInput if it already holds such pictures or another video is being written to it; Io and NotFound if
    /// it cannot be read; those of CreatedDirectories::create().
    static Result<std::unique_ptr<PictureSequence>> create(const std::filesystem::path& folder,
                                                           std::filesystem::path shown = {});
    ~PictureSequence();
    PictureSequence(const PictureSequence&) = delete;
    PictureSequence& operator=(const PictureSequence&) = delete;

    /// Errors: those of writeFileAtomically().
    Status add(std::string_view png);
    int count() const { return m_count; }
    /// Keeps the pictures and folders.
    void keep() { m_isKept = true; }

    /// The printf format of the file names of the pictures.
    static constexpr const char* kFileNameFormat = "frame-%04d.png";

private:
    PictureSequence(std::filesystem::path folder, std::filesystem::path shown)
        : m_folder(std::move(folder)), m_shown(std::move(shown)) {}

    std::filesystem::path m_folder;
    std::filesystem::path m_shown;
    CreatedDirectories m_created;
    std::unique_ptr<OpenFile> m_lock;
    int m_count = 0;
    bool m_isKept = false;
};

}  // namespace rubble
