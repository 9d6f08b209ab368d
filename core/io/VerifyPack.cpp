#include "core/base/MessageText.h"
#include "core/io/PackFaults.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace rubble {
namespace {

using Fault = std::optional<std::string>;

/// Of a volume or a mass, relative: what the gaps of a partition and rounding may take.
constexpr double kRelative = 1e-8;

bool isNear(double value, double expected) { return std::abs(value - expected) <= kRelative * std::abs(expected); }

std::string ownerOf(const Pack& pack, const PackBody& body) {
    if (&body == &pack.whole) return "The whole: ";
    return "Fragment " + std::to_string(&body - pack.fragments.data()) + " \"" + body.id + "\": ";
}

Fault headFault(const Pack& pack) {
    const auto isDigit = [](char letter) {
        return (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'f');
    };
    if (pack.hash.size() != 32 || !std::ranges::all_of(pack.hash, isDigit))
        return "The hash \"" + pack.hash + "\" is not one of 32 hexadecimal digits.";
    if (pack.name.empty()) return "The asset has no name.";
    for (const PackMeshFile& mesh : pack.meshes) {
        const std::string owner = "The mesh \"" + mesh.name + "\" ";
        if (mesh.name.empty() || mesh.name.find('/') != std::string::npos) return owner + "is not a file of the pack.";
        const bool isOne = mesh.bodies == PackMeshBodies::Fragment;
        if (isOne != (mesh.fragment != kNone))
            return owner + "names a fragment where it holds none, or none where it holds one.";
        if (isOne && mesh.fragment >= pack.fragments.size())
            return owner + "holds fragment " + std::to_string(mesh.fragment) + ", which is not there.";
    }
    return std::nullopt;
}

Fault nameFault(const Pack& pack) {
    std::set<std::string_view> ids;
    std::set<std::string_view> names;
    const auto faultOf = [&](const PackBody& body) -> Fault {
        if (body.id.empty() || body.name.empty()) return ownerOf(pack, body) + "has no id or no name.";
        if (!ids.insert(body.id).second) return ownerOf(pack, body) + "the id \"" + body.id + "\" comes twice.";
        if (!names.insert(body.name).second) return ownerOf(pack, body) + "the name \"" + body.name + "\" comes twice.";
        return std::nullopt;
    };
    if (Fault fault = faultOf(pack.whole)) return fault;
    for (const PackBody& body : pack.fragments) {
        if (Fault fault = faultOf(body)) return fault;
    }
    return std::nullopt;
}

/// Parents stand before their pieces, and pieces are called after them.
Fault parentFault(const Pack& pack) {
    if (pack.whole.id != std::to_string(pack.asset))
        return "The whole is called \"" + pack.whole.id + "\", not after its asset.";
    if (pack.whole.parent != kNone) return std::string("The whole is a piece of something.");
    for (std::uint32_t k = 0; k < pack.fragments.size(); ++k) {
        const PackBody& body = pack.fragments[k];
        if (body.parent != kNone && body.parent >= k)
            return ownerOf(pack, body) + "its parent " + std::to_string(body.parent) + " does not stand before it.";
        const PackBody& parent = body.parent == kNone ? pack.whole : pack.fragments[body.parent];
        if (!body.id.starts_with(parent.id + "/"))
            return ownerOf(pack, body) + "is not called after its parent \"" + parent.id + "\".";
    }
    return std::nullopt;
}

Fault neighbourFault(const Pack& pack, std::uint32_t index) {
    const PackBody& body = pack.fragments[index];
    for (std::size_t k = 0; k < body.neighbours.size(); ++k) {
        const std::uint32_t other = body.neighbours[k].fragment;
        const std::string neighbour = ownerOf(pack, body) + "its neighbour " + std::to_string(other);
        if (other >= pack.fragments.size()) return neighbour + " is not there.";
        if (k > 0 && other <= body.neighbours[k - 1].fragment)
            return neighbour + " stands in the wrong place; they ascend.";
        if (other == index) return neighbour + " is itself.";
        if (pack.fragments[other].parent != body.parent) return neighbour + " is a piece of another body.";
        const std::vector<Bond>& theirs = pack.fragments[other].neighbours;
        const auto back = std::ranges::find(theirs, index, &Bond::fragment);
        if (back == theirs.end()) return neighbour + " does not have it as a neighbour.";
        if (!isNear(back->area, body.neighbours[k].area)) return neighbour + " shares another area with it.";
    }
    return std::nullopt;
}

/// Pieces fill what they are pieces of.
Fault volumeFault(const Pack& pack) {
    std::vector<double> sums(pack.fragments.size() + 1, 0.0);  // the whole's last
    for (const PackBody& body : pack.fragments)
        sums[std::min<std::size_t>(body.parent, pack.fragments.size())] += body.volume;
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const PackBody& body = k < pack.fragments.size() ? pack.fragments[k] : pack.whole;
        const bool isWithinGap = pack.gap > 0.0 && sums[k] < body.volume;
        if (sums[k] != 0.0 && !isWithinGap && !isNear(sums[k], body.volume)) {
            return ownerOf(pack, body) + "its pieces have " + messageText(sums[k]) + " m^3 in place of " +
                   messageText(body.volume) + " m^3.";
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> verifyPack(const Pack& pack) {
    if (Fault fault = headFault(pack)) return fault;
    if (Fault fault = nameFault(pack)) return fault;
    if (Fault fault = parentFault(pack)) return fault;
    if (!pack.whole.neighbours.empty()) return std::string("The whole has neighbours.");
    for (std::uint32_t k = 0; k < pack.fragments.size(); ++k) {
        if (Fault fault = neighbourFault(pack, k)) return fault;
    }
    const SolidScale scale = scaleOf(pack);
    if (Fault fault = solidFault(pack.whole, scale)) return ownerOf(pack, pack.whole) + *fault;
    for (const PackBody& body : pack.fragments) {
        if (Fault fault = solidFault(body, scale)) return ownerOf(pack, body) + *fault;
    }
    return volumeFault(pack);
}

}  // namespace rubble
