#include "core/io/pack/PackExport.h"

#include "core/asset/bake/BakeEstimate.h"
#include "core/asset/bake/BakeHash.h"
#include "core/asset/finish/AssetFinish.h"
#include "core/asset/project/Ids.h"
#include "core/asset/project/Variants.h"
#include "core/asset/strength/BondStrength.h"
#include "core/asset/strength/Threshold.h"
#include "core/base/MessageText.h"
#include "core/base/Parallel.h"
#include "core/base/Version.h"
#include "core/io/formats/ExportFormat.h"
#include "core/io/formats/ExportTarget.h"
#include "core/io/formats/TextureBaking.h"
#include "core/io/output/ExportCheck.h"
#include "core/io/output/ExportIndex.h"
#include "core/io/pack/PackBinary.h"
#include "core/io/pack/PackFile.h"
#include "core/io/pack/SceneFile.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/CreatedDirectories.h"
#include "core/io/system/FileName.h"
#include "core/io/system/Temporary.h"

#include <algorithm>
#include <limits>
#include <map>
#include <mutex>

namespace rubble {
namespace {

/// To be increased when pack.json or the mesh files of an asset change, so that existing exports are rewritten.
constexpr std::uint64_t kExportRevision = 6;

/// An asset or a variant of it, and its names.
struct PackedAsset {
    Asset asset;
    PackNames names;
};

/// Returns the assets in all variants that the project uses.
std::vector<PackedAsset> packedAssets(const Project& project, std::span<const Id> assets, const PackOptions& options) {
    const std::map<AssetVariant, PackNames> names = packNames(project, options);
    std::vector<PackedAsset> packed;
    for (const Id id : assets) {
        for (auto at = names.lower_bound({id}); at != names.end() && at->first.asset == id; ++at)
            packed.push_back({variantOf(*findAsset(project, id), at->first.variant), at->second});
    }
    return packed;
}

/// How folders of earlier exports are replaced.
struct Replacement {
    EditedFiles edited;
    FolderLocking locking;
};

bool hasJson(const PackOptions& options) { return options.files != PackFiles::Binary; }
bool hasBinary(const PackOptions& options) { return options.files != PackFiles::Json; }

/// Reports the progress of several parallel tasks as their mean.
class SharedProgress {
public:
    SharedProgress(const TaskContext& task, std::size_t count) : m_task(task), m_fractions(count, 0.0) {}

