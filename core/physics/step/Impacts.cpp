#include "core/physics/step/Impacts.h"

#include "core/physics/narrowphase/Manifold.h"
#include "core/physics/narrowphase/TimeOfImpact.h"
#include "core/physics/solver/SpeedThresholds.h"
#include "core/physics/step/NarrowPhase.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace rubble {
namespace {

constexpr float kRoundingSpeed = 0.01f;  // m/s, tolerance
// Points at most this far behind the first belong to the same impact, for any length of the step.
constexpr float kImpactDepth = 0.005f;  // m
constexpr float kHitSpeed = 0.25f;      // m/s

/// Calls visit(block) for each block of contacts of a region.
template <class Visit>
void visitBlocks(const WorldState& state, const Regions& regions, std::size_t region, const Visit& visit) {
    const std::span<const ContactColours::List> lists = state.colours.lists();
    for (std::size_t list = 0; list < lists.size(); ++list) {
        const std::span blocks = regions.part(list, std::span(lists[list].blocks), region);
        regions.forEachBlockRange(blocks.size(), region, [&](IndexRange range) {
            for (const ContactBlock& block : blocks.subspan(range.begin, range.size())) visit(block);
        });
    }
}

/// Calls visit(block, lane) for each contact.
template <class Visit>
void visitContacts(const WorldState& state, const Visit& visit) {
    visitBlocks(state, Regions(), 0, [&](const ContactBlock& block) {
        for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
            if (block.pointCount[lane] > 0) visit(block, lane);
        }
    });
}

/// By bodies, then by point, since bodies of several hulls may touch at several points: independent of the order of
/// lanes.
template <class Event>
void sortByBodies(std::vector<Event>& events) {
    const auto key = [](const Event& event) {
        return std::tuple(event.first, event.second, event.point.x, event.point.y, event.point.z);
    };
    std::stable_sort(events.begin(), events.end(), [&](const Event& a, const Event& b) { return key(a) < key(b); });
}

/// Computes the centroid of the points that `counts` accepts, relative to the first body's centre. Returns their
/// number.
template <class Counts>
int computeCentroid(const ContactBlock& block, std::size_t lane, const Counts& counts, Vec3f& centroid) {
    int count = 0;
    centroid = Vec3f(0.0f);
    for (std::size_t i = 0; i < block.pointCount[lane]; ++i) {
        if (!counts(block.points[i])) continue;
        centroid += block.points[i].position.at(lane);
        ++count;
    }
    if (count > 0) centroid *= 1.0f / static_cast<float>(count);
    return count;
}

/// A body's contribution to the inverse effective mass at a point along a direction.
float inverseEffectiveMass(const WorldState& state, std::uint32_t body, Vec3f arm, Vec3f normal) {
    const Vec3f turning = cross(arm, normal);
    return state.motions[body].inverseMass + dot(turning, state.poses[body].inverseInertia * turning);
}

/// The velocity of a point of a body.
Vec3f velocityAt(const WorldState& state, std::uint32_t body, Vec3f arm) {
    return state.motions[body].velocity + cross(state.motions[body].angularVelocity, arm);
}

/// The acceleration of a body by gravity.
Vec3f gravityOn(const WorldState& state, std::uint32_t body, Vec3f gravity) {
    return state.bodies[body].isDynamic() ? gravity : Vec3f(0.0f);
}

/// The speed at which a point approaches when it touches, m/s, negative where it moves away; `gain`: what gravity adds
/// to the approach, m/s². The impact of a drop must not depend on where in the step it ends.
float speedAtImpact(float approach, float separation, float gain) {
    const float squared = std::abs(approach) * approach + 2.0f * gain * std::max(separation, 0.0f);
    return squared > 0.0f ? std::sqrt(squared) : -std::sqrt(-squared);
}

/// What gravity adds to the approach of the bodies of a contact, m/s².
float approachGain(const WorldState& state, const ContactBlock& block, std::size_t lane, Vec3f normal) {
    const Vec3f gravity = state.gravity;
    return -dot(gravityOn(state, block.second[lane], gravity) - gravityOn(state, block.first[lane], gravity), normal);
}

/// The least separation of the points that will touch within dt seconds, m; minus infinity if none will.
float firstSeparation(const ContactBlock& block, std::size_t lane, float gain, float dt, float tolerance) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    float first = kInfinity;
    for (std::size_t i = 0; i < block.pointCount[lane]; ++i) {
        const float separation = block.points[i].separation[lane];
        const float speed = speedAtImpact(-block.points[i].approach[lane], separation, gain);
        if (speed > kMinImpactSpeed && separation <= speed * dt + tolerance) first = std::min(first, separation);
    }
    return first < kInfinity ? first : -kInfinity;
}

