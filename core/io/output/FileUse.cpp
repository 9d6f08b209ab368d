#include "core/io/output/FileUse.h"

#include "core/base/MessageText.h"
#include "core/io/output/ExportIndex.h"
#include "core/io/output/ExportManifest.h"
#include "core/io/project/MeshFolder.h"
#include "core/io/system/AtomicFile.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <system_error>

#include <sys/stat.h>

namespace rubble {
namespace {

namespace fs = std::filesystem;

/// What a path leads to.
struct Target {
    fs::path path;  // absolute, without links as far as it exists
    bool exists = false;
    bool isFile = false;
    dev_t device = 0;
    ino_t inode = 0;
};

Target targetOf(const fs::path& path) {
    std::error_code ignored;
    Target target{fs::weakly_canonical(fs::absolute(linkTarget(path), ignored), ignored)};
    if (target.path.empty()) target.path = path;
    struct stat status {};
    if (stat(target.path.c_str(), &status) != 0) return target;
    target.exists = true;
    target.isFile = S_ISREG(status.st_mode);
    target.device = status.st_dev;
    target.inode = status.st_ino;
    return target;
}

bool isSame(const Target& a, const Target& b) {
    if (a.exists && b.exists) return a.device == b.device && a.inode == b.inode;
    return !a.exists && !b.exists && a.path == b.path;
}

Error refused(const FileUse& use, const std::string& reason) {
    return {ErrorCode::BadInput, use.name + ": " + quotedName(use.path.string()) + " " + reason +
                                     " Nothing was written; give another name."};
}

/// What else a run does with a file that it writes; nothing if it does nothing else.
std::optional<std::string> otherUse(std::size_t written, std::span<const FileUse> uses,
                                    std::span<const Target> targets) {
    for (std::size_t k = 0; k < uses.size(); ++k) {
        if (k == written || !isSame(targets[k], targets[written])) continue;
        if (!uses[k].what.empty()) return "is " + uses[k].what + ".";
        switch (uses[k].role) {
            case FileRole::Read: return "is read.";
            case FileRole::Changed: return "is changed.";
            case FileRole::Written: return "is also written as " + uses[k].name + ".";
        }
    }
    return std::nullopt;
}

/// Whether a file is one of an export. What cannot be read says nothing of other files.
bool isOfExport(const fs::path& path) {
    const fs::path folder = path.parent_path();
    const std::string name = path.filename().string();
    const auto isListed = [&](std::span<const ManifestEntry> files) {
        return std::ranges::find(files, name, &ManifestEntry::name) != files.end();
    };
    const Result<std::optional<ExportIndex>> index = readExportIndex(folder);
    if (index && *index && (name == kIndexName || isListed((*index)->files))) return true;
    const std::optional<Manifest> manifest = readManifest(folder);
    return manifest && (name == kManifestName || isListed(manifest->files));
}

std::string lowerExtension(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& letter : extension) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return extension;
}

bool hasExtension(const fs::path& path, std::span<const std::string> extensions) {
    return extensions.empty() || std::ranges::find(extensions, lowerExtension(path)) != extensions.end();
}

}  // namespace

Status checkFileUses(std::span<const FileUse> uses) {
    std::vector<Target> targets;
    for (const FileUse& use : uses) targets.push_back(targetOf(use.path));
    for (std::size_t k = 0; k < uses.size(); ++k) {
        if (uses[k].role != FileRole::Written || (targets[k].exists && !targets[k].isFile)) continue;
        if (const std::optional<std::string> other = otherUse(k, uses, targets)) return refused(uses[k], *other);
        if (isOfExport(targets[k].path)) return refused(uses[k], "is a file of an export.");
        if (isInMeshFolder(targets[k].path)) return refused(uses[k], "lies in the folder of a project's meshes.");
        if (targets[k].exists && !hasExtension(targets[k].path, uses[k].extensions)) {
            return refused(uses[k], "exists, and is something else by its name: what is written ends in " +
                                        uses[k].extensions.front() + ".");
        }
    }
    return success();
}

}  // namespace rubble
