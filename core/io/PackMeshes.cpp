#include "core/io/PackMeshes.h"

#include "core/io/GlbFile.h"
#include "core/io/ObjFile.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr std::uint32_t kTold = 64;  // parts between two reports of progress

/// A file to be, without its ending, and the fragments in it.
struct PartFile {
    std::string name;
    std::vector<std::size_t> fragments;
};

bool isBroken(const BakedFragment& fragment) { return fragment.childCount > 0; }

/// No two fragments of a file overlap: a fragment is in another one than its pieces.
std::vector<PartFile> singleFiles(const Bake& bake, const Asset& asset) {
    std::vector<PartFile> files{{wholeName(asset), {}}};
    for (std::size_t index = 0; index < bake.fragments.size(); ++index) {
        const BakedFragment& fragment = bake.fragments[index];
        const std::size_t file = isBroken(fragment) ? fragment.level + 1 : 0;
        while (files.size() <= file) {
            files.push_back({files[0].name + "-level" + std::to_string(files.size() - 1), {}});
        }
        files[file].fragments.push_back(index);
    }
    std::erase_if(files, [](const PartFile& file) { return file.fragments.empty(); });
    return files;
}

std::vector<PartFile> fragmentFiles(const Bake& bake, const Asset& asset) {
    std::vector<PartFile> files;
    for (std::size_t index = 0; index < bake.fragments.size(); ++index) {
        files.push_back({fragmentName(asset, index), {index}});
    }
    return files;
}

/// Writes parts into files of the kinds that are asked for.
class MeshFiles {
public:
    MeshFiles(const Asset& asset, const Material& material, const MeshOptions& options)
        : m_options(options), m_materials(meshMaterials(asset, material)), m_materialFile(wholeName(asset) + ".mtl") {}

    Status add(const std::string& name, std::vector<MeshPart> parts) {
        if (m_options.faces == FaceShape::Triangles) {
            for (MeshPart& part : parts) part.mesh = triangulated(part.mesh);
        }
        if (m_options.obj) {
            m_files.push_back({name + ".obj", objFile(parts, m_materials, m_options.place, m_materialFile)});
        }
        if (!m_options.glb) return success();
        Result<std::string> glb = glbFile(parts, m_materials, m_options.place);
        if (!glb) return glb.error();
        m_files.push_back({name + ".glb", std::move(*glb)});
        return success();
    }

    std::vector<ExportFile> files() && {
        if (m_options.obj) m_files.push_back({m_materialFile, mtlFile(m_materials)});
        return std::move(m_files);
    }

private:
    MeshOptions m_options;
    MeshMaterials m_materials;
    std::string m_materialFile;
    std::vector<ExportFile> m_files;
};

}  // namespace

std::string wholeName(const Asset& asset) { return meshName(asset.name); }

std::string fragmentName(const Asset& asset, std::size_t index) { return wholeName(asset) + std::to_string(index); }

Result<std::vector<ExportFile>> packMeshes(const Bake& bake, const Asset& asset, const Material& material,
                                           const MeshOptions& options, const TaskContext& task) {
    if (!options.obj && !options.glb) return std::vector<ExportFile>();
    MeshFiles files(asset, material, options);
    const Status whole =
        files.add(wholeName(asset) + "-whole", {{wholeName(asset), wholeMesh(bake, asset), bake.whole.centre}});
    if (!whole) return whole.error();
    std::size_t made = 0;
    for (const PartFile& file :
         options.split == FileSplit::Single ? singleFiles(bake, asset) : fragmentFiles(bake, asset)) {
        std::vector<MeshPart> parts;
        parts.reserve(file.fragments.size());
        for (const std::size_t index : file.fragments) {
            if (task.isCancelled()) return TaskContext::cancelled();
            const BakedFragment& fragment = bake.fragments[index];
            parts.push_back({fragmentName(asset, index), fragmentMesh(fragment, asset), fragment.solid.offset});
            if (++made % kTold == 0) {
                task.report(static_cast<double>(made) / static_cast<double>(bake.fragments.size()));
            }
        }
        if (const Status added = files.add(file.name, std::move(parts)); !added) return added.error();
    }
    return std::move(files).files();
}

}  // namespace rubble
