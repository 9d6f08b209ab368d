#include "core/play/queries/ContactGraph.h"

#include <algorithm>

namespace rubble {
namespace {

/// From this on the normal of a contact says that one body rests on the other, and does not just lean against it.
constexpr double kRestsOn = 0.2;

std::vector<bool> marked(std::span<const std::uint32_t> bodies, std::size_t count) {
    std::vector<bool> marks(count, false);
    for (const std::uint32_t body : bodies) marks[body] = true;
    return marks;
}

}  // namespace

ContactGraph::ContactGraph(std::span<const PlayBody> bodies, const World& world)
    : m_touching(bodies.size()), m_dynamic(bodies.size()) {
    std::vector<std::uint32_t> places;  // by index in the world
    for (std::uint32_t k = 0; k < bodies.size(); ++k) {
        const BodyId body = bodies[k].body;
        if (body.index >= places.size()) places.resize(body.index + 1, 0);
        places[body.index] = k;
        m_dynamic[k] = world.kind(body) == BodyKind::Dynamic;
    }
    const Vec3 up = -glm::normalize(world.gravity());
    BodyId first, second;
    for (const ContactPoint& point : world.contactPoints()) {
        if (point.first == first && point.second == second) continue;  // of the same manifold
        first = point.first, second = point.second;
        const std::uint32_t a = places[first.index], b = places[second.index];
        const double rise = glm::dot(point.normal, up);
        m_touching[a].push_back({b, rise});
        m_touching[b].push_back({a, -rise});
    }
}

bool ContactGraph::addConnected(std::vector<std::uint32_t>& bodies, std::size_t most) const {
    std::vector<bool> isAdded = marked(bodies, m_touching.size());
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        if (!m_dynamic[bodies[k]]) continue;
        for (const TouchingBody& other : m_touching[bodies[k]]) {
            if (isAdded[other.body] || !m_dynamic[other.body]) continue;
            if (bodies.size() >= most) return false;
            isAdded[other.body] = true;
            bodies.push_back(other.body);
        }
    }
    return true;
}

void ContactGraph::addResting(std::vector<std::uint32_t>& bodies) const {
    std::vector<bool> isAdded = marked(bodies, m_touching.size());
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        for (const TouchingBody& other : m_touching[bodies[k]]) {
            if (isAdded[other.body] || !m_dynamic[other.body] || other.up < kRestsOn) continue;
            isAdded[other.body] = true;
            bodies.push_back(other.body);
        }
    }
}

void ContactGraph::addTouching(std::vector<std::uint32_t>& bodies) const {
    std::vector<bool> isAdded = marked(bodies, m_touching.size());
    for (std::size_t k = 0, count = bodies.size(); k < count; ++k) {
        for (const TouchingBody& other : m_touching[bodies[k]]) {
            if (isAdded[other.body]) continue;
            isAdded[other.body] = true;
            bodies.push_back(other.body);
        }
    }
}

}  // namespace rubble
