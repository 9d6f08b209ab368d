#include "core/play/queries/WouldFall.h"

#include "core/base/DisjointSets.h"
#include "core/base/MessageText.h"
#include "core/play/queries/ContactGraph.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {
namespace {

// A body without support falls 11 cm in the trial and is then 1.5 m/s fast. Steps of this length keep stacks at rest.
constexpr double kTrialStep = 0.05;  // s
constexpr int kTrialSteps = 3;
constexpr double kMovedDistance = 0.01;  // m: more than contacts give way to a changed load
constexpr double kMovedSpeed = 0.15;     // m/s
constexpr double kRestSpeed = 0.1;       // m/s: what is faster falls or flies already

/// As many bodies as can be simulated as they are in a few milliseconds.
constexpr std::size_t kMostConnected = 160;

Status verifyRemoved(const Session& session, std::span<const std::uint32_t> removed) {
    for (const std::uint32_t number : removed) {
        const PlayBody* body = session.body(number);
        if (body == nullptr) {
            return Error{ErrorCode::BadInput, "Cannot remove: there is no body " + std::to_string(number) + "."};
        }
        if (body->role == PlayRole::Ground) return Error{ErrorCode::BadInput, "Cannot remove the ground."};
    }
    return success();
}

/// A body in the trial.
struct TrialBody {
    std::uint32_t place = 0;  // its index in Session::bodies()
    BodyId body;              // in the trial's world
};

/// A world in which bodies are gone, and those whose fate is asked for.
struct Trial {
    World world;
    std::vector<TrialBody> bodies;
};

/// The whole world, with the impulses that hold its bodies.
Trial copiedWorld(const Session& session, std::span<const std::uint32_t> removed,
                  std::span<const std::uint32_t> connected) {
    Trial trial{World({.gravity = session.world().gravity()}), {}};
    trial.world.restore(*session.world().snapshot());
    for (const std::uint32_t place : removed) trial.world.removeBody(session.bodies()[place].body);
    for (const std::uint32_t place : connected) {
        const BodyId body = session.bodies()[place].body;
        if (trial.world.contains(body)) trial.bodies.push_back({place, body});
    }
    return trial;
}

/// The bodies near the removed ones: what rests on them, and what touches that. What those touch is held in place.
Trial nearbyWorld(const Session& session, const ContactGraph& graph, std::span<const std::uint32_t> removed) {
    std::vector<std::uint32_t> nearby(removed.begin(), removed.end());
    graph.addResting(nearby);
    graph.addTouching(nearby);
    std::vector<std::uint32_t> all = nearby;
    graph.addTouching(all);
    std::ranges::sort(nearby);
    std::ranges::sort(all);
    Trial trial{World({.gravity = session.world().gravity()}), {}};
    for (const std::uint32_t place : all) {
        if (std::ranges::find(removed, place) != removed.end()) continue;
        const BodyId body = session.bodies()[place].body;
        const Shape& shape = session.world().shape(body);
        const bool isFree = graph.isDynamic(place) && std::ranges::binary_search(nearby, place);
        const Result<BodyId> added =
            trial.world.addBody({.shape = {std::shared_ptr<void>(), &shape},  // the session's, which outlives the trial
                                 .kind = isFree ? BodyKind::Dynamic : BodyKind::Static,
                                 .pose = session.world().state(body).pose,
                                 .density = isFree ? session.world().mass(body) / shape.mass.volume : 1.0,
                                 .friction = session.world().friction(body),
                                 .restitution = session.world().restitution(body)});
        if (added && isFree) trial.bodies.push_back({place, *added});
    }
    return trial;
}

/// The bodies of a trial, by index in Session::bodies(), that were at rest and are not after it.
std::vector<std::uint32_t> movedIn(Trial& trial, const Session& session) {
    for (int step = 0; step < kTrialSteps; ++step) trial.world.step(kTrialStep);
    std::vector<std::uint32_t> moved;
    for (const TrialBody& body : trial.bodies) {
        if (trial.world.kind(body.body) != BodyKind::Dynamic) continue;
        const BodyState before = session.world().state(session.bodies()[body.place].body);
        const BodyState after = trial.world.state(body.body);
        if (glm::length(before.velocity) > kRestSpeed) continue;
        if (glm::distance(before.centre, after.centre) > kMovedDistance || glm::length(after.velocity) > kMovedSpeed) {
            moved.push_back(body.place);
        }
    }
    std::ranges::sort(moved);
    return moved;
}

/// How far a body falls along `down`, of length 1, until it meets what stays; infinite if nothing does.
double dropOf(const Session& session, std::uint32_t place, Vec3 down, const std::vector<BodyId>& gone) {
    constexpr double kFarthest = 500.0;  // m
    constexpr int kMostPassed = 64;      // bodies that fall or are removed, on the way
    const World& world = session.world();
    const BodyId body = session.bodies()[place].body;
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
    for (int passed = 0; passed < kMostPassed; ++passed) {
        const std::optional<CastHit> hit = world.castRay(from, end);
        if (!hit) break;
        if (hit->body != body && !std::ranges::binary_search(gone, hit->body)) {
            return std::max(0.0, glm::dot(hit->point - state.centre, down) - lowest);
        }
        from = hit->point + 1e-4 * down;  // in that body, which the ray does not meet again
    }
    return std::numeric_limits<double>::infinity();
}

void addTimes(const Session& session, std::span<const std::uint32_t> removed, std::span<const std::uint32_t> fallen,
              Collapse& collapse) {
    const double gravity = glm::length(session.world().gravity());
    const Vec3 down = session.world().gravity() / gravity;
    std::vector<BodyId> gone;
    for (const std::uint32_t place : removed) gone.push_back(session.bodies()[place].body);
    for (const std::uint32_t place : fallen) gone.push_back(session.bodies()[place].body);
    std::ranges::sort(gone);
    collapse.first = std::numeric_limits<double>::infinity();
    for (const std::uint32_t place : fallen) {
        const double time = std::sqrt(2.0 * dropOf(session, place, down, gone) / gravity);
        collapse.first = std::min(collapse.first, time);
        collapse.last = std::max(collapse.last, time);
    }
}

/// The bodies that fall, in islands.
Collapse collapseOf(const Session& session, const ContactGraph& graph, std::span<const std::uint32_t> fallen) {
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
        const PlayBody& body = session.bodies()[fallen[k]];
        FallingIsland& island = islands[sets.rootOf(k)];
        island.bodies.push_back(body.number);
        island.mass += session.world().mass(body.body);
        collapse.mass += session.world().mass(body.body);
    }
    std::erase_if(islands, [](const FallingIsland& island) { return island.bodies.empty(); });
    collapse.islands = std::move(islands);
    return collapse;
}

}  // namespace

