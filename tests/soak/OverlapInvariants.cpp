// Nothing sinks into what is static, or passes through it.
#include "tests/soak/InitialOverlaps.h"

#include <algorithm>
#include <map>
#include <set>

namespace rubble::soak {
namespace {

/// How far bodies may sink in beside kSinkFloor, at most in the step of an impact: contacts are soft.
constexpr double kSinkFraction = 0.25;  // of the least width of the body
constexpr double kSinkOfSize = 0.02;    // of its bounding radius

/// Calls visit(moving body, static body, its hulls) for all that are awake.
template <class Visit>
void forEachStaticPair(const Moment& moment, BodyHulls& hulls, const Visit& visit) {
    for (const BodyFacts& fixed : moment.bodies) {
        if (fixed.isDynamic()) continue;
        const BodyHulls::Posed posed = hulls.of(fixed);
        for (const BodyFacts& moving : moment.bodies) {
            if (moving.isDynamic() && !moving.state.asleep) visit(moving, fixed, posed);
        }
    }
}

class StaticOverlap : public Invariant {
public:
    const char* name() const override { return "static overlap"; }
    void start(const Session&, const Moment& moment) override { m_initial.start(moment, m_hulls); }

    std::optional<Fault> check(const StepFacts& step) override {
        m_hulls.keepOnly(step.after);
        std::optional<Fault> fault;
        forEachStaticPair(step.after, m_hulls, [&](const BodyFacts& moving, const BodyFacts& fixed, const auto& posed) {
            if (!fault) fault = faultOf(step, moving, fixed, posed);
        });
        return fault;
    }

private:
    std::optional<Fault> faultOf(const StepFacts& step, const BodyFacts& moving, const BodyFacts& fixed,
                                 const BodyHulls::Posed& posed) {
        if (m_initial.isInside(moving)) return std::nullopt;
        const double allowed = m_initial.of(moving, fixed) + std::max({kSinkFloor, kSinkFraction * moving.minWidth,
                                                                       kSinkOfSize * moving.boundingRadius});
        const double depth = overlapDepth(m_hulls.of(moving), posed, kSinkFloor);
        if (depth <= allowed) return std::nullopt;
        return Fault{step.session.nameOf(moving.body), "it is " + textOf(depth) + " m deep in " +
                                                           step.session.nameOf(fixed.body) + ", at most " +
                                                           textOf(allowed) + " m are allowed"};
    }

    BodyHulls m_hulls;
    InitialOverlaps m_initial;
};

/// Of bodies at rest: an impact may press fragments into each other for a moment.
class RestingOverlap : public Invariant {
public:
    const char* name() const override { return "resting overlap"; }
    void start(const Session&, const Moment& moment) override { m_initial.start(moment, m_hulls); }

    std::optional<Fault> check(const StepFacts& step) override {
        m_hulls.keepOnly(step.after);
        std::vector<std::pair<const BodyFacts*, BodyHulls::Posed>> bodies;
        for (const BodyFacts& one : step.after.bodies) {
            if (one.isDynamic() && one.state.asleep) bodies.emplace_back(&one, m_hulls.of(one));
        }
        for (std::size_t k = 0; k < bodies.size(); ++k) {
            for (std::size_t other = k + 1; other < bodies.size(); ++other) {
                if (std::optional<Fault> fault = faultOf(step, bodies[k], bodies[other])) return fault;
            }
        }
        return std::nullopt;
    }

private:
    using Placed = std::pair<const BodyFacts*, BodyHulls::Posed>;

    std::optional<Fault> faultOf(const StepFacts& step, const Placed& one, const Placed& other) const {
        if (m_initial.isInside(*one.first) || m_initial.isInside(*other.first)) return std::nullopt;  // it jams
        const double depth = overlapDepth(one.second, other.second, kSinkFloor);
        if (depth == 0.0) return std::nullopt;
        const double width = std::min(one.first->minWidth, other.first->minWidth);
        const double size = std::min(one.first->boundingRadius, other.first->boundingRadius);
        const double allowed =
            m_initial.of(*one.first, *other.first) + std::max({kSinkFloor, kMaxOfWidth * width, kSinkOfSize * size});
        if (depth <= allowed) return std::nullopt;
        return Fault{step.session.nameOf(one.first->body), "it is " + textOf(depth) + " m deep in " +
                                                               step.session.nameOf(other.first->body) + ", at most " +
                                                               textOf(allowed) + " m are allowed"};
    }

