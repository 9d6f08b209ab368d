#include "core/io/pack/PackMeshes.h"

#include "core/asset/mesh/FragmentMesh.h"
#include "core/asset/mesh/RoughCuts.h"
#include "core/io/exchange/GlbWriter.h"
#include "core/io/exchange/ObjFile.h"
#include "core/io/system/FileName.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr std::uint32_t kProgressInterval = 64;  // parts

/// A mesh file to be written and the fragments in it.
struct PartFile {
    std::string name;  // without suffix
    PackMeshBodies bodies;
    std::vector<std::uint32_t> fragments;
};

bool isBroken(const BakedFragment& fragment) { return fragment.childCount > 0; }

/// Puts fragments and their children into different files, so that the bodies of a file do not overlap.
std::vector<PartFile> singleFiles(const Bake& bake, const Asset& asset) {
    std::vector<PartFile> files{{meshName(asset.name) + "-fragments", PackMeshBodies::Fragments, {}}};
    for (std::uint32_t index = 0; index < bake.fragmentCount(); ++index) {
        const BakedFragment fragment = bake.fragment(index);
        const std::size_t file = isBroken(fragment) ? fragment.level + 1 : 0;
        while (files.size() <= file) {
            const std::string level = std::to_string(files.size() - 1);
            files.push_back({files[0].name + "-level-" + level, PackMeshBodies::Fragments, {}});
        }
        files[file].fragments.push_back(index);
    }
    std::erase_if(files, [](const PartFile& file) { return file.fragments.empty(); });
    return files;
}

std::vector<PartFile> fragmentFiles(const Bake& bake, const Asset& asset) {
    std::vector<PartFile> files;
    for (std::uint32_t index = 0; index < bake.fragmentCount(); ++index) {
        files.push_back({fragmentBodyName(asset, bake.fragmentId(index)), PackMeshBodies::Fragment, {index}});
    }
    return files;
}

/// Writes parts into OBJ and GLB files, as the options say.
class MeshFileWriter {
public:
    MeshFileWriter(const Asset& asset, const AssetMaterials& material, const MeshOptions& options)
        : m_options(options),
          m_materials(meshMaterials(asset, material)),
          m_materialFile(meshName(asset.name) + ".mtl") {}

    Status add(const PartFile& file, std::vector<MeshPart> parts) {
        if (m_options.faces == FaceShape::Triangles) {
            for (MeshPart& part : parts) part.mesh = triangulated(part.mesh);
        }
        if (m_options.obj)
            addFile(file, ".obj", objFile(parts, m_materials, m_options.place, m_materialFile, m_options.objFrame));
        if (!m_options.glb) return success();
        Result<std::string> glb = glbFile(parts, m_materials, m_options.place);
        if (!glb) return glb.error();
        addFile(file, ".glb", std::move(*glb));
        return success();
    }

    PackMeshes meshes() && {
        if (m_options.obj) m_meshes.files.push_back({m_materialFile, mtlFile(m_materials)});
        if (m_options.obj && m_materials.image)
            m_meshes.files.push_back({m_materials.imageFile, m_materials.image->bytes()});
        return std::move(m_meshes);
    }

private:
    void addFile(const PartFile& file, const char* suffix, std::string bytes) {
        const bool isOne = file.bodies == PackMeshBodies::Fragment;
        const std::uint32_t fragment = isOne ? file.fragments[0] : kNone;
        const std::string name = fittingFileName("", file.name, suffix);
        m_meshes.list.push_back({name, file.bodies, fragment, m_options.place});
        m_meshes.files.push_back({name, std::move(bytes)});
    }

    MeshOptions m_options;
    MeshMaterials m_materials;
    std::string m_materialFile;
    PackMeshes m_meshes;
};

}  // namespace

Result<PackMeshes> packMeshes(const Bake& bake, const Asset& asset, const AssetMaterials& material,
                              const MeshOptions& options, const TaskContext& task) {
    if (!options.obj && !options.glb) return PackMeshes();
    MeshFileWriter files(asset, material, options);
    const FragmentMesher mesher(asset);
    const std::string name = meshName(asset.name);
    const Status whole =
        files.add({name + "-intact", PackMeshBodies::Whole, {}}, {{name, mesher.wholeMesh(bake), bake.whole.centre}});
    if (!whole) return whole.error();
    const RoughCuts cuts(bake, asset);
    std::size_t done = 0;
    for (const PartFile& file :
         options.split == FileSplit::Single ? singleFiles(bake, asset) : fragmentFiles(bake, asset)) {
        std::vector<MeshPart> parts;
        parts.reserve(file.fragments.size());
        for (const std::uint32_t index : file.fragments) {
            if (task.isCancelled()) return TaskContext::cancelled();
            const BakedFragment fragment = bake.fragment(index);
            Mesh mesh = mesher.fragmentMesh(fragment, cuts.cornersOf(index));
            parts.push_back(
                {fragmentBodyName(asset, bake.fragmentId(index)), std::move(mesh), fragment.solid.offset()});
            if (++done % kProgressInterval == 0) {
                task.report(static_cast<double>(done) / static_cast<double>(bake.fragmentCount()));
            }
        }
        if (const Status added = files.add(file, std::move(parts)); !added) return added.error();
    }
    return std::move(files).meshes();
}

}  // namespace rubble
