#include "core/io/pack/PackMeshes.h"

#include "core/asset/mesh/FragmentMesh.h"
#include "core/asset/mesh/RoughCuts.h"
#include "core/io/exchange/CompactGlb.h"
#include "core/io/exchange/GlbWriter.h"
#include "core/io/exchange/MjcfFile.h"
#include "core/io/exchange/ObjFile.h"
#include "core/io/exchange/UsdFile.h"
#include "core/io/system/FileName.h"

#include <algorithm>
#include <optional>

namespace rubble {
namespace {

constexpr std::uint32_t kProgressInterval = 64;  // parts

/// The names of mesh files, without the suffix of a format.
std::string wholeFile(const PackNames& names) { return names.folder + "-intact"; }
std::string fragmentsFile(const PackNames& names) { return names.folder + "-fragments"; }
std::string levelFile(const PackNames& names, std::uint32_t level) {
    return fragmentsFile(names) + "-level-" + std::to_string(level);
}

std::string materialFile(const PackNames& names) { return names.folder + ".mtl"; }
std::string modelFile(const PackNames& names) { return fittingFileName("", names.folder, ".mjcf.xml"); }

std::string layerFile(const PackNames& names, PackMeshBodies bodies) {
    const bool isWhole = bodies == PackMeshBodies::Whole;
    return fittingFileName("", isWhole ? wholeFile(names) : names.folder, ".usda");
}

constexpr const char* kObjSuffix = ".obj";
constexpr const char* kGlbSuffix = ".glb";

std::string meshFile(const std::string& name, const char* suffix) { return fittingFileName("", name, suffix); }

/// Whether the image of a texture is a file of its own, and not within others.
bool hasImageFile(const MeshOptions& options) { return options.obj || options.usd; }

/// A mesh file to be written and the fragments in it.
struct PartFile {
    std::string name;  // without suffix
    PackMeshBodies bodies;
    std::vector<std::uint32_t> fragments;
    std::optional<std::uint32_t> level;  // see PackMeshFile
};

bool isBroken(const BakedFragment& fragment) { return fragment.childCount > 0; }

/// Puts fragments and their children into different files, so that the bodies of a file do not overlap.
std::vector<PartFile> singleFiles(const PackInput& input) {
    const Bake& bake = input.bake;
    std::vector<PartFile> files{{fragmentsFile(input.names), PackMeshBodies::Fragments, {}, {}}};
    for (std::uint32_t index = 0; index < bake.fragmentCount(); ++index) {
        const BakedFragment fragment = bake.fragment(index);
        const std::size_t file = isBroken(fragment) ? fragment.level + 1 : 0;
        while (files.size() <= file) {
            const auto level = static_cast<std::uint32_t>(files.size() - 1);
            files.push_back({levelFile(input.names, level), PackMeshBodies::Fragments, {}, level});
        }
        files[file].fragments.push_back(index);
    }
    std::erase_if(files, [](const PartFile& file) { return file.fragments.empty(); });
    return files;
}

std::vector<PartFile> fragmentFiles(const PackInput& input) {
    std::vector<PartFile> files;
    for (std::uint32_t index = 0; index < input.bake.fragmentCount(); ++index) {
        const std::string name = fragmentBodyName(input.names, input.bake.fragmentId(index));
        files.push_back({name, PackMeshBodies::Fragment, {index}, {}});
    }
    return files;
}

/// Writes parts into OBJ and GLB files, as the options say.
class MeshFileWriter {
public:
    MeshFileWriter(const PackBuilder& builder, const MeshOptions& options)
        : m_builder(builder),
          m_options(options),
          m_materials(meshMaterials(builder.input().asset, builder.input().material)),
          m_materialFile(materialFile(builder.input().names)) {}

    /// Adds the files of parts, which are the whole if the file has no fragments.
    Status add(const PartFile& file, std::vector<MeshPart> parts) {
        if (m_options.faces == FaceShape::Triangles) {
            for (MeshPart& part : parts) part.mesh = triangulated(part.mesh);
        }
        if (m_options.obj)
            addFile(file, kObjSuffix, objFile(parts, m_materials, m_options.place, m_materialFile, m_options.objFrame));
        if (!m_options.glb) return success();
        Result<std::string> glb = glbOf(file, parts);
        if (!glb) return glb.error();
        addFile(file, kGlbSuffix, std::move(*glb));
        return success();
    }

