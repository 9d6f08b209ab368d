#include "app/cli/output/PackFolders.h"

#include "core/base/MessageText.h"
#include "core/io/output/ExportManifest.h"
#include "core/io/pack/PackFile.h"
#include "core/io/system/FolderReading.h"
#include "core/io/system/Temporary.h"

#include <algorithm>
#include <array>

namespace rubble {

bool isPack(const std::filesystem::path& folder) {
    return std::ranges::any_of(std::array{kPackName, kManifestName}, [&](const char* name) {
        std::error_code ignored;
        const std::filesystem::file_status status = std::filesystem::symlink_status(folder / name, ignored);
        return std::filesystem::exists(status) && !std::filesystem::is_directory(status);
    });
}

Result<std::vector<std::filesystem::path>> packsOf(const std::filesystem::path& folder) {
    if (isPack(folder)) return std::vector{folder};
    std::vector<std::filesystem::path> packs;
    const Result<std::vector<std::filesystem::directory_entry>> entries = entriesOf(folder);
    if (!entries) return entries.error();
    for (const std::filesystem::directory_entry& entry : *entries) {
        const bool isTemporary = isTemporaryName(entry.path().filename().string());
        if (!isTemporary && isPack(entry.path())) packs.push_back(entry.path());
    }
    const std::string name = quotedPath(folder);
    if (packs.empty())
        return Error{ErrorCode::NotFound, name + " is not a pack and contains none: it has no " + kPackName + "."};
    std::ranges::sort(packs);
    return packs;
}

}  // namespace rubble
