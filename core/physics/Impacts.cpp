#include "core/physics/Impacts.h"

#include "core/physics/ImpactSpeeds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace rubble {
namespace {

constexpr float kRoundingSpeed = 0.01f;  // m/s
// Points at most so much behind the first are of one blow, whatever the length of the step; others come when it was dealt.
constexpr float kTogether = 0.005f;  // m
constexpr float kHitSpeed = 1.0f;    // m/s

Vec3f at(const Vec3Row& rows, std::size_t lane) { return Vec3f(rows.x[lane], rows.y[lane], rows.z[lane]); }

/// Of a region.
template <class Visit>
void visitContacts(const WorldState& state, const Regions& regions, std::size_t region, const Visit& visit) {
    const std::span<const ContactColours::List> lists = state.colours.lists();
    for (std::size_t list = 0; list < lists.size(); ++list) {
        const std::span blocks = regions.part(list, std::span(lists[list].blocks), region);
        regions.inTheirOrder(blocks.size(), region, [&](IndexRange range) {
            for (const ContactBlock& block : blocks.subspan(range.begin, range.size())) {
                for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
                    if (block.pointCount[lane] > 0) visit(block, lane);
                }
            }
        });
    }
}

template <class Visit>
void visitContacts(const WorldState& state, const Visit& visit) {
    visitContacts(state, Regions(), 0, visit);
}

/// Two bodies of several hulls may touch at several places: those are in order, too, wherever the contacts are kept.
template <class Event>
void sortByBodies(std::vector<Event>& events) {
    const auto key = [](const Event& event) {
        return std::tuple(event.first, event.second, event.point.x, event.point.y, event.point.z);
    };
    std::stable_sort(events.begin(), events.end(), [&](const Event& a, const Event& b) { return key(a) < key(b); });
}

/// The mean place of the points that `counts` accepts, from the first body's centre, or nothing where there is none.
template <class Counts>
int meanPlace(const ContactBlock& block, std::size_t lane, const Counts& counts, Vec3f& place) {
    int count = 0;
    place = Vec3f(0.0f);
    for (std::size_t i = 0; i < block.pointCount[lane]; ++i) {
        if (!counts(block.points[i])) continue;
        place += at(block.points[i].place, lane);
        ++count;
    }
    if (count > 0) place *= 1.0f / static_cast<float>(count);
    return count;
}

/// The least separation of the points that will touch within a step of dt, m; minus infinity where none will.
float firstSeparation(const ContactBlock& block, std::size_t lane, float dt, float late) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    float first = kInfinity;
    for (std::size_t i = 0; i < block.pointCount[lane]; ++i) {
        const float speed = -block.points[i].approach[lane], separation = block.points[i].separation[lane];
        if (speed > kImpactSpeed && separation <= speed * dt + late) first = std::min(first, separation);
    }
    return first < kInfinity ? first : -kInfinity;
}

/// What a body adds to the inverse of the effective mass at a place along a direction.
float mobility(const WorldState& state, std::uint32_t body, Vec3f arm, Vec3f normal) {
    const Vec3f turning = cross(arm, normal);
    return state.motions[body].inverseMass + dot(turning, state.places[body].inverseInertia * turning);
}

/// How fast gravity alone speeds a body up.
Vec3f fallOf(const WorldState& state, std::uint32_t body, Vec3f gravity) {
    return state.bodies[body].isDynamic() ? gravity : Vec3f(0.0f);
}

std::optional<HitEvent> hitOf(const WorldState& state, const ContactBlock& block, std::size_t lane) {
    const auto isHit = [&](const PointRows& point) {
        return point.approach[lane] < -kHitSpeed && point.stepImpulse[lane] > 0.0f;
    };
    Vec3f place(0.0f);
    if (meanPlace(block, lane, isHit, place) == 0) return std::nullopt;
    HitEvent hit{state.idOf(block.first[lane]),
                 state.idOf(block.second[lane]),
                 toDouble(state.places[block.first[lane]].centre + place),
                 toDouble(at(block.normal, lane)),
                 0.0,
                 0.0};
    for (std::size_t i = 0; i < block.pointCount[lane]; ++i) {
        hit.approachSpeed = std::max(hit.approachSpeed, -static_cast<double>(block.points[i].approach[lane]));
        hit.impulse += block.points[i].stepImpulse[lane];
    }
    return hit;
}

/// An impact, and how far its bodies are apart there.
struct ComingImpact : Impact {
    float separation = 0.0f;  // m
};

