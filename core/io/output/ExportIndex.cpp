#include "core/io/output/ExportIndex.h"

#include "core/base/MessageText.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/system/AtomicFile.h"

#include <algorithm>
#include <iterator>

namespace rubble {
namespace {

namespace fs = std::filesystem;

constexpr const char* kIndexFormat = "rubble-export";
constexpr std::uint32_t kIndexVersion = 1;

bool isPlainName(const std::string& name) {
    return !name.empty() && fs::path(name) == fs::path(name).filename() && name != "." && name != "..";
}

bool hasName(std::span<const std::string> names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

ExportIndex readIndexMembers(const JsonValue& root) {
    ExportIndex index;
    index.project.name = root["project"].text();
    if (root["identity"].isPresent()) index.project.identity = root["identity"].text();
    index.folders = root["folders"].list([](const JsonValue& folder) { return folder.text(); });
    index.files = readEntries(root);
    if (!root["assets"].isPresent()) return index;
    for (const JsonValue entry : root["assets"].elements()) {
        entry.requireObject({"folder", "asset", "variant"});
        index.assets[entry["folder"].text()] = {entry["asset"].index(), entry["variant"].index()};
    }
    return index;
}

}  // namespace

std::string exportIndexJson(const ExportIndex& index) {
    JsonWriter json;
    json.openObject();
    json.text("format", kIndexFormat);
    json.wholeNumber("version", std::uint64_t{kIndexVersion});
    json.text("project", index.project.name);
    if (!index.project.identity.empty()) json.text("identity", index.project.identity);
    json.openArray("folders");
    for (const std::string& folder : index.folders) json.text({}, folder);
    json.close();
    if (!index.assets.empty()) {
        json.openArray("assets");
        for (const auto& [folder, asset] : index.assets) {
            json.openObject({}, JsonLayout::Inline);
            json.text("folder", folder);
            json.wholeNumber("asset", std::uint64_t{asset.id});
            json.wholeNumber("variant", std::uint64_t{asset.variant});
            json.close();
        }
        json.close();
    }
    writeEntries(json, index.files);
    json.close();
    return std::move(json).finished();
}

Result<std::optional<ExportIndex>> readExportIndex(const fs::path& folder) {
    const fs::path path = folder / kIndexName;
    const Result<std::string> text = readFile(path);
    if (!text && text.error().code == ErrorCode::NotFound) return std::optional<ExportIndex>();
    if (!text) return text.error();
    const auto unreadable = [&](ErrorCode code, const std::string& reason) {
        return Error{code, quotedPath(path) + " is not the index of an export: " + reason +
                               " Move it first or export elsewhere."};
    };
    Result<JsonDocument> document = JsonDocument::parse(*text);
    if (!document) return unreadable(ErrorCode::BadInput, document.error().message);
    const JsonValue root = document->root();
    const bool isOfFormat = root.isObject() && root["format"].isPresent() && root["version"].isPresent() &&
                            root["format"].text() == kIndexFormat;
    if (!isOfFormat) return unreadable(ErrorCode::BadInput, "it is of another format.");
    if (root["version"].index() != kIndexVersion) return unreadable(ErrorCode::Unsupported, "its version is newer.");
    root.requireObject({"format", "version", "project", "folders", "files"}, {"identity", "assets"});
    ExportIndex index = readIndexMembers(root);
    if (const auto fault = document->firstError()) return unreadable(ErrorCode::BadInput, fault->message);
    const bool areHere = std::ranges::all_of(index.folders, isPlainName) &&
                         std::ranges::all_of(index.files, isPlainName, &ManifestEntry::name);
    if (!areHere) return unreadable(ErrorCode::BadInput, "it names folders or files elsewhere.");
    return std::optional(std::move(index));
}

bool isIndexOf(const std::optional<ExportIndex>& index, const IndexedProject& project) {
    if (!index) return false;
    const IndexedProject& listed = index->project;
    if (!listed.identity.empty() && !project.identity.empty()) return listed.identity == project.identity;
    return listed.name == project.name || listed.name.empty();
}

Status changeExportIndex(const fs::path& folder,
                         const std::function<ExportIndex(const std::optional<ExportIndex>&)>& change) {
    const Result<std::optional<ExportIndex>> earlier = readExportIndex(folder);
    if (!earlier) return earlier.error();
    const ExportIndex index = change(*earlier);
    const bool isEmpty = index.folders.empty() && index.files.empty();
    if (*earlier ? **earlier == index : isEmpty) return success();
    return writeFileAtomically(folder / kIndexName, exportIndexJson(index));
}

std::vector<std::string> staleFolders(const std::optional<ExportIndex>& earlier, const IndexedProject& project,
                                      std::span<const std::string> current) {
    std::vector<std::string> stale;
    if (!isIndexOf(earlier, project)) return stale;
    std::ranges::copy_if(earlier->folders, std::back_inserter(stale),
                         [&](const std::string& folder) { return !hasName(current, folder); });
    return stale;
}

ExportIndex indexAfterExport(const std::optional<ExportIndex>& earlier, const IndexedProject& project,
                             std::span<const std::string> current, const std::set<std::string>& exported,
                             std::span<const std::string> kept) {
    ExportIndex index{.project = project};
    const bool isSame = isIndexOf(earlier, project);
    for (const std::string& folder : current) {
        if (exported.contains(folder) || (isSame && hasName(earlier->folders, folder))) index.folders.push_back(folder);
    }
    index.folders.insert(index.folders.end(), kept.begin(), kept.end());
    if (isSame) index.files = earlier->files;
    return index;
}

}  // namespace rubble
