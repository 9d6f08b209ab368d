#include "app/cli/output/PackDifference.h"

#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/system/AtomicFile.h"

#include <algorithm>
#include <map>

namespace rubble {
namespace {

/// The path of a fragment, without the asset's id: "3.2/4.1" of "7/3.2/4.1"; "" for the whole.
std::string pathOf(const PackBody& body) {
    const std::size_t slash = body.id.find('/');
    return slash == std::string::npos ? "" : body.id.substr(slash + 1);
}

std::string pathOf(const Pack& pack, std::uint32_t fragment) {
    return fragment < pack.fragments.size() ? pathOf(pack.fragments[fragment]) : "";
}

/// The contacts of a body by the path of the neighbour, m².
std::map<std::string, double> contactsOf(const Pack& pack, const PackBody& body) {
    std::map<std::string, double> areas;
    for (const PackNeighbour& contact : body.neighbours) areas[pathOf(pack, contact.fragment)] = contact.area;
    return areas;
}

bool areHullsEqual(const PackBody& before, const PackBody& after) {
    return std::ranges::equal(before.hulls, after.hulls, [](const PackHull& one, const PackHull& other) {
        return one.polytope.vertices == other.polytope.vertices && one.polytope.faces == other.polytope.faces;
    });
}

std::vector<std::string> changedFields(const Pack& earlier, const PackBody& before, const Pack& later,
                                       const PackBody& after) {
    std::vector<std::string> fields;
    const auto compare = [&fields](const char* name, bool isEqual) {
        if (!isEqual) fields.emplace_back(name);
    };
    compare("parent", pathOf(earlier, before.parent) == pathOf(later, after.parent));
    compare("offset", before.offset == after.offset);
    compare("volume", before.volume == after.volume);
    compare("mass", before.mass == after.mass);
    compare("centre of mass", before.centreOfMass == after.centreOfMass);
    compare("inertia", before.inertia == after.inertia);
    compare("neighbours", contactsOf(earlier, before) == contactsOf(later, after));
    compare("threshold", before.threshold == after.threshold);
    compare("gap", before.gap == after.gap && before.lostMass == after.lostMass);
    compare("hulls", areHullsEqual(before, after));
    return fields;
}

std::string colourText(const Colour& colour) {
    return "(" + messageText(colour.red) + ", " + messageText(colour.green) + ", " + messageText(colour.blue) + ")";
}

std::string meshesText(const Pack& pack) {
    std::vector<std::string> names;
    for (const PackMeshFile& mesh : pack.meshes) names.push_back(mesh.name);
    return names.empty() ? "none" : quotedNames(names);
}

std::string placementText(const Pack& pack) {
    if (pack.meshes.empty()) return "none";
    return pack.meshes.front().place == PartPlacement::Centred ? "centred" : "assembled";
}

std::vector<RecipeChange> fieldChanges(const Pack& before, const Pack& after) {
    std::vector<RecipeChange> changes;
    const auto compare = [&changes](const char* what, const std::string& earlier, const std::string& later) {
        if (earlier != later) changes.push_back({what, earlier, later});
    };
    const auto compareNumber = [&](const char* what, double earlier, double later) {
        if (earlier != later) changes.push_back({what, messageText(earlier), messageText(later)});
    };
    const auto bonds = [](const Pack& pack) { return pack.bonding ? "yes" : "no"; };
    const Material &earlier = before.own(), &later = after.own();
    compare("asset", shownName(before.names.name), shownName(after.names.name));
    compareNumber("threshold in N·s", before.threshold, after.threshold);
    compare("material", shownName(earlier.name), shownName(later.name));
    compareNumber("density in kg/m³", earlier.density, later.density);
    compareNumber("friction", earlier.friction, later.friction);
    compareNumber("restitution", earlier.restitution, later.restitution);
    compare("outside colour", colourText(earlier.outside), colourText(later.outside));
    compare("inside colour", colourText(earlier.inside), colourText(later.inside));
    compareNumber("opacity", earlier.opacity, later.opacity);
    compareNumber("gap in m", before.gap, after.gap);
    compareNumber("inset in m", before.inset, after.inset);
    compare("breaks along bonds", bonds(before), bonds(after));
    compare("meshes", meshesText(before), meshesText(after));
    compare("placement", placementText(before), placementText(after));
    compare("hash", before.hash, after.hash);
    return changes;
}

/// Removed and added fragments, then changed ones with the whole before them.
std::vector<PackItemChange> fragmentChanges(const Pack& before, const Pack& after) {
    std::map<std::string, const PackBody*> earlier, later;
    for (const PackBody& fragment : before.fragments) earlier.emplace(pathOf(fragment), &fragment);
    for (const PackBody& fragment : after.fragments) later.emplace(pathOf(fragment), &fragment);
    std::vector<PackItemChange> removed, added, changed;
    const auto compare = [&](const std::string& path, const PackBody& one, const PackBody& other) {
        std::vector<std::string> fields = changedFields(before, one, after, other);
        if (!fields.empty()) changed.push_back({PackChange::Changed, path, std::move(fields)});
    };
    compare("", before.whole, after.whole);
    for (const PackBody& fragment : before.fragments) {
        if (!later.contains(pathOf(fragment)))
            removed.push_back({PackChange::Removed, pathOf(fragment), {}, fragment.volume});
    }
    for (const PackBody& fragment : after.fragments) {
        const auto found = earlier.find(pathOf(fragment));
        if (found != earlier.end()) {
            compare(found->first, *found->second, fragment);
        } else {
            added.push_back({PackChange::Added, pathOf(fragment), {}, fragment.volume});
        }
    }
    removed.insert(removed.end(), added.begin(), added.end());
    removed.insert(removed.end(), changed.begin(), changed.end());
    return removed;
}

std::vector<PackItemChange> fileChanges(const Manifest& before, const Manifest& after) {
    std::map<std::string, std::pair<std::string, std::string>> hashes;  // earlier and later
    for (const ManifestEntry& file : before.files) hashes[file.name].first = file.hash;
    for (const ManifestEntry& file : after.files) hashes[file.name].second = file.hash;
    std::vector<PackItemChange> changes;
    for (const auto& [name, hash] : hashes) {
        if (name == kPackName || hash.first == hash.second) continue;
        const PackChange change = hash.second.empty()  ? PackChange::Removed
                                  : hash.first.empty() ? PackChange::Added
                                                       : PackChange::Changed;
        changes.push_back({change, name});
    }
    return changes;
}

const char* changeWord(PackChange change) {
    switch (change) {
        case PackChange::Removed: return "removed";
        case PackChange::Added: return "added";
        case PackChange::Changed: break;
    }
    return "changed";
}

std::string fragmentText(const PackItemChange& fragment) {
    const std::string name = fragment.name.empty() ? "the whole" : fragment.name;
    std::string text = name + " " + changeWord(fragment.change);
    if (fragment.change != PackChange::Changed)
        return text + ", " + quantityText(QuantityKind::Volume, fragment.volume);
    for (std::size_t k = 0; k < fragment.fields.size(); ++k) text += (k == 0 ? ": " : ", ") + fragment.fields[k];
    return text;
}

std::string countsText(const PackDifference& difference) {
    std::string text = countText(difference.after, "fragment", "fragments");
    if (difference.before != difference.after) text += ", were " + std::to_string(difference.before);
    std::string separator = ": ";
    for (const PackChange change : {PackChange::Removed, PackChange::Added, PackChange::Changed}) {
        const auto count = std::ranges::count_if(difference.fragments, [&](const PackItemChange& fragment) {
            return fragment.change == change && !fragment.name.empty();
        });
        if (count == 0) continue;
        text += separator + std::to_string(count) + " " + changeWord(change);
        separator = ", ";
    }
    return text;
}

void writeFragmentChange(JsonWriter& json, const PackItemChange& fragment) {
    json.openObject({}, JsonLayout::Inline);
    json.text("path", fragment.name);
    json.text("change", changeWord(fragment.change));
    if (fragment.change != PackChange::Changed) {
        json.number("volume", fragment.volume);
    } else {
        json.openArray("fields");
        for (const std::string& field : fragment.fields) json.text({}, field);
        json.close();
    }
    json.close();
}

void writeDifference(JsonWriter& json, const PackDifference& difference) {
    json.openObject();
    json.text("name", printableText(difference.name));
    json.text("state", difference.change ? changeWord(*difference.change) : "same");
    json.wholeNumber("fragmentsBefore", std::uint64_t{difference.before});
    json.wholeNumber("fragmentsAfter", std::uint64_t{difference.after});
    json.list("fields", difference.fields, [](JsonWriter& list, const RecipeChange& change) {
        list.openObject({}, JsonLayout::Inline);
        list.text("what", change.what);
        list.text("before", change.before);
        list.text("after", change.after);
        list.close();
    });
    json.list("fragments", difference.fragments, writeFragmentChange);
    json.list("files", difference.files, [](JsonWriter& list, const PackItemChange& file) {
        list.openObject({}, JsonLayout::Inline);
        list.text("name", printableText(file.name));
        list.text("change", changeWord(file.change));
        list.close();
    });
    json.close();
}

}  // namespace

Result<ExportedPack> loadExportedPack(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / kPackName;
    const Result<std::string> json = readFile(path, Links::Refused);
    if (!json) return json.error();
    Result<Pack> pack = readPack(*json);
    if (!pack) return Error{pack.error().code, path.string() + ": " + pack.error().message};
    return ExportedPack{std::move(*pack), readManifest(folder)};
}

PackDifference packDifference(const ExportedPack* before, const ExportedPack* after) {
    PackDifference difference{.name = (after != nullptr ? after : before)->pack.names.name};
    if (before != nullptr) difference.before = before->pack.fragments.size();
    if (after != nullptr) difference.after = after->pack.fragments.size();
    if (before == nullptr || after == nullptr) {
        difference.change = before == nullptr ? PackChange::Added : PackChange::Removed;
        return difference;
    }
    difference.fields = fieldChanges(before->pack, after->pack);
    difference.fragments = fragmentChanges(before->pack, after->pack);
    if (before->manifest && after->manifest) difference.files = fileChanges(*before->manifest, *after->manifest);
    const bool isSame = difference.fields.empty() && difference.fragments.empty() && difference.files.empty();
    if (!isSame) difference.change = PackChange::Changed;
    return difference;
}

std::string packDifferenceText(const PackDifference& difference, std::size_t most) {
    const std::string name = shownName(difference.name);
    if (!difference.change) return name + ": same\n";
    if (difference.change == PackChange::Added)
        return name + ": added, " + countText(difference.after, "fragment", "fragments") + "\n";
    if (difference.change == PackChange::Removed)
        return name + ": removed, had " + countText(difference.before, "fragment", "fragments") + "\n";
    std::string text = name + ": changed\n";
    for (const RecipeChange& change : difference.fields) text += "  " + sentenceOf(change) + '\n';
    if (!difference.fragments.empty()) text += "  " + countsText(difference) + '\n';
    std::map<PackChange, std::size_t> counts;
    for (const PackItemChange& fragment : difference.fragments) {
        if (counts[fragment.change]++ < most) text += "  " + fragmentText(fragment) + '\n';
    }
    for (const auto& [change, count] : counts) {
        if (count <= most) continue;
        const std::string more = std::to_string(count - most) + " more " + changeWord(change);
        text += "  … and " + more + "; --all lists them\n";
    }
    for (const PackItemChange& file : difference.files)
        text += "  file " + shownName(file.name) + " " + changeWord(file.change) + '\n';
    return text;
}

std::string packDifferencesJson(std::span<const PackDifference> differences) {
    JsonWriter json;
    json.openObject();
    json.boolean("isSame",
                 std::ranges::none_of(differences, [](const PackDifference& one) { return one.change.has_value(); }));
    json.list("packs", differences, writeDifference);
    json.close();
    return std::move(json).finished();
}

}  // namespace rubble
