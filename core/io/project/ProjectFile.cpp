#include "core/io/project/ProjectFile.h"

#include "core/asset/checks/ValueFaults.h"
#include "core/asset/checks/VerifyProject.h"
#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/geometry/polygon/OutlineCleaning.h"
#include "core/io/json/FormatVersion.h"
#include "core/io/json/VectorJson.h"
#include "core/io/project/AssetJson.h"
#include "core/io/project/BondingJson.h"
#include "core/io/project/ProjectJournal.h"
#include "core/io/project/SceneJson.h"
#include "core/io/project/ShotJson.h"
#include "core/io/project/TextureJson.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/FileErrors.h"

#include <algorithm>
#include <array>

namespace rubble {
namespace {

constexpr std::uint32_t kVersionWithoutMeshes = 5;
constexpr FileFormat kProjectFormat{.name = "rubble-project", .noun = "project", .version = kProjectVersion};

/// The readers of the elements whose format differs between versions.
struct ElementReaders {
    Material (*material)(const JsonValue&);
    Asset (*asset)(const JsonValue&);
    Instance (*instance)(const JsonValue&);
};

/// Reads the members that all versions have.
Project readCommon(const JsonValue& root, const ElementReaders& read) {
    return {.nextId = root["nextId"].index(),
            .materials = root["materials"].list(read.material),
            .assets = root["assets"].list(read.asset),
            .instances = root["instances"].list(read.instance),
            .ground = readGround(root["ground"]),
            .gravity = readVector(root["gravity"]),
            .damage = readDamage(root["damage"]),
            .shots = root["shots"].list(readShot),
            .playTests = root["playTests"].list(readPlayTest)};
}

Project readProjectVersion1(const JsonValue& root) {
    root.requireObject({"format", "version", "nextId", "materials", "assets", "instances", "ground", "gravity",
                        "damage", "shots", "playTests"});
    return readCommon(root, {readMaterialBeforeVersion5, readAssetVersion1, readInstanceBeforeVersion3});
}

/// Reads all members since version 2.
Project readProjectSinceVersion2(const JsonValue& root, const ElementReaders& read,
                                 std::initializer_list<std::string_view> optional = {}) {
    root.requireObject({"format", "version", "nextId", "materials", "assets", "instances", "ground", "gravity",
                        "damage", "debris", "shots", "playTests"},
                       optional);
    Project project = readCommon(root, read);
    project.debris = readDebris(root["debris"]);
    return project;
}

/// Version 2 added debris, cuts at impact and strength requirements.
Project readProjectVersion2(const JsonValue& root) {
    return readProjectSinceVersion2(root,
                                    {readMaterialBeforeVersion5, readAssetVersions2To3, readInstanceBeforeVersion3});
}

/// Version 3 added variants, hidden and locked instances.
Project readProjectVersion3(const JsonValue& root) {
    return readProjectSinceVersion2(root, {readMaterialBeforeVersion5, readAssetVersions2To3, readInstance});
}

/// Version 4 added the shaping of fragments: small pieces, gaps, roughness, merges and splits, levels of single
/// fragments.
Project readProjectVersion4(const JsonValue& root) {
    return readProjectSinceVersion2(root, {readMaterialBeforeVersion5, readAssetVersion4, readInstance});
}

void readTextures(const JsonValue& root, std::vector<Asset>& assets) {
    const ImageList images = root["images"].isPresent() ? readImages(root["images"]) : ImageList();
    auto asset = assets.begin();
    for (const JsonValue value : root["assets"].elements()) {
        if (asset == assets.end()) break;  // after an error
        if (const JsonValue texture = value["texture"]; texture.isPresent())
            asset->texture = readTexture(texture, images);
        ++asset;
    }
}

/// Reads all members since version 5.
Project readProjectSinceVersion5(const JsonValue& root, const ElementReaders& read) {
    Project project = readProjectSinceVersion2(root, read, {"identity", "events", "mortars", "images"});
    if (root["identity"].isPresent()) project.identity = root["identity"].text();
    if (root["events"].isPresent()) project.events = readEventSettings(root["events"]);
    if (root["mortars"].isPresent()) project.mortars = root["mortars"].list(readMortar);
    readTextures(root, project.assets);
    return project;
}

/// Version 5 added strength and toughness of materials, and thresholds derived from them.
Project readProjectVersion5(const JsonValue& root) {
    return readProjectSinceVersion5(root, {readMaterial, readAssetVersion5, readInstance});
}

/// Version 6 added assets that are closed meshes, which readMeshes() gives them.
Project readProjectVersion6(const JsonValue& root) {
    return readProjectSinceVersion5(root, {readMaterial, readAsset, readInstance});
}

/// The reader of each version, version 1 at index 0. A new version adds a reader; older ones stay and set defaults.
constexpr std::array<Project (*)(const JsonValue&), kProjectVersion> kReaders{
    &readProjectVersion1, &readProjectVersion2, &readProjectVersion3,
    &readProjectVersion4, &readProjectVersion5, &readProjectVersion6};

/// The version that a project is written as: the oldest that holds it, so that older programs read it.
std::uint32_t versionFor(const Project& project) {
    return std::ranges::all_of(project.assets, &Asset::isPrism) ? kVersionWithoutMeshes : kProjectVersion;
}

Result<Project> readAnyVersion(JsonDocument& document, const MeshSource& meshes) {
    const Result<std::uint32_t> version = versionOf(document, kProjectFormat);
    if (!version) return version.error();
    Project project = kReaders[*version - 1](document.root());
    if (document.firstError()) return *document.firstError();
    if (*version <= kVersionWithoutMeshes) return project;
    if (const Status read = readMeshes(document, project.assets, meshes); !read) return read.error();
    return project;
}

Result<RecoveredProject> recovered(Project project) {
    if (const std::optional<std::string> fault = structureFault(project)) return Error{ErrorCode::BadInput, *fault};
    for (const Asset& asset : project.assets) {
        if (!asset.isPrism()) continue;
        const Result<Prism> prism = validated(asset.prism());
        if (!prism) return prism.error();
    }
    std::vector<std::string> faults = valueFaults(project);
    return RecoveredProject{std::move(project), std::move(faults)};
}

/// Recovers a project from a text, with what its journal has; without that where it does not fit.
Result<RecoveredProject> readRecovered(std::string_view json, std::string_view journal, const MeshSource& meshes) {
    Result<Project> project = readProjectPart(json, meshes);
    if (!project) return project.error();
    if (journal.empty()) return recovered(std::move(*project));
    Result<Project> edited = replayed(*project, contentHash(json), journal, meshes);
    Result<RecoveredProject> whole = edited ? recovered(std::move(*edited)) : Result<RecoveredProject>(edited.error());
    if (whole) return whole;
    Result<RecoveredProject> earlier = recovered(std::move(*project));
    if (earlier) earlier->faults.push_back("The last edits are left out: " + whole.error().message);
    return earlier;
}

/// Removes the repeated points of an asset's outline and its holes, and reports their number.
void cleanOutline(Asset& asset, std::vector<Diagnostic>& notes) {
    if (!asset.isPrism()) return;
    Polygon& outline = asset.prism().outline;
    std::size_t count = removeRepeatedPoints(outline.outer).size();
    for (Ring& hole : outline.holes) count += removeRepeatedPoints(hole).size();
    if (count == 0) return;
    notes.push_back(diagnostic(
        DiagnosticCode::RepeatedPoint, {.asset = asset.id},
        countText(count, "repeated point of the outline was", "repeated points of the outline were") + " left out.",
        static_cast<double>(count)));
}

bool isCleaned(const Asset& asset, const std::vector<Diagnostic>& notes) {
    return std::ranges::any_of(notes, [&](const Diagnostic& note) { return note.place.asset == asset.id; });
}

bool hasFaultyPrism(const Asset& asset) {
    return asset.isPrism() && (prismRangeFault({}, asset.prism()) || !validated(asset.prism()));
}

}  // namespace

Result<Project> readProjectPart(std::string_view json, const MeshSource& meshes) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    if (!document) return document.error();
    return readAnyVersion(*document, meshes);
}

