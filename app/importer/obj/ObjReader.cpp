#include "app/importer/obj/ObjReader.h"

#include "app/importer/files/MeshError.h"
#include "app/importer/files/MeshImages.h"
#include "app/importer/files/PolygonTriangles.h"
#include "app/importer/files/Rounding.h"
#include "app/importer/files/TextWords.h"
#include "app/importer/obj/ObjObjects.h"
#include "core/base/Index.h"
#include "core/base/MessageText.h"

#include <algorithm>
#include <filesystem>

namespace rubble {
namespace {

/// Adds the faces of a file to their objects.
class ObjAssembly {
public:
    explicit ObjAssembly(const ObjContent& file) : m_file(file), m_objectOfPart(objectsOfParts(file)) {
        m_objects.resize(file.parts.size());
        m_indices.resize(file.points.size(), kNone);
        m_owners.resize(file.points.size(), kNone);
        nameObjects();
    }

    std::vector<SourceObject> objects() {
        std::vector<std::uint32_t> order(m_file.faces.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
        std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return m_objectOfPart[m_file.faces[i].part]; });
        for (const std::uint32_t i : order) addFace(m_file.faces[i], m_objectOfPart[m_file.faces[i].part]);
        std::erase_if(m_objects, [](const SourceObject& object) { return object.triangles.empty(); });
        return std::move(m_objects);
    }

private:
    /// A file whose groups are all one object has no name for it.
    void nameObjects() {
        const auto& all = m_objectOfPart;
        const bool isOne = all.size() > 1 && std::ranges::all_of(all, [](std::uint32_t object) { return object == 0; });
        for (std::uint32_t part = 0; part < all.size(); ++part)
            if (all[part] == part && !isOne) m_objects[part].name = m_file.parts[part].name;
    }
    void addFace(const ObjFace& face, std::uint32_t object) {
        m_corners.clear();
        for (std::uint32_t k = 0; k < face.size; ++k)
            m_corners.push_back(m_file.points[m_file.corners[face.firstCorner + k].point]);
        const auto triangles = polygonTriangles(m_corners);
        m_triangles += triangles.size();
        if (m_triangles > kMaxTriangles)
            throw MeshError(ErrorCode::Limit, "contains more than " + std::to_string(kMaxTriangles) + " triangles");
        SourceObject& target = m_objects[object];
        for (const auto& corners : triangles) {
            SourceTriangle& triangle = target.triangles.emplace_back();
            triangle.material = face.material;
            for (int k = 0; k < 3; ++k) {
                const ObjCorner corner = m_file.corners[face.firstCorner + corners[k]];
                triangle.points[k] = indexOf(corner.point, object);
                if (corner.uv == kNoUv) continue;
                triangle.uvs[k] = m_file.uvs[corner.uv];
                target.hasUvs = true;
            }
        }
    }
    /// The index of a point of the file in an object; objects are complete one after the other.
    std::uint32_t indexOf(std::uint32_t point, std::uint32_t object) {
        if (m_owners[point] != object) {
            m_owners[point] = object;
            m_indices[point] = static_cast<std::uint32_t>(m_objects[object].points.size());
            m_objects[object].points.push_back(m_file.points[point]);
        }
        return m_indices[point];
    }

    const ObjContent& m_file;
    std::vector<std::uint32_t> m_objectOfPart;
    std::vector<SourceObject> m_objects;  // some without triangles
    std::vector<std::uint32_t> m_indices, m_owners;
    std::vector<Vec3> m_corners;
    std::size_t m_triangles = 0;
};

/// Reads a material file and the images of its materials; a line may name several, or one with spaces in its name.
void readMaterials(const std::string& names, MeshFiles& files, MeshImages& images, SourceScene& scene) {
    std::vector<std::string> all{names};
    if (!files.Exists(names.c_str())) {
        std::string_view rest = names;
        std::vector<std::string> words;
        while (!(rest = trimmed(rest)).empty()) words.emplace_back(takeWord(rest));
        if (std::ranges::any_of(words, [&](const std::string& word) { return files.Exists(word.c_str()); }))
            all = words;
    }
    for (const std::string& name : all) {
        const std::optional<std::string> text = files.content(name);
        if (!text) continue;
        std::vector<ObjTexture> textures(scene.materials.size());
        readMaterialFile(*text, scene.materials, textures);
        for (std::size_t k = 0; k < textures.size(); ++k) {
            if (textures[k].file.empty()) continue;
            scene.materials[k].image =
                images.file(textures[k].file, std::filesystem::path(name).parent_path().string());
            if (textures[k].isTransformed)
                scene.notes.push_back("The offset and scale of the texture of the material " +
                                      quotedName(scene.materials[k].name) + " are not read.");
        }
    }
}

}  // namespace

SourceScene readObj(std::string_view text, MeshFiles& files) {
    const ObjContent file = readObjText(text);
    SourceScene scene;
    for (const std::string& name : file.materials) scene.materials.push_back({.name = name});
    MeshImages images(files, scene);
    for (const std::string& names : file.materialFiles) readMaterials(names, files, images, scene);
    scene.objects = ObjAssembly(file).objects();
    RoundingMeter rounding;
    rounding.add(file.points);
    for (SourceObject& object : scene.objects) object.rounding = displacementBy(rounding.step(), Mat4(1.0));
    if (file.lacksUvs) scene.notes.emplace_back("The file refers to texture coordinates that it does not have.");
    if (file.hasCurves) scene.notes.emplace_back("Free-form curves and surfaces of the file are not read.");
    return scene;
}

}  // namespace rubble
