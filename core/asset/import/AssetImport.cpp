#include "core/asset/import/AssetImport.h"

#include "core/asset/import/EqualSolids.h"
#include "core/asset/import/ImportedSolid.h"
#include "core/asset/project/Ids.h"
#include "core/asset/project/Names.h"
#include "core/asset/project/Ranges.h"
#include "core/asset/project/SurfaceFault.h"
#include "core/asset/strength/Threshold.h"
#include "core/base/MessageText.h"
#include "core/base/Utf8.h"
#include "core/geometry/mesh/SolidMesh.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace rubble {
namespace {

/// An error with the object's name: `"Ball": The mesh ...`.
Error namedError(const std::string& name, Error error) {
    error.message = quotedName(name) + ": " + error.message;
    return error;
}

/// A part to import with its asset's name, or the error of its object.
using RequestedPart = Result<ImportPart>;

Result<std::vector<RequestedPart>> requestedParts(const SourceScene& scene, const std::string& fileName,
                                                  double metresPerUnit, const ImportOptions& options) {
    std::vector<RequestedPart> all;
    const bool hasSeveral = scene.objects.size() > 1;
    const bool isNamed = std::ranges::find(scene.objects, options.asset, &SourceObject::name) != scene.objects.end();
    if (!options.asset.empty() && hasSeveral && !isNamed) {
        std::vector<std::string> names;
        for (const SourceObject& object : scene.objects) names.push_back(object.name);
        return Error{ErrorCode::NotFound, "The file has several objects and none named " + quotedName(options.asset) +
                                              "; it has " + quotedNames(names) + "."};
    }
    for (const SourceObject& object : scene.objects) {
        if (!options.asset.empty() && hasSeveral && object.name != options.asset) continue;
        const std::string name = object.name.empty() ? wellFormed(fileName) : object.name;
        Result<std::vector<ImportPart>> parts = partsToImport(object, metresPerUnit, options.up, options.as);
        if (!parts) {
            all.push_back(namedError(name, parts.error()));
            continue;
        }
        for (ImportPart& part : *parts) {
            part.name = options.asset.empty() ? name : options.asset;
            all.push_back(std::move(part));
        }
    }
    if (!options.asset.empty() && all.size() > 1)
        return Error{ErrorCode::Degenerate, quotedName(options.asset) + " would have " + std::to_string(all.size()) +
                                                " parts; an asset has one."};
    return all;
}

/// The project's material for one of the file's; added if it is missing.
Id materialFor(const SourceMaterial& source, Project& project, std::vector<std::string>& notes) {
    if (source.name.empty() && !project.materials.empty()) return project.materials.front().id;
    const auto same = std::ranges::find(project.materials, source.name, &Material::name);
    if (same != project.materials.end()) return same->id;
    const Colour colour{source.colour.x, source.colour.y, source.colour.z};
    Material material{.id = allocateId(project), .name = source.name.empty() ? "default" : source.name};
    material.outside = material.inside = colour;
    notes.push_back("The material " + quotedName(material.name) + " is added, with a density of " +
                    messageText(material.density) + " kg/m³.");
    project.materials.push_back(material);
    return material.id;
}

/// The pattern of a new asset.
Pattern defaultPattern(Project& project) {
    const Id id = allocateId(project);
    return {{{.id = id, .randomSeed = id, .parameters = UniformScatter{}}}};
}

/// A pose after a motion.
Pose moved(const Pose& pose, const Pose& motion) {
    return {motion.orientation * pose.position + motion.position,
            glm::normalize(motion.orientation * pose.orientation)};
}

/// What is imported, and how.
struct ImportSource {
    const SourceScene& scene;
    const ImportOptions& options;
    std::set<std::string> names;  // of all objects, folded: duplicates get numbers that make none of them
};

void placeInstance(Project& project, const Asset& asset, const Pose& pose, const ImportSource& source) {
    const ImportOptions& options = source.options;
    const std::string name = uniqueName(project.instances, asset.name, source.names);
    project.instances.push_back({.id = allocateId(project),
                                 .name = name,
                                 .asset = asset.id,
                                 .pose = pose,
                                 .isFixed = options.isFixed,
                                 .isUnbreakable = options.isUnbreakable});
}

/// Places an asset where the solid of a part and its copies stand.
void placeInstances(Project& project, const Asset& asset, const ImportPart& part, const ImportedSolid& solid,
                    const ImportSource& source) {
    placeInstance(project, asset, solid.pose(), source);
    for (const Pose& copy : part.copies) placeInstance(project, asset, moved(solid.pose(), copy), source);
}

/// The asset of this import that is equal to a solid but for its pose; null if there is none.
ImportedAsset* equalAsset(const ImportedSolid& solid, const SourceScene& scene, ImportOutcome& outcome) {
    const std::string& material = scene.materials[solid.material].name;
    for (ImportedAsset& imported : outcome.assets) {
        const Asset& asset = *findAsset(outcome.project, imported.asset);
        const Material& own = *std::ranges::find(outcome.project.materials, asset.material, &Material::id);
        const bool isSameMaterial = material.empty() || own.name == material;
        if (imported.usesFallback == solid.usesFallback && isSameMaterial && isEqual(asset, solid, solid.tolerance))
            return &imported;
    }
    return nullptr;
}

/// Adds a solid to the project as a new asset, or replaces the shape of an existing one.
ImportedAsset added(const ImportPart& part, const ImportedSolid& solid, const ImportSource& source, Project& project) {
    const ImportOptions& options = source.options;
    ImportedAsset result{.usesFallback = solid.usesFallback, .prism = solid.prism, .solid = solid.closed};
    if (solid.prism) result.tolerance = solid.tolerance;
    result.notes = solid.notes;
    const auto old =
        options.asset.empty() ? project.assets.end() : std::ranges::find(project.assets, options.asset, &Asset::name);
    if (old != project.assets.end()) {
        result.asset = old->id;
        result.isReplaced = true;
        old->shape = solid.shape();
        old->surface = solid.surface.surface;
        old->texture = solid.texture;
        return result;
    }
    Asset asset{.name = uniqueName(project.assets, part.name, source.names),
                .shape = solid.shape(),
                .surface = solid.surface.surface,
                .texture = solid.texture};
    if (asset.name != part.name)
        result.notes.push_back("The name " + quotedName(part.name) + " is taken; the asset is named " +
                               quotedName(asset.name) + ".");
    asset.material = materialFor(source.scene.materials[solid.material], project, result.notes);
    // Reused ids are sorted at the end.
    deriveThresholdIfKnown(asset, *std::ranges::find(project.materials, asset.material, &Material::id));
    asset.id = result.asset = allocateId(project);
    project.assets.push_back(std::move(asset));
    project.assets.back().pattern = defaultPattern(project);
    placeInstances(project, project.assets.back(), part, solid, source);
    if (!part.copies.empty())
        result.notes.push_back("It stands in " + std::to_string(part.copies.size() + 1) +
                               " places; each is an instance.");
    return result;
}

/// A size of a solid, m: "width of the outline".
struct SolidSize {
    ProjectNumber number;
    double value = 0.0;
    std::string name;
};

/// A solid in a wrong unit is often too large or too small for a project.
std::optional<std::string> sizeFault(const std::string& name, const ImportedSolid& solid) {
    std::vector<SolidSize> sizes;
    if (solid.closed) {
        const Vec3 size = solid.closed->mesh->bounds.max - solid.closed->mesh->bounds.min;
        for (const auto& [value, axis] : {std::pair(size.x, "x"), std::pair(size.y, "y"), std::pair(size.z, "z")})
            sizes.push_back({ProjectNumber::OutlineSize, value, std::string("size of the mesh along ") + axis});
    } else {
        const Vec2 size = boundsOf(solid.prism->outline.outer).max - boundsOf(solid.prism->outline.outer).min;
        sizes = {{ProjectNumber::OutlineSize, size.x, "width of the outline"},
                 {ProjectNumber::OutlineSize, size.y, "height of the outline"},
                 {ProjectNumber::PrismDepth, solid.prism->depth, "depth"}};
    }
    for (const SolidSize& size : sizes) {
        if (rangeOf(size.number).contains(size.value)) continue;
        return quotedName(name) + ": The " + size.name + " is " + messageText(size.value) + " m, but it must be " +
               rangeText(rangeOf(size.number)) + " m. Choose another unit at import.";
    }
    return std::nullopt;
}

std::optional<std::string> prismFault(const std::string& name, const PrismFit& prism) {
    const std::string owner = quotedName(name);
    if (auto fault = prismRangeFault(owner, {prism.outline, prism.depth})) return fault;
    return rangeFault(owner, ProjectNumber::InstancePosition, prism.pose.position);
}

/// The fallback, if it imports a part.
std::optional<WorkingFallback> tried(PrismFallback fallback, PrismAxis axis, const ImportPart& part) {
    const Result<PrismFit> prism = fallbackPrism(part.mesh, axis, fallback, part.tolerance);
    if (!prism || prismFault(part.name, *prism)) return std::nullopt;
    return WorkingFallback{fallback, axis, volumeOf(*prism)};
}

/// The fallbacks that import a part, each along the requested axis or else the first world axis that works.
std::vector<WorkingFallback> workingFallbacks(const ImportPart& part, PrismAxis requested, const TaskContext& context) {
    std::vector<WorkingFallback> working;
    if (isFlat(part)) return working;
    for (const PrismFallback fallback : {PrismFallback::Silhouette, PrismFallback::TopCap}) {
        for (const PrismAxis axis : {requested, PrismAxis::X, PrismAxis::Y, PrismAxis::Z}) {
            if (context.isCancelled()) return working;
            const std::optional<WorkingFallback> found = tried(fallback, axis, part);
            if (!found) continue;
            working.push_back(*found);
            break;
        }
    }
    return working;
}

/// The same for a closed mesh.
std::optional<std::string> closedFault(const std::string& name, const ImportedSolid& solid) {
    if (auto fault = shapeRangeFault(quotedName(name), {.shape = solid.shape()})) return fault;
    return rangeFault(quotedName(name), ProjectNumber::InstancePosition, solid.closed->position);
}

/// The faults of the shape, and those of copies and of texture coordinates, which may be anything.
std::optional<std::string> solidFault(const ImportPart& part, const ImportedSolid& solid) {
    const std::string& name = part.name;
    if (auto fault = sizeFault(name, solid)) return fault;
    if (auto fault = solid.closed ? closedFault(name, solid) : prismFault(name, *solid.prism)) return fault;
    for (const Pose& copy : part.copies) {
        const Vec3 position = moved(solid.pose(), copy).position;
        if (auto fault = rangeFault(quotedName(name), ProjectNumber::InstancePosition, position)) return fault;
    }
    const Surface* surface = solid.surface.surface.get();
    if (surface != nullptr)
        if (auto fault = surfaceFault(quotedName(name), *surface)) return fault;
    return solid.texture ? textureFault(quotedName(name), *solid.texture, surface) : std::nullopt;
}

/// A part that is not imported, with the fallbacks that would import it if these are wanted.
RejectedObject rejectedPart(const ImportPart& part, PartOutcome outcome, const ImportOptions& options,
                            const TaskContext& context) {
    RejectedObject rejected{namedError(part.name, outcome.solid.error()), {}, {}, std::move(outcome.problem)};
    const bool hasPrism = options.as != ImportShape::Solid && !part.noPrism;
    if (!options.findsFallbacks || !hasPrism) return rejected;
    rejected.fallbacks = workingFallbacks(part, options.axis, context);
    if (const Result<SolidMesh> closed = orientedSolid(part.mesh, part.tolerance)) rejected.volume = closed->volume;
    return rejected;
}

void import(const RequestedPart& part, const ImportSource& source, const TaskContext& context, TextureImages& images,
            ImportOutcome& outcome) {
    const auto& [scene, options, names] = source;
    if (!part) {
        outcome.rejected.push_back({part.error(), {}, {}, {}});
        return;
    }
    PartOutcome made = importedSolid(*part, scene, options, images, context);
    const Result<ImportedSolid>& solid = made.solid;
    if (!solid) {
        outcome.rejected.push_back(rejectedPart(*part, std::move(made), options, context));
    } else if (const auto fault = solidFault(*part, *solid)) {
        outcome.rejected.push_back({{ErrorCode::BadInput, *fault}, {}, {}, {}});
    } else if (ImportedAsset* equal = options.mergesEqual ? equalAsset(*solid, scene, outcome) : nullptr) {
        ++equal->merged;
        placeInstances(outcome.project, *findAsset(outcome.project, equal->asset), *part, *solid, source);
    } else {
        outcome.assets.push_back(added(*part, *solid, source, outcome.project));
    }
}

/// Ids that are used again may be lower than those before them.
void sortById(Project& project) {
    std::ranges::sort(project.materials, {}, &Material::id);
    std::ranges::sort(project.assets, {}, &Asset::id);
    std::ranges::sort(project.instances, {}, &Instance::id);
}

}  // namespace

