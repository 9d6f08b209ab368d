#include "core/io/system/CreatedDirectories.h"

#include "core/base/MessageText.h"
#include "core/io/system/Temporary.h"

#include <algorithm>
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
    std::ranges::reverse(missing);
    for (const fs::path& path : missing) {
        if (!fs::create_directory(path, error)) continue;  // another process did
        m_created.push_back(path);
        if (const int code = syncFolder(path.parent_path())) error.assign(code, std::generic_category());
        if (error) break;
    }
    if (!error) fs::create_directories(directory, error);  // an error if it is a file
    if (!error) return success();
    return Error{ErrorCode::Io, "Cannot create the folder " + quotedPath(directory) + ": " + error.message() + "."};
}

}  // namespace rubble
