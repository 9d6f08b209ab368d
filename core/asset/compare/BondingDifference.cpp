#include "core/asset/compare/BondingDifference.h"

#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"

#include <array>
#include <map>

namespace rubble {
namespace {

// In the order of their enumerators.
constexpr std::array<const char*, 2> kBreakAsTexts{"whole", "bonded"};
constexpr std::array<const char*, 3> kFalloffTexts{"constant", "linear", "smooth"};

template <class Enumeration, std::size_t Count>
std::string wordOf(const std::array<const char*, Count>& words, Enumeration enumerator) {
    return words[static_cast<std::size_t>(enumerator)];
}

std::string impulseText(std::optional<double> perArea) {
    return perArea ? messageText(*perArea) + " N·s/m²" : "from the material";
}

std::string spanText(double span) { return span > 0.0 ? messageText(span) + " m" : "any"; }

std::string islandText(std::uint32_t fragments) { return countText(fragments, "fragment", "fragments"); }

std::string heightsText(const std::vector<HeightStrength>& strengths) {
    std::string text;
    for (const auto& [height, factor] : strengths)
        text += (text.empty() ? "" : ", ") + messageText(factor) + " at " + messageText(height) + " m";
    return text.empty() ? "none" : text;
}

std::string imageText(const std::optional<StrengthImage>& strength) {
    if (!strength) return "none";
    const std::string range = messageText(strength->darkest) + " to " + messageText(strength->brightest);
    if (!strength->image) return range + ", no picture";
    return range + ", " + std::to_string(strength->image->width) + " x " + std::to_string(strength->image->height) +
           " pixels";
}

std::string pathsText(const std::vector<FragmentPath>& paths) {
    std::string text;
    for (const FragmentPath& path : paths) text += (text.empty() ? "" : ", ") + path;
    return text.empty() ? "none" : text;
}

/// "3 of level 0, 8 of level 1".
std::string clustersText(const std::vector<FragmentCluster>& clusters) {
    std::map<std::uint32_t, std::size_t> counts;
    for (const FragmentCluster& cluster : clusters) ++counts[cluster.level];
    std::string text;
    for (const auto& [level, count] : counts)
        text += (text.empty() ? "" : ", ") + std::to_string(count) + " of level " + std::to_string(level);
    return text.empty() ? "none" : text;
}

}  // namespace

std::vector<RecipeChange> bondingChanges(const Asset& before, const Asset& after) {
    std::vector<RecipeChange> changes;
    const auto add = [&](bool isSame, const char* what, const std::string& from, const std::string& to) {
        if (!isSame) changes.push_back({what, from, to == from ? to + ", changed" : to});
    };
    const Bonding &from = before.bonding, &to = after.bonding;
    const auto addText = [&](const char* what, const std::string& earlier, const std::string& later) {
        add(earlier == later, what, earlier, later);
    };
    addText("breaks as", wordOf(kBreakAsTexts, before.breakAs), wordOf(kBreakAsTexts, after.breakAs));
    addText("impulse per area of bonds", impulseText(from.impulsePerArea), impulseText(to.impulsePerArea));
    addText("radius of hits on bonds", messageText(from.radius) + " m", messageText(to.radius) + " m");
    addText("falloff of hits on bonds", wordOf(kFalloffTexts, from.falloff), wordOf(kFalloffTexts, to.falloff));
    addText("load that leaves damage", messageText(from.damageFrom), messageText(to.damageFrom));
    addText("span of bonds", spanText(from.span), spanText(to.span));
    addText("collapse delay", messageText(from.collapseDelay) + " s", messageText(to.collapseDelay) + " s");
    addText("least island", islandText(from.minimumIsland), islandText(to.minimumIsland));
    add(from.strokes == to.strokes, "strokes of bond brushes", std::to_string(from.strokes.size()),
        std::to_string(to.strokes.size()));
    addText("bond strength by height", heightsText(from.heightStrengths), heightsText(to.heightStrengths));
    add(from.strengthImage == to.strengthImage, "bond strength by picture", imageText(from.strengthImage),
        imageText(to.strengthImage));
    addText("fragments that never break", pathsText(from.neverBreaks), pathsText(to.neverBreaks));
    add(from.clusters == to.clusters, "clusters of fragments", clustersText(from.clusters), clustersText(to.clusters));
    return changes;
}

}  // namespace rubble
