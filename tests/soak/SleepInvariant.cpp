// Nothing sleeps in the air, or where it would slide or tip over.
#include "core/base/math/Trigonometry.h"
#include "tests/soak/InitialOverlaps.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace rubble::soak {
namespace {

constexpr double kParallel = 0.9999;    // cosine: contacts of one plane
constexpr double kSlope = 0.01;         // tangent
constexpr double kUpright = 0.99;       // cosine: contacts whose normals are as good as vertical
constexpr double kOffFraction = 0.005;  // of the bounding radius: how far the centre may be beyond its support
constexpr double kOffFloor = 5e-4;      // m

/// The contacts of each body.
using Contacts = std::map<BodyId, std::vector<ContactPoint>>;

Contacts contactsOf(const World& world) {
    Contacts contacts;
    for (const ContactPoint& point : world.contactPoints()) {
        contacts[point.first].push_back(point);
        contacts[point.second].push_back(point);
    }
    return contacts;
}

BodyId otherOf(const ContactPoint& point, BodyId body) { return point.first == body ? point.second : point.first; }

/// The bodies that contacts connect to something static.
std::set<BodyId> supportedBodies(const World& world, const Moment& moment, Contacts& contacts) {
    std::set<BodyId> reached;
    std::vector<BodyId> waiting;
    for (const BodyFacts& one : moment.bodies) {
        if (!one.isDynamic()) waiting.push_back(one.body.body);
    }
    while (!waiting.empty()) {
        const BodyId body = waiting.back();
        waiting.pop_back();
        for (const ContactPoint& point : contacts[body]) {
            const BodyId other = otherOf(point, body);
            if (!world.contains(other) || world.kind(other) != BodyKind::Dynamic) continue;
            if (reached.insert(other).second) waiting.push_back(other);
        }
    }
    return reached;
}

class SleepsSupported : public Invariant {
public:
    const char* name() const override { return "sleeps supported"; }
    void start(const Session&, const Moment& moment) override {
        BodyHulls hulls;
        m_initial.start(moment, hulls);
    }
    std::optional<Fault> check(const StepFacts& step) override {
        if (step.after.gravity == Vec3(0.0)) return std::nullopt;
        const World& world = step.session.world();
        Contacts contacts = contactsOf(world);
        const std::set<BodyId> supported = supportedBodies(world, step.after, contacts);
        for (const BodyFacts& one : step.after.bodies) {
            if (!one.isDynamic() || !one.state.asleep) continue;
            const std::string name = step.session.nameOf(one.body);
            if (!supported.contains(one.body.body)) return Fault{name, "it sleeps, and nothing static supports it"};
            if (m_initial.isInside(one)) continue;  // it may be jammed, where contacts are no support
            if (const double slope = beyondFriction(step, one, contacts[one.body.body]); slope > kSlope) {
                return Fault{name, "it sleeps on a slope that is " + textOf(slope) + " beyond its friction"};
            }
            const double off = beyondSupport(step, one, contacts[one.body.body]);
            if (off <= std::max(kOffFloor, kOffFraction * one.boundingRadius)) continue;
            return Fault{name, "it sleeps, with its centre " + textOf(off) + " m beyond what it stands on"};
        }
        return std::nullopt;
    }

private:
    static bool isStatic(const World& world, BodyId body) {
        return !world.contains(body) || world.kind(body) != BodyKind::Dynamic;
    }

    /// The normal of a contact, into a body.
    static Vec3 normalInto(const ContactPoint& point, BodyId body) {
        return point.second == body ? point.normal : -point.normal;
    }

    /// How much steeper than its friction allows a body lies that touches static planes of one direction only.
    static double beyondFriction(const StepFacts& step, const BodyFacts& one, const std::vector<ContactPoint>& points) {
        const World& world = step.session.world();
        if (points.empty()) return 0.0;
        const Vec3 normal = normalInto(points.front(), one.body.body);
        double friction = 0.0;
        for (const ContactPoint& point : points) {
            const BodyId other = otherOf(point, one.body.body);
            if (!world.contains(other) || !isStatic(world, other)) return 0.0;
            if (glm::dot(normalInto(point, one.body.body), normal) < kParallel) return 0.0;  // it may be jammed
            friction = std::max(friction, std::sqrt(world.friction(one.body.body) * world.friction(other)));
        }
        const double across = std::abs(glm::dot(step.after.gravity, normal));
        const double along = glm::length(step.after.gravity - glm::dot(step.after.gravity, normal) * normal);
        return along / std::max(across, 1e-9) - friction;
    }

    /// How far the centre of a body is beyond the contacts that carry it, m; 0 where not all of these are vertical, or
    /// not all with what is static.
    static double beyondSupport(const StepFacts& step, const BodyFacts& one, const std::vector<ContactPoint>& points) {
        const Vec3 up = -glm::normalize(step.after.gravity);
        const auto isPlain = [&](const ContactPoint& point) {
            const bool isOnStatic = isStatic(step.session.world(), otherOf(point, one.body.body));
            return isOnStatic && glm::dot(normalInto(point, one.body.body), up) >= kUpright;
        };
        if (points.empty() || !std::ranges::all_of(points, isPlain)) return 0.0;
        const Vec3 side = glm::normalize(glm::cross(up, std::abs(up.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 0, 1)));
        const Vec3 front = glm::cross(up, side);
        double beyond = 0.0;
        constexpr int kDirections = 64;
        for (int k = 0; k < kDirections; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kDirections;
            const Vec3 direction = cosine(angle) * side + sine(angle) * front;
            double farthest = -1e300;
            for (const ContactPoint& point : points) {
                farthest = std::max(farthest, glm::dot(point.point - one.state.centre, direction));
            }
            beyond = std::max(beyond, -farthest);
        }
        return beyond;
    }

    InitialOverlaps m_initial;
};

}  // namespace

std::unique_ptr<Invariant> sleepsSupported() { return std::make_unique<SleepsSupported>(); }

}  // namespace rubble::soak