bool RejectedObject::isReshapedBy(const WorkingFallback& working) const {
    constexpr double kMaxChange = 0.01;
    return volume && std::abs(working.volume - *volume) > kMaxChange * *volume;
}

Result<ImportOutcome> importedInto(Project project, const SourceScene& scene, const std::string& fileName,
                                   const ImportOptions& options, const TaskContext& context) {
    const double inFile = scene.metresPerUnit > 0.0 ? scene.metresPerUnit : 1.0;
    const double metresPerUnit = options.metresPerUnit.value_or(inFile);
    if (!rangeOf(ProjectNumber::MetresPerUnit).contains(metresPerUnit))
        return Error{ErrorCode::BadInput, "The unit is " + messageText(metresPerUnit) + " m; it must be " +
                                              rangeText(rangeOf(ProjectNumber::MetresPerUnit)) + "."};
    const Result<std::vector<RequestedPart>> requested = requestedParts(scene, fileName, metresPerUnit, options);
    if (!requested) return requested.error();
    ImportOutcome outcome{.project = std::move(project), .metresPerUnit = metresPerUnit};
    ImportSource source{scene, options, {}};
    for (const RequestedPart& part : *requested)
        if (part) source.names.insert(caseFolded(part->name));
    TextureImages images;
    const auto fractionBefore = [&](std::size_t k) {
        return static_cast<double>(k) / static_cast<double>(requested->size());
    };
    for (std::size_t k = 0; k < requested->size(); ++k) {
        if (context.isCancelled()) return TaskContext::cancelled();
        const TaskContext stage = context.stage(fractionBefore(k), fractionBefore(k + 1));
        import((*requested)[k], source, stage, images, outcome);
        stage.report(1.0);
    }
    if (context.isCancelled()) return TaskContext::cancelled();
    for (ImportedAsset& imported : outcome.assets) {
        if (imported.merged == 0) continue;
        const bool isOne = imported.merged == 1;
        imported.notes.push_back(std::to_string(imported.merged) +
                                 (isOne ? " equal mesh is an instance of it." : " equal meshes are instances of it."));
    }
    if (!outcome.assets.empty()) {
        std::vector<std::string>& notes = outcome.assets.front().notes;
        notes.insert(notes.begin(), scene.notes.begin(), scene.notes.end());
    }
    sortById(outcome.project);
    return outcome;
}

}  // namespace rubble
