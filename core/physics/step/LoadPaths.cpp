#include "core/physics/step/LoadPaths.h"

#include "core/physics/step/BodyManifolds.h"

#include <algorithm>
#include <queue>

namespace rubble {
namespace {

constexpr float kMinUpward = 0.2f;           // of a normal along which one body rests on another
constexpr float kActiveSeparation = 0.002f;  // m: bodies that are nearer, or will be in this step, touch

/// Whether bodies touch at a point. Those that leave each other faster than overlaps are resolved do not.
bool touches(const PointRows& point, std::size_t lane, const SolverStep& step) {
    const float approach = point.approach[lane];
    if (approach > step.pushOutSpeed) return false;
    const float next = point.separation[lane] + std::min(approach, 0.0f) * step.dt;
    return next < kActiveSeparation || point.impulse[lane] > 0.0f;
}

class LoadPaths {
public:
    LoadPaths(const WorldState& state, std::span<const BlockList> unequal, const SolverStep& step)
        : m_state(state), m_step(step), m_up(normalized(step.gravity * -1.0f)), m_carried(state.bodies.size()) {
        for (const BlockList& blocks : unequal) {
            for (const ContactBlock* block : blocks) {
                for (std::size_t lane = 0; lane < kBlockLanes; ++lane) addHeavier(*block, lane);
            }
        }
        // In descending order, so that what a body carries is final when its turn comes.
        while (!m_queue.empty()) {
            const Load load = m_queue.top();
            m_queue.pop();
            if (load == m_carried[load.body]) follow(load);
        }
        followUnloaded();
        findGrounded();
    }

    std::vector<Load> loads() const {
        std::vector<Load> found;
        for (const Support& support : m_supports) {
            if (support.isGrounded && isLoaded(support.upper)) found.push_back(m_carried[support.upper]);
        }
        std::ranges::sort(found, {}, &Load::body);
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

private:
    /// A body, and one that it rests on.
    struct Support {
        std::uint32_t upper = 0, lower = 0;
        bool isGrounded = false;  // it rests on the ground, directly or not
    };

    /// Begins with the heavier of two bodies whose masses differ much.
    void addHeavier(const ContactBlock& block, std::size_t lane) {
        if (block.pointCount[lane] == 0) return;
        const std::uint32_t first = block.first[lane], second = block.second[lane];
        const float a = m_state.motions[first].inverseMass, b = m_state.motions[second].inverseMass;
        if (std::min(a, b) == 0.0f || std::max(a, b) <= kMaxLoadRatio * std::min(a, b)) return;
        const std::uint32_t heavier = a < b ? first : second;
        if (m_carried[heavier].mass == 0.0f) add({m_state.bodies[heavier].mass, heavier, heavier});
    }
    void add(const Load& load) {
        m_carried[load.body] = load;
        m_queue.push(load);
    }

    /// Distributes a load over what its body rests on.
    void follow(const Load& load) {
        findBelow(load.body);
        const float share = load.mass / static_cast<float>(std::max<std::size_t>(m_below.size(), 1));
        for (const std::uint32_t number : m_below) {
            if (isLoaded(load.body)) m_supports.push_back({load.body, number});
            const Body& body = m_state.bodies[number];
            const Load next{share, number, load.source};
            if (body.isDynamic() && share > body.mass && next > m_carried[number] && rests(next)) add(next);
        }
    }

    /// Impacts are left alone: a body that was hit is fast, and so is one that strikes from the side.
    bool rests(const Load& load) const {
        const BodyMotion &motion = m_state.motions[load.body], &source = m_state.motions[load.source];
        const float radius = m_state.poses[load.body].boundingRadius, most = m_step.pushOutSpeed * m_step.pushOutSpeed;
        const Vec3f level = source.velocity - m_up * dot(source.velocity, m_up);
        return lengthSquared(motion.velocity) + radius * radius * lengthSquared(motion.angularVelocity) <= most &&
               lengthSquared(level) <= most;
    }

    void findBelow(std::uint32_t body) {
        m_below.clear();
        m_manifolds.visit(m_state, body, [&](const ContactBlock& block, std::size_t lane, std::uint32_t other) {
            if (!restsOn(body, block, lane)) return;
            if (std::ranges::find(m_below, other) == m_below.end()) m_below.push_back(other);
        });
    }
    bool restsOn(std::uint32_t body, const ContactBlock& block, std::size_t at) const {
        const float upward = dot(block.normal.at(at), m_up) * (block.second[at] == body ? 1.0f : -1.0f);
        const std::span points(block.points.data(), block.pointCount[at]);
        return upward >= kMinUpward &&
               std::ranges::any_of(points, [&](const PointRows& point) { return touches(point, at, m_step); });
    }

    /// Follows down what loads rest on and what carries no more than itself: does it stand, or fall with them?
    void followUnloaded() {
        std::vector<std::uint8_t> isFollowed(m_state.bodies.size(), 0);
        for (std::size_t k = 0; k < m_supports.size(); ++k) {
            const std::uint32_t body = m_supports[k].lower;
            if (!m_state.bodies[body].isDynamic() || isLoaded(body) || isFollowed[body] != 0) continue;
            isFollowed[body] = 1;
            findBelow(body);
            for (const std::uint32_t number : m_below) m_supports.push_back({body, number});
        }
    }
    /// What falls together with its load rests on nothing.
    void findGrounded() {
        std::vector<std::uint8_t> isFalling(m_state.bodies.size(), 0);
        for (const Support& support : m_supports) {
            isFalling[support.upper] = 1;
            if (m_state.bodies[support.lower].isDynamic()) isFalling[support.lower] = 1;
        }
        for (bool hasChanged = true; hasChanged;) {
            hasChanged = false;
            for (auto support = m_supports.rbegin(); support != m_supports.rend(); ++support) {  // from the lowest
                if (support->isGrounded || isFalling[support->lower] != 0) continue;
                support->isGrounded = hasChanged = true;
                isFalling[support->upper] = 0;
            }
        }
    }
    bool isLoaded(std::uint32_t body) const { return m_carried[body].mass > m_state.bodies[body].mass; }

    const WorldState& m_state;
    const SolverStep& m_step;
    Vec3f m_up;
    std::vector<Load> m_carried;  // by body; its own mass if it is a source without load, or 0
    std::priority_queue<Load> m_queue;
    std::vector<std::uint32_t> m_below;
    BodyManifolds m_manifolds;
    std::vector<Support> m_supports;
};

}  // namespace

std::vector<Load> findLoads(const WorldState& state, std::span<const BlockList> unequal, const SolverStep& step) {
    const bool areEqual = std::ranges::all_of(unequal, [](const BlockList& blocks) { return blocks.empty(); });
    if (areEqual || lengthSquared(step.gravity) == 0.0f) return {};
    return LoadPaths(state, unequal, step).loads();
}

}  // namespace rubble
