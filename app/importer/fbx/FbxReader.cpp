#include "app/importer/fbx/FbxReader.h"

#include "app/importer/files/AssimpValues.h"
#include "app/importer/files/MeshError.h"
#include "app/importer/files/MeshImages.h"
#include "app/importer/files/PolygonTriangles.h"
#include "app/importer/files/Rounding.h"

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

/// The files of a mesh for an importer, which deletes what it is given.
class BorrowedFiles final : public Assimp::IOSystem {
public:
    explicit BorrowedFiles(MeshFiles& files) : m_files(files) {}
    bool Exists(const char* name) const override { return m_files.Exists(name); }
    char getOsSeparator() const override { return m_files.getOsSeparator(); }
    Assimp::IOStream* Open(const char* name, const char* mode) override { return m_files.Open(name, mode); }
    void Close(Assimp::IOStream* stream) override { m_files.Close(stream); }

private:
    MeshFiles& m_files;
};

/// Unregisters the library's readers of all other formats.
void keepFbxOnly(Assimp::Importer& importer) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        // A reader cannot be deleted, because its type is not public; it leaks until the process ends.
        const std::string suffixes = std::string(" ") + importer.GetImporterInfo(i)->mFileExtensions + " ";
        if (suffixes.find(" fbx ") == std::string::npos) importer.UnregisterLoader(importer.GetImporter(i));
    }
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

double metresPerUnit(const aiScene& scene) {
    const auto asFloat = metadata<float>(scene, "UnitScaleFactor");
    const double centimetres = asFloat ? decimalOf(*asFloat) : metadata<double>(scene, "UnitScaleFactor").value_or(1.0);
    return std::isfinite(centimetres) && centimetres > 0.0 ? centimetres / 100.0 : 0.01;
}

std::vector<SourceMaterial> materialsOf(const aiScene& scene) {
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
            material.colour[k] = std::isfinite(part) ? std::clamp(decimalOf(part), 0.0, 1.0) : 0.8;
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
        if (scene.materials[i].image) scene.materials[i].colour = Vec3(1.0);  // which the image replaces
    }
}

/// Checks that there are points, and those and the materials to which a mesh refers, which the library does not.
void checkMesh(const aiMesh& mesh, std::size_t materialCount) {
    const bool hasPoints = mesh.mVertices != nullptr || mesh.mNumVertices == 0;
    const bool hasFaces = mesh.mFaces != nullptr || mesh.mNumFaces == 0;
    if (!hasPoints || !hasFaces) throw MeshError(ErrorCode::BadInput, "has a mesh without points");
    if (mesh.mMaterialIndex >= materialCount)
        throw MeshError(ErrorCode::BadInput, "refers to material " + std::to_string(mesh.mMaterialIndex) + " of " +
                                                 std::to_string(materialCount));
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        for (unsigned k = 0; k < face.mNumIndices; ++k) {
            if (face.mIndices[k] < mesh.mNumVertices) continue;
            throw MeshError(ErrorCode::BadInput, "has a face that refers to point " + std::to_string(face.mIndices[k]) +
                                                     " of " + std::to_string(mesh.mNumVertices));
        }
    }
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

    void addNode(const aiNode& node, const Mat4& fromParent) {
        const Mat4 fromNode = fromParent * matrixOf(node.mTransformation);
        SourceObject object{.name = nameOf(node.mName)};
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            const unsigned index = node.mMeshes[i];
            if (index >= m_source.mNumMeshes)
                throw MeshError(ErrorCode::BadInput, "refers to mesh " + std::to_string(index) + " of " +
                                                         std::to_string(m_source.mNumMeshes));
            const aiMesh& mesh = *m_source.mMeshes[index];
            m_triangles += triangleCount(mesh);
            if (m_triangles > kMaxTriangles)
                throw MeshError(ErrorCode::Limit, "contains more than " + std::to_string(kMaxTriangles) + " triangles");
            checkMesh(mesh, m_scene.materials.size());
            addMesh(mesh, fromNode, object);
        }
        if (!object.triangles.empty()) m_scene.objects.push_back(std::move(object));
        for (unsigned i = 0; i < node.mNumChildren; ++i) addNode(*node.mChildren[i], fromNode);
    }

private:
    const aiScene& m_source;
    SourceScene& m_scene;
    std::size_t m_triangles = 0;
};

/// Returns the error for a file that the library rejected.
MeshError rejection(const Assimp::Importer& importer, const MeshFiles& files) {
    if (!files.refused().empty()) return {ErrorCode::Unsupported, refusalText(files.refused().front())};
    const std::string reason = reasonOf(importer);
    if (reason.starts_with("FBX-DOM unsupported, old format version"))
        return {ErrorCode::Unsupported,
                "has a version of FBX before 7.1 (FBX 2011); export it as FBX 2013 or later, or as glTF"};
    return {ErrorCode::Unsupported, "cannot be read as FBX: " + reason};
}

/// Removes names that the library made up, such as "defaultobject" and "nodes[1]".
void removeInventedNames(SourceScene& scene) {
    constexpr std::array kInvented = {"defaultobject", "ROOT", "RootNode", "$ColladaAutoName$"};
    for (SourceObject& object : scene.objects) {
        const bool isIndexed = object.name.starts_with("nodes[") || object.name.starts_with("meshes[");
        if (isIndexed || std::ranges::find(kInvented, object.name) != kInvented.end()) object.name.clear();
    }
}

/// Reports what the library reads of a file and this program does not.
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

}  // namespace

SourceScene readFbx(MeshFiles& files) {
    Assimp::Importer importer;
    importer.SetIOHandler(new BorrowedFiles(files));  // which it deletes
    keepFbxOnly(importer);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    const aiScene* source = importer.ReadFile(files.meshName(), 0);  // no path, so that no message holds one
    if (source == nullptr || source->mRootNode == nullptr) throw rejection(importer, files);
    SourceScene scene{.metresPerUnit = metresPerUnit(*source), .materials = materialsOf(*source)};
    SceneReader(*source, scene).addNode(*source->mRootNode, Mat4(1.0));
    removeInventedNames(scene);
    noteUnread(*source, scene);
    readImages(*source, files, scene);
    return scene;
}

}  // namespace rubble