    /// Returns the context for a task, which reports its own progress from 0 to 1.
    TaskContext contextOf(std::size_t index, int threads) {
        TaskContext context;
        context.cancel = m_task.cancel;
        context.threads = threads;
        context.progress = [this, index](double fraction) { report(index, fraction); };
        return context;
    }
    void report(std::size_t index, double fraction) {
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

Status writePack(const Project& project, const PackedAsset& packed, const PackOptions& options,
                 const ContentHash& source, const Replacement& replacement, const TaskContext& task,
                 AssetExport& result) {
    const Asset& asset = packed.asset;
    Result<Bake> baked = bake(asset, task.stage(0.0, 0.5));
    if (!baked) return baked.error();
    const PackInput input{*baked,
                          asset,
                          materialsOf(project, asset),
                          packed.names,
                          packSettings(project, options),
                          placedOrientation(project, asset.id)};
    const PackBuilder builder(input, task.stage(0.5, 0.52));
    Result<PackMeshes> meshes = packMeshes(builder, options.meshes, task.stage(0.52, 0.8));
    if (!meshes && meshes.error().code == ErrorCode::Cancelled) return meshes.error();
    if (!meshes) return Error{meshes.error().code, "Asset " + quotedName(asset.name) + ": " + meshes.error().message};
    std::vector<ExportFile> files = std::move(meshes->files);
    if (hasBinary(options)) {
        Result<std::string> binary = packBinary(builder, meshes->list, task.stage(0.8, 0.82));
        if (!binary)
            return Error{binary.error().code, "Asset " + quotedName(asset.name) + ": " + binary.error().message};
        files.insert(files.begin(), {kPackBinaryName, std::move(*binary)});
    }
    if (hasJson(options)) {
        std::string json = packJson(builder, meshes->list, options.topology, task.stage(0.82, 0.9));
        files.insert(files.begin(), {kPackName, std::move(json)});
    }
    result.fragmentCount = baked->fragmentCount();
    result.volume = baked->whole.volume;
    result.diagnostics = std::move(baked->diagnostics);
    task.report(0.9);
    return writeExportFolder(result.folder, source, files, replacement.edited, task, replacement.locking);
}

/// The result for an asset before it is exported: whether its folder exists, and already is its export.
AssetExport lookedUp(const PackedAsset& packed, const std::filesystem::path& folder, const ContentHash& source) {
    const Asset& asset = packed.asset;
    AssetExport result{.asset = asset.id, .name = asset.name, .folder = folder / packed.names.folder};
    std::error_code ignored;
    result.isReplacing = std::filesystem::exists(result.folder, ignored);
    result.isUnchanged = isExportOf(result.folder, source);
    return result;
}

AssetExport exportAsset(const Project& project, const PackedAsset& packed, const std::filesystem::path& folder,
                        const PackOptions& options, const Replacement& replacement, const TaskContext& task) {
    const Asset& asset = packed.asset;
    if (task.isCancelled()) {
        return {.asset = asset.id,
                .name = asset.name,
                .folder = folder / packed.names.folder,
                .status = TaskContext::cancelled()};
    }
    const ContentHash source = packSourceHash(project, asset, packed.names, options);
    AssetExport result = lookedUp(packed, folder, source);
    if (!result.isUnchanged) result.status = writePack(project, packed, options, source, replacement, task, result);
    task.report(1.0);
    return result;
}

/// Errors: NotFound if there is no asset with an id.
Status checkAssets(const Project& project, std::span<const Id> assets) {
    for (const Id id : assets) {
        if (findAsset(project, id) != nullptr) continue;
        return Error{ErrorCode::NotFound, "The project has no asset with the id " + std::to_string(id) + "."};
    }
    return success();
}

/// The memory that each export takes, bytes.
///
/// Errors: Limit if one takes more than there is.
Result<std::vector<double>> memoryOf(std::span<const PackedAsset> packed, const PackOptions& options) {
    std::vector<double> bytes;
    for (const PackedAsset& each : packed) {
        const Asset& asset = each.asset;
        BakeEstimate estimate = estimateOf(asset);
        estimate.meshBytes = meshBytesPerFragment(options.meshes);
        if (const std::optional<std::string> fault =
                sizeFault(estimate) ? std::nullopt : stageFault(estimate, MemoryStage::Export))
            return Error{ErrorCode::Limit, "Asset " + quotedName(asset.name) + ": " + *fault};
        bytes.push_back(estimate.bytes(MemoryStage::Export) + bakingBytes(options.meshes));
    }
    return bytes;
}

void addSourceText(Hasher& hasher, std::string_view text) {
    hasher.add(std::uint64_t{text.size()});
    hasher.add(text);
}

void addValue(Hasher& hasher, const ExportOption& option, const PackOptions& options) {
    addSourceText(hasher, option.values[option.get(options)].word);
}

/// Removes all that the pack of an asset that breaks whole does not contain: of bonds.
void removeBonds(Asset& asset) {
    asset.bonding = {};
    for (Level& level : asset.levels) level.bondStrength = 1.0;
    for (FragmentLevel& leaf : asset.fragmentLevels) {
        if (leaf.level) leaf.level->bondStrength = 1.0;
    }
}

}  // namespace

std::map<AssetVariant, PackNames> packNames(const Project& project, const PackOptions& options) {
    // Assets come before variants: a variant "wall_1" of a wall leaves the name to an asset of that name.
    std::vector<AssetVariant> used = usedVariants(project);
    std::ranges::stable_sort(used, {}, [](const AssetVariant& one) { return one.variant != 0; });
    std::vector<std::string> words{kIndexName, kSceneName, kReadmeName};  // not those of packs
    for (const ExportTarget& target : exportTargets()) {
        if (!target.script.empty()) words.emplace_back(target.script);
    }
    const std::size_t first = words.size();
    for (const auto& [id, variant] : used)
        words.push_back(meshName(nameOfVariant(findAsset(project, id)->name, variant)));
    const std::vector<std::string> folders =
        distinctFileNames(words, options.hasShortNames ? kShortestName : kLongestName);
    std::map<AssetVariant, PackNames> names;
    for (std::size_t k = 0; k < used.size(); ++k) {
        const std::string& base = findAsset(project, used[k].asset)->name;
        names[used[k]] = {nameOfVariant(base, used[k].variant), base, used[k].variant, folders[first + k]};
    }
    return names;
}

PackSettings packSettings(const Project& project, const PackOptions& options) {
    PackSettings settings{.inset = options.inset, .rule = project.damage.rule};
    if (project.debris.lifetime || project.debris.maxFragments) settings.debris = project.debris;
    return settings;
}

ContentHash packSourceHash(const Project& project, const Asset& asset, const PackNames& names,
                           const PackOptions& options) {
    // Hashes a project with this asset only, without what packs do not contain.
    Project single;
    single.nextId = std::numeric_limits<Id>::max();
    const AssetMaterials material = materialsOf(project, asset);
    single.materials = {material.own};
    if (asset.insideMaterial != 0) single.materials.push_back(material.inside);
    single.assets = {asset};
    single.damage.rule = project.damage.rule;
    single.debris = project.debris;
    if (asset.breakAs == BreakAs::Whole) removeBonds(single.assets[0]);
    if (asset.breakAs == BreakAs::Bonded) single.assets[0].bonding.impulsePerArea = bondImpulseOf(asset, material.own);
    single.assets[0].requirements.clear();
    single.assets[0].threshold = thresholdOf(asset, material.own);
    single.assets[0].contactTime.reset();
    Hasher hasher;
    hasher.add(kExportRevision);
    hasher.add(std::uint64_t{kPackVersion});
    hasher.add(bakeInputHash(asset).high);  // for the version of bake()
    hasher.add(bakeInputHash(asset).low);
    addSourceText(hasher, programVersion());
    for (const ExportFormat* format : formatsOf(options.meshes.formats)) {
        addSourceText(hasher, format->word);
        for (const ExportOption* option : format->options) addValue(hasher, *option, options);
    }
    if (bakingBytes(options.meshes) > 0.0) {
        const Quat placed = placedOrientation(project, asset.id);
        for (const double part : {placed.w, placed.x, placed.y, placed.z}) hasher.add(part);
    }
    for (const ExportOption* option : {&kPackFilesOption, &kTopologyOption}) addValue(hasher, *option, options);
    hasher.add(options.inset);
    for (const std::string& name : {names.name, names.base, names.folder}) addSourceText(hasher, name);
    hasher.add(projectText(single));
    return hasher.digest();
}

std::vector<PackListing> packListings(const Project& project, std::span<const Id> assets, const PackOptions& options) {
    std::vector<PackListing> listings;
    for (const PackedAsset& packed : packedAssets(project, assets, options)) {
        PackFileNames files;
        if (hasJson(options)) files.names.push_back(kPackName);
        if (hasBinary(options)) files.names.push_back(kPackBinaryName);
        PackFileNames meshes =
            meshFileNames(packed.asset, materialsOf(project, packed.asset), packed.names, options.meshes);
        files.names.insert(files.names.end(), meshes.names.begin(), meshes.names.end());
        files.names.push_back(kManifestName);
        files.areAll = meshes.areAll;
        listings.push_back({packed.names.folder, std::move(files)});
    }
    return listings;
}

Result<std::vector<AssetExport>> exportPacks(const Project& project, std::span<const Id> assets,
                                             const std::filesystem::path& folder, const PackOptions& options,
                                             EditedFiles edited, const TaskContext& task, FolderLocking locking) {
    if (const Status known = checkAssets(project, assets); !known) return known.error();
    CreatedDirectories created;  // not per asset: a failing one would remove the folder of the others
    if (const Status status = created.create(folder); !status) return status.error();
    removeLeftovers(folder);
    const std::vector<PackedAsset> packed = packedAssets(project, assets, options);
    std::vector<AssetExport> results(packed.size());
    SharedProgress progress(task, packed.size());
    Result<std::vector<double>> bytes = memoryOf(packed, options);
    if (!bytes) return bytes.error();
    const int atOnce = bakesAtOnce(std::move(*bytes), task.threads);
    const int threadsEach = std::max(1, task.threads / static_cast<int>(std::max<std::size_t>(1, packed.size())));
    forEachIndex(packed.size(), atOnce, [&](std::size_t index) {
        results[index] = exportAsset(project, packed[index], folder, options, {edited, locking},
                                     progress.contextOf(index, threadsEach));
    });
    if (task.isCancelled()) return TaskContext::cancelled();
    return results;
}

Result<std::vector<AssetExport>> planPacks(const Project& project, std::span<const Id> assets,
                                           const std::filesystem::path& folder, const PackOptions& options,
                                           EditedFiles edited, const TaskContext& task) {
    if (const Status known = checkAssets(project, assets); !known) return known.error();
    const std::vector<PackedAsset> packed = packedAssets(project, assets, options);
    if (const Result<std::vector<double>> bytes = memoryOf(packed, options); !bytes) return bytes.error();
    std::vector<AssetExport> results;
    for (const PackedAsset& each : packed) {
        if (task.isCancelled()) return TaskContext::cancelled();
        AssetExport result = lookedUp(each, folder, packSourceHash(project, each.asset, each.names, options));
        if (!result.isUnchanged) result.status = checkExportFolder(result.folder, edited);
        results.push_back(std::move(result));
        task.report(static_cast<double>(results.size()) / static_cast<double>(packed.size()));
    }
    return results;
}

}  // namespace rubble
