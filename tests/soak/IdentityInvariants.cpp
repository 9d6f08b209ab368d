// Numbers, ids, and that every number is finite.
#include "tests/soak/Moment.h"

#include <cmath>
#include <map>
#include <set>

namespace rubble::soak {
namespace {

bool isFinite(Vec3 value) { return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z); }

bool isFinite(const BodyState& state) {
    const Quat& turned = state.pose.orientation;
    return isFinite(state.pose.position) && isFinite(state.centre) && isFinite(state.velocity) &&
           isFinite(state.angularVelocity) && std::isfinite(turned.w + turned.x + turned.y + turned.z);
}

class FiniteNumbers : public Invariant {
public:
    const char* name() const override { return "finite"; }
    std::optional<Fault> check(const StepFacts& step) override {
        for (const BodyFacts& one : step.after.bodies) {
            if (!isFinite(one.state)) return Fault{step.session.nameOf(one.body), "its state is not finite"};
        }
        double sum = step.session.world().events().contactLoss + step.events.report.energy();
        for (const EventRecord& record : step.events.report.records) {
            sum += record.impulse + record.speed + record.energy + record.area + record.mass;
            if (!isFinite(record.point) || !isFinite(record.normal)) sum = NAN;
        }
        if (!std::isfinite(sum)) return Fault{"", "a figure that is reported is not finite"};
        return std::nullopt;
    }
};

class UniqueNumbers : public Invariant {
public:
    const char* name() const override { return "unique numbers"; }
    void start(const Session&, const Moment& moment) override {
        for (const BodyFacts& one : moment.bodies) add(one.body);
    }
    std::optional<Fault> check(const StepFacts& step) override {
        const std::uint32_t known = m_next;
        std::uint32_t last = 0;
        for (const BodyFacts& one : step.after.bodies) {
            const PlayBody& body = one.body;
            const std::string name = step.session.nameOf(body);
            if (&one != &step.after.bodies.front() && body.number <= last) return Fault{name, "numbers do not ascend"};
            last = body.number;
            if (step.session.world().tag(body.body) != body.number) return Fault{name, "its tag is not its number"};
            if (body.number < known && step.before.find(body.number) == nullptr) {
                return Fault{name, "number " + std::to_string(body.number) + " is used again"};
            }
            if (!add(body)) return Fault{name, "the id of its body was another one's"};
        }
        if (step.session.world().bodyCount() != step.after.bodies.size()) {
            return Fault{"", "the world has " + std::to_string(step.session.world().bodyCount()) +
                                 " bodies, the session " + std::to_string(step.after.bodies.size())};
        }
        return std::nullopt;
    }

private:
    /// False if the id was that of another number.
    bool add(const PlayBody& body) {
        m_next = std::max(m_next, body.number + 1);
        const auto [known, isNew] = m_numbers.emplace(body.body, body.number);
        return isNew || known->second == body.number;
    }

    std::map<BodyId, std::uint32_t> m_numbers;
    std::uint32_t m_next = 0;
};

}  // namespace

std::unique_ptr<Invariant> finiteNumbers() { return std::make_unique<FiniteNumbers>(); }
std::unique_ptr<Invariant> uniqueNumbers() { return std::make_unique<UniqueNumbers>(); }

}  // namespace rubble::soak
