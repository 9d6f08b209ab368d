#include "core/play/scene/SupportProblems.h"

#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/play/scene/HangingLoads.h"
#include "core/structure/graph/Islands.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace rubble {
namespace {

/// The distance of a node from an anchor at the start where it is beyond the span, m; at most the span elsewhere.
double distanceAtStart(const PlayStructure& structure, std::uint32_t node) {
    const double limit = structure.supportLimits[node];
    return structure.mortar.empty() ? limit : limit * structure.span;
}

/// The numbers of nodes' fragments in the bake.
std::vector<std::uint32_t> fragmentsOf(const PlayStructure& structure, const std::vector<std::uint32_t>& nodes) {
    std::vector<std::uint32_t> fragments;
    for (const std::uint32_t node : nodes) fragments.push_back(structure.fragmentOf(node));
    return fragments;
}

std::string sentenceOf(const PlayStructure& structure, const Instance& instance, std::size_t count, double farthest,
                       const std::string& id) {
    const std::string span = quantityText(QuantityKind::Length, structure.span);
    std::string sentence = "Instance " + quotedName(instance.name) + ": " +
                           countText(count, "fragment is", "fragments are") + " beyond the span of " + span;
    const bool isOne = count == 1;
    sentence += (isOne ? ": fragment " : "; the farthest, fragment ") + id;
    sentence += std::isfinite(farthest) ? ", by " + quantityText(QuantityKind::Length, farthest - structure.span)
                                        : std::string(isOne ? "" : ",") + " has no support from below or from a side";
    sentence += isOne ? ". It stays until it loses a part of its support"
                      : ". They stay until they lose a part of their support";
    return sentence + "; lengthen the span, or add anchors.";
}

Diagnostic problemOf(const PlayStructure& structure, const Instance& instance,
                     const std::vector<std::uint32_t>& beyond) {
    const auto distance = [&](std::uint32_t node) { return distanceAtStart(structure, node); };
    const std::uint32_t node = *std::ranges::max_element(beyond, {}, distance);
    const double farthest = distance(node);
    const std::uint32_t fragment = structure.fragmentOf(node);
    const std::string path = structure.asset->bake->fragmentPath(fragment);
    const Vec3& centre = structure.graph.centres[node];
    Diagnostic problem = diagnostic(
        DiagnosticCode::BeyondSpan,
        {.asset = instance.asset,
         .fragment = fragment,
         .path = path,
         .fragments = fragmentsOf(structure, beyond),
         .point = DiagnosticPlace::Point{centre.x, centre.y}},
        sentenceOf(structure, instance, beyond.size(), farthest, structure.asset->bake->fragmentId(fragment)));
    if (!std::isfinite(farthest)) return problem;
    problem.value = farthest;
    problem.limit = structure.span;
    return problem;
}

/// The problem of bonds of an instance that take less than hangs on them; nothing if none do.
std::optional<Diagnostic> weakBondsOf(const PlayStructure& structure, const Instance& instance,
                                      std::span<const HangingLoad> loads) {
    const auto isOver = [](const HangingLoad& one) { return one.load > one.strength; };
    std::vector<std::uint32_t> over;
    for (const HangingLoad& one : loads) {
        if (isOver(one)) over.push_back(one.node);
    }
    const std::size_t count = over.size();
    if (count == 0) return std::nullopt;
    const HangingLoad& worst = *std::ranges::max_element(
        loads, {}, [](const HangingLoad& one) { return one.strength > 0.0 ? one.load / one.strength : 1e300; });
    const std::uint32_t fragment = structure.fragmentOf(worst.node);
    const Vec3& centre = structure.graph.centres[worst.node];
    const std::string id = structure.asset->bake->fragmentId(fragment);
    std::string sentence = "Instance " + quotedName(instance.name) + ": ";
    sentence += count == 1 ? "fragment " + id + " hangs on less than its weight needs, "
                           : countText(count, "fragment", "fragments") +
                                 " hang on less than their weight needs; the worst, fragment " + id + ", ";
    const bool isMortar = worst.mortar > 0.5;
    sentence += std::string("on ") + (isMortar ? "mortar that takes " : "bonds that take ") +
                quantityText(QuantityKind::Force, worst.strength) + " of " +
                quantityText(QuantityKind::Force, worst.load) +
                ", by an estimate. Play does not break bonds by weight alone; raise the impulse per area" +
                (isMortar ? " of the mortar" : "") + ", or add support from below.";
    return diagnostic(DiagnosticCode::WeakBonds,
                      {.asset = instance.asset,
                       .fragment = fragment,
                       .path = structure.asset->bake->fragmentPath(fragment),
                       .fragments = fragmentsOf(structure, over),
                       .point = DiagnosticPlace::Point{centre.x, centre.y}},
                      std::move(sentence), worst.load, worst.strength);
}

}  // namespace

std::vector<std::uint32_t> nodesBeyondSpan(const PlayStructure& structure) {
    if (structure.supportLimits.empty()) return {};
    std::vector<std::uint32_t> nodes(structure.nodeCount());
    std::iota(nodes.begin(), nodes.end(), 0u);
    std::vector<std::uint32_t> beyond;
    const Islands islands = islandsOf(structure.graph, structure.initialDamage, nodes);
    for (std::uint32_t k = 0; k < islands.count(); ++k) {
        if (!islands[k].isAnchored) continue;
        std::ranges::copy_if(islands[k].nodes, std::back_inserter(beyond),
                             [&](std::uint32_t node) { return distanceAtStart(structure, node) > structure.span; });
    }
    std::ranges::sort(beyond);
    return beyond;
}

std::vector<Diagnostic> supportProblems(const PlayScene& scene) {
    std::vector<Diagnostic> problems;
    const std::vector<HangingLoad> loads = hangingLoads(scene);
    for (const Instance& instance : scene.project.instances) {
        const auto found = scene.structures.find(instance.id);
        if (found == scene.structures.end()) continue;
        const std::vector<std::uint32_t> beyond = nodesBeyondSpan(*found->second);
        if (!beyond.empty()) problems.push_back(problemOf(*found->second, instance, beyond));
        const auto own = std::ranges::equal_range(loads, instance.id, {}, &HangingLoad::instance);
        if (auto problem = weakBondsOf(*found->second, instance, own)) problems.push_back(std::move(*problem));
    }
    return problems;
}

bool isOfSupport(const Diagnostic& diagnostic) {
    using enum DiagnosticCode;
    return diagnostic.code == IdleMortar || diagnostic.code == BeyondSpan || diagnostic.code == WeakBonds;
}

bool mayHaveSceneProblems(const Project& project) {
    const auto isHeldBonded = [&](const Instance& instance) {
        const Asset* asset = findAsset(project, instance.asset);
        return asset->breakAs == BreakAs::Bonded && isHeldInPlace(project, *asset, instance);
    };
    return !project.mortars.empty() || std::ranges::any_of(project.instances, isHeldBonded);
}

std::vector<Diagnostic> sceneProblems(const Project& project, const AssetBakes& bakes, const TaskContext& task) {
    if (!mayHaveSceneProblems(project)) return {};
    const Result<std::shared_ptr<const PlayScene>> scene = playScene(project, bakes, task, FindContacts::OnBreak);
    if (!scene) return {};
    std::vector<Diagnostic> problems = (*scene)->diagnostics;
    std::erase_if(problems, std::not_fn(isOfSupport));
    return problems;
}

}  // namespace rubble
