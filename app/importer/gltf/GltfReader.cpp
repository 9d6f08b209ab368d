#include "app/importer/gltf/GltfReader.h"

#include "app/importer/files/AssimpValues.h"
#include "app/importer/files/MeshError.h"
#include "app/importer/files/MeshImages.h"
#include "app/importer/gltf/GltfShapes.h"
#include "core/base/MessageText.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// The materials, and behind them the one of primitives without a material.
std::vector<SourceMaterial> materialsOf(const GltfDocument& document) {
    std::vector<SourceMaterial> materials;
    for (const GltfMaterial& source : document.materials) {
        SourceMaterial& material = materials.emplace_back(SourceMaterial{.name = source.name});
        for (int k = 0; k < 3; ++k) material.colour[k] = srgbFromLinear(source.colour[k]);
    }
    materials.push_back({.name = {}, .colour = Vec3(1.0)});
    return materials;
}

/// Reads the image of a material's base colour; nothing if it has none or it is not read.
std::optional<std::uint32_t> imageOf(const GltfMaterial& material, const GltfDocument& document, GltfBuffers& buffers,
                                     MeshImages& images) {
    if (!material.texture) return std::nullopt;
    const bool hasTexture = *material.texture < document.textures.size();
    const GltfIndex index = hasTexture ? document.textures[*material.texture] : std::nullopt;
    if (!index || *index >= document.images.size()) {
        images.note(material.name, hasTexture && !index ? "is in a format that is not read; export it as PNG or JPEG"
                                                        : "does not exist");
        return std::nullopt;
    }
    const GltfImage& image = document.images[*index];
    const std::string key = "images[" + std::to_string(*index) + "]";
    const std::string& name = image.name.empty() ? material.name : image.name;
    if (image.uri && !image.uri->starts_with("data:")) return images.file(*image.uri);
    try {
        if (image.uri) return images.embedded(key, name, GltfBuffers::dataOf(*image.uri).value_or(""));
        return images.embedded(key, name, image.view ? buffers.view(*image.view) : std::string_view());
    } catch (const MeshError&) {
        images.note(name, "has no bytes; export it again");
        return std::nullopt;
    }
}

/// The name of a node, else of its mesh, else of the closest parent with a name.
std::string nameOf(std::uint32_t index, const GltfDocument& document, const std::vector<GltfIndex>& parents) {
    const GltfNode& node = document.nodes[index];
    if (!node.name.empty()) return node.name;
    if (*node.mesh < document.meshes.size() && !document.meshes[*node.mesh].name.empty())
        return document.meshes[*node.mesh].name;
    for (GltfIndex parent = parents[index]; parent; parent = parents[*parent])
        if (!document.nodes[*parent].name.empty()) return document.nodes[*parent].name;
    return {};
}

void addNode(const GltfNode& node, const std::string& name, const Mat4& toScene, GltfAccessors& accessors,
             GltfShapes& shapes, SourceScene& scene) {
    const auto first = static_cast<std::ptrdiff_t>(scene.objects.size());
    std::vector<Mat4> placed;  // of the objects from `first` on
    for (const Mat4& transform : instanceTransforms(node, toScene, accessors)) {
        bool isCopy = false;
        for (std::size_t i = 0; i < placed.size() && !isCopy; ++i) {
            const std::optional<Pose> motion = rigidMotion(placed[i], transform);
            isCopy = motion.has_value();
            if (isCopy) scene.objects[static_cast<std::size_t>(first) + i].copies.push_back(*motion);
        }
        if (isCopy) continue;
        placed.push_back(transform);
        SourceObject& object = scene.objects.emplace_back(SourceObject{.name = name});
        shapes.addMesh(node, transform, object);
    }
    scene.objects.erase(std::remove_if(scene.objects.begin() + first, scene.objects.end(),
                                       [](const SourceObject& object) { return object.triangles.empty(); }),
                        scene.objects.end());
}

/// Adds a note with the names of hidden objects.
///
/// Errors: throws MeshError if all objects are hidden.
void noteHidden(const std::vector<std::uint32_t>& hidden, const GltfDocument& document,
                const std::vector<GltfIndex>& parents, SourceScene& scene) {
    std::vector<std::string> names;
    for (const std::uint32_t index : hidden)
        if (document.nodes[index].mesh) names.push_back(nameOf(index, document, parents));
    if (names.empty()) return;
    if (scene.objects.empty())
        throw MeshError(ErrorCode::Degenerate,
                        "has only hidden objects; show what to import in the program that made it");
    scene.notes.push_back("Hidden in the file and not imported: " + quotedNames(names) + ".");
}

}  // namespace

SourceScene readGltf(std::string_view bytes, MeshFiles& files) {
    const GltfChunks chunks = gltfChunks(bytes);
    const GltfDocument document = readGltfDocument(chunks.json);
    GltfBuffers buffers(document, chunks.binary, files);
    GltfAccessors accessors(document, buffers);
    const std::vector<GltfIndex> parents = nodeParents(document);
    const std::vector<Mat4> fromNodes = sceneTransforms(document, parents);
    GltfShapes shapes(document, buffers, accessors, fromNodes);
    SourceScene scene{.metresPerUnit = 1.0, .materials = materialsOf(document)};
    MeshImages images(files, scene);
    for (std::size_t k = 0; k < document.materials.size(); ++k)
        scene.materials[k].image = imageOf(document.materials[k], document, buffers, images);
    const SceneNodes nodes = nodesOfScene(document);
    for (const std::uint32_t index : nodes.visible) {
        const GltfNode& node = document.nodes[index];
        if (!node.mesh) continue;
        addNode(node, nameOf(index, document, parents), fromNodes[index], accessors, shapes, scene);
    }
    noteHidden(nodes.hidden, document, parents, scene);
    if (document.sceneCount > 1)
        scene.notes.push_back("The file has " + std::to_string(document.sceneCount) +
                              " scenes; only the one that it shows is read.");
    if (document.hasAnimations) scene.notes.emplace_back("The animations of the file are not read.");
    return scene;
}

}  // namespace rubble