std::string projectText(const Project& project) {
    JsonWriter json;
    json.openObject();
    json.text("format", kProjectFormat.name);
    json.wholeNumber("version", versionFor(project));
    if (!project.identity.empty()) json.text("identity", project.identity);
    json.wholeNumber("nextId", project.nextId);
    json.list("materials", project.materials, writeMaterial);
    const ImageList images = imagesOf(project);
    json.list("assets", project.assets,
              [&](JsonWriter& writer, const Asset& asset) { writeAsset(writer, asset, images); });
    json.list("instances", project.instances, writeInstance);
    writeGround(json, project.ground);
    writeVector(json, "gravity", project.gravity);
    writeDamage(json, project.damage);
    writeDebris(json, project.debris);
    if (project.events != EventSettings{}) writeEventSettings(json, project.events);
    json.list("shots", project.shots, writeShot);
    json.list("playTests", project.playTests, writePlayTest);
    if (!project.mortars.empty()) json.list("mortars", project.mortars, writeMortar);
    if (!images.empty()) writeImages(json, images);
    json.close();
    return std::move(json).finished();
}

Result<Project> readProjectText(std::string_view json, std::vector<Diagnostic>* notes, const MeshSource& meshes) {
    Result<Project> project = readProjectPart(json, meshes);
    if (!project) return project;
    std::vector<Diagnostic> found;
    for (Asset& asset : project->assets) cleanOutline(asset, found);
    if (std::optional<std::string> fault = verifyProject(*project)) {
        const auto isFaulty = [&](const Asset& asset) { return isCleaned(asset, found) && hasFaultyPrism(asset); };
        if (std::ranges::any_of(project->assets, isFaulty))
            *fault += " Points are counted without those that repeat others.";
        return Error{ErrorCode::BadInput, *fault};
    }
    if (notes) *notes = std::move(found);
    return project;
}

