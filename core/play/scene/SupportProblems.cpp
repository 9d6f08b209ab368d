#include "core/play/scene/SupportProblems.h"

#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/structure/graph/Islands.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rubble {
namespace {

/// The distance of a node from an anchor at the start where it is beyond the span, m; at most the span elsewhere.
double distanceAtStart(const PlayStructure& structure, std::uint32_t node) {
    const double limit = structure.supportLimits[node];
    return structure.mortar.empty() ? limit : limit * structure.span;
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
         .point = DiagnosticPlace::Point{centre.x, centre.y}},
        sentenceOf(structure, instance, beyond.size(), farthest, structure.asset->bake->fragmentId(fragment)));
    if (!std::isfinite(farthest)) return problem;
    problem.value = farthest;
    problem.limit = structure.span;
    return problem;
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
    for (const Instance& instance : scene.project.instances) {
        const auto found = scene.structures.find(instance.id);
        if (found == scene.structures.end()) continue;
        const std::vector<std::uint32_t> beyond = nodesBeyondSpan(*found->second);
        if (!beyond.empty()) problems.push_back(problemOf(*found->second, instance, beyond));
    }
    return problems;
}

bool mayHaveSceneProblems(const Project& project) {
    const auto hasSpan = [](const Asset& asset) {
        return asset.breakAs == BreakAs::Bonded && asset.bonding.span > 0.0;
    };
    return !project.mortars.empty() || std::ranges::any_of(project.assets, hasSpan);
}

std::vector<Diagnostic> sceneProblems(const Project& project, const AssetBakes& bakes, const TaskContext& task) {
    if (!mayHaveSceneProblems(project)) return {};
    const Result<std::shared_ptr<const PlayScene>> scene = playScene(project, bakes, task, FindContacts::OnBreak);
    if (!scene) return {};
    std::vector<Diagnostic> problems = (*scene)->diagnostics;
    std::erase_if(problems, [](const Diagnostic& one) {
        return one.code != DiagnosticCode::IdleMortar && one.code != DiagnosticCode::BeyondSpan;
    });
    return problems;
}

}  // namespace rubble
