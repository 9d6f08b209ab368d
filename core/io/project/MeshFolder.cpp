#include "core/io/project/MeshFolder.h"

#include "core/base/MessageText.h"
#include "core/io/project/MeshFile.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/CreatedDirectories.h"
#include "core/io/system/FileErrors.h"

#include <map>
#include <utility>

namespace rubble {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kProjectSuffix = ".rubble";
constexpr std::string_view kFolderSuffix = ".meshes";
constexpr std::string_view kMeshSuffix = ".mesh";

Result<std::shared_ptr<const ClosedMesh>> loadMesh(const fs::path& folder, const ContentHash& hash) {
    const fs::path path = meshPath(folder, hash);
    const Result<std::string> bytes = readFile(path, Links::Refused);
    if (!bytes && bytes.error().code == ErrorCode::NotFound) {
        return Error{ErrorCode::NotFound, "The file of its mesh is missing, " + quotedPath(path) +
                                              "; copy the folder " + quotedPath(folder.filename()) +
                                              " beside the project."};
    }
    if (!bytes) return bytes.error();
    Result<std::shared_ptr<const ClosedMesh>> mesh = readMeshBytes(*bytes, hash);
    if (!mesh) return withPath("Cannot read", path, mesh.error());
    return mesh;
}

/// Whether a mesh can be read again once it is written.
Status checkReadable(const Asset& asset) {
    const TriangleMesh& mesh = asset.mesh()->mesh;
    Status readable = checkMeshSize(mesh.points.size(), mesh.triangles.size());
    if (readable) {
        if (const auto closed = closedMesh(mesh); !closed) readable = closed.error();
    }
    if (readable) return readable;
    return Error{readable.error().code, "Asset " + quotedName(asset.name) + ": " + readable.error().message};
}

}  // namespace

fs::path meshFolderOf(const fs::path& project) {
    fs::path folder = linkTarget(project);
    folder += kFolderSuffix;
    return folder;
}

fs::path meshPath(const fs::path& folder, const ContentHash& hash) {
    return folder / (hash.hex() + std::string(kMeshSuffix));
}

bool isInMeshFolder(const fs::path& path) {
    const fs::path folder = path.parent_path().filename();
    return folder.extension() == kFolderSuffix && folder.stem().extension() == kProjectSuffix;
}

Status saveMeshes(const Project& project, const fs::path& folder) {
    CreatedDirectories created;
    Leftovers leftovers = Leftovers::Removed;  // once
    for (const Asset& asset : project.assets) {
        const ClosedMesh* mesh = asset.mesh();
        if (mesh == nullptr) continue;
        const fs::path path = meshPath(folder, mesh->hash);
        if (isMeshFileOf(path, *mesh)) continue;
        if (const Status readable = checkReadable(asset); !readable) return readable;
        if (const Status made = created.create(folder); !made) return made;
        if (const Status written = writeFileAtomically(path, meshBytes(*mesh), leftovers); !written) return written;
        leftovers = Leftovers::Kept;
    }
    return success();
}

MeshSource meshesIn(const fs::path& folder) {
    struct LessHash {
        bool operator()(const ContentHash& a, const ContentHash& b) const {
            return std::pair(a.high, a.low) < std::pair(b.high, b.low);
        }
    };
    using Meshes = std::map<ContentHash, std::shared_ptr<const ClosedMesh>, LessHash>;
    return [folder, known = std::make_shared<Meshes>()](const ContentHash& hash) {
        if (const auto at = known->find(hash); at != known->end())
            return Result<std::shared_ptr<const ClosedMesh>>(at->second);
        Result<std::shared_ptr<const ClosedMesh>> mesh = loadMesh(folder, hash);
        if (mesh) known->emplace(hash, *mesh);
        return mesh;
    };
}

}  // namespace rubble
