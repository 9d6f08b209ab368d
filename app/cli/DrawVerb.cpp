#include "app/cli/ChosenAssets.h"
#include "app/cli/CommonOptions.h"
#include "app/cli/Verb.h"
#include "core/asset/Breaking.h"
#include "core/fracture/Delaunay.h"
#include "core/io/PatternSvg.h"
#include "core/io/ProjectFile.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <ostream>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(One picture shows every asset, or those named by --asset: its outline, its seeds, their Delaunay triangulation and the
Voronoi cells that the asset breaks into first. Browsers, Inkscape and rsvg-convert open it.

Examples:
  rubble-cli draw house.rubble --out house.svg
  rubble-cli draw house.rubble --asset roof --show cells > roof.svg)";

struct DrawOptions {
    std::string file;
    std::vector<std::string> assets;
    std::string out = "-";
    std::vector<std::string> shown = {"cells", "triangles", "seeds"};
};

PatternShown shownOf(const std::vector<std::string>& words) {
    const auto has = [&](const char* word) { return std::ranges::find(words, word) != words.end(); };
    return {.cells = has("cells"), .triangles = has("triangles"), .seeds = has("seeds")};
}

void tell(const Asset& asset, const std::vector<Report>& reports, const CliContext& context) {
    for (const Report& report : reports) context.err << "Asset \"" << asset.name << "\": " << report.message << '\n';
}

/// Carries out the asset's recipe as far as it is drawn, and tells what is to be told of it.
Result<PatternPanel> panelOf(const Asset& asset, const CliContext& context) {
    const TaskContext task{.cancel = context.cancel};
    Result<PlaneBreaking> cut = cutBy(recipeOf(asset), asset.prism, task);
    if (!cut) return cut.error();
    tell(asset, cut->seeds.reports, context);
    tell(asset, cut->partition.reports, context);
    return PatternPanel{.title = asset.name,
                        .prism = std::move(cut->prism),
                        .seeds = std::move(cut->seeds.positions),
                        .triangles = triangleList(cut->delaunay),
                        .partition = std::move(cut->partition)};
}

Result<std::vector<PatternPanel>> panelsOf(const Project& project, std::span<const Id> assets,
                                           const CliContext& context) {
    std::vector<PatternPanel> panels;
    for (const Id id : assets) {
        const Asset& asset = *findAsset(project, id);
        Result<PatternPanel> panel = panelOf(asset, context);
        if (!panel) return ofAsset(asset, panel.error());
        panels.push_back(std::move(*panel));
    }
    return panels;
}

Status draw(const DrawOptions& options, const CliContext& context) {
    const Result<Project> project = loadProject(options.file);
    if (!project) return project.error();
    const Result<std::vector<Id>> assets = chosenAssets(*project, options.assets);
    if (!assets) return assets.error();
    if (assets->empty()) return Error{ErrorCode::NotFound, "The project has no asset to draw."};
    const Result<std::vector<PatternPanel>> panels = panelsOf(*project, *assets, context);
    if (!panels) return panels.error();
    return writeOutput(options.out, patternSvg(*panels, shownOf(options.shown)), context);
}

}  // namespace

Verb addDraw(CLI::App& program) {
    CLI::App* command = program.add_subcommand("draw", "Draw patterns as an SVG picture: seeds, Delaunay, cells");
    const auto options = std::make_shared<DrawOptions>();
    command->footer(kFooter);
    command->add_option("FILE", options->file, "The project")->required()->type_name("");
    addAssetOption(*command, options->assets);
    command->add_option("--out", options->out, "Where to write the picture: standard output if not given, or -")
        ->option_text("FILE");
    command->add_option("--show", options->shown, "Only some of cells, triangles and seeds: all if not given")
        ->delimiter(',')
        ->check(oneOf({"cells", "triangles", "seeds"}))
        ->option_text("WHAT,...");
    return {command, [options](const CliContext& context) { return draw(*options, context); }};
}

}  // namespace rubble
