#include "app/importer/MeshFile.h"

#include "app/importer/fbx/FbxReader.h"
#include "app/importer/files/MeshError.h"
#include "app/importer/files/TextWords.h"
#include "app/importer/gltf/GltfReader.h"
#include "app/importer/obj/ObjReader.h"
#include "app/importer/ply/PlyReader.h"
#include "app/importer/stl/StlReader.h"
#include "core/base/MessageText.h"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <optional>

namespace rubble {
namespace {

/// Returns an error for the first number that is not finite, as the end of a sentence.
std::optional<std::string> numberError(const SourceScene& scene) {
    const auto isFinite = [](const auto& vector) {
        return !glm::any(glm::isnan(vector)) && !glm::any(glm::isinf(vector));
    };
    for (const SourceObject& object : scene.objects) {
        const bool hasPoints = std::ranges::all_of(object.points, isFinite);
        const bool hasUvs = std::ranges::all_of(object.triangles, [&](const SourceTriangle& triangle) {
            return std::ranges::all_of(triangle.uvs, isFinite);
        });
        if (!hasPoints) return "has a point in " + quotedName(object.name) + " that is not finite";
        if (!hasUvs) return "has texture coordinates in " + quotedName(object.name) + " that are not finite";
    }
    return std::nullopt;
}

Error fileError(ErrorCode code, const std::string& name, const std::string& what) {
    return {code, quotedName(name) + " " + what + "."};
}

/// Adds a note for each file that was not read, and leaves out those above the maximum.
void addNotes(const std::vector<RefusedFile>& refused, std::vector<std::string>& notes) {
    const std::size_t room = kMaxNotes - std::min(notes.size(), kMaxNotes);
    for (std::size_t i = 0; i < refused.size(); ++i) {
        if (i + 1 == room && refused.size() > room) {
            notes.push_back(std::to_string(refused.size() - i) + " more files were not read.");
            break;
        }
        notes.push_back("The file " + refusalText(refused[i]) + ".");
    }
}

bool hasSuffix(const std::string& name, std::string_view suffix) {
    return name.size() > suffix.size() &&
           isSameWord(std::string_view(name).substr(name.size() - suffix.size()), suffix);
}

bool isFbx(std::string_view bytes) { return bytes.starts_with("Kaydara FBX") || trimmed(bytes).starts_with("; FBX"); }
bool isPly(std::string_view bytes) { return bytes.starts_with("ply\n") || bytes.starts_with("ply\r"); }
bool isGltf(std::string_view bytes) { return bytes.starts_with("glTF") || trimmed(bytes).starts_with('{'); }

/// Returns whether text has a line that gives a point, which no other format has.
bool isObj(std::string_view text) { return text.starts_with("v ") || text.find("\nv ") != std::string_view::npos; }

/// Reads a file with the reader of its format. The content counts, and where that is of no format for certain, the
/// suffix does.
///
/// Errors: throws MeshError; Unsupported for another format, and those of the reader.
SourceScene reading(MeshFiles& files) {
    const std::string& name = files.meshName();
    const std::string bytes = files.meshContent();
    if (isFbx(bytes)) return readFbx(files);
    if (isPly(bytes) || hasSuffix(name, ".ply")) return readPly(bytes);
    if (isGltf(bytes)) return readGltf(bytes, files);
    if (hasSuffix(name, ".stl") || isStl(bytes)) return readStl(bytes);
    if (hasSuffix(name, ".obj") || isObj(bytes)) return readObj(bytes, files);
    if (hasSuffix(name, ".fbx")) return readFbx(files);
    throw MeshError(ErrorCode::Unsupported, "is not an OBJ, glTF, GLB, FBX, STL or PLY file");
}

}  // namespace

Result<SourceScene> readMeshFile(MeshPlace place, FileLog log) {
    const std::string name = place.name;
    MeshFiles files(std::move(place), log);
    SourceScene scene;
    try {
        scene = reading(files);
    } catch (const MeshError& error) {
        return fileError(error.code(), name, error.what());
    }
    addNotes(files.refused(), scene.notes);
    if (scene.objects.empty()) return fileError(ErrorCode::Degenerate, name, "has no triangles");
    if (const std::optional<std::string> error = numberError(scene))
        return fileError(ErrorCode::BadInput, name, *error);
    return scene;
}

}  // namespace rubble
