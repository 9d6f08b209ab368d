#include "core/io/pack/PackMeshes.h"

#include "core/io/formats/ExportFormat.h"
#include "core/io/formats/TextureBaking.h"
#include "core/io/system/FileName.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr std::uint32_t kProgressInterval = 64;  // parts

std::string fragmentsFile(const PackNames& names) { return names.folder + "-fragments"; }
std::string levelFile(const PackNames& names, std::uint32_t level) {
    return fragmentsFile(names) + "-level-" + std::to_string(level);
}

std::string partFileName(const std::string& name, const ExportFormat& format) {
    return fittingFileName("", name, std::string(format.suffix));
}

bool hasParts(const ExportFormat* format) { return format->partFile != nullptr; }

/// Whether the image of a texture is a file of its own, and not within others.
bool hasImageFile(std::span<const ExportFormat* const> formats) {
    return std::ranges::any_of(formats, &ExportFormat::hasImageFile);
}

/// Puts fragments and their children into different files, so that the bodies of a file do not overlap.
std::vector<PartFile> singleFiles(const PackInput& input) {
    const Bake& bake = input.bake;
    std::vector<PartFile> files{{fragmentsFile(input.names), PackMeshBodies::Fragments, {}, {}}};
    for (std::uint32_t index = 0; index < bake.fragmentCount(); ++index) {
        const BakedFragment fragment = bake.fragment(index);
        const bool isBroken = fragment.childCount > 0;
        const std::size_t file = isBroken ? fragment.level + 1 : 0;
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

/// Writes the files of the formats of an export.
class MeshFileWriter {
public:
    MeshFileWriter(const FormatInput& input, std::vector<const ExportFormat*> formats)
        : m_input(input), m_formats(std::move(formats)) {}

    /// Writes the files of parts, the whole first.
    Status addPartFiles() {
        if (std::ranges::none_of(m_formats, hasParts)) return success();
        const PackInput& pack = m_input.pack.input();
        const Status whole =
            add({wholeFileName(pack.names), PackMeshBodies::Whole, {}, {}},
                {{wholeBodyName(pack.names), m_input.mesher.wholeMesh(pack.bake), pack.bake.whole.centre}});
        if (!whole) return whole.error();
        const bool isSingle = m_input.options.split == FileSplit::Single;
        for (const PartFile& file : isSingle ? singleFiles(pack) : fragmentFiles(pack)) {
            Result<std::vector<MeshPart>> parts = partsOf(file);
            if (!parts) return parts.error();
            if (const Status added = add(file, std::move(*parts)); !added) return added.error();
        }
        return success();
    }

    /// Writes the files of the asset.
    Status addAssetFiles() {
        for (const ExportFormat* format : m_formats) {
            if (format->assetFiles == nullptr) continue;
            Result<std::vector<std::string>> files = format->assetFiles(m_input);
            if (!files) return files.error();
            const std::vector<std::string> names = format->assetFileNames(m_input.pack.input().names);
            for (std::size_t k = 0; k < names.size(); ++k) m_meshes.files.push_back({names[k], std::move((*files)[k])});
        }
        if (hasImageFile(m_formats) && m_input.materials.image)
            m_meshes.files.push_back({m_input.materials.imageFile, m_input.materials.image->bytes()});
        if (m_input.textures == nullptr || !areImagesBeside(m_input.options)) return success();
        const auto& [colour, normal, surface, areBeside] = *m_input.textures->materials.baked;
        for (const MeshImage* image : {&colour, &normal, &surface})
            m_meshes.files.push_back({image->name, image->image->bytes()});
        return success();
    }

    PackMeshes meshes() && { return std::move(m_meshes); }

private:
    Result<std::vector<MeshPart>> partsOf(const PartFile& file) {
        const PackInput& pack = m_input.pack.input();
        std::vector<MeshPart> parts;
        parts.reserve(file.fragments.size());
        for (const std::uint32_t index : file.fragments) {
            if (m_input.task.isCancelled()) return TaskContext::cancelled();
            const BakedFragment fragment = pack.bake.fragment(index);
            Mesh mesh = m_input.mesher.fragmentMesh(fragment, m_input.cuts.cornersOf(index));
            const std::string name = fragmentBodyName(pack.names, pack.bake.fragmentId(index));
            parts.push_back({name, std::move(mesh), fragment.solid.offset()});
            if (++m_done % kProgressInterval == 0)
                m_input.task.report(static_cast<double>(m_done) / static_cast<double>(pack.bake.fragmentCount()));
        }
        return parts;
    }

    /// Writes a file of parts in each format that has such files.
    Status add(const PartFile& file, std::vector<MeshPart> parts) {
        for (const ExportFormat* format : m_formats) {
            if (!hasParts(format)) continue;
            Result<std::string> bytes = format->partFile(m_input, file, parts);
            if (!bytes) return bytes.error();
            const std::uint32_t fragment = file.bodies == PackMeshBodies::Fragment ? file.fragments[0] : kNone;
            const std::string name = partFileName(file.name, *format);
            m_meshes.list.push_back({name, file.bodies, fragment, m_input.options.place, file.level});
            m_meshes.files.push_back({name, std::move(*bytes)});
        }
        return success();
    }

    FormatInput m_input;
    std::vector<const ExportFormat*> m_formats;
    std::size_t m_done = 0;  // fragments
    PackMeshes m_meshes;
};

}  // namespace

PackFileNames meshFileNames(const Asset& asset, const AssetMaterials& materials, const PackNames& names,
                            const MeshOptions& options) {
    const std::vector<const ExportFormat*> formats = formatsOf(options.formats);
    std::vector<std::string> parts{wholeFileName(names)};
    if (options.split == FileSplit::Single) parts.push_back(fragmentsFile(names));
    PackFileNames files;
    for (const std::string& name : parts) {
        for (const ExportFormat* format : formats) {
            if (hasParts(format)) files.names.push_back(partFileName(name, *format));
        }
    }
    for (const ExportFormat* format : formats) {
        if (format->assetFiles == nullptr) continue;
        for (std::string& name : format->assetFileNames(names)) files.names.push_back(std::move(name));
    }
    if (hasImageFile(formats) && asset.texture) files.names.push_back(imageFileName(*asset.texture));
    const TexturedSides baked = bakedSides(asset, materials, options);
    if ((baked.outside || baked.inside) && areImagesBeside(options)) {
        for (std::string& name : bakedImageNames(names)) files.names.push_back(std::move(name));
    }
    const auto breaks = [](const FragmentLevel& single) { return single.level.has_value(); };
    const bool hasLevels = !asset.levels.empty() || std::ranges::any_of(asset.fragmentLevels, breaks);
    const bool dependsOnFragments = options.split == FileSplit::PerFragment || hasLevels;
    files.areAll = !dependsOnFragments || std::ranges::none_of(formats, hasParts);
    return files;
}

double meshBytesPerFragment(const MeshOptions& options) {
    double bytes = 0.0;
    for (const ExportFormat* format : formatsOf(options.formats)) bytes += format->bytesPerFragment(options);
    return bytes;
}

Result<PackMeshes> packMeshes(const PackBuilder& builder, const MeshOptions& options, const TaskContext& task) {
    std::vector<const ExportFormat*> formats = formatsOf(options.formats);
    if (formats.empty()) return PackMeshes();
    const PackInput& pack = builder.input();
    const FragmentMesher mesher(pack.asset);
    const RoughCuts cuts(pack.bake, pack.asset);
    const MeshMaterials materials = meshMaterials(pack.asset, pack.material);
    const Result<std::optional<BakedTextures>> textures =
        bakedTextures(pack, options, mesher, cuts, materials, task.stage(0.0, 0.5));
    if (!textures) return textures.error();
    const TaskContext writing = *textures ? task.stage(0.5, 1.0) : task;
    MeshFileWriter files({builder, options, materials, mesher, cuts, *textures ? &**textures : nullptr, writing},
                         std::move(formats));
    if (const Status added = files.addPartFiles(); !added) return added.error();
    if (const Status added = files.addAssetFiles(); !added) return added.error();
    return std::move(files).meshes();
}

}  // namespace rubble