    PackMeshes meshes() && {
        if (m_options.obj) m_meshes.files.push_back({m_materialFile, mtlFile(m_materials)});
        if (hasImageFile(m_options) && m_materials.image)
            m_meshes.files.push_back({m_materials.imageFile, m_materials.image->bytes()});
        return std::move(m_meshes);
    }

private:
    Result<std::string> glbOf(const PartFile& file, std::span<const MeshPart> parts) const {
        if (m_options.glbKind == GlbKind::Compact)
            return compactGlbFile(parts, m_materials, m_options.place, file.name);
        const std::optional<GlbPhysics> physics = physicsOf(file);
        return glbFile(parts, m_materials, m_options.place, physics ? &*physics : nullptr);
    }
    /// The bodies in a file, in the order of its parts; nothing if GLB files have none.
    std::optional<GlbPhysics> physicsOf(const PartFile& file) const {
        if (m_options.glbKind != GlbKind::Physics && m_options.glbKind != GlbKind::Named) return std::nullopt;
        const auto& [bake, asset, material, names, settings] = m_builder.input();
        const bool isNamed = m_options.glbKind == GlbKind::Named;
        GlbPhysics physics{
            .bodies = {}, .material = material.own, .form = isNamed ? GlbBodyForm::Names : GlbBodyForm::Extensions};
        if (file.bodies == PackMeshBodies::Whole) physics.bodies.push_back({m_builder.whole(), {}});
        for (const std::uint32_t index : file.fragments) {
            PackBody body = m_builder.fragment(index);
            std::string parent = body.parent == kNone ? std::to_string(asset.id) : bake.fragmentId(body.parent);
            physics.bodies.push_back({std::move(body), std::move(parent)});
        }
        return physics;
    }
    void addFile(const PartFile& file, const char* suffix, std::string bytes) {
        const bool isOne = file.bodies == PackMeshBodies::Fragment;
        const std::uint32_t fragment = isOne ? file.fragments[0] : kNone;
        const std::string name = meshFile(file.name, suffix);
        m_meshes.list.push_back({name, file.bodies, fragment, m_options.place, file.level});
        m_meshes.files.push_back({name, std::move(bytes)});
    }

