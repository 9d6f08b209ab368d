#include "core/physics/Sleeping.h"

#include "core/physics/Contacts.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rubble {
namespace {

constexpr float kRestSpeed = 0.05f;  // m/s, of any point
constexpr float kRestTime = 0.5f;    // s

bool hasManifold(const Contact& contact) { return contact.slot.isSet() || contact.stored != kNone; }

void listAwake(WorldState& state, std::uint32_t body) {
    state.bodies[body].isAwake = true;
    state.bodies[body].restTime = 0.0f;
    state.awake.insert(std::lower_bound(state.awake.begin(), state.awake.end(), body), body);
}

void wake(WorldState& state, std::uint32_t sleepers) {
    const Sleepers woken = std::exchange(state.sleepers[sleepers], {});
    state.freeSleepers.push_back(sleepers);
    for (std::uint32_t body : woken.bodies) {
        state.bodies[body].sleepers = kNone;
        listAwake(state, body);
    }
    for (std::uint32_t contact : woken.contacts) bringBackContact(state, contact);
    for (std::uint32_t body : woken.bodies) {
        visitContacts(state, body, [&](std::uint32_t contact, std::uint32_t) {
            if (!hasManifold(state.contacts[contact])) listOpen(state, contact);
        });
    }
}

/// Which bodies hang together, by union-find on their numbers.
class Unions {
public:
    explicit Unions(std::size_t count) : m_above(count) { std::iota(m_above.begin(), m_above.end(), 0u); }
    std::uint32_t root(std::uint32_t item) {
        while (m_above[item] != item) item = m_above[item] = m_above[m_above[item]];
        return item;
    }
    /// The smaller number stays on top, so that roots do not depend on the order.
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        if (a != b) m_above[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> m_above;
};

template <class Visit>
void visitLanes(const ContactColours& colours, const Visit& visit) {
    for (const ContactColours::List& list : colours.lists()) {
        for (const ContactBlock& block : list.blocks) {
            for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
                if (block.first[lane] != 0) visit(block, lane);
            }
        }
    }
}

Unions islands(const WorldState& state) {
    Unions unions(state.bodies.size());
    visitLanes(state.colours, [&](const ContactBlock& block, std::size_t lane) {
        if (block.againstFixed[lane] == 0.0f) unions.join(block.first[lane], block.second[lane]);
    });
    return unions;
}

bool isNoted(const Body& body) { return body.restTime >= kRestTime; }

std::uint32_t newSleepers(WorldState& state) {
    if (state.freeSleepers.empty()) {
        state.sleepers.emplace_back();
        return static_cast<std::uint32_t>(state.sleepers.size() - 1);
    }
    const std::uint32_t sleepers = state.freeSleepers.back();
    state.freeSleepers.pop_back();
    return sleepers;
}

void layToSleep(WorldState& state, std::uint32_t number, std::uint32_t sleepers) {
    Body& body = state.bodies[number];
    body.isAwake = false;
    body.sleepers = sleepers;
    state.motions[number].velocity = state.motions[number].spin = Vec3f(0.0f);
    body.momentum = body.spinThen = Vec3f(0.0f);
    state.sleepers[sleepers].bodies.push_back(number);
}

/// Stores the contacts of bodies that just fell asleep, and takes the others off the list.
void storeContacts(WorldState& state, std::uint32_t sleepers) {
    Sleepers& asleep = state.sleepers[sleepers];
    for (std::uint32_t body : asleep.bodies) {
        visitContacts(state, body, [&](std::uint32_t contact, std::uint32_t) {
            if (state.contacts[contact].slot.isSet()) {
                storeContact(state, contact);
                asleep.contacts.push_back(contact);
            } else if (!state.isAwake(state.contacts[contact])) {
                unlistOpen(state, contact);
            }
        });
    }
}

}  // namespace

void wakeBody(WorldState& state, std::uint32_t number) {
    const Body& body = state.bodies[number];
    if (body.kind == BodyKind::Static) return;
    if (body.sleepers != kNone) wake(state, body.sleepers);
    if (!body.isAwake) listAwake(state, number);
    state.bodies[number].restTime = 0.0f;
}

void wakeNeighbours(WorldState& state, std::uint32_t body) {
    visitContacts(state, body, [&](std::uint32_t contact, std::uint32_t other) {
        if (hasManifold(state.contacts[contact])) wakeBody(state, other);
    });
}

void noteRest(WorldState& state, std::uint32_t number, float dt) {
    Body& body = state.bodies[number];
    const BodyMotion& motion = state.motions[number];
    const float turning = length(motion.spin) * state.places[number].reach;
    const bool rests = body.isDynamic() && length(motion.velocity) < kRestSpeed && turning < kRestSpeed;
    body.restTime = rests ? body.restTime + dt : 0.0f;
}

int sleepWhereAtRest(WorldState& state) {
    const auto rests = [&](std::uint32_t body) { return isNoted(state.bodies[body]); };
    if (!state.sleeping || std::none_of(state.awake.begin(), state.awake.end(), rests)) return 0;
    Unions unions = islands(state);
    std::vector<char> isRestless(state.bodies.size(), 0);
    for (std::uint32_t body : state.awake) {
        if (state.bodies[body].isDynamic() && !rests(body)) isRestless[unions.root(body)] = 1;
    }
    std::vector<std::uint32_t> sleepersOfRoot(state.bodies.size(), kNone), newOnes, stillAwake;
    int count = 0;
    for (std::uint32_t body : state.awake) {
        const std::uint32_t root = unions.root(body);
        count += root == body ? 1 : 0;
        if (!state.bodies[body].isDynamic() || isRestless[root] != 0) {
            stillAwake.push_back(body);
            continue;
        }
        if (sleepersOfRoot[root] == kNone) newOnes.push_back(sleepersOfRoot[root] = newSleepers(state));
        layToSleep(state, body, sleepersOfRoot[root]);
    }
    state.awake = std::move(stillAwake);
    for (std::uint32_t sleepers : newOnes) storeContacts(state, sleepers);
    return count;
}

std::vector<std::uint32_t> islandsOf(const WorldState& state) {
    Unions unions = islands(state);
    for (const Sleepers& asleep : state.sleepers) {
        for (const std::uint32_t body : asleep.bodies) unions.join(asleep.bodies.front(), body);
    }
    std::vector<std::uint32_t> roots(state.bodies.size(), 0);
    for (std::uint32_t body = 1; body < roots.size(); ++body) {
        if (state.bodies[body].shape != nullptr && state.bodies[body].isDynamic()) roots[body] = unions.root(body);
    }
    return roots;
}

}  // namespace rubble