/// Of bodies that meet at several hulls, leaves what is of the first blow.
void dropLaterBlows(std::vector<ComingImpact>& impacts) {
    const auto isSamePair = [](const ComingImpact& a, const ComingImpact& b) {
        return a.first == b.first && a.second == b.second;
    };
    auto kept = impacts.begin();
    for (auto begin = impacts.begin(); begin != impacts.end();) {
        const auto end =
            std::find_if_not(begin, impacts.end(), [&](const auto& one) { return isSamePair(*begin, one); });
        const auto first =
            std::min_element(begin, end, [](const auto& a, const auto& b) { return a.separation < b.separation; });
        const float last = first->separation + kTogether;
        kept = std::copy_if(begin, end, kept, [&](const auto& one) { return one.separation <= last; });
        begin = end;
    }
    impacts.erase(kept, impacts.end());
}

}  // namespace

std::vector<Impact> impactsOf(const WorldState& state, const SolverStep& step) {
    std::vector<ComingImpact> impacts;
    // Gravity speeds bodies up within the step, and rounding must not let a hit pass between two steps.
    const float late = (length(step.gravity) * step.dt + kRoundingSpeed) * step.dt;
    visitContacts(state, [&](const ContactBlock& block, std::size_t lane) {
        const float first = firstSeparation(block, lane, step.dt, late);
        const auto approaches = [&](const PointRows& point) {
            return -point.approach[lane] > kImpactSpeed && point.separation[lane] <= first + kTogether;
        };
        Vec3f place(0.0f);
        if (meanPlace(block, lane, approaches, place) == 0) return;
        const std::uint32_t a = block.first[lane], b = block.second[lane];
        const Vec3f normal = at(block.normal, lane), otherPlace = place + at(block.apart, lane);
        const Vec3f speed = state.motions[b].velocity + cross(state.motions[b].spin, otherPlace) -
                            state.motions[a].velocity - cross(state.motions[a].spin, place);
        const float mobilities = mobility(state, a, place, normal) + mobility(state, b, otherPlace, normal);
        if (mobilities <= 0.0f) return;
        ComingImpact impact;
        impact.separation = first;
        impact.first = state.idOf(a);
        impact.second = state.idOf(b);
        impact.point = toDouble(state.places[a].centre + place);
        impact.normal = toDouble(normal);
        // They meet a little later, and gravity works on them until then: what a drop does must not depend on where in the
        // step it ends.
        const float approach = -dot(speed, normal);
        const float gain = -dot(fallOf(state, b, step.gravity) - fallOf(state, a, step.gravity), normal);
        const float squared = approach * approach + 2.0f * gain * std::max(first, 0.0f);
        impact.approachSpeed = std::sqrt(std::max(squared, 0.0f));
        impact.effectiveMass = 1.0f / mobilities;
        impact.restitution = impact.approachSpeed > step.restitutionSpeed ? block.restitution[lane] : 0.0f;
        impacts.push_back(impact);
    });
    sortByBodies(impacts);
    dropLaterBlows(impacts);
    return {impacts.begin(), impacts.end()};
}

void listHits(const WorldState& state, WorkerTeam& team, const Regions& regions,
              std::vector<std::vector<HitEvent>>& byRegion, std::vector<HitEvent>& hits) {
    byRegion.resize(regions.count());
    regions.forEach(team, [&](std::size_t region) {
        byRegion[region].clear();
        visitContacts(state, regions, region, [&](const ContactBlock& block, std::size_t lane) {
            if (const std::optional<HitEvent> hit = hitOf(state, block, lane)) byRegion[region].push_back(*hit);
        });
    });
    for (const std::vector<HitEvent>& some : byRegion) hits.insert(hits.end(), some.begin(), some.end());
    sortByBodies(hits);
}

std::vector<ContactPoint> contactPointsOf(const WorldState& state) {
    std::vector<ContactPoint> points;
    const auto list = [&](const ContactBlock& block, std::size_t lane) {
        for (std::size_t i = 0; i < block.pointCount[lane]; ++i) {
            const PointRows& point = block.points[i];
            points.push_back({state.idOf(block.first[lane]), state.idOf(block.second[lane]),
                              toDouble(state.places[block.first[lane]].centre + at(point.place, lane)),
                              toDouble(at(block.normal, lane)), point.separation[lane], point.impulse[lane]});
        }
    };
    visitContacts(state, list);
    for (const Contact& contact : state.contacts) {
        if (contact.proxies[0] == kNone || contact.stored == kNone) continue;
        ContactBlock block{};
        putLane(block, 0, state.stored[contact.stored].block);
        list(block, 0);
    }
    sortByBodies(points);
    return points;
}

}  // namespace rubble
