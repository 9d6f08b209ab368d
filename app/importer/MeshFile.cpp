#include "app/importer/MeshFile.h"

#include "app/importer/AssimpValues.h"
#include "app/importer/PlyReader.h"
#include "core/base/MessageText.h"

#include <glm/matrix.hpp>

#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
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
    return std::ranges::any_of(std::array{" obj ", " gltf ", " glb ", " fbx ", " stl "},
                               [&](const char* suffix) { return suffixes.find(suffix) != std::string::npos; });
}

/// Unregisters the library's readers of other formats, and that of PLY, which a reader of our own replaces.
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

/// Converts linear to sRGB, rounded to three decimals.
double srgbFromLinear(double linear) {
    const double value = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    return std::round(1e3 * value) / 1e3;
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

/// Adds a mesh's triangles to an object. A mirroring transform reverses their winding.
void addMesh(const aiMesh& mesh, const Mat4& fromMesh, SourceObject& object) {
    const auto first = static_cast<std::uint32_t>(object.points.size());
    const bool isMirrored = glm::determinant(Mat3(fromMesh)) < 0.0;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i)
        object.points.push_back(Vec3(fromMesh * glm::dvec4(pointOf(mesh.mVertices[i]), 1.0)));
    const aiVector3D* uvs = mesh.mTextureCoords[0];
    object.hasUvs |= uvs != nullptr;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices != 3) continue;
        SourceTriangle& triangle = object.triangles.emplace_back();
        triangle.material = mesh.mMaterialIndex;
        for (int k = 0; k < 3; ++k) {
            const unsigned index = face.mIndices[isMirrored ? 2 - k : k];
            triangle.points[k] = first + index;
            if (uvs != nullptr) triangle.uvs[k] = Vec2(decimalOf(uvs[index].x), decimalOf(uvs[index].y));
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
            m_triangles += mesh.mNumFaces;
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

std::string outsideText(const std::string& resource) {
    return "refers to " + quotedName(resource) +
           ", which lies outside its folder; only files in the folder of a mesh and below are read";
}

/// Returns the error for a file that the library rejected.
Error rejection(const Assimp::Importer& importer, const MeshFiles& files, const std::string& name) {
    if (!files.refused().empty()) return fileError(ErrorCode::Unsupported, name, outsideText(files.refused().front()));
    const std::string reason = reasonOf(importer);
    if (reason.starts_with("No suitable reader"))
        return fileError(ErrorCode::Unsupported, name,
                         "is not an OBJ, glTF, GLB, FBX, STL or PLY file, or its version is not supported");
    return fileError(ErrorCode::Unsupported, name, "cannot be read as OBJ, glTF, FBX, STL or PLY: " + reason);
}

std::vector<std::string> notesOf(const std::vector<std::string>& refused) {
    std::vector<std::string> notes;
    for (const std::string& resource : refused) {
        if (notes.size() + 1 == kMaxNotes && refused.size() > kMaxNotes) {
            notes.push_back(std::to_string(refused.size() - notes.size()) + " more files were not read.");
            break;
        }
        notes.push_back("The file " + outsideText(resource) + ".");
    }
    return notes;
}

}  // namespace

Result<SourceScene> readMeshFile(MeshPlace place, FileLog log) {
    const std::string name = place.name;
    Assimp::Importer importer;
    keepSupportedFormats(importer);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    auto* files = new MeshFiles(std::move(place), log);
    importer.SetIOHandler(files);                                            // which deletes it
    const aiScene* source = importer.ReadFile(name, aiProcess_Triangulate);  // no path, so that no message holds one
    if (source == nullptr || source->mRootNode == nullptr) return rejection(importer, *files, name);
    const Format format = formatOf(importer, *source);
    SourceScene scene{.metresPerUnit = metresPerUnit(*source, format), .materials = materialsOf(*source, format)};
    scene.notes = notesOf(files->refused());
    const Status added = SceneReader(*source, scene).addNode(*source->mRootNode, Mat4(1.0));
    if (!added) return fileError(added.error().code, name, added.error().message);
    if (scene.objects.empty()) return fileError(ErrorCode::Degenerate, name, "has no triangles");
    if (const std::optional<std::string> error = numberError(scene))
        return fileError(ErrorCode::BadInput, name, *error);
    return scene;
}

}  // namespace rubble
