#include "core/physics/step/EnergyLimit.h"

#include "core/base/DisjointSets.h"
#include "core/physics/state/Contacts.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace rubble {
namespace {

// What a body may seem to gain:
constexpr float kSoftness = 5e-4f;       // m: contacts give way, and lift again by that
constexpr float kSlowest = 5e-7f;        // J/kg: of motion by rounding
constexpr float kRounding = 1e-5f;       // of twice its kinetic energy
constexpr float kRiseFraction = 0.001f;  // of its bounding radius, by which it may rise in a step without motion

/// The motion of a rigid body or of an island as a whole.
struct Motion {
    Vec3 centre{0.0}, velocity{0.0}, angularVelocity{0.0};
    Vec3 velocityAt(Vec3 point) const { return velocity + glm::cross(angularVelocity, point - centre); }
};

Mat3 inertiaOf(const WorldState& state, std::uint32_t body) {
    const Mat3f r = state.poses[body].rotation.matrix();
    const Mat3 rotation(toDouble(r.x), toDouble(r.y), toDouble(r.z));
    const SymMat3f& i = state.bodies[body].inertia;
    const Mat3 own(i.xx, i.xy, i.xz, i.xy, i.yy, i.yz, i.xz, i.yz, i.zz);
    return rotation * own * glm::transpose(rotation);
}

double kineticOf(const WorldState& state, std::uint32_t body, Vec3 velocity, Vec3 angularVelocity) {
    return 0.5 * state.bodies[body].mass * glm::dot(velocity, velocity) +
           0.5 * glm::dot(angularVelocity, inertiaOf(state, body) * angularVelocity);
}

double kineticOf(const WorldState& state, std::uint32_t body) {
    return kineticOf(state, body, toDouble(state.motions[body].velocity),
                     toDouble(state.motions[body].angularVelocity));
}

/// The energy that a body may seem to gain, J.
double toleranceOf(const WorldState& state, std::uint32_t body, float weight) {
    const BodyMotion& motion = state.motions[body];
    const float radius = state.poses[body].boundingRadius;
    const float squared =
        lengthSquared(motion.velocity) + radius * radius * lengthSquared(motion.angularVelocity);  // at most
    return static_cast<double>(state.bodies[body].mass * (weight * kSoftness + kRounding * squared + kSlowest));
}

bool pushes(const ContactBlock& block, std::size_t lane) {
    for (std::size_t i = 0; i < block.pointCount[lane]; ++i) {
        if (block.points[i].stepImpulse[lane] > 0.0f) return true;
    }
    return false;
}

/// Bodies that pushed each other in the step.
struct Island {
    std::vector<std::uint32_t> bodies;
    bool isFixed = false;   // it touches something that is fixed
    bool isDriven = false;  // something moves it that gives it energy
};

/// Finds the islands of some bodies.
class Islands {
public:
    Islands(const WorldState& state, std::span<const BodyPair> clamped)
        : m_state(state), m_sets(state.bodies.size()), m_isFixed(state.bodies.size()), m_isDriven(state.bodies.size()) {
        for (const ContactColours::List& list : state.colours.lists()) {
            for (const ContactBlock& block : list.blocks) {
                for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
                    if (pushes(block, lane)) add(block.first[lane], block.second[lane]);
                }
            }
        }
        for (const auto& [body, other] : clamped) add(body, other);
        m_isDriven[state.grabbed.index] = 1;  // body 0: none
    }

    /// Those of some bodies.
    std::vector<Island> of(std::span<const std::uint32_t> bodies) {
        std::vector<std::uint32_t> place(m_state.bodies.size(), kNone);
        std::vector<Island> islands;
        for (const std::uint32_t body : bodies) {
            if (place[m_sets.rootOf(body)] != kNone) continue;
            place[m_sets.rootOf(body)] = static_cast<std::uint32_t>(islands.size());
            islands.emplace_back();
        }
        for (const std::uint32_t body : m_state.awake) {
            if (!isDynamic(body) || place[m_sets.rootOf(body)] == kNone) continue;
            Island& island = islands[place[m_sets.rootOf(body)]];
            island.bodies.push_back(body);
            island.isFixed |= m_isFixed[body] != 0;
            island.isDriven |= m_isDriven[body] != 0;
        }
        return islands;
    }

private:
    bool isDynamic(std::uint32_t body) const { return m_state.bodies[body].isDynamic(); }
    void add(std::uint32_t first, std::uint32_t second) {
        if (!isDynamic(first)) return addFixed(second, first);
        if (!isDynamic(second)) return addFixed(first, second);
        m_sets.merge(first, second);
    }
    void addFixed(std::uint32_t body, std::uint32_t fixed) {
        const BodyMotion& motion = m_state.motions[fixed];
        m_isFixed[body] = 1;
        if (motion.velocity != Vec3f(0.0f) || motion.angularVelocity != Vec3f(0.0f)) m_isDriven[body] = 1;
    }

