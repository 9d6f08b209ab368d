#include "core/io/ProjectFile.h"

#include "core/io/AssetJson.h"
#include "core/io/AtomicFile.h"
#include "core/io/FormatVersion.h"
#include "core/io/SceneJson.h"
#include "core/io/ShotJson.h"

#include <array>

namespace rubble {
namespace {

constexpr FileFormat kFormat{.name = "rubble-project", .noun = "project", .version = kProjectVersion};

/// How the parts of a project are read that are not the same in all versions.
struct Parts {
    Material (*material)(const JsonValue&);
    Asset (*asset)(const JsonValue&);
    Instance (*instance)(const JsonValue&);
};

/// What a project held from the first version on.
Project readCommon(const JsonValue& root, const Parts& read) {
    return {.nextId = root["nextId"].index(),
            .materials = root["materials"].listOf(read.material),
            .assets = root["assets"].listOf(read.asset),
            .instances = root["instances"].listOf(read.instance),
            .ground = readGround(root["ground"]),
            .gravity = readVector(root["gravity"]),
            .damage = readDamage(root["damage"]),
            .shots = root["shots"].listOf(readShot),
            .playTests = root["playTests"].listOf(readPlayTest)};
}

Project readVersion1(const JsonValue& root) {
    root.requireObject({"format", "version", "nextId", "materials", "assets", "instances", "ground", "gravity",
                        "damage", "shots", "playTests"});
    return readCommon(root, {readMaterialVersion1, readAssetVersion1, readInstanceVersion2});
}

/// With debris; of what else came after the first version its callers tell.
Project readWithDebris(const JsonValue& root, const Parts& read) {
    root.requireObject({"format", "version", "nextId", "materials", "assets", "instances", "ground", "gravity",
                        "damage", "debris", "shots", "playTests"});
    Project project = readCommon(root, read);
    project.debris = readDebris(root["debris"]);
    return project;
}

/// Knows debris, cuts at impact and intents.
Project readVersion2(const JsonValue& root) {
    return readWithDebris(root, {readMaterialVersion1, readAssetVersion2, readInstanceVersion2});
}

/// Knows variants of instances, and which are hidden and locked.
Project readVersion3(const JsonValue& root) {
    return readWithDebris(root, {readMaterialVersion1, readAssetVersion2, readInstance});
}

/// Knows what is done to pieces: small ones, gaps, roughness, merges and splits, fragments broken in their own way.
Project readVersion4(const JsonValue& root) {
    return readWithDebris(root, {readMaterialVersion1, readAssetVersion4, readInstance});
}

/// Knows strength and toughness of materials, and thresholds that follow from them.
Project readVersion5(const JsonValue& root) { return readWithDebris(root, {readMaterial, readAsset, readInstance}); }

/// How each version is read, the first at 0. A new version comes as one more reader; those of older ones stay, and fill
/// in what their files did not know.
constexpr std::array<Project (*)(const JsonValue&), kProjectVersion> kReaders{
    &readVersion1, &readVersion2, &readVersion3, &readVersion4, &readVersion5};

Result<Project> readAnyVersion(JsonDocument& document) {
    const Result<std::uint32_t> version = versionOf(document, kFormat);
    if (!version) return version.error();
    Project project = kReaders[*version - 1](document.root());
    if (document.fault()) return *document.fault();
    return project;
}

Error about(const char* what, const std::filesystem::path& path, const Error& error) {
    return {error.code, std::string(what) + " \"" + path.string() + "\": " + error.message};
}

}  // namespace

std::string projectText(const Project& project) {
    JsonLayout json;
    json.openObject();
    json.text("format", kFormat.name);
    json.wholeNumber("version", kProjectVersion);
    json.wholeNumber("nextId", project.nextId);
    json.list("materials", project.materials, writeMaterial);
    json.list("assets", project.assets, writeAsset);
    json.list("instances", project.instances, writeInstance);
    writeGround(json, project.ground);
    writeVector(json, "gravity", project.gravity);
    writeDamage(json, project.damage);
    writeDebris(json, project.debris);
    json.list("shots", project.shots, writeShot);
    json.list("playTests", project.playTests, writePlayTest);
    json.close();
    return std::move(json).finished();
}

Result<Project> readProjectText(std::string_view json) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    if (!document) return document.error();
    Result<Project> project = readAnyVersion(*document);
    if (!project) return project;
    if (const std::optional<std::string> fault = verifyProject(*project)) return Error{ErrorCode::BadInput, *fault};
    return project;
}

Result<Project> loadProject(const std::filesystem::path& path) {
    const Result<std::string> text = readFile(path);
    if (!text) return text.error();
    Result<Project> project = readProjectText(*text);
    if (!project) return about("Cannot read", path, project.error());
    return project;
}

Status saveProject(const std::filesystem::path& path, const Project& project) {
    if (const std::optional<std::string> fault = verifyProject(project))
        return about("Cannot write", path, {ErrorCode::BadInput, *fault});
    const std::string text = projectText(project);
    if (text.size() > kLargestJson) {
        return about("Cannot write", path, {ErrorCode::Limit, "The project is larger than 256 MiB."});
    }
    return writeFileAtomically(path, text);
}

}  // namespace rubble