    static constexpr double kMaxOfWidth = 0.5;  // beyond it bodies may come out on the other side

    BodyHulls m_hulls;
    InitialOverlaps m_initial;
};

/// The height of a point above the ground, as a plane, m; above 0 where there is none.
double heightAboveGround(const Session& session, Vec3 point) {
    const Ground& ground = session.scene().project.ground;
    return ground.isOn ? point.y - ground.height : 1.0;
}

class NothingTunnels : public Invariant {
public:
    const char* name() const override { return "tunnelling"; }
    void start(const Session& session, const Moment& moment) override {
        m_initial.start(moment, m_hulls);
        for (const BodyFacts& one : moment.bodies) {
            if (one.mass > 0.0) addIfBelow(session, one);
        }
    }

    std::optional<Fault> check(const StepFacts& step) override {
        m_hulls.keepOnly(step.after);
        std::optional<Fault> fault = belowGround(step);
        forEachStaticPair(step.after, m_hulls, [&](const BodyFacts& moving, const BodyFacts& fixed, const auto& posed) {
            if (!fault) fault = passedThrough(step, moving, fixed, posed);
        });
        return fault;
    }

private:
    /// What begins in the ground may stay there.
    void addIfBelow(const Session& session, const BodyFacts& facts) {
        if (heightAboveGround(session, m_hulls.of(facts).box.min) < -kSinkFloor) m_below.insert(facts.body.origin);
    }

    /// What begins above the plane of the ground stays there: also beyond the ground's edge.
    std::optional<Fault> belowGround(const StepFacts& step) {
        for (const BodyFacts& one : step.after.bodies) {
            if (!one.isDynamic() || heightAboveGround(step.session, one.massCentre) >= -0.001) continue;
            const bool isNew = step.before.find(one.body.number) == nullptr;
            if (isNew && one.body.role == PlayRole::Projectile) m_below.insert(one.body.origin);
            if (m_below.contains(one.body.origin)) continue;
            return Fault{step.session.nameOf(one.body), "its centre is below the ground, at " + textOf(one.massCentre)};
        }
        return std::nullopt;
    }

    /// What is held has the centre of mass of its whole, however little of that is left.
    static bool isSame(const PlayBody& one, const PlayBody& other) {
        return one.fragment == other.fragment && one.structure == other.structure && one.nodes == other.nodes &&
               one.isHeld == other.isHeld;
    }

    /// How far the path of a body may be from a straight line, m: it is pushed once in a step, say round an edge.
    static double deviationOf(const StepFacts& step, const BodyState& before, const BodyState& after) {
        return 0.25 * step.session.stepLength() * glm::distance(before.velocity, after.velocity);
    }

    /// The centre of a body that lies in one of its hulls cannot come out on the other side of something.
    std::optional<Fault> passedThrough(const StepFacts& step, const BodyFacts& moving, const BodyFacts& fixed,
                                       const BodyHulls::Posed& posed) {
        if (m_initial.isInside(moving)) return std::nullopt;
        const BodyFacts* const before = step.before.find(moving.body.number);
        if (before == nullptr || !isSame(before->body, moving.body)) return std::nullopt;
        if (!contains(m_hulls.of(moving), moving.state.centre)) return std::nullopt;
        const double length = lengthThrough(posed, before->state.centre, moving.state.centre,
                                            kGrazed + deviationOf(step, before->state, moving.state));
        if (length <= std::max(0.001, kSinkFraction * moving.minWidth)) return std::nullopt;
        return Fault{step.session.nameOf(moving.body),
                     "its centre passed through " + textOf(length) + " m of " + step.session.nameOf(fixed.body)};
    }

    static constexpr double kGrazed = 5e-4;  // m: as deep as the thinnest bodies may be

    BodyHulls m_hulls;
    InitialOverlaps m_initial;
    std::set<std::uint32_t> m_below;  // origins
};

}  // namespace

std::unique_ptr<Invariant> staticOverlap() { return std::make_unique<StaticOverlap>(); }
std::unique_ptr<Invariant> restingOverlap() { return std::make_unique<RestingOverlap>(); }
std::unique_ptr<Invariant> nothingTunnels() { return std::make_unique<NothingTunnels>(); }

}  // namespace rubble::soak