/// Whether a contact of a block may be a hit, which few are.
bool mayHit(const ContactBlock& block) {
    int hits = 0;  // in all lanes at once
    for (const PointRows& point : block.points) {
        for (int lane = 0; lane < kBlockLanes; ++lane) {
            hits |=
                static_cast<int>(point.approach[lane] < -kHitSpeed) & static_cast<int>(point.stepImpulse[lane] > 0.0f);
        }
    }
    return hits != 0;
}

std::optional<HitEvent> hitOf(const WorldState& state, const ContactBlock& block, std::size_t lane,
                              const std::vector<StartMotion>& starts) {
    const auto isHit = [&](const PointRows& point) {
        return point.approach[lane] < -kHitSpeed && point.stepImpulse[lane] > 0.0f;
    };
    Vec3f position(0.0f);
    if (computeCentroid(block, lane, isHit, position) == 0) return std::nullopt;
    HitEvent hit{state.idOf(block.first[lane]),
                 state.idOf(block.second[lane]),
                 toDouble(state.poses[block.first[lane]].centre + position),
                 toDouble(block.normal.at(lane)),
                 0.0,
                 0.0,
                 contactEnergy(state, block, lane, starts)};
    for (std::size_t i = 0; i < block.pointCount[lane]; ++i) {
        hit.approachSpeed = std::max(hit.approachSpeed, -static_cast<double>(block.points[i].approach[lane]));
        hit.impulse += block.points[i].stepImpulse[lane];
    }
    return hit;
}

/// An impact and the separation of its bodies there.
struct SeparatedImpact : Impact {
    float separation = 0.0f;  // m
};

/// Where two bodies touch at the time of impact: from their centres, and along which normal.
struct TouchingPoint {
    Vec3f armFirst, armSecond;
    Vec3f normal;
};

/// The centroid of the points at most kImpactDepth behind the first.
Vec3f centroidOf(const Manifold& manifold) {
    const std::span points(manifold.points.data(), static_cast<std::size_t>(manifold.count));
    const float last = std::ranges::min_element(points, {}, &Manifold::Point::separation)->separation + kImpactDepth;
    Vec3f sum(0.0f);
    float count = 0.0f;
    for (const Manifold::Point& point : points) {
        if (point.separation > last) continue;
        sum += point.position;
        count += 1.0f;
    }
    return sum * (1.0f / count);
}

/// Where bodies touch that are apart now: the features that are closest now need not be the ones that meet. Nothing if
/// they miss each other without rotating.
std::optional<TouchingPoint> sweptTouch(const WorldState& state, std::uint32_t number, float dt) {
    constexpr float kSlack = 1.25f;  // of the displacement: rotation and gravity may bring them together, too
    const Contact& contact = state.contacts[number];
    const PlacedHull& firstPlaced = placedHullOf(state, state.proxies[contact.proxies[0]]);
    const PlacedHull& secondPlaced = placedHullOf(state, state.proxies[contact.proxies[1]]);
    const Hull &first = *firstPlaced.hull, &second = *secondPlaced.hull;
    const BodyPose &firstPose = state.poses[contact.bodies[0]], &secondPose = state.poses[contact.bodies[1]];
    RelativePose pose = relativePose(firstPose, firstPlaced.offset, secondPose, secondPlaced.offset);
    const Mat3f rotation = firstPose.rotation.matrix();
    const Vec3f armFirst = rotation * firstPlaced.offset;
    const Vec3f armSecond = secondPose.rotation.matrix() * secondPlaced.offset;
    const Vec3f velocity =
        velocityAt(state, contact.bodies[1], armSecond) - velocityAt(state, contact.bodies[0], armFirst);
    const Vec3f displacement = rotation.transposedTimes(velocity * (kSlack * dt));
    const TimeOfImpact impact = timeOfImpact(first, second, pose, displacement);
    if (impact.axis.kind == AxisKind::None) return std::nullopt;
    pose.offset = pose.offset + displacement * impact.fraction;
    const Manifold manifold = touchingManifold(impact.axis, first, second, pose, kImpactDepth);
    if (manifold.count == 0) return std::nullopt;
    const Vec3f position = centroidOf(manifold);
    return TouchingPoint{rotation * position + armFirst, rotation * (position - pose.offset) + armSecond,
                         rotation * manifold.normal};
}

