#include "app/cli/ChosenAssets.h"
#include "app/cli/ChosenShots.h"
#include "app/cli/CommonOptions.h"
#include "app/cli/PlayOptions.h"
#include "app/cli/ProgressLine.h"
#include "app/cli/Verb.h"
#include "core/base/MessageText.h"
#include "core/io/JsonLayout.h"
#include "core/io/ProjectFile.h"
#include "viewport/film/SheetPage.h"
#include "viewport/film/SheetPicture.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(Variants of one asset, by other random seeds of its layers, side by side in one picture and measured: 0 is the asset as it
is. With --shot and --at all are played to the same step first. The table has a row a variant, in the picture's order.

Examples:
  rubble-cli sheet house.rubble --asset wall --variants 12 --out sheet.png --sort smallestPiece
  rubble-cli sheet house.rubble --asset wall --shot "box at the door" --at 60 --out sheet.png --json)";

struct SheetOptions {
    std::string file;
    std::string out;
    std::string asset;
    BreedingRecipe recipe;
    std::string shot;
    std::uint64_t step = 60;
    std::string sort = "number";
    std::string theme = "light";
    bool isJson = false;
    int threads = 1;
};

std::vector<std::string> measureNames() {
    std::vector<std::string> names;
    for (int k = 0; k < kSheetMeasures; ++k) names.emplace_back(nameOf(static_cast<SheetMeasure>(k)));
    return names;
}

/// Errors: NotFound where the project has no such asset or shot; those of variantsOf().
Result<SheetOrder> orderFor(const Project& project, const SheetOptions& options, const CliContext& context) {
    const Result<std::vector<Id>> chosen = chosenAssets(project, {options.asset});
    if (!chosen) return chosen.error();
    SheetOrder order{.project = project, .bakes = {}, .asset = chosen->front(), .variants = {}, .stage = {}};
    Result<std::vector<Asset>> variants = variantsOf(*findAsset(project, order.asset), options.recipe);
    if (!variants) return variants.error();
    order.variants = std::move(*variants);
    if (options.shot.empty()) return order;
    const Result<std::vector<Shot>> shots = chosenShots(project, {.names = {options.shot}, .file = {}}, context);
    if (!shots) return shots.error();
    order.stage = SheetStage{.shots = {shots->front().id}, .step = options.step};
    return order;
}

std::string valueText(const SheetEntry& entry, SheetMeasure measure) {
    const std::optional<double> value = entry.figures.value(measure, entry.number);
    return value ? roundedText(*value, 6) : "-";
}

std::string tableOf(const std::vector<SheetEntry>& entries) {
    std::string text;
    for (const std::string& name : measureNames()) text += (text.empty() ? "" : "\t") + name;
    text += '\n';
    for (const SheetEntry& entry : entries) {
        for (int k = 0; k < kSheetMeasures; ++k) {
            text += (k == 0 ? "" : "\t") + valueText(entry, static_cast<SheetMeasure>(k));
        }
        text += (entry.fault ? "\t" + *entry.fault : "") + '\n';
    }
    return text;
}

std::string jsonOf(const std::vector<SheetEntry>& entries) {
    JsonLayout json;
    json.openObject();
    json.openArray("variants");
    for (const SheetEntry& entry : entries) {
        json.openObject({}, JsonLines::One);
        json.wholeNumber("number", std::uint64_t{entry.number});
        for (int k = 1; k < kSheetMeasures; ++k) {
            const auto measure = static_cast<SheetMeasure>(k);
            json.number(nameOf(measure), entry.figures.value(measure, entry.number));
        }
        if (entry.fault) json.text("fault", *entry.fault);
        json.close();
    }
    json.close();
    json.close();
    return std::move(json).finished();
}

Status sheet(const SheetOptions& options, const CliContext& context) {
    const Result<Project> project = loadProject(options.file);
    if (!project) return project.error();
    const Result<SheetOrder> order = orderFor(*project, options, context);
    if (!order) return order.error();
    ProgressLine line(context, "Drawing");
    const TaskContext task{.cancel = context.cancel,
                           .progress = [&line](double fraction) { line.show(fraction); },
                           .threads = options.threads};
    const Theme theme = options.theme == "dark" ? Theme::Dark : Theme::Light;
    std::vector<SheetEntry> made(order->variants.size());
    std::vector<NumberedPicture> pictures(made.size());
    const auto take = [&](SheetEntry entry, std::optional<Image> picture) {
        pictures[entry.number] = {entry.number, std::move(picture)};
        made[entry.number] = std::move(entry);
    };
    const Status drawn = drawContactSheet(
        *order, {.theme = theme, .view = order->stage ? StandardView::Isometric : StandardView::Front}, take, task);
    line.clear();
    if (!drawn) return drawn;
    const std::vector<std::string> names = measureNames();
    const auto measure = std::ranges::find(names, options.sort) - names.begin();
    std::vector<SheetEntry> entries;
    std::vector<NumberedPicture> page;
    for (const std::uint32_t k : sortedBy(static_cast<SheetMeasure>(measure), made)) {
        entries.push_back(made[k]);
        page.push_back(std::move(pictures[k]));
    }
    const Result<std::string> png = pngOf(sheetPage(page, theme));
    if (!png) return png.error();
    if (const Status written = writeOutput(options.out, *png, context); !written) return written;
    return writeOutput("-", options.isJson ? jsonOf(entries) : tableOf(entries), context);
}

}  // namespace

Verb addSheet(CLI::App& program) {
    CLI::App* command = program.add_subcommand("sheet", "Draw variants of an asset side by side, and measure them");
    const auto options = std::make_shared<SheetOptions>();
    command->footer(kFooter);
    command->add_option("FILE", options->file, "The project")->required()->type_name("");
    command->add_option("--asset", options->asset, "The asset that varies")->required()->option_text("NAME");
    command->add_option("--out", options->out, "Where to write the picture")->required()->option_text("FILE");
    command->add_option("--variants", options->recipe.count, "How many, the asset itself included: 12 if not given")
        ->check(numberBetween(1, static_cast<int>(BreedingRecipe::kMostVariants)))
        ->option_text("N");
    command->add_option("--random-seed", options->recipe.randomSeed, "Another one, other variants: 1 if not given")
        ->option_text("N");
    CLI::Option* shot = command->add_option("--shot", options->shot, "Fire this shot of the project at all of them")
                            ->option_text("NAME");
    command->add_option("--at", options->step, "Draw them after so many steps: 60 if not given")
        ->check(numberBetween(0, kMostSteps))
        ->needs(shot)
        ->option_text("STEP");
    command->add_option("--sort", options->sort, "By which measure: " + joinedText(measureNames()))
        ->check(oneOf(measureNames()))
        ->option_text("MEASURE");
    command->add_option("--theme", options->theme, "light or dark")->check(oneOf({"light", "dark"}))->option_text("T");
    command->add_flag("--json", options->isJson, "For programs: JSON instead of a table");
    addThreadsOption(*command, options->threads);
    return {command, [options](const CliContext& context) { return sheet(*options, context); }};
}

}  // namespace rubble