    const WorldState& m_state;
    DisjointSets m_sets;
    std::vector<char> m_isFixed, m_isDriven;  // by body
};

/// The motion of an island as one rigid body, with its momenta.
Motion rigidMotion(const WorldState& state, const Island& island) {
    Motion whole;
    double mass = 0.0;
    for (const std::uint32_t body : island.bodies) {
        const double own = state.bodies[body].mass;
        mass += own;
        whole.centre += own * toDouble(state.poses[body].centre);
        whole.velocity += own * toDouble(state.motions[body].velocity);
    }
    whole.centre /= mass;
    whole.velocity /= mass;
    Mat3 inertia(0.0);
    Vec3 momentum(0.0);
    for (const std::uint32_t body : island.bodies) {
        const double own = state.bodies[body].mass;
        const Vec3 arm = toDouble(state.poses[body].centre) - whole.centre;
        const Mat3 spin = inertiaOf(state, body);
        inertia += spin + own * (glm::dot(arm, arm) * Mat3(1.0) - glm::outerProduct(arm, arm));
        momentum += spin * toDouble(state.motions[body].angularVelocity) +
                    own * glm::cross(arm, toDouble(state.motions[body].velocity));
    }
    whole.angularVelocity = glm::inverse(inertia) * momentum;
    return whole;
}

/// Lowers bodies that rise in the step, by `gain` J in all, or by as much as they rise: but by no less than what
/// resolves overlaps in time, which is little of what a fall from their size gives.
void lowerBodies(WorldState& state, const Island& island, double gain, std::vector<BodyLoss>& losses) {
    const Vec3f up = normalized(state.gravity * -1.0f);
    const float weight = length(state.gravity);
    const auto riseOf = [&](std::uint32_t body) {  // J
        return weight * state.bodies[body].mass * std::max(0.0f, dot(up, state.motions[body].deltaPosition));
    };
    double rise = 0.0;
    for (const std::uint32_t body : island.bodies) {
        rise += static_cast<double>(riseOf(body));
        gain -=
            static_cast<double>(kRiseFraction * state.poses[body].boundingRadius * weight * state.bodies[body].mass);
    }
    if (rise <= 0.0 || gain <= 0.0) return;
    const auto part = static_cast<float>(std::min(1.0, gain / rise));
    for (const std::uint32_t body : island.bodies) {
        losses[body].energy += part * riseOf(body);
        Vec3f& displacement = state.motions[body].deltaPosition;
        displacement -= up * (part * std::max(0.0f, dot(up, displacement)));
    }
}

/// Reduces the energy of an island by up to `gain` J.
void reduceEnergy(WorldState& state, const Island& island, double gain, std::vector<BodyLoss>& losses) {
    const Motion whole = island.isFixed ? Motion{} : rigidMotion(state, island);
    double relative = 0.0;
    const auto relativeMotion = [&](std::uint32_t body) {
        const BodyMotion& motion = state.motions[body];
        return Motion{.velocity = toDouble(motion.velocity) - whole.velocityAt(toDouble(state.poses[body].centre)),
                      .angularVelocity = toDouble(motion.angularVelocity) - whole.angularVelocity};
    };
    for (const std::uint32_t body : island.bodies) {
        const Motion own = relativeMotion(body);
        relative += kineticOf(state, body, own.velocity, own.angularVelocity);
    }
    const double less = 1.0 - std::sqrt(relative > gain ? 1.0 - gain / relative : 0.0);
    for (const std::uint32_t body : island.bodies) {
        const Motion own = relativeMotion(body);
        const double before = kineticOf(state, body);
        state.motions[body].velocity -= toFloat(less * own.velocity);
        state.motions[body].angularVelocity -= toFloat(less * own.angularVelocity);
        losses[body].energy += static_cast<float>(before - kineticOf(state, body));
    }
    if (island.isFixed && relative < gain) lowerBodies(state, island, gain - relative, losses);
}

}  // namespace

double limitEnergy(WorldState& state, ThreadPool& threads, const Regions& regions, const SolverKernels& kernels,
                   const SolverStep& step, std::span<const BodyPair> clamped, ContactEnergyScratch& scratch) {
    findLosses(state, threads, regions, kernels, step, scratch);
    const float weight = length(step.gravity);
    const auto gainOf = [&](std::uint32_t body) {
        return -static_cast<double>(scratch.losses[body].energy) - toleranceOf(state, body, weight);
    };
    std::vector<std::uint32_t> gaining;
    for (const std::uint32_t body : state.awake) {
        if (scratch.losses[body].energy < 0.0f && gainOf(body) > 0.0) gaining.push_back(body);
    }
    if (gaining.empty()) return contactLoss(state, scratch);
    for (const Island& island : Islands(state, clamped).of(gaining)) {
        double gain = 0.0;
        for (const std::uint32_t body : island.bodies) gain += gainOf(body);
        if (gain > 0.0 && !island.isDriven) reduceEnergy(state, island, gain, scratch.losses);
    }
    return contactLoss(state, scratch);
}

}  // namespace rubble
