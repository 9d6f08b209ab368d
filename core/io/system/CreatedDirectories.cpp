#include "core/io/system/CreatedDirectories.h"

#include <system_error>

namespace rubble {

namespace fs = std::filesystem;

CreatedDirectories::~CreatedDirectories() {
    std::error_code ignored;  // a directory that is not empty stays
    for (auto directory = m_created.rbegin(); directory != m_created.rend(); ++directory)
        fs::remove(*directory, ignored);
}

Status CreatedDirectories::create(const fs::path& directory) {
    std::error_code error;
    std::vector<fs::path> missing;
    for (fs::path path = directory; !path.empty() && !fs::exists(path, error); path = path.parent_path())
        missing.push_back(path);
    m_created.insert(m_created.end(), missing.rbegin(), missing.rend());
    fs::create_directories(directory, error);
    if (!error) return success();
    return Error{ErrorCode::Io, "Cannot create the folder \"" + directory.string() + "\": " + error.message() + "."};
}

}  // namespace rubble
