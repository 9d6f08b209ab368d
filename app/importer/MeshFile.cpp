#include "app/importer/MeshFile.h"

#include "app/importer/files/AssimpValues.h"
#include "app/importer/files/MeshError.h"
#include "app/importer/files/MeshImages.h"
#include "app/importer/files/PolygonTriangles.h"
#include "app/importer/files/Rounding.h"
#include "app/importer/files/TextWords.h"
#include "app/importer/gltf/GltfDocument.h"
#include "app/importer/gltf/GltfReader.h"
#include "app/importer/obj/ObjReader.h"
#include "app/importer/ply/PlyReader.h"
#include "app/importer/stl/StlReader.h"
#include "core/base/MessageText.h"

#include <glm/matrix.hpp>

#include <assimp/importerdesc.h>
#include <assimp/scene.h>
#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace Assimp {

/// Replaces the function of the library, built with assertions, that ends the process: the file is rejected instead.
void aiAssertViolation(const char* condition, const char* /*file*/, int /*line*/) {
    throw std::logic_error(std::string("the assertion of its reader failed that ") + condition);
}

}  // namespace Assimp

namespace rubble {
namespace {

/// Returns whether one of a reader's suffixes, which are separated by spaces, is a supported one.
bool isSupported(const aiImporterDesc& description) {
    const std::string suffixes = std::string(" ") + description.mFileExtensions + " ";
    return std::ranges::any_of(std::array{" gltf ", " fbx "},
                               [&](const char* suffix) { return suffixes.find(suffix) != std::string::npos; });
}

/// Unregisters the library's readers of all formats but FBX and glTF 1; readers of our own replace those of the others.
void keepSupportedFormats(Assimp::Importer& importer) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        // A reader cannot be deleted, because its type is not public; it leaks until the process ends.
        if (!isSupported(*importer.GetImporterInfo(i))) importer.UnregisterLoader(importer.GetImporter(i));
    }
    importer.RegisterLoader(new PlyReader);  // which the importer deletes
}

/// Returns the first line of the library's error message, shortened, as the end of a sentence.
std::string reasonOf(const Assimp::Importer& importer) {
    std::string reason = importer.GetErrorString();
    reason.erase(std::min(reason.find_first_of("\r\n"), reason.size()));
    while (!reason.empty() && (reason.back() == '.' || reason.back() == ' ')) reason.pop_back();
    return reason.empty() ? "unknown error" : excerptOf(reason);
}

/// Returns a number from the file's metadata.
template <class Number>
std::optional<Number> metadata(const aiScene& scene, const char* key) {
    if (scene.mMetaData == nullptr) return std::nullopt;
    Number number{};
    if (scene.mMetaData->Get(key, number)) return number;
    return std::nullopt;
}

enum class Format { Gltf, Fbx, Other };

Format formatOf(const Assimp::Importer& importer, const aiScene& scene) {
    const int index = importer.GetPropertyInteger("importerIndex", -1);
    const aiImporterDesc* description = index < 0 ? nullptr : importer.GetImporterInfo(static_cast<std::size_t>(index));
    const std::string suffixes = description == nullptr ? "" : description->mFileExtensions;
    if (suffixes.find("gltf") != std::string::npos) return Format::Gltf;
    return suffixes.find("fbx") != std::string::npos || metadata<int>(scene, "UpAxis") ? Format::Fbx : Format::Other;
}

double metresPerUnit(const aiScene& scene, Format format) {
    if (format == Format::Gltf) return 1.0;
    if (format != Format::Fbx) return 0.0;
    const auto asFloat = metadata<float>(scene, "UnitScaleFactor");
    const double centimetres = asFloat ? decimalOf(*asFloat) : metadata<double>(scene, "UnitScaleFactor").value_or(1.0);
    return std::isfinite(centimetres) && centimetres > 0.0 ? centimetres / 100.0 : 0.01;
}

