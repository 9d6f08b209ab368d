#include "core/play/breaking/SharedImpacts.h"

#include "core/play/breaking/MovingMass.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble {
namespace {

/// The impact of two bodies: the strongest of their manifolds.
struct PairImpact {
    std::size_t begin = 0, end = 0;  // its manifolds among the impacts
    const Impact* strongest = nullptr;
    std::size_t first = 0, second = 0;  // indices of the bodies
    double impulse = 0.0;               // N·s, so far
    double relaxation = 1.0;            // 1 / the most impacts that one of its bodies has

    /// The change of speed along the normal that is wanted, m/s: of the approach and the restitution.
    double wanted() const { return (1.0 + strongest->restitution) * strongest->approachSpeed; }
};

/// A body, with the velocities that it gets from impacts.
struct ImpactBody {
    MovingMass mass;
    int impacts = 0;
};

/// Impacts as one problem of all their bodies.
class ImpactProblem {
public:
    ImpactProblem(const World& world, std::span<const Impact> impacts) {
        std::map<BodyId, std::size_t> indices;
        const auto indexOf = [&](BodyId body) {
            const auto [found, isNew] = indices.try_emplace(body, m_bodies.size());
            if (isNew) m_bodies.push_back({.mass = movingMass(world, body)});
            ++m_bodies[found->second].impacts;
            return found->second;
        };
        for (std::size_t begin = 0, end = 0; begin < impacts.size(); begin = end) {
            const Impact& one = impacts[begin];
            while (end < impacts.size() && impacts[end].first == one.first && impacts[end].second == one.second) ++end;
            const auto strongest = std::ranges::max_element(impacts.subspan(begin, end - begin), {}, &Impact::impulse);
            m_pairs.push_back({begin, end, &*strongest, indexOf(one.first), indexOf(one.second)});
        }
        for (ImpactBody& body : m_bodies) body.mass.velocity = body.mass.angularVelocity = Vec3(0.0);
        for (PairImpact& pair : m_pairs)
            pair.relaxation = 1.0 / std::max(impactsOf(pair.first), impactsOf(pair.second));
    }

    /// Whether any body that can move has several impacts.
    bool isShared() const {
        return std::ranges::any_of(m_pairs, [](const PairImpact& pair) { return pair.relaxation < 1.0; });
    }

    const std::vector<PairImpact>& solve() {
        constexpr int kSweeps = 200;
        constexpr double kTolerance = 1e-4;  // of the strongest impulse
        for (int sweep = 0; sweep < kSweeps; ++sweep) {
            const auto [change, most] = improve();
            if (change <= kTolerance * most) break;
        }
        return m_pairs;
    }

private:
    /// Those of a body that can move; others take any impulse.
    int impactsOf(std::size_t body) const { return m_bodies[body].mass.inverseMass > 0.0 ? m_bodies[body].impacts : 1; }

    /// One iteration. Returns the largest change of an impulse, and the largest impulse, N·s.
    std::pair<double, double> improve() {
        double largest = 0.0, most = 0.0;
        std::vector<double> changes;
        for (PairImpact& pair : m_pairs) {
            const Impact& impact = *pair.strongest;
            const Vec3 velocity = m_bodies[pair.second].mass.velocityAt(impact.point) -
                                  m_bodies[pair.first].mass.velocityAt(impact.point);
            const double missing = pair.wanted() - glm::dot(velocity, impact.normal);
            const double after = std::max(0.0, pair.impulse + pair.relaxation * missing * impact.effectiveMass);
            changes.push_back(after - pair.impulse);
            pair.impulse = after;
            largest = std::max(largest, std::abs(changes.back()));
            most = std::max(most, after);
        }
        for (std::size_t k = 0; k < m_pairs.size(); ++k) {
            const Impact& impact = *m_pairs[k].strongest;
            m_bodies[m_pairs[k].first].mass.applyImpulse(-changes[k] * impact.normal, impact.point);
            m_bodies[m_pairs[k].second].mass.applyImpulse(changes[k] * impact.normal, impact.point);
        }
        return {largest, most};
    }

    std::vector<ImpactBody> m_bodies;
    std::vector<PairImpact> m_pairs;
};

}  // namespace

std::vector<Impact> sharedImpacts(const World& world, std::span<const Impact> impacts) {
    std::vector<Impact> shared(impacts.begin(), impacts.end());
    ImpactProblem problem(world, impacts);
    if (!problem.isShared()) return shared;
    for (const PairImpact& pair : problem.solve()) {
        const double fraction = std::min(1.0, pair.impulse / pair.strongest->impulse());
        for (std::size_t k = pair.begin; k < pair.end; ++k) shared[k].effectiveMass *= fraction;
    }
    return shared;
}

}  // namespace rubble
