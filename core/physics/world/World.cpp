#include "core/physics/world/World.h"

#include "core/base/Assert.h"
#include "core/base/Stopwatch.h"
#include "core/physics/islands/Sleeping.h"
#include "core/physics/state/Contacts.h"
#include "core/physics/state/Regions.h"
#include "core/physics/state/StateSize.h"
#include "core/physics/state/VerifyBody.h"
#include "core/physics/state/WorldState.h"
#include "core/physics/step/BroadPhase.h"
#include "core/physics/step/ContinuousCollision.h"
#include "core/physics/step/DeepContacts.h"
#include "core/physics/step/EnergyLimit.h"
#include "core/physics/step/Impacts.h"
#include "core/physics/step/NarrowPhase.h"
#include "core/physics/step/RollingResistance.h"
#include "core/physics/step/SharedLoad.h"
#include "core/physics/step/Solver.h"
#include "core/physics/step/StaticOverlaps.h"
#include "core/physics/world/Bodies.h"
#include "core/physics/world/Split.h"
#include "core/physics/world/ThreadingHeuristic.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

std::uint32_t proxyOf(const WorldState& state, std::uint32_t body, std::uint32_t hull) {
    std::uint32_t proxy = state.bodies[body].firstProxy;
    while (state.proxies[proxy].hull != hull) proxy = state.proxies[proxy].next;
    return proxy;
}

/// Adds a contact with a known manifold.
void addCachedContact(WorldState& state, std::uint32_t first, std::uint32_t second, const CachedManifold& cached) {
    const std::uint32_t contact = addContact(state, first, second);
    if (contact == kNone) return;
    const HullCollision& collision = cached.collisions[state.contacts[contact].proxies[0] == first ? 0 : 1];
    wakeBodies(state, contact);
    beginTouching(state, contact, static_cast<std::uint32_t>(collision.manifold.count));
    storeManifold(state, contact, collision);
}

bool isAlive(const WorldState& state, std::uint32_t body) { return state.bodies[body].shape != nullptr; }

}  // namespace

struct World::StepContext {
    explicit StepContext(const WorldSettings& settings)
        : threads(settings.threads), kernels(kernelsOf(settings.lanes)) {}

    bool hasEnoughContacts(const WorldState& state) const {
        // Below, two threads are never faster than one: a step has two hundred stages with a barrier after each.
        constexpr std::size_t kMinContacts = 1000;
        return threads.size() > 1 && state.colours.contactCount() >= kMinContacts;
    }
    int threadCountFor(const WorldState& state) const {
        return hasEnoughContacts(state) && heuristic.isThreaded() ? threads.size() : 1;
    }

    ThreadPool threads;
    const SolverKernels& kernels;
    ThreadingHeuristic heuristic;
    int threadCount = 1;  // of the current step
    PairScratch pairs;
    NarrowPhaseScratch collisions;
    SolveScratch solve;
    ContactEnergyScratch energy;
    std::vector<std::vector<HitEvent>> hits;  // by region
    ContinuousScratch continuous;
    StaticOverlapScratch overlaps;
    StepCounts counts;
    StepTimes times;
    Regions regions;
    float dt = 0.0f;          // s, of the current step
    bool isCollided = false;  // the current step has been collided, but not solved
};

World::World(const WorldSettings& settings)
    : m_state(std::make_unique<WorldState>()), m_context(std::make_unique<StepContext>(settings)) {
    RUBBLE_ASSERT(isWithin(settings.gravity, kMaxSpeed));
    m_state->gravity = toFloat(settings.gravity);
    m_state->sleeping = settings.sleeping;
    m_state->colours.resizeBodies(1);
}

World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

Result<BodyId> World::addBody(const BodyDefinition& definition) {
    if (const std::optional<std::string> fault = verifyBodyDefinition(definition))
        return Error{ErrorCode::BadInput, *fault};
    return m_state->idOf(rubble::addBody(*m_state, definition));
}

void World::removeBody(BodyId body) {
    RUBBLE_ASSERT(contains(body));
    rubble::removeBody(*m_state, body.index);
}

Result<std::vector<BodyId>> World::split(BodyId body, std::span<const SplitPart> parts) {
    RUBBLE_ASSERT(contains(body));
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (const auto fault = verifyPart(parts[k])) {
            return Error{ErrorCode::BadInput, "Part " + std::to_string(k) + ": " + *fault};
        }
    }
    std::vector<BodyId> ids;
    for (const std::uint32_t index : splitBody(*m_state, body.index, parts)) ids.push_back(m_state->idOf(index));
    return ids;
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

