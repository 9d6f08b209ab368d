#include "core/play/analysis/HitForecast.h"

#include "core/play/session/StandingParts.h"
#include "core/structure/graph/Islands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rubble {
namespace {

constexpr double kWeakest = 1e-6;    // of breaking(): what a hit leaves of weaker bonds does not differ
constexpr double kPrecision = 1e-6;  // of a strength that is looked for
constexpr double kFineStep = 1.01, kCoarseStep = 1.05, kCoarseBelow = 0.01;
constexpr double kQuickNodes = 2000.0;

double volumeOf(const PlayStructure& structure, const Island& island) {
    double volume = 0.0;
    for (const std::uint32_t node : island.nodes) volume += structure.volumes[node];
    return volume;
}

}  // namespace

HitForecast::HitForecast(std::shared_ptr<const PlayStructure> structure, RequirementImpact impact)
    : m_structure(std::move(structure)), m_impact(std::move(impact)) {
    m_level = breakingLevel(m_structure->graph, m_structure->capacities, m_structure->clusterLevels,
                            m_structure->initialDamage, m_structure->allNodes());
    std::vector<BondDamage> damage;
    m_breaking = hit(1.0, damage).utilization;
}

/// The outcome of the hit, and the damage after it. An impulse J on bonds of a strength s does what J / s does to those
/// of the strength 1.
HitOutcome HitForecast::hit(double strength, std::vector<BondDamage>& damage) const {
    damage = m_structure->initialDamage;
    if (m_impact.points.empty()) return {};
    const std::vector<std::uint32_t> owners(m_structure->nodeCount(), 0);
    return applyHit(m_structure->graph, m_structure->capacities, m_structure->rule,
                    {m_impact.points, m_impact.impulse / strength, {m_structure->clusterLevels, m_level}}, owners, 0,
                    damage);
}

std::vector<std::uint32_t> HitForecast::lost(double strength) const {
    std::vector<BondDamage> damage;
    hit(strength, damage);
    const std::vector<std::uint32_t> nodes = m_structure->allNodes();
    const Islands islands = islandsOf(m_structure->graph, damage, nodes);
    std::uint32_t heaviest = 0;
    for (std::uint32_t island = 1; island < islands.count(); ++island) {
        if (volumeOf(*m_structure, islands[island]) > volumeOf(*m_structure, islands[heaviest])) heaviest = island;
    }
    std::vector<bool> stays(nodes.size());
    for (const std::uint32_t node : islands[heaviest].nodes) stays[node] = true;
    std::vector<std::uint32_t> lost;
    for (const std::uint32_t node : nodes) {
        if (!stays[node]) lost.push_back(node);
    }
    return lost;
}

double HitForecast::hole(double strength) const {
    const std::vector<std::uint32_t> nodes = lost(strength);
    std::vector<std::uint32_t> standing;
    auto next = nodes.begin();
    for (std::uint32_t node = 0; node < m_structure->nodeCount(); ++node) {
        if (next != nodes.end() && *next == node) {
            ++next;
        } else {
            standing.push_back(m_structure->fragmentOf(node));
        }
    }
    return holeWidth(*m_structure, standing);
}

double HitForecast::strengthFor(double width) const {
    if (hole(std::numeric_limits<double>::infinity()) > width) return std::numeric_limits<double>::infinity();
    if (!(m_breaking > 0.0)) return 0.0;
    const double nodes = std::max(1.0, m_structure->nodeCount() / kQuickNodes);
    double holds = m_breaking, fails = m_breaking;
    while (hole(fails) <= width) {
        holds = fails;
        fails /= std::pow(fails > kCoarseBelow * m_breaking ? kFineStep : kCoarseStep, nodes);
        if (fails < kWeakest * m_breaking) return 0.0;
    }
    while (holds > fails * (1.0 + kPrecision)) {
        const double middle = std::sqrt(holds) * std::sqrt(fails);
        (hole(middle) <= width ? holds : fails) = middle;
    }
    return holds;
}

}  // namespace rubble
