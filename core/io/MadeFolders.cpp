#include "core/io/MadeFolders.h"

#include <system_error>

namespace rubble {

namespace fs = std::filesystem;

MadeFolders::~MadeFolders() {
    std::error_code ignored;  // a folder that something lies in is not removed
    for (auto folder = m_made.rbegin(); folder != m_made.rend(); ++folder) fs::remove(*folder, ignored);
}

Status MadeFolders::make(const fs::path& folder) {
    std::error_code fault;
    std::vector<fs::path> missing;
    for (fs::path path = folder; !path.empty() && !fs::exists(path, fault); path = path.parent_path())
        missing.push_back(path);
    m_made.insert(m_made.end(), missing.rbegin(), missing.rend());
    fs::create_directories(folder, fault);
    if (!fault) return success();
    return Error{ErrorCode::Io, "Cannot make the folder \"" + folder.string() + "\": " + fault.message() + "."};
}

}  // namespace rubble
