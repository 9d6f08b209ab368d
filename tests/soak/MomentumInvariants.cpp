// Only gravity changes the momentum of what touches nothing static.
#include "core/base/DisjointSets.h"
#include "tests/soak/BodyHulls.h"

#include <algorithm>
#include <map>

namespace rubble::soak {
namespace {

constexpr double kRelative = 1e-4;  // single precision, summed over sub-steps
constexpr double kDrift = 1e-3;     // m/s: slower motion may end
constexpr double kAngular = 0.02;   // of the angular momentum

/// The number of the body that is grabbed.
std::optional<std::uint32_t> grabbedNumber(const Session& session) {
    const auto spring = session.world().grabSpring();
    return spring ? std::optional(static_cast<std::uint32_t>(session.world().tag(spring->body))) : std::nullopt;
}

/// Bodies that may have acted on each other in a step: all that came near, whatever the simulation says of contacts.
class ActingBodies {
public:
    /// `grabbed`: the number of the body that was grabbed before the step.
    ActingBodies(const StepFacts& step, BodyHulls& hulls, std::optional<std::uint32_t> grabbed)
        : m_sets(countOf(step)), m_boxes(countOf(step)) {
        m_isFree.assign(m_boxes.size(), true);
        for (const Moment* moment : {&step.before, &step.after}) {
            for (const BodyFacts& one : moment->bodies) include(one, step.session.stepLength(), hulls);
        }
        for (std::uint32_t first = 0; first < m_boxes.size(); ++first) {
            for (std::uint32_t second = first + 1; second < m_boxes.size(); ++second) {
                if (!isApart(m_boxes[first], m_boxes[second])) join(first, second);
            }
        }
        for (const PlayBreak& one : step.events.breaks) {
            for (std::uint32_t k = 0; k < one.fragmentCount; ++k) join(one.body.number, one.firstFragment + k);
            join(one.body.number, one.impactorNumber);
        }
        for (const PlaySplit& one : step.events.splits) {
            for (const std::uint32_t freed : one.freed) join(one.body.number, freed);
            join(one.body.number, one.impactorNumber);
        }
        if (const auto now = grabbedNumber(step.session)) m_isFree[*now] = false;
        if (grabbed && *grabbed < m_isFree.size()) m_isFree[*grabbed] = false;
    }

    std::uint32_t rootOf(std::uint32_t number) { return m_sets.rootOf(number); }
    /// The roots of what came near nothing static and was not grabbed.
    std::vector<bool> freeRoots() {
        std::vector<bool> isFree(m_isFree.size(), true);
        for (std::uint32_t number = 0; number < m_isFree.size(); ++number) {
            if (!m_isFree[number]) isFree[rootOf(number)] = false;
        }
        return isFree;
    }

private:
    static std::size_t countOf(const StepFacts& step) {
        std::uint32_t last = 0;
        for (const Moment* moment : {&step.before, &step.after}) {
            if (!moment->bodies.empty()) last = std::max(last, moment->bodies.back().body.number);
        }
        for (const PlayBody& born : step.events.born) last = std::max(last, born.number);
        for (const PlayBreak& one : step.events.breaks) last = std::max(last, one.firstFragment + one.fragmentCount);
        return last + 1;
    }
    static bool isApart(const Box3& a, const Box3& b) {
        return a.isEmpty() || b.isEmpty() || glm::any(glm::lessThan(a.max, b.min)) ||
               glm::any(glm::lessThan(b.max, a.min));
    }
    void join(std::uint32_t first, std::uint32_t second) {
        if (first < m_isFree.size() && second < m_isFree.size()) m_sets.merge(first, second);
    }
    /// Adds where a body may have been in a step of dt seconds.
    void include(const BodyFacts& one, double dt, BodyHulls& hulls) {
        Box3& box = m_boxes[one.body.number];
        if (!one.isDynamic()) {
            m_isFree[one.body.number] = false;
            box.include(hulls.of(one).box);
            return;
        }
        const Vec3 radius(one.boundingRadius + kNear + dt * glm::length(one.state.velocity));
        box.include(one.state.centre - radius);
        box.include(one.state.centre + radius);
    }

    static constexpr double kNear = 0.02;  // m: contacts act before bodies touch

    DisjointSets m_sets;
    std::vector<Box3> m_boxes;   // by number
    std::vector<bool> m_isFree;  // by number
};

/// Several bodies, as one.
struct Sum {
    std::vector<const BodyFacts*> bodies;
    double mass = 0.0;
    Vec3 momentum{0.0};
    Vec3 centre{0.0};     // m, times the mass while bodies are added
    double moving = 0.0;  // kg·m/s: the sum of the amounts