Result<Project> readProjectText(std::string_view json, const std::filesystem::path& path,
                                std::vector<Diagnostic>* notes) {
    if (isInterruptedSave(json)) return withPath("Cannot read", path, {ErrorCode::BadInput, interruptedSaveText(path)});
    Result<Project> project = readProjectText(json, notes, meshesIn(meshFolderOf(path)));
    if (!project) return withPath("Cannot read", path, project.error());
    return project;
}

Result<Project> loadProject(const std::filesystem::path& path, std::vector<Diagnostic>* notes) {
    const Result<std::string> text = readFile(path);
    if (!text) return text.error();
    return readProjectText(*text, path, notes);
}

Result<RecoveredProject> recoverProject(const std::filesystem::path& path, const std::filesystem::path& journal) {
    const Result<std::string> text = readFile(path);
    if (!text) return text.error();
    const Result<std::string> edits = journal.empty() ? std::string() : readFile(journal);
    if (!edits && edits.error().code != ErrorCode::NotFound) return edits.error();
    Result<RecoveredProject> project =
        readRecovered(*text, edits ? *edits : std::string(), meshesIn(meshFolderOf(path)));
    if (!project) return withPath("Cannot read", path, project.error());
    return project;
}

Status saveProject(const std::filesystem::path& path, const Project& project) {
    if (const std::optional<std::string> fault = verifyProject(project))
        return withPath("Cannot write", path, {ErrorCode::BadInput, *fault});
    const std::string text = projectText(project);
    if (const Status fits = checkJsonSize(text); !fits) return withPath("Cannot write", path, fits.error());
    if (const Status saved = saveMeshes(project, meshFolderOf(path)); !saved) return saved;
    return writeFileAtomically(path, text);
}

}  // namespace rubble
