#include "core/physics/World.h"

#include "core/base/Assert.h"
#include "core/base/Stopwatch.h"
#include "core/physics/Bodies.h"
#include "core/physics/BroadPhase.h"
#include "core/physics/Contacts.h"
#include "core/physics/FastBodies.h"
#include "core/physics/Impacts.h"
#include "core/physics/NarrowPhase.h"
#include "core/physics/Regions.h"
#include "core/physics/SharingTrial.h"
#include "core/physics/Sleeping.h"
#include "core/physics/Solver.h"
#include "core/physics/WorldState.h"

#include <algorithm>

namespace rubble {
namespace {

std::uint32_t proxyOf(const WorldState& state, std::uint32_t body, std::uint32_t hull) {
    std::uint32_t proxy = state.bodies[body].firstProxy;
    while (state.proxies[proxy].hull != hull) proxy = state.proxies[proxy].next;
    return proxy;
}

/// Makes a contact that is known, and keeps how it touches.
void seedContact(WorldState& state, std::uint32_t first, std::uint32_t second, const ContactSeed& seed) {
    const std::uint32_t contact = addContact(state, first, second);
    if (contact == kNone) return;
    const Look& look = seed.looks[state.contacts[contact].proxies[0] == first ? 0 : 1];
    beginTouching(state, contact, static_cast<std::uint32_t>(look.manifold.count));
    keepManifold(state, contact, look);
}

bool isAlive(const WorldState& state, std::uint32_t body) { return state.bodies[body].shape != nullptr; }

}  // namespace

struct World::Workshop {
    explicit Workshop(const WorldSettings& settings) : team(settings.threads), kernels(kernelsOf(settings.lanes)) {}

    bool isWorthATrial(const WorldState& state) const {
        // Below, two threads are never quicker than one: a step has two hundred stages, and each waits for the slowest.
        constexpr std::size_t kLeastContacts = 1000;
        return team.size() > 1 && state.colours.contactCount() >= kLeastContacts;
    }
    int workersOf(const WorldState& state) const {
        return isWorthATrial(state) && sharing.isShared() ? team.size() : 1;
    }