std::vector<SourceMaterial> materialsOf(const aiScene& scene, Format format) {
    std::vector<SourceMaterial> materials;
    for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
        const aiMaterial& source = *scene.mMaterials[i];
        SourceMaterial& material = materials.emplace_back();
        material.name = nameOf(source.GetName());
        if (material.name == AI_DEFAULT_MATERIAL_NAME) material.name.clear();
        aiColor4D colour(0.8f, 0.8f, 0.8f, 1.0f);
        if (source.Get(AI_MATKEY_BASE_COLOR, colour) != aiReturn_SUCCESS) source.Get(AI_MATKEY_COLOR_DIFFUSE, colour);
        for (int k = 0; k < 3; ++k) {
            const float part = colour[static_cast<unsigned>(k)];
            const double value = std::isfinite(part) ? std::clamp(decimalOf(part), 0.0, 1.0) : 0.8;
            material.colour[k] = format == Format::Gltf ? srgbFromLinear(value) : value;
        }
    }
    if (materials.empty()) materials.emplace_back();
    return materials;
}

/// Reads the images of the base colours of materials, in files or in the mesh.
void readImages(const aiScene& source, MeshFiles& files, SourceScene& scene) {
    MeshImages images(files, scene);
    for (unsigned i = 0; i < source.mNumMaterials; ++i) {
        aiString path;
        const aiMaterial& material = *source.mMaterials[i];
        if (material.GetTexture(aiTextureType_BASE_COLOR, 0, &path) != aiReturn_SUCCESS &&
            material.GetTexture(aiTextureType_DIFFUSE, 0, &path) != aiReturn_SUCCESS)
            continue;
        const aiTexture* texture = source.GetEmbeddedTexture(path.C_Str());
        const std::string name = path.C_Str(), held = texture == nullptr ? "" : texture->mFilename.C_Str();
        if (texture == nullptr) {
            if (!name.empty()) scene.materials[i].image = images.file(name);
        } else if (texture->mHeight != 0) {  // pixels
            images.note(name, "is neither PNG nor JPEG; save it as one of them");
        } else {
            const std::string_view bytes(reinterpret_cast<const char*>(texture->pcData), texture->mWidth);
            scene.materials[i].image = images.embedded("embedded " + name, held.empty() ? name : held, bytes);
        }
        if (scene.materials[i].image) scene.materials[i].colour = Vec3(1.0);  // which the image replaces in FBX
    }
}

/// Returns an error for missing points and for indices of missing points and materials, which the library does not
/// check.
std::optional<std::string> meshError(const aiMesh& mesh, std::size_t materialCount) {
    const bool hasPoints = mesh.mVertices != nullptr || mesh.mNumVertices == 0;
    const bool hasFaces = mesh.mFaces != nullptr || mesh.mNumFaces == 0;
    if (!hasPoints || !hasFaces) return "has a mesh without points";
    if (mesh.mMaterialIndex >= materialCount)
        return "refers to material " + std::to_string(mesh.mMaterialIndex) + " of " + std::to_string(materialCount);
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        for (unsigned k = 0; k < face.mNumIndices; ++k) {
            if (face.mIndices[k] < mesh.mNumVertices) continue;
            return "has a face that refers to point " + std::to_string(face.mIndices[k]) + " of " +
                   std::to_string(mesh.mNumVertices);
        }
    }
    return std::nullopt;
}

/// The number of triangles that the polygons of a mesh become.
std::size_t triangleCount(const aiMesh& mesh) {
    std::size_t count = 0;
    for (unsigned i = 0; mesh.mFaces != nullptr && i < mesh.mNumFaces; ++i)
        count += std::max(mesh.mFaces[i].mNumIndices, 2u) - 2;
    return count;
}

