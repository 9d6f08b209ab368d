#include "app/cli/ChosenAssets.h"
#include "app/cli/CommonOptions.h"
#include "app/cli/FragmentsText.h"
#include "app/cli/ProgressLine.h"
#include "app/cli/Verb.h"
#include "core/io/PackExport.h"
#include "core/io/ProjectFile.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(Every asset gets a folder of its name: pack.json, which tells all of the whole and its fragments, meshes, and
manifest.json. A folder that holds this very export already is left as it is; one is only ever replaced as a whole.

Examples:
  rubble-cli export house.rubble --out packs
  rubble-cli export house.rubble --out packs --asset wall --format obj --pieces files --place centred)";

enum class Formats { Obj, Glb, Both, None };

struct ExportArguments {
    std::string project;
    std::string out;
    std::vector<std::string> assets;
    Formats formats = Formats::Both;
    MeshOptions meshes;
    int threads = 1;
};

template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

/// An option that takes one of a few words.
template <class Value>
void addChoice(CLI::App& command, const char* name, const char* help, const Choices<Value>& choices, Value& value) {
    std::vector<std::string> words;
    std::string label;
    for (const auto& [word, meaning] : choices) {
        words.push_back(word);
        label += (label.empty() ? "" : "|") + word;
    }
    const auto choose = [choices, &value](const std::string& chosen) {
        for (const auto& [word, meaning] : choices) {
            if (word == chosen) value = meaning;
        }
    };
    command.add_option_function<std::string>(name, choose, help)->check(oneOf(words))->option_text(label);
}

std::string summaryOf(const AssetExport& asset) {
    if (asset.isUnchanged) return asset.name + ": unchanged in " + asset.folder.string() + '\n';
    return asset.name + ": " + fragmentsText(asset.fragmentCount, asset.volume) + ", exported to " +
           asset.folder.string() + '\n';
}

/// Prints what became of every asset; a fault that tells of all that failed.
Status told(const std::vector<AssetExport>& assets, const CliContext& context) {
    std::string summary;
    std::optional<Error> fault;
    for (const AssetExport& asset : assets) {
        for (const Report& report : asset.reports)
            context.err << "Asset \"" << asset.name << "\": " << report.message << '\n';
        if (asset.status) {
            summary += summaryOf(asset);
        } else if (!fault) {
            fault = asset.status.error();
        } else if (!fault->message.ends_with(asset.status.error().message)) {  // one folder fails all of them alike
            fault->message += '\n' + asset.status.error().message;
        }
    }
    if (const Status written = writeOutput("-", summary, context); !written) return written;
    if (fault) return *fault;
    return success();
}

Status exportAssets(ExportArguments arguments, const CliContext& context) {
    arguments.meshes.obj = arguments.formats == Formats::Obj || arguments.formats == Formats::Both;
    arguments.meshes.glb = arguments.formats == Formats::Glb || arguments.formats == Formats::Both;
    const Result<Project> project = loadProject(arguments.project);
    if (!project) return project.error();
    const Result<std::vector<Id>> chosen = chosenAssets(*project, arguments.assets);
    if (!chosen) return chosen.error();
    ProgressLine line(context, "Exporting");
    const TaskContext task{context.cancel, [&](double fraction) { line.show(fraction); }, arguments.threads};
    const auto assets = exportPacks(*project, *chosen, arguments.out, arguments.meshes, task);
    line.clear();
    return assets ? told(*assets, context) : assets.error();
}

}  // namespace

Verb addExport(CLI::App& program) {
    CLI::App* command = program.add_subcommand("export", "Break assets and write their packs and meshes");
    const auto arguments = std::make_shared<ExportArguments>();
    MeshOptions& meshes = arguments->meshes;
    command->footer(kFooter);
    command->add_option("FILE", arguments->project, "The project")->required()->type_name("");
    command->add_option("--out", arguments->out, "Where the folders of the assets go")
        ->required()
        ->option_text("FOLDER");
    addAssetOption(*command, arguments->assets);
    addChoice<Formats>(*command, "--format", "Which meshes: both if not given",
                       {{"obj", Formats::Obj}, {"glb", Formats::Glb}, {"both", Formats::Both}, {"none", Formats::None}},
                       arguments->formats);
    addChoice<FileSplit>(*command, "--pieces", "All fragments in a single file, the default, or in files of their own",
                         {{"single", FileSplit::Single}, {"files", FileSplit::PerFragment}}, meshes.split);
    addChoice<PartPlace>(*command, "--place",
                         "Fragments at their places, the default, or each about its centre of mass",
                         {{"assembled", PartPlace::Assembled}, {"centred", PartPlace::Centred}}, meshes.place);
    addChoice<FaceShape>(*command, "--faces", "What OBJ files hold: polygons if not given",
                         {{"polygons", FaceShape::Polygons}, {"triangles", FaceShape::Triangles}}, meshes.faces);
    addThreadsOption(*command, arguments->threads);
    return {command, [arguments](const CliContext& context) { return exportAssets(*arguments, context); }};
}

}  // namespace rubble
