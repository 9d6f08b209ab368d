#include "core/play/queries/WouldFall.h"

#include "core/base/DisjointSets.h"
#include "core/base/MessageText.h"
#include "core/play/breaking/DamageDone.h"
#include "core/play/queries/ContactGraph.h"
#include "core/play/queries/PartsRemoved.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

namespace rubble {
namespace {

constexpr double kHorizon = 3.0;         // s
constexpr double kMovedDistance = 0.05;  // m
constexpr double kMovedPart = 0.05;      // of its size, if that is less
constexpr double kRestSpeed = 0.1;       // m/s: what is faster falls or flies already
constexpr double kMinDrop = 0.01;        // m
constexpr double kOnItsWay = 0.15;       // m/s, of what is not yet so far

constexpr std::size_t kMaxBodySteps = 6000;  // of a quick query: a few milliseconds
/// As many bodies as a quick query can simulate as they are, long enough.
constexpr std::size_t kMaxConnected = 160;

// What more bodies than that are connected with: a body without support falls 11 cm and is then 1.5 m/s fast. Steps of
// this length keep stacks at rest.
constexpr double kCoarseStep = 0.05;  // s
constexpr double kCoarseHorizon = 0.15;
constexpr double kCoarseDistance = 0.01;  // m: more than contacts give way to a changed load

/// What is removed: whole bodies, and parts of others.
struct Removal {
    std::vector<std::uint32_t> places;  // of the whole ones: indices in Session::bodies(), ascending
    std::vector<BodyPart> parts;        // ascending body
};

/// Adds fragments to those that a body loses.
Status addFragments(const Session& session, const PlayBody& body, std::span<const std::uint32_t> fragments,
                    std::vector<std::uint32_t>& lost) {
    const std::vector<std::uint32_t> bonded = bondedFragments(body);
    for (const std::uint32_t fragment : fragments) {
        if (!std::ranges::binary_search(bonded, fragment)) {
            return Error{ErrorCode::BadInput, "Cannot remove fragment " + std::to_string(fragment) + " of " +
                                                  quotedName(session.nameOf(body)) + ": it is not bonded in it."};
        }
        lost.push_back(fragment);
    }
    if (fragments.empty()) lost = bonded;
    std::ranges::sort(lost);
    lost.erase(std::unique(lost.begin(), lost.end()), lost.end());
    return success();
}

Result<Removal> removalOf(const Session& session, std::span<const BodyPart> removed) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> lost;  // fragments, by body
    for (const BodyPart& part : removed) {
        const PlayBody* body = session.body(part.body);
        if (body == nullptr) {
            return Error{ErrorCode::BadInput, "Cannot remove: there is no body " + std::to_string(part.body) + "."};
        }
        if (body->role == PlayRole::Ground) return Error{ErrorCode::BadInput, "Cannot remove the ground."};
        const Status added = addFragments(session, *body, part.fragments, lost[part.body]);
        if (!added) return added.error();
    }
    Removal removal;
    for (auto& [number, fragments] : lost) {
        const auto body = std::ranges::lower_bound(session.bodies(), number, {}, &PlayBody::number);
        if (fragments == bondedFragments(*body)) {
            removal.places.push_back(static_cast<std::uint32_t>(body - session.bodies().begin()));
        } else {
            removal.parts.push_back({number, std::move(fragments)});
        }
    }
    return removal;
}

/// Bodies and their world before they are simulated.
struct Moment {
    std::span<const PlayBody> bodies;
    const World& world;
};

/// A body in the trial.
struct TrialBody {
    std::uint32_t place = 0;  // its index in the bodies of the moment
    BodyId body;              // in the trial's world
};

/// A world in which bodies are gone, and those whose fate is asked for.
struct Trial {
    World world;
    std::vector<TrialBody> bodies;
    double dt = 0.0;             // s, of its steps
    double horizon = 0.0;        // s: how long it is simulated
    double movedDistance = 0.0;  // m: what moves farther falls
};

/// The whole world, with the impulses that hold its bodies.
Trial copiedWorld(const Moment& moment, std::span<const std::uint32_t> removed) {
    Trial trial{World({.gravity = moment.world.gravity()})};
    trial.world.restore(*moment.world.snapshot());
    for (const std::uint32_t place : removed) trial.world.removeBody(moment.bodies[place].body);
    for (std::uint32_t place = 0; place < moment.bodies.size(); ++place) {
        const BodyId body = moment.bodies[place].body;
        if (trial.world.contains(body)) trial.bodies.push_back({place, body});
    }
    return trial;
}

/// The bodies near some: what rests on them, and what touches that. What those touch is held in place.
///
/// Errors: those of World::addBody().
Result<Trial> nearbyWorld(const Moment& moment, const ContactGraph& graph, std::span<const std::uint32_t> removed,
                          std::vector<std::uint32_t> nearby) {
    graph.addResting(nearby);
    graph.addTouching(nearby);
    std::vector<std::uint32_t> all = nearby;
    graph.addTouching(all);
    std::ranges::sort(nearby);
    std::ranges::sort(all);
    Trial trial{World({.gravity = moment.world.gravity()})};
    for (const std::uint32_t place : all) {
        if (std::ranges::find(removed, place) != removed.end()) continue;
        const BodyId body = moment.bodies[place].body;
        const Shape& shape = moment.world.shape(body);
        const bool isFree = graph.isDynamic(place) && std::ranges::binary_search(nearby, place);
        const Result<BodyId> added =
            trial.world.addBody({.shape = {std::shared_ptr<void>(), &shape},  // the moment's, which outlives the trial
                                 .kind = isFree ? BodyKind::Dynamic : BodyKind::Static,
                                 .pose = moment.world.state(body).pose,
                                 .density = isFree ? moment.world.mass(body) / shape.mass.volume : 1.0,
                                 .friction = moment.world.friction(body),
                                 .restitution = moment.world.restitution(body)});
        if (!added) return added.error();
        if (isFree) trial.bodies.push_back({place, *added});
    }
    return trial;
}

/// A trial being simulated, and what it finds out.
class TrialRun {
public:
    TrialRun(const Session& session, const Moment& moment, Trial& trial)
        : m_session(session), m_moment(moment), m_trial(trial) {
        m_isDecided.assign(trial.bodies.size(), false);
        for (std::uint32_t k = 0; k < trial.bodies.size(); ++k) {
            const TrialBody& body = trial.bodies[k];
            if (moment.bodies[body.place].fracture() != nullptr) m_breakable[body.body] = k;
        }
        for (const auto& [body, k] : m_breakable) m_asked.push_back(body);
    }

