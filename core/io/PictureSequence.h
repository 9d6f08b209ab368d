#pragma once

#include "core/io/MadeFolders.h"

#include <memory>
#include <string_view>

namespace rubble {

inline constexpr int kMostPictures = 10'000;  // of a film: four digits

/// The pictures of a film as they come: FOLDER/frame-0000.png and so on, each written whole or not at all. When this is let go
/// they are removed again, with the folders that were made for them, unless they are kept.
class PictureSequence {
public:
    /// The folder is made, with those above it, where it is not there.
    ///
    /// Errors: BadInput where it holds such pictures already, which these would be mixed with; those of MadeFolders::make().
    static Result<std::unique_ptr<PictureSequence>> begun(const std::filesystem::path& folder);
    ~PictureSequence();
    PictureSequence(const PictureSequence&) = delete;
    PictureSequence& operator=(const PictureSequence&) = delete;

    /// Errors: those of writeFileAtomically().
    Status add(std::string_view png);
    int count() const { return m_count; }
    /// From now on nothing of it is removed.
    void keep() { m_isKept = true; }

    /// What printf makes a picture's name of.
    static constexpr const char* kNames = "frame-%04d.png";

private:
    explicit PictureSequence(std::filesystem::path folder) : m_folder(std::move(folder)) {}

    std::filesystem::path m_folder;
    MadeFolders m_made;
    int m_count = 0;
    bool m_isKept = false;
};

}  // namespace rubble