Result<Collapse> wouldFall(const Session& session, std::span<const std::uint32_t> removed) {
    if (const Status verified = verifyRemoved(session, removed); !verified) return verified.error();
    if (removed.empty() || session.world().gravity() == Vec3(0.0)) return Collapse{};
    std::vector<std::uint32_t> places;
    for (const std::uint32_t number : removed) {
        const auto body = std::ranges::lower_bound(session.bodies(), number, {}, &PlayBody::number);
        places.push_back(static_cast<std::uint32_t>(body - session.bodies().begin()));
    }
    std::ranges::sort(places);
    places.erase(std::ranges::unique(places).begin(), places.end());
    const ContactGraph graph(session);
    std::vector<std::uint32_t> connected = places;
    for (const std::uint32_t place : places) {  // also what a fixed body holds
        for (const TouchingBody& other : graph.touching(place)) {
            if (graph.isDynamic(other.body)) connected.push_back(other.body);
        }
    }
    std::ranges::sort(connected);
    connected.erase(std::ranges::unique(connected).begin(), connected.end());
    Trial trial = graph.addConnected(connected, kMostConnected) ? copiedWorld(session, places, connected)
                                                                : nearbyWorld(session, graph, places);
    const std::vector<std::uint32_t> fallen = movedIn(trial, session);
    Collapse collapse = collapseOf(session, graph, fallen);
    if (!fallen.empty()) addTimes(session, places, fallen, collapse);
    return collapse;
}

}  // namespace rubble