    /// Until all bodies sleep, to the horizon, or until so many steps of single bodies were done.
    void simulate(std::size_t mostBodySteps) {
        const auto steps = static_cast<int>(std::lround(m_trial.horizon / m_trial.dt));
        std::size_t bodySteps = 0;
        m_isStopped = false;
        for (int step = 0; step < steps && !m_isStopped; ++step) {
            m_trial.world.collide(m_trial.dt);
            if (m_session.hasDestruction()) markBroken();
            m_trial.world.solve(m_trial.dt);
            removeEscaped();
            const int awake = m_trial.world.counts().awake;
            if (awake == 0) return;
            bodySteps += static_cast<std::size_t>(awake);
            m_isStopped = bodySteps >= mostBodySteps;
        }
    }

    /// The indices in the moment of the bodies that were at rest and fall, ascending.
    std::vector<std::uint32_t> fallen() const {
        std::vector<std::uint32_t> places;
        for (std::uint32_t k = 0; k < m_trial.bodies.size(); ++k) {
            const TrialBody& body = m_trial.bodies[k];
            const double speed = glm::length(m_moment.world.state(m_moment.bodies[body.place].body).velocity);
            if (speed <= kRestSpeed && (m_isDecided[k] || hasMoved(body))) places.push_back(body.place);
        }
        std::ranges::sort(places);
        return places;
    }

private:
    void markBroken() {
        const std::vector<Impact> impacts = m_trial.world.impacts(m_asked);
        for (const DamageDone& damage : damageOf(impacts, m_trial.world, m_session.scene().project.damage.rule)) {
            const auto found = m_breakable.find(damage.body);
            if (found == m_breakable.end()) continue;
            const PlayBody& body = m_moment.bodies[m_trial.bodies[found->second].place];
            if (damage.amount >= m_session.thresholdOf(body)) m_isDecided[found->second] = true;
        }
    }

