#pragma once

#include "core/base/Result.h"

#include <filesystem>
#include <vector>

namespace rubble {

/// Folders that are made for what is about to be written. When this is let go, those that nothing came into go, too.
class MadeFolders {
public:
    MadeFolders() = default;
    ~MadeFolders();
    MadeFolders(const MadeFolders&) = delete;
    MadeFolders& operator=(const MadeFolders&) = delete;

    /// Makes a folder, and those above it, where they are not there.
    ///
    /// Errors: Io, with the path and the system's reason.
    Status make(const std::filesystem::path& folder);

private:
    std::vector<std::filesystem::path> m_made;  // deepest last
};

}  // namespace rubble
