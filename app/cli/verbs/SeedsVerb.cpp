#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/import/VertexSeeds.h"
#include "core/asset/project/Ids.h"
#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/fracture/pattern/PatternKind.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/media/GreyImageFile.h"
#include "core/io/mesh/MeshImport.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>

namespace rubble {
namespace {

constexpr const char* kSeedsFooter =
    R"(Adds a layer of placed seeds to an asset, one at each vertex of the mesh. The mesh is read as by rubble-cli
import and projected along one of its axes, with its origin at the prism's; --fit scales and moves it to fill
the outline instead. Vertices outside the outline and duplicates are ignored, and their number is printed.

With --density, adds a layer of seeds that follow a PNG picture, stretched over the bounding box of the outline:
most are where it is dark, and none where it is transparent. --layer gives the picture to a density image that the
asset already has; with an unknown number, the error lists the layers. Pictures above 1024 pixels a side are
reduced, and those above 8192 rejected.

Examples:
  rubble-cli seeds cracks.obj --into house.rubble --asset Wall
  rubble-cli seeds scan.ply --into house.rubble --asset Wall --along y --fit
  rubble-cli seeds --density cracks.png --count 300 --into house.rubble --asset Wall)";

struct SeedsOptions {
    std::filesystem::path mesh;
    std::filesystem::path picture;
    std::optional<Id> layer;
    std::optional<std::uint32_t> count;
    std::string dense;
    std::filesystem::path project;
    std::string asset;
    std::string along = "z";
    VertexView view;
};

/// What was changed in an asset.
struct ChangedAsset {
    Id layer = 0;                      // with the seeds
    std::optional<std::size_t> seeds;  // that were placed
    std::string sentence;
    std::string note;  // what was left out or reduced; empty: nothing
};

/// Changes an asset of a project.
using AssetChange = std::function<Result<ChangedAsset>(Project& project, Asset& asset)>;

void reportChange(const SeedsOptions& options, const ChangedAsset& changed, VerbReport& report) {
    const std::string project = options.project.string();
    report.writeResults = [=, asset = options.asset](JsonWriter& json) {
        json.text("project", printableText(project));
        json.text("asset", printableText(asset));
        json.wholeNumber("layer", std::uint64_t{changed.layer});
        if (changed.seeds) json.wholeNumber("seeds", std::uint64_t{*changed.seeds});
    };
    if (changed.note.empty()) return;
    const FindingPlace place{.file = project, .asset = options.asset, .details = {.layer = changed.layer}};
    report.findings.push_back(
        {Severity::Note, options.picture.empty() ? "OmittedVertices" : "ReducedPicture", place, changed.note});
}

/// Applies a change to the asset, saves the project and prints what was changed.
Status addSeedsBy(const SeedsOptions& options, const AssetChange& change, VerbReport& report,
                  const CliContext& context) {
    ChangedAsset changed;
    const Status saved =
        changeAsset(options.project, options.asset, context, [&](Project& project, Asset& asset) -> Status {
            Result<ChangedAsset> made = change(project, asset);
            if (!made) return made.error();
            changed = std::move(*made);
            return success();
        });
    if (!saved) return saved;
    reportChange(options, changed, report);
    const std::string note = changed.note.empty() ? "" : " " + changed.note;
    return printSummary(changed.sentence + note + "\nSaved " + options.project.string() + "\n", report, context);
}

/// Returns the id of the new layer.
Id addLayer(LayerParameters parameters, Project& project, Asset& asset) {
    const Id id = allocateId(project);
    asset.pattern.layers.push_back({.id = id, .randomSeed = id, .parameters = std::move(parameters)});
    return id;
}

Status addVertexSeeds(const SeedsOptions& options, VerbReport& report, const CliContext& context) {
    const TaskContext task{.cancel = context.cancel};
    const Result<SourceScene> mesh = importMesh(options.mesh, importerPath(context.programFolder), task);
    if (!mesh) return mesh.error();
    VertexView view = options.view;
    if (options.along != "z") view.along = options.along == "x" ? FileAxis::X : FileAxis::Y;
    const AssetChange change = [&](Project& project, Asset& asset) -> Result<ChangedAsset> {
        if (!asset.isPrism())
            return Error{ErrorCode::Unsupported, "Seeds at the points of a mesh need the outline of a prism."};
        Result<VertexSeeds> found = seedsAtVertices(*mesh, view, asset.prism().outline);
        if (!found) return found.error();
        const std::size_t count = found->seeds.seeds.size();
        const std::string omissions = found->omissionText();
        const Id layer = addLayer(std::move(found->seeds), project, asset);
        return ChangedAsset{layer, count,
                            quotedName(asset.name) + " has a new layer of " + countText(count, "seed", "seeds") + ".",
                            omissions};
    };
    return addSeedsBy(options, change, report, context);
}

/// The patterns of an asset, of its levels and of single fragments, which may share layers.
std::vector<Pattern*> patternsOf(Asset& asset) {
    std::vector<Pattern*> patterns{&asset.pattern};
    for (Level& level : asset.levels) patterns.push_back(&level.pattern);
    for (FragmentLevel& leaf : asset.fragmentLevels) {
        if (leaf.level) patterns.push_back(&leaf.level->pattern);
    }
    return patterns;
}

/// "3 (uniform), 5 (densityImage)"
std::string layersText(Asset& asset) {
    std::map<Id, std::string_view> kinds;
    for (const Pattern* pattern : patternsOf(asset)) {
        for (const PatternLayer& layer : pattern->layers) kinds.emplace(layer.id, kindOf(layer.parameters).name);
    }
    std::vector<std::string> layers;
    for (const auto& [id, kind] : kinds) layers.push_back(std::to_string(id) + " (" + std::string(kind) + ")");
    return layers.empty() ? "none" : joinedText(layers);
}

/// The density images of an asset with an id.
///
/// Errors: NotFound if no layer has the id; BadInput if it is of another kind.
Result<std::vector<DensityImage*>> densityImages(Asset& asset, Id id) {
    std::vector<DensityImage*> images;
    for (Pattern* pattern : patternsOf(asset)) {
        for (PatternLayer& layer : pattern->layers) {
            if (layer.id != id) continue;
            auto* image = std::get_if<DensityImage>(&layer.parameters);
            if (!image) {
                return Error{ErrorCode::BadInput, "Layer " + std::to_string(id) + " of " + quotedName(asset.name) +
                                                      " is not a density image; the asset has " + layersText(asset) +
                                                      "."};
            }
            images.push_back(image);
        }
    }
    if (!images.empty()) return images;
    return Error{ErrorCode::NotFound, quotedName(asset.name) + " has no layer " + std::to_string(id) + "; it has " +
                                          layersText(asset) + "."};
}

void apply(const SeedsOptions& options, const DensityPicture& picture, DensityImage& layer) {
    layer.image = picture.image;
    if (options.count) layer.count = *options.count;
    if (!options.dense.empty()) layer.dense = options.dense == "bright" ? DenseWhere::Bright : DenseWhere::Dark;
}

Status applyPicture(const SeedsOptions& options, VerbReport& report, const CliContext& context) {
    const Result<DensityPicture> picture = loadDensityPicture(options.picture);
    if (!picture) return picture.error();
    const AssetChange change = [&](Project& project, Asset& asset) -> Result<ChangedAsset> {
        DensityImage added;
        std::vector<DensityImage*> images{&added};
        if (options.layer) {
            Result<std::vector<DensityImage*>> found = densityImages(asset, *options.layer);
            if (!found) return found.error();
            images = std::move(*found);
        }
        for (DensityImage* image : images) apply(options, *picture, *image);
        const Id id = options.layer ? *options.layer : addLayer(added, project, asset);
        const std::string layer = (options.layer ? "Layer " : "The new layer ") + std::to_string(id);
        return ChangedAsset{.layer = id,
                            .sentence = layer + " of " + quotedName(asset.name) + " follows " +
                                        quotedName(options.picture.filename().string()) + ".",
                            .note = picture->note};
    };
    return addSeedsBy(options, change, report, context);
}

Status addSeeds(const SeedsOptions& options, VerbReport& report, const CliContext& context) {
    return options.picture.empty() ? addVertexSeeds(options, report, context) : applyPicture(options, report, context);
}

/// Adds --density and the options of its layer.
void addDensityOptions(Command& command, SeedsOptions& options) {
    const CommandOption picture = command.option("--density", options.picture, "Add seeds that follow this PNG picture")
                                      .reads()
                                      .valueName("PICTURE");
    command.option("--layer", options.layer, "Give the picture to this density image instead of a new layer")
        .wholeUpTo(std::numeric_limits<Id>::max())
        .valueName("N");
    command.option("--count", options.count, "The number of seeds that follow the picture (default: 200)")
        .wholeUpTo(kMaxSeeds)
        .valueName("N");
    command.option("--dense", options.dense, "Where seeds are densest (default: dark)")
        .oneOf({"bright", "dark"})
        .valueName("bright|dark");
    command.requireOne(command["FILE"], picture);
    for (const char* name : {"FILE", "--unit", "--along", "--fit"}) picture.excludes(command[name]);
    for (const char* name : {"--layer", "--count", "--dense"}) command[name].needs(picture);
    for (const char* name : {"FILE", "--fit"}) command[name].valueName(" ");  // hides CLI11's note on --density
}

}  // namespace

Verb addSeeds(CLI::App& program) {
    Command command(program, "seeds", "Place seeds at the vertices of a mesh, or by the greys of a picture",
                    kSeedsFooter);
    const auto options = std::make_shared<SeedsOptions>();
    command.argument("FILE", options->mesh, "The mesh file").reads();
    command.option("-i,--into", options->project, "The project of the asset").required().changes().valueName("PROJECT");
    command.option("-a,--asset", options->asset, "The asset").required().valueName("NAME");
    addUnitOption(command, options->view.metresPerUnit);
    command.option("--along", options->along, "The axis of the file to project along (default: z)")
        .oneOf({"x", "y", "z"})
        .valueName("x|y|z");
    command.flag("--fit", options->view.isFitted, "Scale and move the mesh to fill the outline");
    addDensityOptions(command, *options);
    command.addReportFlag();
    return {command,
            [options](VerbReport& report, const CliContext& context) { return addSeeds(*options, report, context); }};
}

}  // namespace rubble
