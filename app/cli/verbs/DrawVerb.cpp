#include "app/cli/console/InputOutput.h"
#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/Warnings.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/bake/Bake.h"
#include "core/asset/bake/FractureResult.h"
#include "core/asset/project/AssetShape.h"
#include "core/asset/project/Ranges.h"
#include "core/base/QuantityText.h"
#include "core/fracture/delaunay/Delaunay.h"
#include "core/fracture/planes/SectionPieces.h"
#include "core/io/media/PatternSvg.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <ostream>

namespace rubble {
namespace {

constexpr const char* kDrawFooter =
    R"(Draws the assets of a project, or those given by --asset, as one SVG picture: outline, seeds, their Delaunay
triangulation and the Voronoi cells of the first level. Browsers, Inkscape and rsvg-convert open it. Of a closed
mesh it draws a section, across the axis given by --section, with the cells that it cuts and their seeds.

Examples:
  rubble-cli draw house.rubble --out house.svg
  rubble-cli draw house.rubble --asset roof --show cells > roof.svg
  rubble-cli draw sculptures.rubble --asset vase --section y --height 0.1 --out vase.svg)";

struct DrawOptions {
    std::string file;
    std::vector<std::string> assets;
    std::string out = "-";
    std::vector<std::string> shown = {"cells", "triangles", "seeds"};
    std::string axis = "z";        // that sections of meshes are across
    std::optional<double> height;  // m, of them along it; otherwise in the middle
};

PatternSvgOptions svgOptions(const std::vector<std::string>& words) {
    const auto has = [&](const char* word) { return std::ranges::find(words, word) != words.end(); };
    return {.cells = has("cells"), .triangles = has("triangles"), .seeds = has("seeds")};
}

/// Fractures a prism in the plane and adds its warnings.
Result<PatternPanel> planOf(const Asset& asset, std::vector<AssetWarnings>& all, const TaskContext& task) {
    Result<PlanarFracture> cut = planarFracture(recipeOf(asset), asset.prism(), task);
    if (!cut) return ofAsset(asset, cut.error());
    std::vector<Diagnostic> warnings = cut->seeds.diagnostics;
    warnings.insert(warnings.end(), cut->partition.diagnostics.begin(), cut->partition.diagnostics.end());
    all.push_back({asset.name, std::move(warnings)});
    return PatternPanel{.title = asset.name,
                        .outlines = {std::move(cut->prism.outline)},
                        .depth = cut->prism.depth,
                        .seeds = std::move(cut->seeds.positions),
                        .triangles = triangleList(cut->delaunay),
                        .partition = std::move(cut->partition)};
}

/// Fractures a mesh, without the levels below, cuts it, and adds its warnings.
Result<PatternPanel> sectionPanelOf(Asset asset, const DrawOptions& options, std::vector<AssetWarnings>& all,
                                    const TaskContext& task) {
    const int axis = options.axis[0] - 'x';
    const Box3 box = boundsOf(asset);
    const double height = options.height.value_or((box.min[axis] + box.max[axis]) / 2.0);
    const auto metres = [](double value) { return roundedText(value, 4) + " m"; };
    if (!(height > box.min[axis] && height < box.max[axis])) {
        return ofAsset(asset,
                       {ErrorCode::BadInput, "The section at " + options.axis + " = " + metres(height) +
                                                 " does not cut the mesh, which is between " + metres(box.min[axis]) +
                                                 " and " + metres(box.max[axis]) + "; change --height."});
    }
    asset.levels.clear();
    Result<Bake> baked = bake(asset, task);
    if (!baked) return baked.error();
    const BakedFracture& fracture = baked->fractures[0];
    const SolidPartition& solid = fracture.fragments.solid()->partition;
    SolidSection section = sectionOf(solid, sectionPlane(axis, height));
    SectionPieces pieces = sectionPieces(section, solid, !fracture.seeds.ids.empty());
    PatternPanel panel{.title = asset.name,
                       .outlines = std::move(section.outline),
                       .section = options.axis + " = " + metres(height),
                       .partition = std::move(pieces.partition)};
    for (const std::uint32_t seed : pieces.seeds) panel.seeds.push_back(section.plane.inPlane(fracture.seeds.at(seed)));
    all.push_back({asset.name, std::move(baked->diagnostics)});
    return panel;
}

Result<std::vector<PatternPanel>> panelsOf(const Project& project, std::span<const Id> assets,
                                           const DrawOptions& options, const CliContext& context) {
    const TaskContext task{.cancel = context.cancel};
    std::vector<PatternPanel> panels;
    std::vector<AssetWarnings> warnings;
    for (const Id id : assets) {
        const Asset& asset = *findAsset(project, id);
        Result<PatternPanel> panel =
            asset.isPrism() ? planOf(asset, warnings, task) : sectionPanelOf(asset, options, warnings, task);
        if (!panel) return panel.error();
        panels.push_back(std::move(*panel));
    }
    printWarnings(context, warnings, options.file);
    return panels;
}

Status draw(const DrawOptions& options, const CliContext& context) {
    const Result<ProjectAssets> loaded = loadProjectAssets(options.file, options.assets, context);
    if (!loaded) return loaded.error();
    const Result<std::vector<PatternPanel>> panels = panelsOf(loaded->project, loaded->assets, options, context);
    if (!panels) return panels.error();
    return writeOutput(options.out, patternSvg(*panels, svgOptions(options.shown)), context);
}

}  // namespace

Verb addDraw(CLI::App& program) {
    Command command(program, "draw", "Draw seeds, Delaunay triangulation and cells as an SVG picture", kDrawFooter);
    const auto options = std::make_shared<DrawOptions>();
    addProjectArgument(command, options->file);
    addAssetOption(command, options->assets);
    command.option("-o,--out", options->out, "The picture to write (default: -, standard output)")
        .writes({".svg"})
        .valueName("FILE");
    command.option("--show", options->shown, "What to draw: cells, triangles, seeds (default: all)")
        .separatedBy(',')
        .oneOf({"cells", "triangles", "seeds"})
        .valueName("WHAT,...");
    command.option("--section", options->axis, "The axis across which meshes are cut: x, y or z (default: z)")
        .oneOf({"x", "y", "z"})
        .valueName("AXIS");
    command.option("--height", options->height, "Where, in metres in the frame of the asset (default: its middle)")
        .inRange(ProjectNumber::OutlineCoordinate)
        .valueName("M");
    return {command, [options](VerbReport&, const CliContext& context) { return draw(*options, context); }};
}

}  // namespace rubble
