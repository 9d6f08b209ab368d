#include "app/cli/console/InputOutput.h"
#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/FragmentsText.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/output/Warnings.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"
#include "core/io/pack/PackExport.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rubble {
namespace {

constexpr const char* kExportFooter =
    R"(Writes each asset into a folder with its name: pack.json, which describes the whole and its fragments; meshes;
and manifest.json. A folder that already holds the same export is not rewritten; others are replaced as a whole,
unless a file in them was changed since or is not part of an export. Files that engines write beside meshes
(.import, .uid, .meta) are kept. If there are many warnings, only the first three are printed; rubble-cli check
prints all.

Examples:
  rubble-cli export house.rubble --out packs
  rubble-cli export house.rubble --out packs --asset wall --format obj --pieces files --place centred)";

enum class Formats { Obj, Glb, Both, None };

struct ExportArguments {
    std::string project;
    std::string out;
    std::vector<std::string> assets;
    Formats formats = Formats::Both;
    PackOptions pack;
    bool isOverwriting = false;
    int threads = 1;
};

template <class Value>
using Alternatives = std::vector<std::pair<std::string, Value>>;

/// Adds an option whose value is one of a few words.
template <class Value>
void addEnumOption(Command& command, const char* name, const char* help, const Alternatives<Value>& alternatives,
                   Value& value) {
    std::vector<std::string> words;
    std::string label;
    for (const auto& [word, meaning] : alternatives) {
        words.push_back(word);
        label += (label.empty() ? "" : "|") + word;
    }
    const auto select = [alternatives, &value](const std::string& given) {
        for (const auto& [word, meaning] : alternatives) {
            if (word == given) value = meaning;
        }
    };
    command.callback(name, select, help).oneOf(words).valueName(label);
}

std::string summaryOf(const AssetExport& asset) {
    if (asset.isUnchanged) return shownName(asset.name) + ": unchanged in " + asset.folder.string() + '\n';
    return shownName(asset.name) + ": " + fragmentsText(asset.fragmentCount, asset.volume) + ", exported to " +
           asset.folder.string() + '\n';
}

std::string errorOf(const AssetExport& asset) {
    const Error& error = asset.status.error();
    return error.message + (error.code == ErrorCode::Edited ? " Use --overwrite to replace it." : "");
}

/// Prints the result of every asset; returns an error with a line for each of the first that failed.
Status printResults(const std::vector<AssetExport>& assets, const std::string& project, const CliContext& context) {
    std::string summary;
    std::vector<AssetWarnings> warnings;
    std::vector<std::string> errors;
    for (const AssetExport& asset : assets) {
        warnings.push_back({asset.name, asset.diagnostics});
        if (asset.status) {
            summary += summaryOf(asset);
        } else if (errors.empty() || errors.back() != errorOf(asset)) {  // all fail alike if the folder does
            errors.push_back(errorOf(asset));
        }
    }
    printWarnings(context, warnings, project);
    if (const Status written = printText(summary, context); !written) return written;
    if (!errors.empty()) return Error{ErrorCode::BadInput, firstLinesOf(errors)};
    return success();
}

Status exportAssets(ExportArguments arguments, const CliContext& context) {
    arguments.pack.meshes.obj = arguments.formats == Formats::Obj || arguments.formats == Formats::Both;
    arguments.pack.meshes.glb = arguments.formats == Formats::Glb || arguments.formats == Formats::Both;
    const Result<Project> project = openProject(arguments.project, context);
    if (!project) return project.error();
    const Result<std::vector<Id>> selected = selectedAssets(*project, arguments.assets);
    if (!selected) return selected.error();
    const EditedFiles edited = arguments.isOverwriting ? EditedFiles::Replaced : EditedFiles::Kept;
    ProgressLine line(context, "Exporting");
    const TaskContext task{context.cancel, [&](double fraction) { line.show(fraction); }, arguments.threads};
    const auto assets = exportPacks(*project, *selected, arguments.out, arguments.pack, edited, task);
    line.clear();
    return assets ? printResults(*assets, arguments.project, context) : assets.error();
}

}  // namespace

Verb addExport(CLI::App& program) {
    Command command(program, "export", "Fracture assets and write their packs and meshes", kExportFooter);
    const auto arguments = std::make_shared<ExportArguments>();
    MeshOptions& meshes = arguments->pack.meshes;
    addProjectArgument(command, arguments->project);
    command.option("-o,--out", arguments->out, "The output folder, with a subfolder for each asset")
        .required()
        .valueName("FOLDER");
    addAssetOption(command, arguments->assets);
    addEnumOption<Formats>(
        command, "--format", "The mesh files to write (default: both)",
        {{"obj", Formats::Obj}, {"glb", Formats::Glb}, {"both", Formats::Both}, {"none", Formats::None}},
        arguments->formats);
    addEnumOption<FileSplit>(command, "--pieces", "All fragments in a single file (default) or one file each",
                             {{"single", FileSplit::Single}, {"files", FileSplit::PerFragment}}, meshes.split);
    addEnumOption<PartPlacement>(
        command, "--place", "Fragments in place (default) or with their centres of mass at the origin",
        {{"assembled", PartPlacement::Assembled}, {"centred", PartPlacement::Centred}}, meshes.place);
    addEnumOption<FaceShape>(command, "--faces", "The faces in OBJ files (default: polygons)",
                             {{"polygons", FaceShape::Polygons}, {"triangles", FaceShape::Triangles}}, meshes.faces);
    addEnumOption<UpAxis>(command, "--up", "The up axis of OBJ files (default: y)",
                          {{"y", UpAxis::Y}, {"z", UpAxis::Z}}, meshes.objFrame.up);
    addEnumOption<ObjUnit>(command, "--unit", "The unit of OBJ files (default: m)",
                           {{"m", ObjUnit::Metre}, {"cm", ObjUnit::Centimetre}, {"mm", ObjUnit::Millimetre}},
                           meshes.objFrame.unit);
    command.option("--inset", arguments->pack.inset, "The inset of collision hulls in m (default: 0.0001)")
        .inRange(ProjectNumber::HullInset)
        .valueName("LENGTH");
    addEnumOption<PackFiles>(command, "--pack", "The files that describe the bodies (default: both)",
                             {{"json", PackFiles::Json}, {"bin", PackFiles::Binary}, {"both", PackFiles::Both}},
                             arguments->pack.files);
    addEnumOption<PackTopology>(
        command, "--topology", "Edges and planes of hulls in pack.json (default), or loops only",
        {{"full", PackTopology::Full}, {"loops", PackTopology::Loops}}, arguments->pack.topology);
    command.flag("--overwrite", arguments->isOverwriting, "Replace files that were changed after an export");
    addThreadsOption(command, arguments->threads);
    return {command, [arguments](const CliContext& context) { return exportAssets(*arguments, context); }};
}

}  // namespace rubble