    /// What flies out of the world falls, too.
    void removeEscaped() {
        for (std::uint32_t k = 0; k < m_trial.bodies.size(); ++k) {
            const BodyId body = m_trial.bodies[k].body;
            if (!m_trial.world.contains(body) || m_trial.world.isWithinBounds(body)) continue;
            m_trial.world.removeBody(body);
            if (m_breakable.erase(body) > 0) std::erase(m_asked, body);
            m_isDecided[k] = true;
        }
    }

    bool hasMoved(const TrialBody& body) const {
        if (m_trial.world.kind(body.body) != BodyKind::Dynamic) return false;
        const BodyId original = m_moment.bodies[body.place].body;
        const BodyState before = m_moment.world.state(original), after = m_trial.world.state(body.body);
        const double size = 2.0 * m_moment.world.shape(original).boundingRadius;
        const double distance = glm::distance(before.centre, after.centre);
        if (distance > std::min(m_trial.movedDistance, kMovedPart * size)) return true;
        return m_isStopped && glm::length(after.velocity) > kOnItsWay;
    }

    const Session& m_session;
    const Moment& m_moment;
    Trial& m_trial;
    std::map<BodyId, std::uint32_t> m_breakable;  // index in the trial's bodies
    std::vector<BodyId> m_asked;
    std::vector<bool> m_isDecided;  // to fall: by index in the trial's bodies
    bool m_isStopped = false;       // before the horizon
};

/// How far a body falls along `down`, of length 1, until it meets what stays; infinite if nothing does.
double dropOf(const Moment& moment, std::uint32_t place, Vec3 down, const std::vector<BodyId>& gone) {
    constexpr double kFarthest = 500.0;  // m
    constexpr int kMaxPassed = 64;       // bodies that fall or are removed, on the way
    const World& world = moment.world;
    const BodyId body = moment.bodies[place].body;
    const BodyState state = world.state(body);
    double lowest = 0.0;  // of its corners, along `down` from its centre
    for (const PlacedHull& placed : world.shape(body).hulls) {
        for (int k = 0; k < placed.hull->cornerCount; ++k) {
            const Vec3 corner = toDouble(placed.offset + placed.hull->corner(k));
            lowest = std::max(lowest, glm::dot(state.pose.orientation * corner, down));
        }
    }
    const Vec3 end = state.centre + kFarthest * down;
    Vec3 from = state.centre;
    for (int passed = 0; passed < kMaxPassed; ++passed) {
        const std::optional<CastHit> hit = world.castRay(from, end);
        if (!hit) break;
        if (hit->body != body && !std::ranges::binary_search(gone, hit->body)) {
            return std::max(0.0, glm::dot(hit->point - state.centre, down) - lowest);
        }
        from = hit->point + 1e-4 * down;  // in that body, which the ray does not meet again
    }
    return std::numeric_limits<double>::infinity();
}

void addTimes(const Moment& moment, std::span<const std::uint32_t> removed, std::span<const std::uint32_t> fallen,
              Collapse& collapse) {
    const double gravity = glm::length(moment.world.gravity());
    const Vec3 down = moment.world.gravity() / gravity;
    std::vector<BodyId> gone;
    for (const std::uint32_t place : removed) gone.push_back(moment.bodies[place].body);
    for (const std::uint32_t place : fallen) gone.push_back(moment.bodies[place].body);
    std::ranges::sort(gone);
    std::optional<double> first;
    for (const std::uint32_t place : fallen) {
        const double drop = dropOf(moment, place, down, gone);
        if (drop < kMinDrop) continue;  // it is pushed away or broken where it is
        const double time = std::sqrt(2.0 * drop / gravity);
        first = std::min(first.value_or(time), time);
        collapse.last = std::max(collapse.last, time);
    }
    collapse.first = first.value_or(0.0);
}

/// The bodies that fall, in islands; their bodies are indices in the moment.
Collapse collapseOf(const Moment& moment, const ContactGraph& graph, std::span<const std::uint32_t> fallen) {
    Collapse collapse;
    DisjointSets sets(fallen.size());
    for (std::uint32_t k = 0; k < fallen.size(); ++k) {
        for (const TouchingBody& other : graph.touching(fallen[k])) {
            const auto found = std::ranges::lower_bound(fallen, other.body);
            if (found == fallen.end() || *found != other.body) continue;
            sets.merge(k, static_cast<std::uint32_t>(found - fallen.begin()));
        }
    }
    std::vector<FallingIsland> islands(fallen.size());  // by root
    for (std::uint32_t k = 0; k < fallen.size(); ++k) {
        FallingIsland& island = islands[sets.rootOf(k)];
        const double mass = moment.world.mass(moment.bodies[fallen[k]].body);
        island.bodies.push_back(fallen[k]);
        island.mass += mass;
        collapse.mass += mass;
    }
    std::erase_if(islands, [](const FallingIsland& island) { return island.bodies.empty(); });
    collapse.islands = std::move(islands);
    return collapse;
}

/// Bodies, ascending, and each once.
void makeSet(std::vector<std::uint32_t>& bodies) {
    std::ranges::sort(bodies);
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
}

/// The bodies whose support may be gone, those removed among them: what touched a removed body, or one that lost
/// fragments, and what split off that.
std::vector<std::uint32_t> affectedBodies(const Session& session, const Removal& removal, std::size_t count) {
    const ContactGraph before(session.bodies(), session.world());
    std::vector<std::uint32_t> losing = removal.places;
    for (const BodyPart& part : removal.parts) {
        const auto body = std::ranges::lower_bound(session.bodies(), part.body, {}, &PlayBody::number);
        losing.push_back(static_cast<std::uint32_t>(body - session.bodies().begin()));
    }
    std::vector<std::uint32_t> affected = losing;
    for (const std::uint32_t place : losing) {  // also what a fixed body holds
        for (const TouchingBody& other : before.touching(place)) {
            if (before.isDynamic(other.body)) affected.push_back(other.body);
        }
    }
    for (auto place = static_cast<std::uint32_t>(session.bodies().size()); place < count; ++place)
        affected.push_back(place);
    makeSet(affected);
    return affected;
}

/// The bodies of a moment that fall. `cameOff` do anyway; the others if the simulation says so.
///
/// Errors: those of nearbyWorld().
Result<std::vector<std::uint32_t>> fallenOf(const Session& session, QueryEffort effort, const Moment& moment,
                                            const ContactGraph& graph, const Removal& removal,
                                            std::span<const std::uint32_t> affected,
                                            std::span<const std::uint32_t> cameOff) {
    std::vector<std::uint32_t> fallen(cameOff.begin(), cameOff.end());
    std::vector<std::uint32_t> connected(affected.begin(), affected.end());
    const bool isWhole =
        graph.addConnected(connected, effort == QueryEffort::Quick ? kMaxConnected : moment.bodies.size());
    const bool isKnown = std::ranges::all_of(connected, [&](std::uint32_t place) {
        return !graph.isDynamic(place) || std::ranges::binary_search(cameOff, place) ||
               std::ranges::binary_search(removal.places, place);
    });
    if (isWhole && isKnown) return fallen;
    std::vector<std::uint32_t> nearby(removal.places);
    if (!removal.parts.empty()) nearby.assign(affected.begin(), affected.end());
    Result<Trial> trial =
        isWhole ? copiedWorld(moment, removal.places) : nearbyWorld(moment, graph, removal.places, std::move(nearby));
    if (!trial) return trial.error();
    trial->dt = isWhole ? session.stepLength() : kCoarseStep;
    trial->horizon = isWhole ? kHorizon : kCoarseHorizon;
    trial->movedDistance = isWhole ? kMovedDistance : kCoarseDistance;
    TrialRun run(session, moment, *trial);
    run.simulate(effort == QueryEffort::Quick ? kMaxBodySteps : std::numeric_limits<std::size_t>::max());
    std::ranges::copy(run.fallen(), std::back_inserter(fallen));
    makeSet(fallen);
    return fallen;
}

/// The island of a moment in terms of the session that it is of.
FallingIsland islandIn(const Session& session, const PartsRemoved& after, const FallingIsland& island) {
    FallingIsland reported{.mass = island.mass};
    std::map<std::uint32_t, std::vector<std::uint32_t>> parts;  // fragments, by body
    for (const std::uint32_t place : island.bodies) {
        const PlayBody& body = after.bodies[place];
        const std::size_t present = session.bodies().size();
        const std::uint32_t number = place < present ? body.number : after.splitOff[place - present];
        if (!std::ranges::binary_search(after.reduced, number)) {
            reported.bodies.push_back(number);
        } else if (body.nodes.empty()) {
            parts[number].push_back(body.fragment);
        } else {
            std::ranges::copy(fragmentsOf(body), std::back_inserter(parts[number]));
        }
    }
    for (auto& [number, fragments] : parts) {
        makeSet(fragments);
        reported.parts.push_back({number, std::move(fragments)});
    }
    return reported;
}

}  // namespace