/// Adds a mesh's triangles to an object. A mirroring transform reverses their winding.
void addMesh(const aiMesh& mesh, const Mat4& fromMesh, SourceObject& object) {
    const auto first = static_cast<std::uint32_t>(object.points.size());
    const bool isMirrored = glm::determinant(Mat3(fromMesh)) < 0.0;
    RoundingMeter rounding;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const Vec3 point = pointOf(mesh.mVertices[i]);
        rounding.add({&point, 1});
        object.points.push_back(Vec3(fromMesh * glm::dvec4(point, 1.0)));
    }
    object.rounding = std::max(object.rounding, displacementBy(rounding.step(), fromMesh));
    const aiVector3D* uvs = mesh.mTextureCoords[0];
    object.hasUvs |= uvs != nullptr;
    std::vector<Vec3> polygon;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices < 3) continue;
        polygon.clear();
        for (unsigned k = 0; k < face.mNumIndices; ++k) polygon.push_back(object.points[first + face.mIndices[k]]);
        for (const auto& corners : polygonTriangles(polygon)) {
            SourceTriangle& triangle = object.triangles.emplace_back();
            triangle.material = mesh.mMaterialIndex;
            for (std::size_t k = 0; k < 3; ++k) {
                const unsigned index = face.mIndices[corners[isMirrored ? 2 - k : k]];
                triangle.points[k] = first + index;
                if (uvs != nullptr) triangle.uvs[k] = Vec2(decimalOf(uvs[index].x), decimalOf(uvs[index].y));
            }
        }
    }
}

/// Visits the nodes and adds an object for each with triangles.
class SceneReader {
public:
    explicit SceneReader(const aiScene& source, SourceScene& scene) : m_source(source), m_scene(scene) {}

    Status addNode(const aiNode& node, const Mat4& fromParent) {
        const Mat4 fromNode = fromParent * matrixOf(node.mTransformation);
        SourceObject object{.name = nameOf(node.mName)};
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            const unsigned index = node.mMeshes[i];
            if (index >= m_source.mNumMeshes)
                return Error{ErrorCode::BadInput,
                             "refers to mesh " + std::to_string(index) + " of " + std::to_string(m_source.mNumMeshes)};
            const aiMesh& mesh = *m_source.mMeshes[index];
            m_triangles += triangleCount(mesh);
            if (m_triangles > kMaxTriangles)
                return Error{ErrorCode::Limit, "contains more than " + std::to_string(kMaxTriangles) + " triangles"};
            if (std::optional<std::string> error = meshError(mesh, m_scene.materials.size()))
                return Error{ErrorCode::BadInput, *error};
            addMesh(mesh, fromNode, object);
        }
        if (!object.triangles.empty()) m_scene.objects.push_back(std::move(object));
        for (unsigned i = 0; i < node.mNumChildren; ++i)
            if (const Status added = addNode(*node.mChildren[i], fromNode); !added) return added;
        return success();
    }

private:
    const aiScene& m_source;
    SourceScene& m_scene;
    std::size_t m_triangles = 0;
};

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

