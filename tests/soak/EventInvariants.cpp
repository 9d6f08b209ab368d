// That a file of events alone says which bodies there are, of which fragments, what is damaged, and all energy.
#include "core/io/play/EventStreamFile.h"
#include "docs/formats/rubble_pack.hpp"
#include "tests/soak/Moment.h"

#include <cmath>

namespace rubble::soak {
namespace {

constexpr double kMassTolerance = 1e-4;  // of a mass: each piece that came off was reported with seven digits
constexpr double kEnergyTolerance = 1e-5;

/// The paths of what a body consists of, ascending as text; "": the whole.
std::vector<std::string> pathsOf(const PlayBody& body) {
    std::vector<std::string> paths;
    if (isPartial(body)) {
        for (const std::uint32_t fragment : fragmentsOf(body))
            paths.push_back(body.asset->bake->fragmentPath(fragment));
    } else {
        paths.push_back(body.asset && body.fragment != kNone ? body.asset->bake->fragmentPath(body.fragment) : "");
    }
    std::ranges::sort(paths);
    return paths;
}

/// The damage of an instance as events report it.
rubble_pack::EventDamage toldDamage(const InstanceDamage& damage) {
    rubble_pack::EventDamage reported;
    for (std::uint32_t k = 0; k < damage.broken.size(); ++k)
        if (damage.broken[k]) reported.broken.push_back(k);
    for (const auto& [bond, amount] : damage.partial) reported.weakened.emplace_back(bond, amount);
    if (damage.cut) reported.cut = std::to_string(damage.cut->number);
    return reported;
}

class EventsTellAll : public Invariant {
public:
    const char* name() const override { return "events report all"; }
    void start(const Session& session, const Moment& moment) override {
        m_text.emplace(session);
        m_log = {};
        m_fault = read();
        m_state = rubble_pack::startOf(m_log);
        m_born.clear();
        for (const BodyFacts& one : moment.bodies) m_born[one.body.number] = session.stepsDone();
    }
    std::optional<Fault> check(const StepFacts& step) override {
        if (!m_fault.empty()) return Fault{"", m_fault};
        const std::size_t firstEvent = m_log.events.size(), firstSum = m_log.sums.size();
        m_text->add(step.session);
        if (m_fault = read(); !m_fault.empty()) return Fault{"", m_fault};
        rubble_pack::playTo(m_log, step.session.stepsDone(), m_state);
        m_hasNewMaterials = m_hasNewMaterials || step.hasInput<MaterialInput>();
        if (m_state.bodies.size() != step.after.bodies.size()) {
            return Fault{"", "they have " + std::to_string(m_state.bodies.size()) + " bodies of " +
                                 std::to_string(step.after.bodies.size())};
        }
        for (const BodyFacts& one : step.after.bodies) {
            if (std::optional<std::string> fault = faultOf(one, step))
                return Fault{step.session.nameOf(one.body), *fault};
        }
        double energy = 0.0;
        for (std::size_t k = firstEvent; k < m_log.events.size(); ++k) energy += m_log.events[k].energy;
        for (std::size_t k = firstSum; k < m_log.sums.size(); ++k)
            energy += m_log.sums[k].restEnergy + m_log.sums[k].omitted[0].energy;
        if (std::optional<std::string> fault = energyFault(energy, step)) return Fault{"", *fault};
        return damageFault(step);
    }

private:
    std::string read() {
        std::string fault;
        rubble_pack::appendEvents(m_text->take(), m_log, fault);
        return fault;
    }
    std::optional<std::string> faultOf(const BodyFacts& one, const StepFacts& step) {
        const std::uint32_t number = one.body.number;
        const auto reported = m_state.bodies.find(number);
        if (reported == m_state.bodies.end()) return "they do not have it";
        const rubble_pack::EventBody& body = reported->second;
        if (body.fragments != pathsOf(one.body)) {
            return "of its fragments they have " + std::to_string(body.fragments.size()) + ", not " +
                   std::to_string(pathsOf(one.body).size());
        }
        const auto [born, isNew] = m_born.try_emplace(number, step.session.stepsDone());
        if (body.born != born->second) return "it was born at step " + std::to_string(born->second);
        if (body.isFixed == one.isDynamic()) return "they have it fixed, or free, and it is not";
        const double mass = one.isDynamic() ? step.session.world().mass(one.body.body) : 0.0;
        if (!m_hasNewMaterials && std::abs(body.mass - mass) > kMassTolerance * mass)
            return "its mass is " + textOf(mass) + " kg, not " + textOf(body.mass);
        const PlayOrigin& origin = step.session.origins()[one.body.origin];
        if (body.name != origin.name || body.instance != origin.instance)
            return "they have it as \"" + body.name + "\"";
        return std::nullopt;
    }
    static std::optional<std::string> energyFault(double energy, const StepFacts& step) {
        const EventReport& reported = step.events.report;
        double scale = std::abs(reported.restEnergy);
        for (const EventRecord& record : reported.records) scale += std::abs(record.energy);
        for (const OmittedEvents& one : reported.omitted) scale += std::abs(one.energy);
        if (std::abs(energy - reported.energy()) <= kEnergyTolerance * scale) return std::nullopt;
        return "they have " + textOf(energy) + " J of " + textOf(reported.energy());
    }
    std::optional<Fault> damageFault(const StepFacts& step) {
        if (step.events.splits.empty() && step.events.breaks.empty() && step.events.impacts.empty())
            return std::nullopt;
        for (const auto& [instance, damage] : step.session.damage()) {
            const rubble_pack::EventDamage expected = toldDamage(damage);
            const rubble_pack::EventDamage& read = m_state.damages[instance];
            if (read.broken == expected.broken && read.weakened == expected.weakened && read.cut == expected.cut)
                continue;
            return Fault{"", "instance " + std::to_string(instance) + ": they have " +
                                 std::to_string(read.broken.size()) + " broken of " +
                                 std::to_string(expected.broken.size())};
        }
        return std::nullopt;
    }

    std::optional<EventStreamText> m_text;
    rubble_pack::EventLog m_log;
    rubble_pack::EventState m_state;
    std::map<std::uint32_t, std::uint64_t> m_born;  // step after which each body was there first
    std::string m_fault;
    bool m_hasNewMaterials = false;
};

}  // namespace

std::unique_ptr<Invariant> eventsTellAll() { return std::make_unique<EventsTellAll>(); }

}  // namespace rubble::soak