Result<Collapse> wouldFall(const Session& session, std::span<const BodyPart> removed, QueryEffort effort) {
    const Result<Removal> removal = removalOf(session, removed);
    if (!removal) return removal.error();
    if (removed.empty() || session.world().gravity() == Vec3(0.0)) return Collapse{};
    std::vector<std::uint32_t> gone;
    for (const std::uint32_t place : removal->places) gone.push_back(session.bodies()[place].number);
    const bool doBondsBreak = !removal->parts.empty() || !session.scene().project.mortars.empty();
    const std::optional<PartsRemoved> after =
        doBondsBreak ? std::optional(withoutParts(session, removal->parts, gone)) : std::nullopt;
    const Moment moment = after ? Moment{after->bodies, after->world} : Moment{session.bodies(), session.world()};
    const ContactGraph graph(moment.bodies, moment.world);
    const std::vector<std::uint32_t> affected = affectedBodies(session, *removal, moment.bodies.size());
    const Result<std::vector<std::uint32_t>> fallen = fallenOf(session, effort, moment, graph, *removal, affected,
                                                               after ? after->cameOff : std::vector<std::uint32_t>());
    if (!fallen) return fallen.error();
    Collapse collapse = collapseOf(moment, graph, *fallen);
    if (!fallen->empty()) addTimes(moment, removal->places, *fallen, collapse);
    for (FallingIsland& island : collapse.islands) {
        if (after) {
            island = islandIn(session, *after, island);
        } else {
            for (std::uint32_t& body : island.bodies) body = session.bodies()[body].number;
        }
    }
    return collapse;
}

Result<Collapse> wouldFall(const Session& session, std::span<const std::uint32_t> removed, QueryEffort effort) {
    std::vector<BodyPart> parts;
    for (const std::uint32_t number : removed) parts.push_back({.body = number});
    return wouldFall(session, parts, effort);
}

}  // namespace rubble