    const PackBuilder& m_builder;
    MeshOptions m_options;
    MeshMaterials m_materials;
    std::string m_materialFile;
    PackMeshes m_meshes;
};

/// Writes the OBJ and GLB files, the whole first.
Status addMeshFiles(const PackInput& input, const MeshOptions& options, const FragmentMesher& mesher,
                    const RoughCuts& cuts, MeshFileWriter& files, const TaskContext& task) {
    const Bake& bake = input.bake;
    const Status whole = files.add({wholeFile(input.names), PackMeshBodies::Whole, {}, {}},
                                   {{wholeBodyName(input.names), mesher.wholeMesh(bake), bake.whole.centre}});
    if (!whole) return whole.error();
    std::size_t done = 0;
    for (const PartFile& file : options.split == FileSplit::Single ? singleFiles(input) : fragmentFiles(input)) {
        std::vector<MeshPart> parts;
        parts.reserve(file.fragments.size());
        for (const std::uint32_t index : file.fragments) {
            if (task.isCancelled()) return TaskContext::cancelled();
            const BakedFragment fragment = bake.fragment(index);
            Mesh mesh = mesher.fragmentMesh(fragment, cuts.cornersOf(index));
            const std::string name = fragmentBodyName(input.names, bake.fragmentId(index));
            parts.push_back({name, std::move(mesh), fragment.solid.offset()});
            if (++done % kProgressInterval == 0) {
                task.report(static_cast<double>(done) / static_cast<double>(bake.fragmentCount()));
            }
        }
        if (const Status added = files.add(file, std::move(parts)); !added) return added.error();
    }
    return success();
}

/// The fragments that do not break.
std::vector<std::uint32_t> unbrokenFragments(const Bake& bake) {
    std::vector<std::uint32_t> fragments;
    for (std::uint32_t index = 0; index < bake.fragmentCount(); ++index) {
        if (!isBroken(bake.fragment(index))) fragments.push_back(index);
    }
    return fragments;
}

/// Writes the files of USD and MuJoCo that the options ask for.
Status addPhysicsFiles(const PackBuilder& pack, const MeshOptions& options, const FragmentMesher& mesher,
                       const RoughCuts& cuts, std::vector<ExportFile>& files, const TaskContext& task) {
    const PackInput& input = pack.input();
    const Bake& bake = input.bake;
    const std::vector<std::uint32_t> fragments = unbrokenFragments(bake);
    if (options.mjcf) {
        Result<std::string> model = mjcfFile(pack, fragments, task);
        if (!model) return model.error();
        files.push_back({modelFile(input.names), std::move(*model)});
    }
    if (!options.usd) return success();
    const auto meshOf = [&](std::uint32_t index) {
        return index == kNone ? mesher.wholeMesh(bake)
                              : mesher.fragmentMesh(bake.fragment(index), cuts.cornersOf(index));
    };
    const MeshMaterials materials = meshMaterials(input.asset, input.material);
    const std::vector<std::uint32_t> whole{kNone};
    for (const PackMeshBodies bodies : {PackMeshBodies::Fragments, PackMeshBodies::Whole}) {
        const bool isWhole = bodies == PackMeshBodies::Whole;
        Result<std::string> layer = usdFile(pack, isWhole ? whole : fragments, materials, meshOf, task);
        if (!layer) return layer.error();
        files.push_back({layerFile(input.names, bodies), std::move(*layer)});
    }
    return success();
}

}  // namespace

PackFileNames meshFileNames(const Asset& asset, const PackNames& names, const MeshOptions& options) {
    std::vector<std::string> meshes{wholeFile(names)};
    if (options.split == FileSplit::Single) meshes.push_back(fragmentsFile(names));
    PackFileNames files;
    for (const std::string& name : meshes) {
        if (options.obj) files.names.push_back(meshFile(name, kObjSuffix));
        if (options.glb) files.names.push_back(meshFile(name, kGlbSuffix));
    }
    if (options.obj) files.names.push_back(materialFile(names));
    if (hasImageFile(options) && asset.texture) files.names.push_back(imageFileName(*asset.texture));
    if (options.mjcf) files.names.push_back(modelFile(names));
    for (const PackMeshBodies bodies : {PackMeshBodies::Fragments, PackMeshBodies::Whole}) {
        if (options.usd) files.names.push_back(layerFile(names, bodies));
    }
    const auto breaks = [](const FragmentLevel& single) { return single.level.has_value(); };
    const bool hasLevels = !asset.levels.empty() || std::ranges::any_of(asset.fragmentLevels, breaks);
    const bool dependsOnFragments = options.split == FileSplit::PerFragment || hasLevels;
    files.areAll = !(options.obj || options.glb) || !dependsOnFragments;
    return files;
}

double meshBytesPerFragment(const MeshOptions& options) {
    double bytes = 0.0;
    if (options.obj) bytes += 2200.0;
    if (options.usd) bytes += 4800.0;
    if (options.mjcf) bytes += 1200.0;
    if (!options.glb) return bytes;
    switch (options.glbKind) {
        case GlbKind::Plain: return bytes + 3400.0;
        case GlbKind::Physics: return bytes + 8800.0;
        case GlbKind::Compact: return bytes + 900.0;
        case GlbKind::Named: return bytes + 7100.0;
    }
    return bytes;
}

Result<PackMeshes> packMeshes(const PackBuilder& builder, const MeshOptions& options, const TaskContext& task) {
    const PackInput& input = builder.input();
    const bool hasMeshes = options.obj || options.glb;
    if (!hasMeshes && !options.usd && !options.mjcf) return PackMeshes();
    const FragmentMesher mesher(input.asset);
    const RoughCuts cuts(input.bake, input.asset);
    MeshFileWriter files(builder, options);
    if (hasMeshes) {
        const Status added = addMeshFiles(input, options, mesher, cuts, files, task);
        if (!added) return added.error();
    }
    PackMeshes meshes = std::move(files).meshes();
    const Status added = addPhysicsFiles(builder, options, mesher, cuts, meshes.files, task);
    if (!added) return added.error();
    return meshes;
}

}  // namespace rubble
