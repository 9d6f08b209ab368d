#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/ImportSummary.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/import/AssetImport.h"
#include "core/asset/placement/InstancePlacement.h"
#include "core/base/MessageText.h"
#include "core/base/Parallel.h"
#include "core/base/QuantityText.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/mesh/MeshImport.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/project/ProjectLock.h"

#include <memory>
#include <optional>
#include <ostream>

namespace rubble {
namespace {

constexpr const char* kImportFooter =
    R"(Reads OBJ, glTF, GLB, FBX, STL and PLY files, in a separate process limited to 2 GiB and 30 s. Each object that
is a prism (two parallel caps with the same outline along any axis, and sides perpendicular to them) becomes an
asset and an instance at the position of the mesh, or beside the scene where they would overlap. What is not a prism
becomes a solid, an asset of its mesh, if that is closed and does not cross itself; cavities stay. Prints what was
imported, merged and ignored. An object that is rejected does not keep others from being imported; the reason, with
the place, goes to standard error. If all are rejected, nothing is written.

With --as prism nothing becomes a solid. With --as solid each object does, unsplit; by default and for prisms the
unconnected parts of an object become assets of their own.

Without --into, a new project is written beside FILE (wall.rubble for wall.glb), unless it exists. glTF is in
metres; FBX states its unit; OBJ, STL and PLY do not and are read in metres. An object that is a prism along
several axes, such as a box, is extruded along the thinnest one. With --asset an existing asset gets the new
shape and appearance, and keeps its material, pattern, levels, threshold and instances.

Examples:
  rubble-cli import wall.glb
  rubble-cli import parts.stl --into house.rubble --unit mm --up z
  rubble-cli import wall2.glb --into house.rubble --asset Wall
  rubble-cli import statue.obj --as solid --up z
  rubble-cli import boulder.ply --fallback silhouette --axis y)";

struct ImportVerbOptions {
    std::filesystem::path mesh;
    std::filesystem::path project;
    std::optional<double> metresPerUnit;
    std::string up = "y";
    std::string as = "auto";
    std::string axis;
    std::string asset;
    std::string fallback;
    bool isFixed = false;
    bool isUnbreakable = false;
};

/// The project to import into, new if its file does not exist yet.
struct Target {
    std::filesystem::path path;
    Project project;
};

std::filesystem::path targetPath(const ImportVerbOptions& options) {
    if (!options.project.empty()) return options.project;
    return std::filesystem::path(options.mesh).replace_extension(".rubble");
}

/// Fails if the project was not named and exists.
Status checkTarget(const ImportVerbOptions& options) {
    std::error_code ignored;
    const std::filesystem::path path = targetPath(options);
    if (!options.project.empty() || !std::filesystem::exists(path, ignored)) return success();
    return Error{ErrorCode::BadInput,
                 quotedPath(path) + " already exists; use --into to import into it or into another project."};
}

Result<Target> openTarget(const ImportVerbOptions& options, const CliContext& context) {
    if (const Status isFree = checkTarget(options); !isFree) return isFree.error();
    Target target{.path = targetPath(options)};
    std::error_code ignored;
    if (!std::filesystem::exists(target.path, ignored)) return target;
    Result<Project> project = openProject(target.path, context);
    if (!project) return project.error();
    target.project = std::move(*project);
    return target;
}

ImportOptions importOptions(const ImportVerbOptions& given) {
    ImportOptions options{.metresPerUnit = given.metresPerUnit,
                          .asset = given.asset,
                          .isFixed = given.isFixed,
                          .isUnbreakable = given.isUnbreakable,
                          .findsFallbacks = true};
    if (given.up == "z") options.up = UpAxis::Z;
    if (given.as == "prism") options.as = ImportShape::Prism;
    if (given.as == "solid") options.as = ImportShape::Solid;
    if (given.axis == "x") options.axis = PrismAxis::X;
    if (given.axis == "y") options.axis = PrismAxis::Y;
    if (given.axis == "z") options.axis = PrismAxis::Z;
    if (given.fallback == "silhouette") options.fallback = PrismFallback::Silhouette;
    if (given.fallback == "cap") options.fallback = PrismFallback::TopCap;
    return options;
}

/// Returns the options that import a rejected object.
std::string optionsOf(const WorkingFallback& working, const ImportOptions& options) {
    const std::string fallback =
        working.fallback == PrismFallback::Silhouette ? "--fallback silhouette" : "--fallback cap";
    if (working.axis == options.axis) return fallback;
    return fallback + " --axis " +
           std::string(1, "xyz"[static_cast<int>(working.axis) - static_cast<int>(PrismAxis::X)]);
}

std::string volumeText(double volume) { return quantityText(QuantityKind::Volume, volume); }

/// Returns the advice to use fallbacks that keep the volume of an object, and what others would change.
std::string adviceOn(const RejectedObject& rejected, const ImportOptions& options) {
    std::string kept, changed;
    for (const WorkingFallback& working : rejected.fallbacks) {
        const std::string words = optionsOf(working, options), volume = volumeText(working.volume);
        if (rejected.isReshapedBy(working)) {
            const std::string from = "would change its volume from " + volumeText(*rejected.volume) + " ";
            changed += (changed.empty() ? "; " : ", ") + words + " " + (changed.empty() ? from : "") + "to " + volume;
        } else {
            const std::string instead = rejected.volume ? " in place of " + volumeText(*rejected.volume) : "";
            kept += (kept.empty() ? "; use " : " or ") + words + " (" + volume + instead + ")";
        }
    }
    return (kept.empty() ? "" : kept + " to import its outline") + changed;
}

/// Returns why an object is rejected, and what fallbacks would do.
Error rejectionOf(const RejectedObject& rejected, const ImportOptions& options) {
    Error error = rejected.error;
    const std::string advice = adviceOn(rejected, options);
    if (!advice.empty() && error.message.ends_with('.')) error.message.pop_back();
    if (!advice.empty()) error.message += advice + ".";
    return error;
}

/// Returns a line for each rejected object.
std::string rejections(const ImportOutcome& outcome, const ImportOptions& options) {
    std::string text;
    for (const RejectedObject& rejected : outcome.rejected)
        text += (text.empty() ? "" : "\n") + rejectionOf(rejected, options).message;
    return text;
}

/// Fails if options of prisms are given for solids.
Status checkOptions(const ImportVerbOptions& options) {
    if (options.as != "solid" || (options.fallback.empty() && options.axis.empty())) return success();
    const std::string option = options.fallback.empty() ? "--axis" : "--fallback";
    return Error{ErrorCode::BadInput, option + " is for prisms; leave it out, or use --as auto or --as prism."};
}

/// Fails if a project is given instead of a mesh file.
Status checkIsNoProject(const std::filesystem::path& mesh) {
    if (mesh.extension() != ".rubble") return success();
    const std::string name = mesh.string();
    return Error{ErrorCode::BadInput, quotedPath(mesh) +
                                          " is a project, not a mesh file. To import a mesh into it, use --into " +
                                          name + "; to export its meshes, use rubble-cli export."};
}

void writePrism(JsonWriter& json, const PrismFit& prism) {
    json.wholeNumber("corners", std::uint64_t{prism.outline.outer.size()});
    json.wholeNumber("holes", std::uint64_t{prism.outline.holes.size()});
    json.number("depth", prism.depth);
}

void writeSolid(JsonWriter& json, const SolidFit& solid) {
    json.wholeNumber("triangles", std::uint64_t{solid.mesh->mesh.triangles.size()});
    json.wholeNumber("parts", std::uint64_t{solid.parts});
    json.wholeNumber("cavities", std::uint64_t{solid.cavities});
    json.number("volume", solid.mesh->mass.volume);
    if (!solid.whyNoPrism.empty()) json.text("whyNoPrism", printableText(solid.whyNoPrism));
}

void writeAsset(JsonWriter& json, const ImportedAsset& imported, const Project& project) {
    const Vec3 position = imported.solid ? imported.solid->position : imported.prism->pose.position;
    json.openObject();
    json.text("name", printableText(findAsset(project, imported.asset)->name));
    json.wholeNumber("id", std::uint64_t{imported.asset});
    json.boolean("updated", imported.isReplaced);
    json.text("shape", imported.solid ? "solid" : "prism");
    json.boolean("fallback", imported.usesFallback);
    if (imported.solid) {
        writeSolid(json, *imported.solid);
    } else {
        writePrism(json, *imported.prism);
    }
    json.numbers("position", {position.x, position.y, position.z});
    if (imported.prism) json.number("tolerance", imported.tolerance);
    json.close();
}

/// Reports what was imported; what was merged, omitted or rejected is a finding.
void reportImport(const ImportOutcome& outcome, const ImportVerbOptions& options, const std::string& project,
                  VerbReport& report) {
    const std::string mesh = options.mesh.string();
    for (const ImportedAsset& imported : outcome.assets) {
        const std::string& name = findAsset(outcome.project, imported.asset)->name;
        for (const std::string& note : imported.notes)
            report.findings.push_back({Severity::Note, "ImportNote", {.file = mesh, .asset = name}, note});
    }
    for (const RejectedObject& rejected : outcome.rejected) {
        Finding finding = findingOf(rejectionOf(rejected, importOptions(options)), {.file = mesh});
        finding.severity = outcome.assets.empty() ? Severity::Error : Severity::Warning;
        report.findings.push_back(std::move(finding));
    }
    report.hasErrorInFindings = outcome.assets.empty();
    report.writeResults = [outcome, project](JsonWriter& json) {
        json.text("project", printableText(project));
        json.number("metresPerUnit", outcome.metresPerUnit);
        json.list("assets", outcome.assets, [&](JsonWriter& list, const ImportedAsset& imported) {
            writeAsset(list, imported, outcome.project);
        });
    };
}

Status import(const ImportVerbOptions& options, VerbReport& report, const CliContext& context) {
    const TaskContext task{.cancel = context.cancel, .threads = availableProcessors()};
    if (const Status isFitting = checkOptions(options); !isFitting) return isFitting;
    if (const Status isMesh = checkIsNoProject(options.mesh); !isMesh) return isMesh;
    if (const Status isFree = checkTarget(options); !isFree) return isFree;
    const Result<SourceScene> scene = importMesh(options.mesh, importerPath(context.programFolder), task);
    if (!scene) return scene.error();
    const Result<std::shared_ptr<const LockFile>> lock = waitForProjectLock(targetPath(options), context.cancel);
    if (!lock) return lock.error();
    Result<Target> target = openTarget(options, context);
    if (!target) return target.error();
    const ImportOptions wanted = importOptions(options);
    Result<ImportOutcome> outcome = importedInto(target->project, *scene, options.mesh.stem().string(), wanted, task);
    if (!outcome) return outcome.error();
    const std::string rejected = rejections(*outcome, wanted);
    reportImport(*outcome, options, target->path.string(), report);
    if (outcome->assets.empty()) return Error{ErrorCode::BadInput, rejected};
    if (!rejected.empty()) context.err << rejected << '\n';
    moveAddedBesideOthers(target->project, outcome->project);
    if (const Status saved = saveProject(target->path, outcome->project); !saved) return saved.error();
    return printSummary(importSummary(*outcome, target->path.string()), report, context);
}

}  // namespace

