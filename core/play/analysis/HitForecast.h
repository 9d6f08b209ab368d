#pragma once

#include "core/play/analysis/RequirementImpulse.h"
#include "core/play/scene/PlayStructure.h"
#include "core/structure/clusters/ClusterLevels.h"

#include <memory>
#include <span>
#include <vector>

namespace rubble {

/// What one impact does to an intact structure, in closed form: applyHit(), and what then is connected. Anchors are not
/// looked at: the heaviest part stays in place, and the others come off. What these hit, and what comes down later by
/// gravity, is left to play.
///
/// Strengths are relative: those of the structure are 1. A bond under the fraction f of an impulse J breaks where its
/// capacity is at most f J, and capacities are proportional to the strength.
class HitForecast {
public:
    HitForecast(std::shared_ptr<const PlayStructure> structure, RequirementImpact impact);

    /// The strength up to which a bond breaks; 0 if none can.
    double breaking() const { return m_breaking; }
    /// The fragments that come off at a strength > 0, as nodes, ascending.
    std::vector<std::uint32_t> lost(double strength) const;
    /// The width of the widest hole at a strength > 0, m: holeWidth().
    double hole(double strength) const;
    /// The least strength from which on no hole is wider than `width` (m), within a millionth; 0 where none ever is,
    /// and infinite where one is before anything is hit. A stronger structure may lose a wider part, where another one
    /// is the heaviest then: strengths are tried from breaking() down in steps of 1 %, and of 5 % below a hundredth
    /// of it, longer ones where it has more than 2,000 nodes.
    double strengthFor(double width) const;

private:
    HitOutcome hit(double strength, std::vector<BondDamage>& damage) const;

    std::shared_ptr<const PlayStructure> m_structure;
    RequirementImpact m_impact;
    ClusterLevel m_level = kEveryLevel;
    double m_breaking = 0.0;
};

}  // namespace rubble
