#include "core/io/project/ProjectJournal.h"

#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/project/ProjectFile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

namespace rubble {
namespace {

constexpr std::string_view kJournalFormat = "rubble-journal 1 ";

using Ids = std::vector<Id>;
constexpr std::array<std::pair<const char*, Ids ProjectPart::*>, 7> kIdLists{
    {{"removedMaterials", &ProjectPart::removedMaterials},
     {"removedAssets", &ProjectPart::removedAssets},
     {"removedInstances", &ProjectPart::removedInstances},
     {"removedShots", &ProjectPart::removedShots},
     {"removedPlayTests", &ProjectPart::removedPlayTests},
     {"removedMortars", &ProjectPart::removedMortars},
     {"keptTextures", &ProjectPart::keptTextures}}};

std::string idsText(const ProjectPart& part) {
    JsonWriter json;
    json.openObject();
    for (const auto& [name, list] : kIdLists) json.wholeNumbers(name, part.*list);
    json.close();
    return std::move(json).finished();
}

Status readIds(std::string_view text, ProjectPart& part) {
    Result<JsonDocument> document = JsonDocument::parse(text);
    if (!document) return document.error();
    const JsonValue root = document->root();
    for (const auto& [name, list] : kIdLists)
        part.*list = root[name].list([](const JsonValue& id) { return id.index(1); });
    return document->firstError() ? Status(*document->firstError()) : success();
}

/// The seal of a record: of its two texts, and all before it.
ContentHash sealed(const ContentHash& before, std::string_view ids, std::string_view values) {
    Hasher hasher;
    hasher.add(before.high);
    hasher.add(before.low);
    hasher.add(std::uint64_t{ids.size()});
    hasher.add(ids);
    hasher.add(values);
    return hasher.digest();
}

/// Takes a number and the character behind it from the start of a text.
std::optional<std::size_t> takeNumber(std::string_view& text, char end) {
    std::size_t number = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || stop == text.data() + text.size() || *stop != end) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()) + 1);
    return number;
}

/// The two texts of a record.
struct RecordTexts {
    std::string_view ids, values;
};

/// Takes the first record from a journal; nothing if it is not whole, or does not follow what `seal` is of.
std::optional<RecordTexts> takeRecord(std::string_view& journal, ContentHash& seal) {
    constexpr std::size_t kHexDigits = 32;
    std::string_view rest = journal;
    const std::optional<std::size_t> idBytes = takeNumber(rest, ' ');
    const std::optional<std::size_t> valueBytes = idBytes ? takeNumber(rest, ' ') : std::nullopt;
    if (!valueBytes || rest.size() <= kHexDigits || rest[kHexDigits] != '\n') return std::nullopt;
    const std::optional<ContentHash> written = parseContentHash(rest.substr(0, kHexDigits));
    rest.remove_prefix(kHexDigits + 1);
    if (!written || rest.size() < *idBytes || rest.size() - *idBytes < *valueBytes) return std::nullopt;
    const RecordTexts record{rest.substr(0, *idBytes), rest.substr(*idBytes, *valueBytes)};
    if (sealed(seal, record.ids, record.values) != *written) return std::nullopt;
    seal = *written;
    journal = rest.substr(*idBytes + *valueBytes);
    return record;
}

template <class Element>
void replaceElements(std::vector<Element>& list, std::vector<Element>&& values, const Ids& removed) {
    std::erase_if(list, [&](const Element& element) { return std::ranges::binary_search(removed, element.id); });
    for (Element& value : values) {
        const auto at = std::ranges::lower_bound(list, value.id, {}, &Element::id);
        if (at != list.end() && at->id == value.id) {
            *at = std::move(value);
        } else {
            list.insert(at, std::move(value));
        }
    }
}

/// Exchanges what a record has.
void apply(Project& project, ProjectPart&& part) {
    Project& values = part.values;
    for (Asset& asset : values.assets) {
        const bool keepsTexture = std::ranges::find(part.keptTextures, asset.id) != part.keptTextures.end();
        if (const Asset* before = findAsset(project, asset.id); keepsTexture && before) asset.texture = before->texture;
    }
    replaceElements(project.materials, std::move(values.materials), part.removedMaterials);
    replaceElements(project.assets, std::move(values.assets), part.removedAssets);
    replaceElements(project.instances, std::move(values.instances), part.removedInstances);
    replaceElements(project.shots, std::move(values.shots), part.removedShots);
    replaceElements(project.playTests, std::move(values.playTests), part.removedPlayTests);
    replaceElements(project.mortars, std::move(values.mortars), part.removedMortars);
    project.nextId = values.nextId;
    project.ground = values.ground;
    project.gravity = values.gravity;
    project.damage = values.damage;
    project.debris = values.debris;
    project.events = values.events;
}

}  // namespace

std::string journalStart(const ContentHash& text) { return std::string(kJournalFormat) + text.hex() + '\n'; }

std::string journalRecord(const ProjectPart& part, ContentHash& seal) {
    const std::string ids = idsText(part), values = projectText(part.values);
    seal = sealed(seal, ids, values);
    return std::to_string(ids.size()) + ' ' + std::to_string(values.size()) + ' ' + seal.hex() + '\n' + ids + values;
}

Result<Project> replayed(Project project, const ContentHash& text, std::string_view journal, const MeshSource& meshes) {
    if (!journal.starts_with(journalStart(text))) return project;
    journal.remove_prefix(journalStart(text).size());
    ContentHash seal = text;
    while (const std::optional<RecordTexts> record = takeRecord(journal, seal)) {
        ProjectPart part;
        if (const Status read = readIds(record->ids, part); !read) return read.error();
        Result<Project> values = readProjectPart(record->values, meshes);
        if (!values) return values.error();
        part.values = std::move(*values);
        apply(project, std::move(part));
    }
    return project;
}

}  // namespace rubble
