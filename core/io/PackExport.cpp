#include "core/io/PackExport.h"

#include "core/asset/Threshold.h"
#include "core/asset/Variants.h"
#include "core/base/Parallel.h"
#include "core/io/MadeFolders.h"
#include "core/io/PackFile.h"
#include "core/io/ProjectFile.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>

namespace rubble {
namespace {

/// Raised when the same asset gives other mesh files than before, so that old exports are made anew.
constexpr std::uint64_t kMeshVersion = 1;

/// The name of an asset's folder as a system sees it that does not tell "Wall" from "wall".
std::string foldedFolderName(const Asset& asset) {
    std::string name = safeFileName(asset.name);
    for (char& letter : name) {
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    }
    return name;
}

/// The assets of the project in all variants that it uses, each as an asset; only those that are named where any are.
std::vector<Asset> assetsInVariants(const Project& project, std::span<const Id> only = {}) {
    std::vector<Asset> assets;
    for (const auto& [id, variant] : usedVariants(project)) {
        if (!only.empty() && std::ranges::find(only, id) == only.end()) continue;
        assets.push_back(variantOf(*findAsset(project, id), variant));
    }
    return assets;
}

/// All assets of the project count, so that exporting them one by one is no way around it.
Status checkFolderNames(const Project& project) {
    std::map<std::string, std::string> owners;
    for (const Asset& asset : assetsInVariants(project)) {
        const auto [owner, isFirst] = owners.emplace(foldedFolderName(asset), asset.name);
        if (isFirst) continue;
        return Error{ErrorCode::BadInput, "The assets \"" + owner->second + "\" and \"" + asset.name +
                                              "\" would both be exported to the folder \"" + safeFileName(asset.name) +
                                              "\"; rename one of them."};
    }
    return success();
}

/// Progress of several tasks at once, told as that of one.
class SharedProgress {
public:
    SharedProgress(const TaskContext& task, std::size_t count) : m_task(task), m_fractions(count, 0.0) {}

    /// The context of the task `index`: its share of the whole runs from 0 to 1.
    TaskContext contextOf(std::size_t index, int threads) {
        TaskContext context;
        context.cancel = m_task.cancel;
        context.threads = threads;
        context.progress = [this, index](double fraction) { tell(index, fraction); };
        return context;
    }
    void tell(std::size_t index, double fraction) {
        const std::lock_guard lock(m_mutex);
        m_sum += fraction - m_fractions[index];
        m_fractions[index] = fraction;
        m_task.report(std::clamp(m_sum / static_cast<double>(m_fractions.size()), 0.0, 1.0));
    }

private:
    const TaskContext& m_task;
    std::mutex m_mutex;
    std::vector<double> m_fractions;
    double m_sum = 0.0;
};

Status writePack(const Project& project, const Asset& asset, const MeshOptions& options, const ContentHash& source,
                 const TaskContext& task, AssetExport& result) {
    const AssetMaterials material = materialsOf(project, asset);
    Result<Bake> baked = bake(asset, task.stage(0.0, 0.5));
    if (!baked) return baked.error();
    Result<PackMeshes> meshes = packMeshes(*baked, asset, material, options, task.stage(0.5, 0.8));
    if (!meshes && meshes.error().code == ErrorCode::Cancelled) return meshes.error();
    if (!meshes) return Error{meshes.error().code, "Asset \"" + asset.name + "\": " + meshes.error().message};
    std::vector<ExportFile> files = std::move(meshes->files);
    files.insert(files.begin(), {kPackName, packJson(*baked, asset, material, meshes->list, task.stage(0.8, 0.9))});
    result.fragmentCount = baked->fragmentCount();
    result.volume = baked->whole.volume;
    result.reports = std::move(baked->reports);
    task.report(0.9);
    return writeExportFolder(result.folder, source, files, task);
}

AssetExport exported(const Project& project, const Asset& asset, const std::filesystem::path& folder,
                     const MeshOptions& options, const TaskContext& task) {
    AssetExport result{.asset = asset.id, .name = asset.name, .folder = folder / safeFileName(asset.name)};
    if (task.isCancelled()) {
        result.status = TaskContext::cancelled();
        return result;
    }
    const ContentHash source = packSource(project, asset, options);
    result.isUnchanged = isExportOf(result.folder, source);
    if (!result.isUnchanged) result.status = writePack(project, asset, options, source, task, result);
    task.report(1.0);
    return result;
}

}  // namespace

ContentHash packSource(const Project& project, const Asset& asset, const MeshOptions& options) {
    // A project of nothing but this asset tells all of it; play beyond the threshold is not in packs.
    Project alone;
    alone.nextId = std::numeric_limits<Id>::max();
    const AssetMaterials material = materialsOf(project, asset);
    alone.materials = {material.own};
    if (asset.insideMaterial != 0) alone.materials.push_back(material.inside);
    alone.assets = {asset};
    alone.assets[0].cutAtImpact.reset();
    alone.assets[0].intents.clear();
    alone.assets[0].threshold = thresholdOf(asset, material.own);
    alone.assets[0].contactTime.reset();
    for (Material& each : alone.materials) {
        each.tensileStrength.reset();
        each.fractureToughness.reset();
    }
    Hasher hasher;
    hasher.add(kMeshVersion);
    hasher.add(std::uint64_t{kPackVersion});
    hasher.add(bakeInputHash(asset).high);  // these two for the version of bake()
    hasher.add(bakeInputHash(asset).low);
    hasher.add(std::uint64_t{options.obj});
    hasher.add(std::uint64_t{options.glb});
    for (const std::uint64_t option :
         {static_cast<std::uint64_t>(options.split), static_cast<std::uint64_t>(options.place),
          static_cast<std::uint64_t>(options.faces)}) {
        hasher.add(option);
    }
    hasher.add(projectText(alone));
    return hasher.digest();
}

Result<std::vector<AssetExport>> exportPacks(const Project& project, std::span<const Id> assets,
                                             const std::filesystem::path& folder, const MeshOptions& options,
                                             const TaskContext& task) {
    for (const Id id : assets) {
        if (findAsset(project, id) != nullptr) continue;
        return Error{ErrorCode::NotFound, "The project has no asset with the id " + std::to_string(id) + "."};
    }
    if (const Status distinct = checkFolderNames(project); !distinct) return distinct.error();
    MadeFolders made;  // here, so that no asset takes away the folder that another is about to write into
    if (const Status status = made.make(folder); !status) return status.error();
    std::vector<Asset> packed;
    for (const Id id : assets) std::ranges::move(assetsInVariants(project, {&id, 1}), std::back_inserter(packed));
    std::vector<AssetExport> results(packed.size());
    SharedProgress progress(task, packed.size());
    const int threadsEach = std::max(1, task.threads / static_cast<int>(std::max<std::size_t>(1, packed.size())));
    forEachIndex(packed.size(), task.threads, [&](std::size_t index) {
        results[index] = exported(project, packed[index], folder, options, progress.contextOf(index, threadsEach));
    });
    if (task.isCancelled()) return TaskContext::cancelled();
    return results;
}

}  // namespace rubble