    WorkerTeam team;
    const SolverKernels& kernels;
    SharingTrial sharing;
    int workers = 1;  // of the step that was collided
    PairScratch pairs;
    LookScratch looks;
    SolveScratch solve;
    std::vector<std::vector<HitEvent>> hits;             // by region
    std::vector<std::vector<std::uint32_t>> fastBodies;  // by region
    StepCounts counts;
    StepTimes times;
    Regions regions;
    float dt = 0.0f;          // s, of the step that was collided
    bool isCollided = false;  // and not solved yet
};

World::World(const WorldSettings& settings)
    : m_state(std::make_unique<WorldState>()), m_workshop(std::make_unique<Workshop>(settings)) {
    m_state->gravity = toFloat(settings.gravity);
    m_state->sleeping = settings.sleeping;
    m_state->colours.resizeBodies(1);
}

World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

Result<BodyId> World::addBody(const BodyDefinition& definition) {
    if (const std::optional<std::string> fault = faultOf(definition)) return Error{ErrorCode::BadInput, *fault};
    return m_state->idOf(rubble::addBody(*m_state, definition));
}

void World::removeBody(BodyId body) {
    RUBBLE_ASSERT(contains(body));
    rubble::removeBody(*m_state, body.index);
}

bool World::contains(BodyId body) const {
    return body.index > 0 && body.index < m_state->bodies.size() && isAlive(*m_state, body.index) &&
           m_state->bodies[body.index].generation == body.generation;
}

std::size_t World::bodyCount() const { return m_state->bodies.size() - 1 - m_state->freeBodies.size(); }

std::vector<BodyId> World::bodies() const {
    std::vector<BodyId> ids;
    for (std::uint32_t body = 1; body < m_state->bodies.size(); ++body) {
        if (isAlive(*m_state, body)) ids.push_back(m_state->idOf(body));
    }
    return ids;
}

BodyState World::state(BodyId body) const {
    RUBBLE_ASSERT(contains(body));
    const BodyMotion& motion = m_state->motions[body.index];
    const Body& record = m_state->bodies[body.index];
    return {poseOf(*m_state, body.index), toDouble(m_state->places[body.index].centre), toDouble(motion.velocity),
            toDouble(motion.spin), record.isDynamic() && !record.isAwake};
}

BodyKind World::kind(BodyId body) const {
    RUBBLE_ASSERT(contains(body));
    return m_state->bodies[body.index].kind;
}

const Shape& World::shape(BodyId body) const {
    RUBBLE_ASSERT(contains(body));
    return *m_state->bodies[body.index].shape;
}

std::uint64_t World::tag(BodyId body) const {
    RUBBLE_ASSERT(contains(body));
    return m_state->bodies[body.index].tag;
}

double World::mass(BodyId body) const {
    RUBBLE_ASSERT(contains(body));
    return m_state->bodies[body.index].mass;
}

double World::restitution(BodyId body) const {
    RUBBLE_ASSERT(contains(body));
    return m_state->bodies[body.index].restitution;
}

void World::collide(double dt) {
    Workshop& shop = *m_workshop;
    Stopwatch watch;
    if (!shop.isCollided) {
        m_state->events.began.clear();
        m_state->events.ended.clear();
        m_state->events.hits.clear();
        shop.times = {};
        shop.counts.separatingAxisTests = 0;
    }
    const bool newOnly = shop.isCollided;
    if (!newOnly) shop.workers = shop.workersOf(*m_state);
    shop.dt = static_cast<float>(dt);
    shop.isCollided = true;
    shop.regions.shareOut(*m_state, shop.workers);
    findPairs(*m_state, shop.team, shop.regions, shop.pairs, shop.dt, !newOnly);
    shop.times.pairs += watch.lap();
    shop.counts.separatingAxisTests += findManifolds(*m_state, shop.team, shop.regions, shop.looks, shop.kernels,
                                                     solverStep(*m_state, shop.dt), newOnly);
    shop.times.collide += watch.lap();
}

void World::expectContact(BodyId first, BodyId second, std::span<const ContactSeed> seeds) {
    RUBBLE_ASSERT(contains(first) && contains(second));
    WorldState& state = *m_state;
    for (const ContactSeed& seed : seeds) {
        seedContact(state, proxyOf(state, first.index, seed.hulls[0]), proxyOf(state, second.index, seed.hulls[1]),
                    seed);
    }
    if (!seeds.empty()) return;
    for (std::uint32_t a = state.bodies[first.index].firstProxy; a != kNone; a = state.proxies[a].next) {
        for (std::uint32_t b = state.bodies[second.index].firstProxy; b != kNone; b = state.proxies[b].next) {
            addContact(state, a, b);
        }
    }
}

std::vector<Impact> World::impacts() {
    RUBBLE_ASSERT(m_workshop->isCollided);
    const SolverStep step = solverStep(*m_state, m_workshop->dt);
    prepareContacts(*m_state, m_workshop->team, m_workshop->regions, m_workshop->kernels, step);
    return impactsOf(*m_state, step);
}

void World::solve(double dt) {
    Workshop& shop = *m_workshop;
    RUBBLE_ASSERT(shop.isCollided && shop.dt == static_cast<float>(dt));
    shop.isCollided = false;
    const SolverStep step = solverStep(*m_state, shop.dt);
    Stopwatch watch;
    shop.regions.shareOut(*m_state, shop.workers);
    shop.regions.orderContacts(*m_state, shop.team);
    prepareContacts(*m_state, shop.team, shop.regions, shop.kernels, step);
    shop.times.prepare = watch.lap();
    solveSubSteps(*m_state, shop.team, shop.regions, shop.solve, shop.kernels, step);
    shop.times.solve = watch.lap();
    listHits(*m_state, shop.team, shop.regions, shop.hits, m_state->events.hits);
    holdBackFastBodies(*m_state, shop.team, shop.regions, shop.fastBodies);
    finishBodies(*m_state, shop.team, shop.regions, shop.dt);
    shop.counts.awake = static_cast<int>(m_state->awake.size());
    shop.counts.islands = sleepWhereAtRest(*m_state);
    shop.times.finish = watch.lap();
    if (shop.isWorthATrial(*m_state)) shop.sharing.note(shop.times.total());
}

void World::step(double dt) {
    collide(dt);
    solve(dt);
}

const StepEvents& World::events() const { return m_state->events; }
const StepTimes& World::times() const { return m_workshop->times; }

StepCounts World::counts() const {
    StepCounts counts = m_workshop->counts;
    counts.bodies = static_cast<int>(bodyCount());
    counts.candidatePairs = static_cast<int>(m_state->contacts.size() - m_state->freeContacts.size());
    counts.colours = m_state->colours.colourCount();
    counts.contacts = static_cast<int>(m_state->colours.contactCount());
    for (const ContactColours::List& list : m_state->colours.lists()) {
        for (const ContactBlock& block : list.blocks) {
            for (std::uint32_t points : block.pointCount) counts.contactPoints += static_cast<int>(points);
        }
    }
    return counts;
}

std::vector<ContactPoint> World::contactPoints() const { return contactPointsOf(*m_state); }

Box3 World::box(BodyId body) const {
    RUBBLE_ASSERT(contains(body));
    Box3 around;
    for (std::uint32_t proxy = m_state->bodies[body.index].firstProxy; proxy != kNone;) {
        const Proxy& hull = m_state->proxies[proxy];
        const Box& box = m_state->tree.box(hull.leaf);
        around.include(Box3{toDouble(box.low), toDouble(box.high)});
        proxy = hull.next;
    }
    return around;
}

std::vector<std::uint32_t> World::islands() const { return islandsOf(*m_state); }

std::shared_ptr<const Snapshot> World::snapshot() const { return std::make_shared<const Snapshot>(Snapshot{*m_state}); }

void World::restore(const Snapshot& snapshot) {
    *m_state = snapshot.state;
    m_workshop->isCollided = false;
}

}  // namespace rubble