bool World::isWithinBounds(BodyId body) const {
    RUBBLE_ASSERT(contains(body));
    const BodyPose& pose = m_state->poses[body.index];
    const BodyMotion& motion = m_state->motions[body.index];
    const Quatf& q = pose.rotation;
    // A sum is only finite if all of its terms are.
    const float sum = q.x + q.y + q.z + q.w + motion.velocity.x + motion.velocity.y + motion.velocity.z +
                      motion.angularVelocity.x + motion.angularVelocity.y + motion.angularVelocity.z;
    return isWithin(toDouble(pose.centre), kMaxCoordinate) && std::isfinite(sum);
}

BodyState World::state(BodyId body) const {
    RUBBLE_ASSERT(contains(body));
    const BodyMotion& motion = m_state->motions[body.index];
    const Body& record = m_state->bodies[body.index];
    return {poseOf(*m_state, body.index), toDouble(m_state->poses[body.index].centre), toDouble(motion.velocity),
            toDouble(motion.angularVelocity), record.isDynamic() && !record.isAwake};
}

Vec3 World::centre(BodyId body) const {
    RUBBLE_ASSERT(contains(body));
    return toDouble(m_state->poses[body.index].centre);
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

double World::friction(BodyId body) const {
    RUBBLE_ASSERT(contains(body));
    return m_state->bodies[body.index].friction;
}

double World::restitution(BodyId body) const {
    RUBBLE_ASSERT(contains(body));
    return m_state->bodies[body.index].restitution;
}

void World::collide(double dt) {
    RUBBLE_ASSERT(!m_context->isCollided || m_context->dt == static_cast<float>(dt));
    const CollideBodies bodies = m_context->isCollided ? CollideBodies::Changed : CollideBodies::All;
    collide(dt, bodies, bodies);
}

void World::recollide(double dt, std::span<const BodyId> bodies) {
    WorldState& state = *m_state;
    for (const BodyId body : bodies) {
        visitContacts(state, body.index, [&](std::uint32_t number, std::uint32_t) {
            const Contact& contact = state.contacts[number];
            if (contact.slot.isSet() && isApart(state, contact)) outdateManifold(state, contact);
        });
    }
    const bool isSame = m_context->isCollided && m_context->dt == static_cast<float>(dt);
    collide(dt, isSame ? CollideBodies::Changed : CollideBodies::All, CollideBodies::All);
}

void World::collide(double dt, CollideBodies paired, CollideBodies collided) {
    StepContext& context = *m_context;
    Stopwatch watch;
    if (!context.isCollided) {
        m_state->events.began.clear();
        m_state->events.ended.clear();
        m_state->events.hits.clear();
        m_state->events.fellAsleep.clear();
        m_state->events.contactLoss = 0.0;
        context.times = {};
        context.counts.separatingAxisTests = 0;
    }
    const bool newOnly = collided == CollideBodies::Changed;
    if (!newOnly) context.threadCount = context.threadCountFor(*m_state);
    context.dt = static_cast<float>(dt);
    context.isCollided = true;
    updateAwakeBodies(*m_state);
    context.regions.assignBodies(*m_state, context.threadCount);
    findPairs(*m_state, context.threads, context.regions, context.pairs, context.dt,
              paired == CollideBodies::Changed ? PairBodies::Changed : PairBodies::All);
    context.times.pairs += watch.lap();
    context.counts.separatingAxisTests += findManifolds(*m_state, context.threads, context.regions, context.collisions,
                                                        context.kernels, solverStep(*m_state, context.dt), newOnly);
    context.times.collide += watch.lap();
}

bool World::hasUncollided() const { return !m_state->rebox.empty(); }

void World::sleepInPlace(double dt) {
    RUBBLE_ASSERT(!m_context->isCollided);
    collide(dt);
    m_context->isCollided = false;
    sleepAllIslands(*m_state);
}

void World::addContact(BodyId first, BodyId second, std::span<const CachedManifold> manifolds) {
    RUBBLE_ASSERT(contains(first) && contains(second) && first != second);
    WorldState& state = *m_state;
    for (const CachedManifold& cached : manifolds) {
        addCachedContact(state, proxyOf(state, first.index, cached.hulls[0]),
                         proxyOf(state, second.index, cached.hulls[1]), cached);
    }
    if (!manifolds.empty()) return;
    for (std::uint32_t a = state.bodies[first.index].firstProxy; a != kNone; a = state.proxies[a].next) {
        for (std::uint32_t b = state.bodies[second.index].firstProxy; b != kNone; b = state.proxies[b].next) {
            rubble::addContact(state, a, b);
        }
    }
}

bool World::areTouching(BodyId first, BodyId second) const {
    RUBBLE_ASSERT(contains(first) && contains(second));
    bool isTouching = false;
    visitContacts(*m_state, first.index, [&](std::uint32_t number, std::uint32_t other) {
        const Contact& contact = m_state->contacts[number];
        isTouching = isTouching || (other == second.index && (contact.slot.isSet() || contact.stored != kNone));
    });
    return isTouching;
}

std::vector<Impact> World::impacts() {
    RUBBLE_ASSERT(m_context->isCollided);
    const SolverStep step = solverStep(*m_state, m_context->dt);
    prepareContacts(*m_state, m_context->threads, m_context->regions, m_context->solve, m_context->kernels, step);
    return findImpacts(*m_state, step);
}

std::vector<Impact> World::impacts(std::span<const BodyId> bodies) {
    RUBBLE_ASSERT(m_context->isCollided);
    if (bodies.empty()) return {};
    std::vector<std::uint8_t> isWanted(m_state->bodies.size(), 0);
    for (const BodyId body : bodies) isWanted[body.index] = 1;
    const SolverStep step = solverStep(*m_state, m_context->dt);
    prepareContacts(*m_state, m_context->threads, m_context->regions, m_context->solve, m_context->kernels, step);
    return findImpacts(*m_state, step, isWanted);
}

void World::solve(double dt) {
    StepContext& context = *m_context;
    RUBBLE_ASSERT(context.isCollided && context.dt == static_cast<float>(dt));
    context.isCollided = false;
    const SolverStep step = solverStep(*m_state, context.dt);
    Stopwatch watch;
    updateAwakeBodies(*m_state);
    context.regions.assignBodies(*m_state, context.threadCount);
    context.regions.sortContacts(*m_state, context.threads);
    prepareContacts(*m_state, context.threads, context.regions, context.solve, context.kernels, step);
    const bool hasContacts = m_state->colours.contactCount() > 0 || !m_state->separated.empty();
    if (hasContacts) saveStartMotions(*m_state, context.threads, context.regions, context.energy);
    context.solve.scaled = scaleMasses(*m_state, context.solve.unequalBlocks, context.kernels, step);
    softenSharedContacts(*m_state, context.threads, context.regions, step);
    context.times.prepare = watch.lap();
    solveSubSteps(*m_state, context.threads, context.regions, context.solve, context.kernels, step,
                  context.energy.starts);
    restoreMasses(*m_state, context.solve.scaled);
    resistRolling(*m_state);
    limitSpins(*m_state, context.threads, context.regions);
    context.times.solve = watch.lap();
    displaceDeepContacts(*m_state, context.solve.deepBlocks, step.dt);
    findUnforeseenPairs(*m_state, context.threads, context.regions, context.pairs);
    const std::vector<BodyPair> clamped =
        clampFastBodies(*m_state, context.threads, context.regions, context.continuous);
    if (hasContacts) findContactEvents(step, clamped);
    displaceOutOfStatic(*m_state, context.threads, context.regions, step, context.overlaps);
    finishBodies(*m_state, context.threads, context.regions, context.dt);
    context.counts.awake = static_cast<int>(m_state->awake.size());
    context.counts.islands = sleepRestingIslands(*m_state);
    context.times.finish = watch.lap();
    if (context.hasEnoughContacts(*m_state)) context.heuristic.addStep(context.times.total());
}

void World::findContactEvents(const SolverStep& step, std::span<const BodyPair> clamped) {
    StepContext& context = *m_context;
    StepEvents& events = m_state->events;
    const double loss =
        limitEnergy(*m_state, context.threads, context.regions, context.kernels, step, clamped, context.energy);
    findHits(*m_state, context.threads, context.regions, context.energy.starts, context.hits, events.hits);
    addGravity(*m_state, step, context.energy.starts, events.hits);
    limitHits(events.hits, loss);
    events.contactLoss = loss + m_state->grabWork;
}

void World::step(double dt) {
    collide(dt);
    solve(dt);
}

const StepEvents& World::events() const { return m_state->events; }
const StepTimes& World::times() const { return m_context->times; }

StepCounts World::counts() const {
    StepCounts counts = m_context->counts;
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

std::vector<ContactPoint> World::contactPoints() const {
    std::vector<ContactPoint> points = contactPointsOf(*m_state);
    if (!(m_context->dt > 0.0f)) return points;
    const double subStep = double{solverStep(*m_state, m_context->dt).subStep};
    for (ContactPoint& point : points) point.force = point.impulse / subStep;
    return points;
}

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

std::optional<CastHit> World::castRay(Vec3 from, Vec3 to) const { return rubble::castRay(*m_state, from, to); }

Result<std::optional<CastHit>> World::castHull(const Polytope& polytope, const Pose& pose, Vec3 displacement) const {
    return rubble::castHull(*m_state, polytope, pose, displacement);
}

Result<std::vector<BodyId>> World::overlapping(const Polytope& polytope, const Pose& pose) const {
    return overlappingBodies(*m_state, polytope, pose);
}

std::shared_ptr<const Snapshot> World::snapshot() const { return std::make_shared<const Snapshot>(Snapshot{*m_state}); }

std::size_t World::snapshotBytes() const { return byteCount(*m_state); }

void World::restore(const Snapshot& snapshot) {
    *m_state = snapshot.state;
    m_context->isCollided = false;
}

}  // namespace rubble
