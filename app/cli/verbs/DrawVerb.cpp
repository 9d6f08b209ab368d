#include "app/cli/console/InputOutput.h"
#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/Warnings.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/bake/FractureResult.h"
#include "core/fracture/delaunay/Delaunay.h"
#include "core/io/media/PatternSvg.h"

#include <algorithm>
#include <memory>
#include <ostream>

namespace rubble {
namespace {

constexpr const char* kDrawFooter =
    R"(Draws the assets of a project, or those given by --asset, as one SVG picture: outline, seeds, their Delaunay
triangulation and the Voronoi cells of the first level. Browsers, Inkscape and rsvg-convert open it.

Examples:
  rubble-cli draw house.rubble --out house.svg
  rubble-cli draw house.rubble --asset roof --show cells > roof.svg)";

struct DrawOptions {
    std::string file;
    std::vector<std::string> assets;
    std::string out = "-";
    std::vector<std::string> shown = {"cells", "triangles", "seeds"};
};

PatternSvgOptions svgOptions(const std::vector<std::string>& words) {
    const auto has = [&](const char* word) { return std::ranges::find(words, word) != words.end(); };
    return {.cells = has("cells"), .triangles = has("triangles"), .seeds = has("seeds")};
}

/// Fractures the asset in the plane and adds its warnings.
Result<PatternPanel> panelOf(const Asset& asset, std::vector<AssetWarnings>& all, const CliContext& context) {
    const TaskContext task{.cancel = context.cancel};
    if (!asset.isPrism()) return Error{ErrorCode::Unsupported, "It is a mesh, which has no plan to draw."};
    Result<PlanarFracture> cut = planarFracture(recipeOf(asset), asset.prism(), task);
    if (!cut) return cut.error();
    std::vector<Diagnostic> warnings = cut->seeds.diagnostics;
    warnings.insert(warnings.end(), cut->partition.diagnostics.begin(), cut->partition.diagnostics.end());
    all.push_back({asset.name, std::move(warnings)});
    return PatternPanel{.title = asset.name,
                        .prism = std::move(cut->prism),
                        .seeds = std::move(cut->seeds.positions),
                        .triangles = triangleList(cut->delaunay),
                        .partition = std::move(cut->partition)};
}

Result<std::vector<PatternPanel>> panelsOf(const Project& project, std::span<const Id> assets, const std::string& file,
                                           const CliContext& context) {
    std::vector<PatternPanel> panels;
    std::vector<AssetWarnings> warnings;
    for (const Id id : assets) {
        const Asset& asset = *findAsset(project, id);
        Result<PatternPanel> panel = panelOf(asset, warnings, context);
        if (!panel) return ofAsset(asset, panel.error());
        panels.push_back(std::move(*panel));
    }
    printWarnings(context, warnings, file);
    return panels;
}

Status draw(const DrawOptions& options, const CliContext& context) {
    const Result<ProjectAssets> loaded = loadProjectAssets(options.file, options.assets, context);
    if (!loaded) return loaded.error();
    const Result<std::vector<PatternPanel>> panels = panelsOf(loaded->project, loaded->assets, options.file, context);
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
    return {command, [options](VerbReport&, const CliContext& context) { return draw(*options, context); }};
}

}  // namespace rubble
