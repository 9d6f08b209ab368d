#include "core/play/events/MovingContacts.h"

#include <algorithm>
#include <map>
#include <span>
#include <tuple>

namespace rubble {
namespace {

constexpr double kMinSpeed = 0.05;     // m/s
constexpr double kMinPower = 1.0;      // W
constexpr double kRollingSlip = 0.25;  // of the speed of the centre

double powerOf(const MovingContact& contact) { return contact.load * contact.speed; }

Vec3 velocityAt(const BodyState& state, Vec3 point) {
    return state.velocity + glm::cross(state.angularVelocity, point - state.centre);
}

double speedAlong(Vec3 velocity, Vec3 normal) { return glm::length(velocity - glm::dot(velocity, normal) * normal); }

bool isMoving(const World& world, BodyId body, const BodyState& state) {
    return world.kind(body) == BodyKind::Dynamic && !state.asleep;
}

/// How two bodies touch, at all their points together; no load: they do not.
MovingContact contactOf(const World& world, std::span<const ContactPoint> points) {
    BodyId first = points.front().first, second = points.front().second;
    MovingContact contact;
    BodyState one = world.state(first), other = world.state(second);
    if (!isMoving(world, first, one)) {
        std::swap(first, second);
        std::swap(one, other);
    }
    if (!isMoving(world, first, one)) return contact;
    double slip = 0.0, travel = 0.0;  // weighted by force
    Vec3 centre(0.0);
    for (const ContactPoint& point : points) {
        contact.load += point.force;
        centre += point.force * point.point;
        slip += point.force * speedAlong(velocityAt(one, point.point) - velocityAt(other, point.point), point.normal);
        travel += point.force * speedAlong(one.velocity - velocityAt(other, one.centre), point.normal);
    }
    if (!(contact.load > 0.0)) return {};
    contact.body = static_cast<std::uint32_t>(world.tag(first));
    contact.other = static_cast<std::uint32_t>(world.tag(second));
    contact.point = centre / contact.load;
    contact.isRolling = slip < kRollingSlip * travel;
    contact.speed = (contact.isRolling ? travel : slip) / contact.load;
    return contact;
}

}  // namespace

std::vector<MovingContact> movingContacts(const World& world, std::size_t most) {
    const std::vector<ContactPoint> points = world.contactPoints();
    std::map<std::uint32_t, MovingContact> ofBody;
    for (auto begin = points.begin(); begin != points.end();) {
        const auto end = std::find_if(begin, points.end(), [&](const ContactPoint& one) {
            return one.first != begin->first || one.second != begin->second;
        });
        const MovingContact contact = contactOf(world, {begin, end});
        begin = end;
        if (contact.speed < kMinSpeed || powerOf(contact) < kMinPower) continue;
        const auto [known, isNew] = ofBody.try_emplace(contact.body, contact);
        if (!isNew && powerOf(known->second) < powerOf(contact)) known->second = contact;
    }
    std::vector<MovingContact> contacts;
    for (const auto& [body, contact] : ofBody) contacts.push_back(contact);
    std::ranges::stable_sort(contacts, std::greater(), powerOf);
    contacts.resize(std::min(contacts.size(), most));
    std::ranges::sort(contacts, {}, &MovingContact::body);
    return contacts;
}

}  // namespace rubble
