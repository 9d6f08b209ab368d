#include "app/cli/console/InputOutput.h"
#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/options/PlayOptions.h"
#include "app/cli/options/ShotOptions.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/project/Ranges.h"
#include "core/base/QuantityText.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/play/ReplayFile.h"
#include "core/io/play/StateFile.h"
#include "viewport/video/ContactSheetPage.h"
#include "viewport/video/ContactSheetPainter.h"

#include <algorithm>
#include <memory>

namespace rubble {
namespace {

constexpr const char* kSheetFooter =
    R"(Draws variants of an asset, generated with other random seeds, side by side in one picture, and measures them; 0
is the asset itself. With --shot and --at all are simulated to the same step first, with --state from a saved
moment in which the asset is intact. The table has one row per variant, in the order of the picture.

Examples:
  rubble-cli sheet house.rubble --asset wall --variants 12 --out sheet.png --sort smallestFragment
  rubble-cli sheet house.rubble --asset wall --shot "box at the door" --at 60 --out sheet.png --json)";

struct SheetOptions {
    std::string file;
    std::string out;
    std::string asset;
    VariantRecipe recipe;
    std::string shot;
    std::uint64_t step = 60;
    std::string state;  // file that variants start from; empty: the scene
    std::string sort = "number";
    std::string theme = "light";
    bool isJson = false;
    int threads = 1;
};

/// The words of --sort and the titles of the table. In JSON, measures have the names that they had in earlier versions.
const std::vector<std::string>& measureWords() {
    static const std::vector<std::string> words{"number", "fragments",   "smallestFragment",
                                                "aspect", "breakImpact", "debrisHeight"};
    return words;
}

/// Errors: NotFound if the project has no such asset or shot; those of generateVariants().
Result<SheetRequest> requestFor(const Project& project, const SheetOptions& options, const CliContext& context) {
    const Result<std::vector<Id>> selected = selectedAssets(project, {options.asset});
    if (!selected) return selected.error();
    SheetRequest request{.project = project, .bakes = {}, .asset = selected->front(), .variants = {}, .stage = {}};
    Result<std::vector<Asset>> variants = generateVariants(*findAsset(project, request.asset), options.recipe);
    if (!variants) return variants.error();
    request.variants = std::move(*variants);
    if (options.shot.empty()) return request;
    const Result<std::vector<Shot>> shots = selectedShots(project, {.names = {options.shot}, .file = {}}, context);
    if (!shots) return shots.error();
    request.stage = SheetStage{.shots = {shots->front().id}, .step = options.step};
    if (options.state.empty()) return request;
    Result<SavedSession> saved = loadSavedSession(options.state, sceneHash(project));
    if (!saved) return saved.error();
    request.stage->state = std::make_shared<const SavedSession>(std::move(*saved));
    return request;
}

std::string valueText(const SheetEntry& entry, SheetMeasure measure) {
    const std::optional<double> value = entry.figures.value(measure, entry.number);
    return value ? roundedNumber(*value) : "-";
}

std::string tableOf(const std::vector<SheetEntry>& entries) {
    std::string text;
    for (const std::string& word : measureWords()) text += (text.empty() ? "" : "\t") + word;
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
    JsonWriter json;
    json.openObject();
    json.openArray("variants");
    for (const SheetEntry& entry : entries) {
        json.openObject({}, JsonLayout::Inline);
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
    const Result<Project> project = openProject(options.file, context);
    if (!project) return project.error();
    const Result<SheetRequest> request = requestFor(*project, options, context);
    if (!request) return request.error();
    ProgressLine line(context, "Drawing");
    const TaskContext task{.cancel = context.cancel,
                           .progress = [&line](double fraction) { line.show(fraction); },
                           .threads = options.threads};
    const Theme theme = options.theme == "dark" ? Theme::Dark : Theme::Light;
    std::vector<SheetEntry> generated(request->variants.size());
    std::vector<NumberedImage> pictures(generated.size());
    const auto store = [&](SheetEntry entry, std::optional<Image> picture) {
        pictures[entry.number] = {entry.number, std::move(picture)};
        generated[entry.number] = std::move(entry);
    };
    const Status drawn = drawContactSheet(
        *request, {.theme = theme, .view = request->stage ? StandardView::Isometric : StandardView::Front}, store,
        task);
    line.clear();
    if (!drawn) return drawn;
    const auto measure = std::ranges::find(measureWords(), options.sort) - measureWords().begin();
    std::vector<SheetEntry> entries;
    std::vector<NumberedImage> page;
    for (const std::uint32_t k : sortedBy(static_cast<SheetMeasure>(measure), generated)) {
        entries.push_back(generated[k]);
        page.push_back(std::move(pictures[k]));
    }
    const Result<std::string> png = pngOf(contactSheetPage(page, theme));
    if (!png) return png.error();
    if (const Status written = writeOutput(options.out, *png, context); !written) return written;
    return printText(options.isJson ? jsonOf(entries) : tableOf(entries), context);
}

}  // namespace

Verb addSheet(CLI::App& program) {
    Command command(program, "sheet", "Draw and measure variants of an asset side by side", kSheetFooter);
    const auto options = std::make_shared<SheetOptions>();
    addProjectArgument(command, options->file);
    command.option("-a,--asset", options->asset, "The asset").required().valueName("NAME");
    command.option("-o,--out", options->out, "The picture to write").required().writes({".png"}).valueName("FILE");
    command.option("--variants", options->recipe.count, "The number of variants, including the asset (default: 12)")
        .wholeInRange(ProjectNumber::Variants)
        .valueName("N");
    command.option("--random-seed", options->recipe.randomSeed, "The random seed of the variants (default: 1)")
        .valueName("N");
    const CommandOption shot =
        command.option("--shot", options->shot, "Fire this shot of the project at each variant").valueName("NAME");
    command.option("--at", options->step, "Draw them after this step (default: 60)")
        .wholeInRange(ProjectNumber::Step)
        .needs(shot)
        .valueName("STEP");
    command.option("--state", options->state, "Start from a saved state, in which the asset is intact")
        .reads()
        .needs(shot)
        .valueName("FILE");
    command.option("--sort", options->sort, "Sort by one of " + joinedText(measureWords()))
        .oneOf(measureWords())
        .formerWords({{"pieces", "fragments"}, {"smallestPiece", "smallestFragment"}})
        .valueName("MEASURE");
    command.option("--theme", options->theme, "light (default) or dark").oneOf({"light", "dark"}).valueName("T");
    command.flag("--json", options->isJson, "Print JSON instead of a table");
    addThreadsOption(command, options->threads);
    return {command, [options](VerbReport&, const CliContext& context) { return sheet(*options, context); }};
}

}  // namespace rubble