/// Where the bodies of a contact touch, from a position between them now. A swept manifold is that of the time of
/// impact already.
TouchingPoint touchingPoint(const WorldState& state, const ContactBlock& block, std::size_t lane, Vec3f position,
                            float separation, float dt) {
    const std::uint32_t a = block.first[lane], b = block.second[lane];
    const Vec3f centreOffset = block.centreOffset.at(lane);
    const Vec3f swept = state.poses[a].centre - state.poses[b].centre - centreOffset;
    if (separation > kImpactDepth && lengthSquared(swept) == 0.0f) {
        if (const auto touch = sweptTouch(state, block.contact[lane], dt)) return *touch;
    }
    return {position, position + centreOffset, block.normal.at(lane)};
}

std::optional<SeparatedImpact> impactAt(const WorldState& state, const ContactBlock& block, std::size_t lane,
                                        Vec3f position, float separation, const SolverStep& step) {
    const std::uint32_t a = block.first[lane], b = block.second[lane];
    const auto [armFirst, armSecond, normal] = touchingPoint(state, block, lane, position, separation, step.dt);
    const float inverseMass =
        inverseEffectiveMass(state, a, armFirst, normal) + inverseEffectiveMass(state, b, armSecond, normal);
    if (inverseMass <= 0.0f) return std::nullopt;
    SeparatedImpact impact;
    impact.separation = separation;
    impact.first = state.idOf(a);
    impact.second = state.idOf(b);
    impact.normal = toDouble(normal);
    const float approach = -dot(velocityAt(state, b, armSecond) - velocityAt(state, a, armFirst), normal);
    impact.approachSpeed =
        std::max(0.0f, speedAtImpact(approach, separation, approachGain(state, block, lane, normal)));
    impact.point = toDouble(state.poses[a].centre + armFirst);
    impact.effectiveMass = 1.0f / inverseMass;
    impact.restitution = impact.approachSpeed > step.restitutionSpeed ? block.restitution[lane] : 0.0f;
    return impact;
}

/// Removes impacts of the same two bodies that come after the first.
void removeLaterImpacts(std::vector<SeparatedImpact>& impacts) {
    const auto isSamePair = [](const SeparatedImpact& a, const SeparatedImpact& b) {
        return a.first == b.first && a.second == b.second;
    };
    auto kept = impacts.begin();
    for (auto begin = impacts.begin(); begin != impacts.end();) {
        const auto end =
            std::find_if_not(begin, impacts.end(), [&](const auto& one) { return isSamePair(*begin, one); });
        const auto first =
            std::min_element(begin, end, [](const auto& a, const auto& b) { return a.separation < b.separation; });
        const float last = first->separation + kImpactDepth;
        kept = std::copy_if(begin, end, kept, [&](const auto& one) { return one.separation <= last; });
        begin = end;
    }
    impacts.erase(kept, impacts.end());
}

}  // namespace

std::vector<Impact> findImpacts(const WorldState& state, const SolverStep& step,
                                std::span<const std::uint8_t> isWanted) {
    std::vector<SeparatedImpact> impacts;
    // Gravity accelerates bodies within the step, and rounding must not let an impact fall between two steps.
    const float tolerance = (length(step.gravity) * step.dt + kRoundingSpeed) * step.dt;
    visitContacts(state, [&](const ContactBlock& block, std::size_t lane) {
        if (!isWanted.empty() && (isWanted[block.first[lane]] | isWanted[block.second[lane]]) == 0) return;
        const float gain = approachGain(state, block, lane, block.normal.at(lane));
        const float first = firstSeparation(block, lane, gain, step.dt, tolerance);
        const auto approaches = [&](const PointRows& point) {
            return point.separation[lane] <= first + kImpactDepth &&
                   speedAtImpact(-point.approach[lane], point.separation[lane], gain) > kMinImpactSpeed;
        };
        Vec3f position(0.0f);
        if (computeCentroid(block, lane, approaches, position) == 0) return;
        if (const auto impact = impactAt(state, block, lane, position, first, step)) impacts.push_back(*impact);
    });
    sortByBodies(impacts);
    removeLaterImpacts(impacts);
    return {impacts.begin(), impacts.end()};
}

void findHits(const WorldState& state, ThreadPool& threads, const Regions& regions,
              const std::vector<StartMotion>& starts, std::vector<std::vector<HitEvent>>& byRegion,
              std::vector<HitEvent>& hits) {
    clearLists(byRegion, regions.count());
    regions.forEach(threads, [&](std::size_t region) {
        visitBlocks(state, regions, region, [&](const ContactBlock& block) {
            if (!mayHit(block)) return;
            for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
                if (const auto hit = hitOf(state, block, lane, starts)) byRegion[region].push_back(*hit);
            }
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
                              toDouble(state.poses[block.first[lane]].centre + point.position.at(lane)),
                              toDouble(block.normal.at(lane)), point.separation[lane], point.impulse[lane]});
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