/// Returns the error for a file that the library rejected.
Error rejection(const Assimp::Importer& importer, const MeshFiles& files, const std::string& name) {
    if (!files.refused().empty()) return fileError(ErrorCode::Unsupported, name, refusalText(files.refused().front()));
    const std::string reason = reasonOf(importer);
    if (reason.starts_with("FBX-DOM unsupported, old format version"))
        return fileError(ErrorCode::Unsupported, name,
                         "has a version of FBX before 7.1 (FBX 2011); export it as FBX 2013 or later, or as glTF");
    if (reason.starts_with("No suitable reader"))
        return fileError(ErrorCode::Unsupported, name,
                         "is not an OBJ, glTF, GLB, FBX, STL or PLY file, or its version is not supported");
    return fileError(ErrorCode::Unsupported, name, "cannot be read as OBJ, glTF, FBX, STL or PLY: " + reason);
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

/// Removes names that the library made up, such as "defaultobject" and "nodes[1]".
void removeInventedNames(SourceScene& scene) {
    constexpr std::array kInvented = {"defaultobject", "ROOT", "RootNode", "$ColladaAutoName$"};
    for (SourceObject& object : scene.objects) {
        const bool isIndexed = object.name.starts_with("nodes[") || object.name.starts_with("meshes[");
        if (isIndexed || std::ranges::find(kInvented, object.name) != kInvented.end()) object.name.clear();
    }
}

/// Tells what the library reads of a file and this program does not.
void noteUnread(const aiScene& source, SourceScene& scene) {
    bool hasBones = false, hasMorphs = false;
    for (unsigned i = 0; i < source.mNumMeshes; ++i) {
        hasBones |= source.mMeshes[i]->mNumBones > 0;
        hasMorphs |= source.mMeshes[i]->mNumAnimMeshes > 0;
    }
    if (hasBones) scene.notes.emplace_back("Meshes with bones are read as they are without a pose.");
    if (hasMorphs) scene.notes.emplace_back("Shape keys of the file are not read; meshes have their basis shape.");
    if (source.mNumAnimations > 0) scene.notes.emplace_back("The animations of the file are not read.");
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

/// Rejects a binary file of glTF 1 whose bytes do not begin at a multiple of four, as the format requires: the library
/// would read others. assimp writes such files.
void checkAlignment(std::string_view bytes) {
    constexpr std::size_t kHeaderSize = 20, kContentLength = 12;
    const bool isFirst = bytes.size() > kHeaderSize && bytes.starts_with(std::string_view("glTF\1\0\0\0", 8));
    if (isFirst && static_cast<unsigned char>(bytes[kContentLength]) % 4 != 0)
        throw MeshError(ErrorCode::Unsupported,
                        "is a GLB file of glTF 1 whose content is not aligned; export it as glTF 2");
}

/// Reads a file with a reader of our own; nothing if the library has to. The content counts, and where that is of no
/// format for certain, the suffix does.
std::optional<SourceScene> ownReading(const std::string& bytes, MeshFiles& files) {
    const std::string& name = files.meshName();
    if (isFbx(bytes) || isPly(bytes) || hasSuffix(name, ".ply")) return std::nullopt;
    if (isGltf(bytes)) {
        checkAlignment(bytes);
        const bool isFirst =
            bytes.starts_with("glTF") ? bytes.substr(4, 4) == std::string("\1\0\0\0", 4) : isGltf1(bytes);
        return isFirst ? std::nullopt : std::optional(readGltf(bytes, files));
    }
    if (hasSuffix(name, ".stl") || isStl(bytes)) return readStl(bytes);
    if (hasSuffix(name, ".obj") || isObj(bytes)) return readObj(bytes, files);
    return std::nullopt;
}

/// Reads a file with the library: FBX, PLY and glTF 1.
Result<SourceScene> libraryReading(Assimp::Importer& importer, MeshFiles& files) {
    const std::string& name = files.meshName();
    const aiScene* source = importer.ReadFile(name, 0);  // no path, so that no message holds one
    if (source == nullptr || source->mRootNode == nullptr) return rejection(importer, files, name);
    const Format format = formatOf(importer, *source);
    SourceScene scene{.metresPerUnit = metresPerUnit(*source, format), .materials = materialsOf(*source, format)};
    const Status added = SceneReader(*source, scene).addNode(*source->mRootNode, Mat4(1.0));
    if (!added) return fileError(added.error().code, name, added.error().message);
    removeInventedNames(scene);
    noteUnread(*source, scene);
    readImages(*source, files, scene);
    return scene;
}

}  // namespace

Result<SourceScene> readMeshFile(MeshPlace place, FileLog log) {
    const std::string name = place.name;
    Assimp::Importer importer;
    auto* files = new MeshFiles(std::move(place), log);
    importer.SetIOHandler(files);  // which deletes it
    keepSupportedFormats(importer);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    std::optional<SourceScene> scene;
    try {
        scene = ownReading(files->meshContent(), *files);
    } catch (const MeshError& error) {
        return fileError(error.code(), name, error.what());
    }
    if (!scene) {
        Result<SourceScene> read = libraryReading(importer, *files);
        if (!read) return read;
        scene = std::move(*read);
    }
    addNotes(files->refused(), scene->notes);
    if (scene->objects.empty()) return fileError(ErrorCode::Degenerate, name, "has no triangles");
    if (const std::optional<std::string> error = numberError(*scene))
        return fileError(ErrorCode::BadInput, name, *error);
    return *scene;
}

}  // namespace rubble
