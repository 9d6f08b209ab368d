#include "core/io/system/FolderReading.h"

#include "core/io/system/FileErrors.h"

#include <system_error>

namespace rubble {

namespace fs = std::filesystem;

Result<std::vector<fs::directory_entry>> entriesOf(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::directory_entry> entries;
    fs::directory_iterator entry(folder.empty() ? "." : folder, error);
    while (!error && entry != fs::directory_iterator()) {
        entries.push_back(*entry);
        entry.increment(error);
    }
    if (error) return cannotRead(folder, error.value());
    return entries;
}

bool isLink(const fs::path& path) {
    std::error_code ignored;
    return fs::is_symlink(path, ignored);
}

}  // namespace rubble