    void add(const BodyFacts& one) {
        bodies.push_back(&one);
        mass += one.mass;
        momentum += one.mass * one.state.velocity;
        centre += one.mass * one.state.centre;
        moving += one.mass * glm::length(one.state.velocity);
    }
};

/// The angular momentum of bodies about their common centre.
struct AngularSum {
    Vec3 momentum{0.0};  // kg·m²/s
    double amounts = 0.0;
    double arms = 0.0;    // kg·m
    double energy = 0.0;  // J, twice that of the motion about the common centre

    explicit AngularSum(const Sum& sum) {
        const Vec3 centre = sum.centre / sum.mass, velocity = sum.momentum / sum.mass;
        for (const BodyFacts* body : sum.bodies) {
            const Vec3 arm = body->state.centre - centre;
            const Vec3 orbital = body->mass * glm::cross(arm, body->state.velocity - velocity);
            momentum += body->spin + orbital;
            amounts +=
                glm::length(body->spin) + body->mass * glm::length(arm) * glm::distance(body->state.velocity, velocity);
            energy += body->mass * glm::dot(body->state.velocity - velocity, body->state.velocity - velocity) +
                      std::abs(glm::dot(body->spin, body->state.angularVelocity));
            arms += body->mass * (glm::length(arm) + body->boundingRadius);
        }
    }
};

std::map<std::uint32_t, Sum> sumsOf(const Moment& moment, ActingBodies& acting, const std::vector<bool>& isFree) {
    std::map<std::uint32_t, Sum> sums;
    for (const BodyFacts& one : moment.bodies) {
        const std::uint32_t root = acting.rootOf(one.body.number);
        if (one.isDynamic() && isFree[root]) sums[root].add(one);
    }
    return sums;
}

class FreeMomentum : public Invariant {
public:
    const char* name() const override { return "free momentum"; }
    std::optional<Fault> check(const StepFacts& step) override {
        const bool isActedOn = step.hasInput<ShotInput>() || step.hasInput<MaterialInput>() ||
                               step.hasInput<RemoveInput>() || step.hasInput<GrabInput>() ||
                               step.hasInput<ReleaseInput>();
        const auto grabbed = std::exchange(m_grabbed, grabbedNumber(step.session));
        if (isActedOn || !step.events.removed.empty()) return std::nullopt;
        ActingBodies acting(step, m_hulls, grabbed);
        m_hulls.keepOnly(step.after);
        const std::vector<bool> isFree = acting.freeRoots();
        const std::map<std::uint32_t, Sum> before = sumsOf(step.before, acting, isFree);
        for (const auto& [root, after] : sumsOf(step.after, acting, isFree)) {
            const auto found = before.find(root);
            if (found == before.end()) continue;
            if (std::optional<Fault> fault = faultOf(step, found->second, after)) return fault;
        }
        return std::nullopt;
    }

private:
    static std::optional<Fault> faultOf(const StepFacts& step, const Sum& before, const Sum& after) {
        if (std::abs(before.mass - after.mass) > 1e-5 * before.mass) return std::nullopt;  // a gap took some
        const Vec3 expected = before.momentum + after.mass * step.session.stepLength() * step.after.gravity;
        const double fall = glm::length(step.after.gravity) * step.session.stepLength();
        const double slack = kRelative * (before.moving + after.moving + after.mass * fall) + kDrift * after.mass;
        const double wrong = glm::distance(after.momentum, expected);
        if (wrong > slack) {
            return fault(step, after, "velocity by " + textOf(wrong / after.mass) + " m/s beyond gravity");
        }
        return angularFault(step, before, after);
    }

    static std::optional<Fault> angularFault(const StepFacts& step, const Sum& before, const Sum& after) {
        const AngularSum first(before), last(after);
        const double wrong = glm::distance(first.momentum, last.momentum);
        double slack = kAngular * (first.amounts + last.amounts) + kDrift * (first.arms + last.arms);
        // Contacts act where bodies touched at the beginning of the step; in the end these are elsewhere.
        const bool isTouching = before.bodies.size() > 1 || after.bodies.size() > 1;
        if (isTouching) slack += step.session.stepLength() * (first.energy + last.energy);
        if (wrong <= slack) return std::nullopt;
        return fault(step, after,
                     "angular momentum by " + textOf(wrong) + " kg·m²/s, of " + textOf(glm::length(first.momentum)));
    }

    static Fault fault(const StepFacts& step, const Sum& after, const std::string& change) {
        const BodyFacts& body = *after.bodies.front();
        return {step.session.nameOf(body.body), std::to_string(after.bodies.size()) +
                                                    " bodies that touch nothing static change their " + change +
                                                    (body.state.asleep ? ", asleep" : "")};
    }

    BodyHulls m_hulls;
    std::optional<std::uint32_t> m_grabbed;  // the number of the body that was after the last step
};

}  // namespace

std::unique_ptr<Invariant> freeMomentum() { return std::make_unique<FreeMomentum>(); }

}  // namespace rubble::soak