Verb addImport(CLI::App& program) {
    Command command(program, "import", "Import the objects of a mesh file as assets", kImportFooter);
    const auto options = std::make_shared<ImportVerbOptions>();
    command.argument("FILE", options->mesh, "The mesh file").required().reads();
    command.option("-i,--into", options->project, "The project to import into, created if missing")
        .changes()
        .valueName("PROJECT");
    addUnitOption(command, options->metresPerUnit);
    command.option("--up", options->up, "The up axis of the file (default: y)").oneOf({"y", "z"}).valueName("y|z");
    command.option("--as", options->as, "What objects become (default: auto, a solid where it is not a prism)")
        .oneOf({"auto", "prism", "solid"})
        .valueName("auto|prism|solid");
    command.option("--axis", options->axis, "Extrude along the axis closest to this one (y is up)")
        .oneOf({"x", "y", "z"})
        .valueName("x|y|z");
    command.option("-a,--asset", options->asset, "Update this asset, or create it").valueName("NAME");
    command
        .option("--fallback", options->fallback, "The outline to use for an object that is not a prism, along --axis")
        .oneOf({"silhouette", "cap"})
        .valueName("silhouette|cap");
    command.flag("--fixed", options->isFixed, "Hold the new instances in place until they break");
    command.flag("--unbreakable", options->isUnbreakable, "Prevent the new instances from breaking");
    command.addReportFlag();
    return {command,
            [options](VerbReport& report, const CliContext& context) { return import(*options, report, context); }};
}

}  // namespace rubble
