#include "core/base/MessageText.h"
#include "core/io/pack/VerifyPackBody.h"
#include "core/io/pack/VerifyPackBonding.h"
#include "core/io/pack/VerifyPackContacts.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace rubble {
namespace {

using ErrorText = std::optional<std::string>;

/// The relative tolerance of volumes and areas: the gaps of a partition and rounding.
constexpr double kTolerance = 1e-8;

bool isNear(double value, double expected) { return std::abs(value - expected) <= kTolerance * std::abs(expected); }

std::string ownerOf(const Pack& pack, const PackBody& body) {
    if (&body == &pack.whole) return "The whole: ";
    return "Fragment " + std::to_string(&body - pack.fragments.data()) + " " + quotedName(body.id) + ": ";
}

ErrorText verifyHash(const std::string& name, const std::string& hash) {
    const auto isDigit = [](char letter) {
        return (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'f');
    };
    if (hash.size() != 32 || !std::ranges::all_of(hash, isDigit))
        return name + " " + quotedName(hash) + " is not 32 hexadecimal digits.";
    if (hash == std::string(hash.size(), '0')) return name + " is zero.";
    return std::nullopt;
}

ErrorText verifyMeshFiles(const Pack& pack) {
    for (const PackMeshFile& mesh : pack.meshes) {
        const std::string owner = "The mesh " + quotedName(mesh.name) + " ";
        if (mesh.name.empty() || mesh.name.find('/') != std::string::npos) return owner + "is not a file of the pack.";
        const bool isOne = mesh.bodies == PackMeshBodies::Fragment;
        if (isOne != (mesh.fragment != kNone))
            return owner + "must name a fragment if it contains exactly one, and only then.";
        if (isOne && mesh.fragment >= pack.fragments.size())
            return owner + "refers to fragment " + std::to_string(mesh.fragment) + ", which does not exist.";
        if (mesh.level && mesh.bodies != PackMeshBodies::Fragments) return owner + "has a level, but not of fragments.";
        const auto isOfLevel = [&](const PackBody& body) { return body.childCount > 0 && body.level == *mesh.level; };
        if (mesh.level && std::ranges::none_of(pack.fragments, isOfLevel))
            return owner + "holds the fragments of level " + std::to_string(*mesh.level) + ", of which none breaks.";
    }
    return std::nullopt;
}

ErrorText verifyHeader(const Pack& pack) {
    if (ErrorText error = verifyHash("The hash", pack.hash)) return error;
    if (pack.names.name.empty()) return "The asset has no name.";
    if (ErrorText error = verifyMeshFiles(pack)) return error;
    if (pack.version < 2) return std::nullopt;
    if (ErrorText error = verifyHash("The hash of the physics", pack.physicsHash)) return error;
    if (pack.names.folder.empty() || pack.names.base.empty()) return "The asset has no folder or no base.";
    if ((pack.breaking.as == BreakAs::Bonded) != pack.bonding.has_value())
        return "The asset must have bonds if it breaks bonded, and only then.";
    return std::nullopt;
}

/// Levels ascend with parents, and the children of a body are consecutive.
ErrorText verifyLevels(const Pack& pack) {
    if (pack.version < 2) return std::nullopt;
    std::vector<std::uint32_t> first(pack.fragments.size() + 1, kNone), count(first.size(), 0);  // the whole's last
    for (std::uint32_t k = 0; k < pack.fragments.size(); ++k) {
        const PackBody& body = pack.fragments[k];
        const std::size_t parent = std::min<std::size_t>(body.parent, pack.fragments.size());
        const std::uint32_t level = body.parent == kNone ? 0 : pack.fragments[body.parent].level + 1;
        if (body.level != level) return ownerOf(pack, body) + "its level is not that of its parent and one.";
        if (first[parent] == kNone) first[parent] = k;
        if (k != first[parent] + count[parent]++)
            return ownerOf(pack, body) + "it does not follow the other fragments of its parent.";
    }
    for (std::size_t k = 0; k < first.size(); ++k) {
        const PackBody& body = k < pack.fragments.size() ? pack.fragments[k] : pack.whole;
        const bool isRight = body.childCount == count[k] && (count[k] == 0 || body.firstChild == first[k]);
        if (!isRight) return ownerOf(pack, body) + "its first child or the number of its children is wrong.";
        const bool hasThreshold = &body == &pack.whole || body.childCount > 0;
        if (body.threshold.has_value() != hasThreshold)
            return ownerOf(pack, body) + "it must have a threshold if it breaks, and only then.";
    }
    if (pack.whole.level != 0) return "The whole has a level.";
    if (pack.whole.threshold != pack.threshold) return "The thresholds of the pack and of the whole differ.";
    return std::nullopt;
}

ErrorText verifyNames(const Pack& pack) {
    std::set<std::string_view> ids;
    std::set<std::string_view> names;
    const auto verifyBodyName = [&](const PackBody& body) -> ErrorText {
        if (body.id.empty() || body.name.empty()) return ownerOf(pack, body) + "it has no id or no name.";
        if (body.name.find(' ') != std::string::npos)
            return ownerOf(pack, body) + "its name " + quotedName(body.name) + " has a space.";
        if (!ids.insert(body.id).second)
            return ownerOf(pack, body) + "the id " + quotedName(body.id) + " is used twice.";
        if (!names.insert(body.name).second)
            return ownerOf(pack, body) + "the name " + quotedName(body.name) + " is used twice.";
        return std::nullopt;
    };
    if (ErrorText error = verifyBodyName(pack.whole)) return error;
    for (const PackBody& body : pack.fragments) {
        if (ErrorText error = verifyBodyName(body)) return error;
    }
    return std::nullopt;
}

/// Whether a part of an id names cells and a piece of them: "5.17", "5.17.1", "5.17+8.2.1".
bool isPieceName(std::string_view name) {
    std::size_t numbers = 0;  // since the last '+'
    for (bool isMore = true; isMore;) {
        std::size_t digits = 0;
        while (digits < name.size() && name[digits] >= '0' && name[digits] <= '9') ++digits;
        if (digits == 0) return false;
        ++numbers;
        name.remove_prefix(digits);
        if (name.empty()) break;
        const char next = name[0];
        name.remove_prefix(1);
        if (next == '+' && numbers != 2) return false;
        if (next == '+') numbers = 0;
        isMore = next == '+' || next == '.';
        if (!isMore || numbers > 2) return false;
    }
    return numbers == 2 || numbers == 3;
}

/// Parents precede their children, whose ids start with the parent's.
ErrorText verifyParents(const Pack& pack) {
    if (pack.whole.id != std::to_string(pack.asset))
        return "The id of the whole is " + quotedName(pack.whole.id) + " instead of the asset's.";
    if (pack.whole.parent != kNone) return std::string("The whole has a parent.");
    for (std::uint32_t k = 0; k < pack.fragments.size(); ++k) {
        const PackBody& body = pack.fragments[k];
        if (body.parent != kNone && body.parent >= k)
            return ownerOf(pack, body) + "its parent " + std::to_string(body.parent) + " does not precede it.";
        const PackBody& parent = body.parent == kNone ? pack.whole : pack.fragments[body.parent];
        if (!body.id.starts_with(parent.id + "/"))
            return ownerOf(pack, body) + "its id does not start with its parent's " + quotedName(parent.id) + ".";
        if (!isPieceName(std::string_view(body.id).substr(parent.id.size() + 1)))
            return ownerOf(pack, body) + "its id does not name a seed or a cell after its parent's.";
    }
    return std::nullopt;
}

ErrorText verifyNeighbours(const Pack& pack, std::uint32_t index) {
    const PackBody& body = pack.fragments[index];
    for (std::size_t k = 0; k < body.neighbours.size(); ++k) {
        const std::uint32_t other = body.neighbours[k].fragment;
        const std::string neighbour = ownerOf(pack, body) + "its neighbour " + std::to_string(other);
        if (other >= pack.fragments.size()) return neighbour + " does not exist.";
        if (k > 0 && other <= body.neighbours[k - 1].fragment)
            return neighbour + " is out of order; neighbours must ascend.";
        if (other == index) return neighbour + " is itself.";
        if (pack.fragments[other].parent != body.parent) return neighbour + " has another parent.";
        const std::vector<PackNeighbour>& theirs = pack.fragments[other].neighbours;
        const auto back = std::ranges::find(theirs, index, &PackNeighbour::fragment);
        if (back == theirs.end()) return neighbour + " does not list it as a neighbour.";
        if (!isNear(back->area, body.neighbours[k].area)) return neighbour + " states a different shared area.";
        const bool hasFace = pack.version >= 2 && other > index;
        if (body.neighbours[k].centroid.has_value() != hasFace || body.neighbours[k].normal.has_value() != hasFace)
            return neighbour + " must have centroid and normal if it has the larger index, and only then.";
        if (hasFace && !(std::abs(glm::length(*body.neighbours[k].normal) - 1.0) <= kTolerance))
            return neighbour + " has a normal that is not of length 1.";
    }
    return std::nullopt;
}

/// The masses of children sum to their parent's, less what the gap takes.
ErrorText verifyMassOfChildren(const PackBody& body, double sum, bool isGapKnown) {
    if (sum == 0.0) return body.gap == 0.0 ? std::nullopt : ErrorText("it has a gap, but no fragments.");
    if (!isGapKnown && sum < body.mass) return std::nullopt;
    if (isNear(sum + body.lostMass, body.mass)) return std::nullopt;
    const std::string lost =
        body.gap > 0.0 ? ", and the gap takes " + messageText(body.lostMass) + " kg," : std::string();
    return "its children have a mass of " + messageText(sum) + " kg" + lost + " instead of " + messageText(body.mass) +
           " kg.";
}

/// The gap of the pack is the widest of its bodies. Earlier versions wrote it there only, and without the mortar.
ErrorText verifyGaps(const Pack& pack) {
    double widest = pack.whole.gap;
    for (const PackBody& body : pack.fragments) widest = std::max(widest, body.gap);
    const bool isGapKnown = widest > 0.0 || pack.gap == 0.0;
    if (isGapKnown && widest != pack.gap) {
        return "The gap of the asset is " + messageText(pack.gap) + " m instead of the widest of its bodies, " +
               messageText(widest) + " m.";
    }
    std::vector<double> sums(pack.fragments.size() + 1, 0.0);  // the whole's last
    for (const PackBody& body : pack.fragments)
        sums[std::min<std::size_t>(body.parent, pack.fragments.size())] += body.mass;
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const PackBody& body = k < pack.fragments.size() ? pack.fragments[k] : pack.whole;
        if (ErrorText error = verifyMassOfChildren(body, sums[k], isGapKnown)) return ownerOf(pack, body) + *error;
    }
    return std::nullopt;
}

