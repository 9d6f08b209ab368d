#pragma once

#include "core/base/Result.h"

#include <filesystem>
#include <vector>

namespace rubble {

/// Creates directories for files about to be written. The destructor removes those that are still empty.
class CreatedDirectories {
public:
    CreatedDirectories() = default;
    ~CreatedDirectories();
    CreatedDirectories(const CreatedDirectories&) = delete;
    CreatedDirectories& operator=(const CreatedDirectories&) = delete;

    /// Creates a directory and its missing parents, and flushes their entries to disk.
    ///
    /// Errors: Io, with the path and the system's reason.
    Status create(const std::filesystem::path& directory);

private:
    std::vector<std::filesystem::path> m_created;  // deepest last
};

}  // namespace rubble