/// The centre of mass of the children is their parent's, up to what a gap may shift it by.
ErrorText verifyOffsets(const Pack& pack, double size) {
    const std::size_t count = pack.fragments.size();
    std::vector<Vec3> sums(count + 1, Vec3(0.0));  // the whole's last
    std::vector<double> masses(count + 1, 0.0);
    for (const PackBody& body : pack.fragments) {
        const std::size_t parent = std::min<std::size_t>(body.parent, count);
        const Vec3 origin = parent < count ? pack.fragments[parent].offset : pack.whole.offset;
        sums[parent] += body.mass * (body.offset - origin);
        masses[parent] += body.mass;
    }
    for (std::size_t k = 0; k <= count; ++k) {
        const PackBody& body = k < count ? pack.fragments[k] : pack.whole;
        if (masses[k] == 0.0) continue;
        const double lost = std::max(0.0, body.mass - masses[k]) / body.mass;
        const double slack =
            (kTolerance + (pack.gap > 0.0 ? lost : 0.0)) * (size + kTolerance * glm::length(body.offset));
        if (const double off = glm::length(sums[k]) / masses[k]; !(off <= slack)) {
            return ownerOf(pack, body) + "the centre of mass of its children is " + messageText(off) +
                   " m beside its own.";
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> verifyPack(const Pack& pack) {
    if (ErrorText error = verifyHeader(pack)) return error;
    if (ErrorText error = verifyNames(pack)) return error;
    if (ErrorText error = verifyParents(pack)) return error;
    if (ErrorText error = verifyLevels(pack)) return error;
    if (!pack.whole.neighbours.empty()) return std::string("The whole has neighbours.");
    for (std::uint32_t k = 0; k < pack.fragments.size(); ++k) {
        if (ErrorText error = verifyNeighbours(pack, k)) return error;
    }
    const PackScale scale = scaleOf(pack);
    if (ErrorText error = verifyPackBody(pack.whole, scale)) return ownerOf(pack, pack.whole) + *error;
    for (const PackBody& body : pack.fragments) {
        if (ErrorText error = verifyPackBody(body, scale)) return ownerOf(pack, body) + *error;
    }
    if (ErrorText error = verifyGaps(pack)) return error;
    if (ErrorText error = verifyOffsets(pack, scale.size)) return error;
    if (ErrorText error = verifyPackContacts(pack)) return error;
    return verifyPackBonding(pack);
}

}  // namespace rubble
