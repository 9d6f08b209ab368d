// Only sources add energy, and what is reported of energy is what happened.
#include "core/base/Diagnostic.h"
#include "tests/soak/BodyHulls.h"

#include <algorithm>
#include <limits>
#include <set>

namespace rubble::soak {
namespace {

constexpr double kGrowth = 0.01;    // of the peak so far
constexpr double kSumError = 0.01;  // the same, of what is reported: sums are that exact
constexpr double kOverlap = 1e-4;   // m: what overlaps deeper is pushed apart, which takes energy from nowhere
constexpr double kSoftness = 1e-3;  // m: by which contacts give way, and lift again
constexpr double kSlowest = 1e-3;   // m/s: motion that touching bodies may get by rounding
constexpr double kSmallest = 1e-9;  // J

/// Follows the mechanical energy of a session.
class EnergyBook {
public:
    void start(const Session& session, const Moment& moment) {
        const auto isSimplified = [](const Diagnostic& one) { return one.code == DiagnosticCode::SimplifiedShape; };
        m_isSimplified = std::ranges::any_of(session.scene().diagnostics, isSimplified);
        for (const BodyFacts& one : moment.bodies) {
            for (const BodyFacts& other : moment.bodies) {
                if (one.body.number >= other.body.number) continue;  // what is fixed may break
                if (overlapDepth(m_hulls.of(one), m_hulls.of(other), kOverlap) > 0.0) {
                    m_overlapping.emplace(one.body.origin, other.body.origin);
                }
            }
        }
    }

    /// Enters a step. False if nothing can be said of its energy.
    bool enter(const StepFacts& step) {
        m_hulls.keepOnly(step.after);
        const bool wasGrabbed = m_isGrabbed;
        m_isGrabbed = step.session.world().grabSpring().has_value();
        // What is fixed and breaks in the step may be free after it only.
        const bool isPushed = pushesApart(step.before) || pushesApart(step.after);
        findEnergies(step);
        return !wasGrabbed && !m_isGrabbed && !isPushed && !m_isSimplified && !step.hasInput<MaterialInput>() &&
               !step.hasInput<GrabInput>() && !step.changesMasses();
    }

    double before() const { return m_before; }          // J: with the gravity of the step
    double after() const { return m_after; }            // J
    double given() const { return m_given; }            // J: by sources
    double work() const { return m_work; }              // J: what they added or took
    double peak() const { return m_peak; }              // J: of all that moved, so far
    double rounding() const { return m_rounding; }      // J: of contacts that give way
    double freeFlight() const { return m_freeFlight; }  // J: how exact the integration of gravity is
    double asleep() const { return m_asleep; }          // J: that what fell asleep had

private:
    bool pushesApart(const Moment& moment) {
        if (m_overlapping.empty()) return false;
        for (const BodyFacts& one : moment.bodies) {
            for (const BodyFacts& other : moment.bodies) {
                const bool isMeant = one.body.number < other.body.number && (one.isDynamic() || other.isDynamic()) &&
                                     m_overlapping.contains(std::minmax(one.body.origin, other.body.origin));
                if (isMeant && overlapDepth(m_hulls.of(one), m_hulls.of(other), kOverlap) > 0.0) return true;
            }
        }
        return false;
    }

    static double motionOf(const StepFacts& step, const BodyFacts& one) {
        const BodyFacts* const before = step.before.find(one.body.number);
        const double fall = glm::length(step.after.gravity) * step.session.stepLength();
        if (before == nullptr) return 0.0;
        return before->kinetic + before->mass * fall * (glm::length(before->state.velocity) + fall);
    }

    static double heightOf(const StepFacts& step, Vec3 point) { return -glm::dot(step.after.gravity, point); }

    /// J, above the lowest point of the step: so that mass that is removed takes energy with it.
    double energyOf(const StepFacts& step, const BodyFacts& one) const {
        return one.kinetic + one.mass * (heightOf(step, one.massCentre) - m_lowest);
    }

    void findEnergies(const StepFacts& step) {
        double lowestCentre = std::numeric_limits<double>::max();
        const double weight = glm::length(step.after.gravity);
        m_lowest = lowestCentre;
        m_before = m_after = m_given = m_work = m_rounding = m_freeFlight = m_asleep = 0.0;
        for (const Moment* moment : {&step.before, &step.after}) {
            for (const BodyFacts& one : moment->bodies) {
                if (one.mass <= 0.0) continue;
                const double centre = heightOf(step, one.massCentre);
                lowestCentre = std::min(lowestCentre, centre);
                m_lowest = std::min(m_lowest, centre - 2.0 * weight * one.boundingRadius);
            }
        }
        double moving = 0.0;
        const double fall = weight * step.session.stepLength();
        for (const BodyFacts& one : step.before.bodies) m_before += energyOf(step, one);
        for (const BodyFacts& one : step.after.bodies) {
            m_after += energyOf(step, one);
            if (!one.isDynamic()) continue;
            if (one.state.asleep) m_asleep += motionOf(step, one);
            moving += one.kinetic + one.mass * (heightOf(step, one.massCentre) - lowestCentre);
            m_rounding += one.mass * (weight * kSoftness + 0.5 * kSlowest * kSlowest);
            m_freeFlight += one.mass * fall * fall;
        }
        addSources(step);
        m_peak = std::max({m_peak, moving, m_given});
    }

    void addSources(const StepFacts& step) {
        for (const EnergyEntry& entry : step.events.energy) {
            m_given += std::max(0.0, entry.given);
            if (entry.given != 0.0) m_work += entry.after - entry.before;
        }
        for (const ThrownBody& thrown : step.thrown) {
            const double potential = thrown.mass * (heightOf(step, thrown.from) - m_lowest);
            m_given += potential;
            m_work += potential;
        }
    }

    BodyHulls m_hulls;
    std::set<std::pair<std::uint32_t, std::uint32_t>> m_overlapping;  // origins, that overlapped at the start
    bool m_isSimplified = false;
    bool m_isGrabbed = false;
    double m_lowest = 0.0;
    double m_before = 0.0;
    double m_after = 0.0;
    double m_given = 0.0;
    double m_work = 0.0;
    double m_peak = 0.0;
    double m_rounding = 0.0;
    double m_freeFlight = 0.0;
    double m_asleep = 0.0;
};

/// An invariant that keeps such a book.
class EnergyInvariant : public Invariant {
public:
    void start(const Session& session, const Moment& moment) override { m_book.start(session, moment); }
    std::optional<Fault> check(const StepFacts& step) override {
        return m_book.enter(step) ? faultOf(step) : std::nullopt;
    }

protected:
    virtual std::optional<Fault> faultOf(const StepFacts& step) const = 0;
    EnergyBook m_book;
};

std::string partOf(double energy, double peak) {
    return textOf(energy) + " J, " + textOf(100.0 * energy / std::max(peak, kSmallest)) + " % of the peak of " +
           textOf(peak) + " J";
}

class EnergyGrowth : public EnergyInvariant {
public:
    const char* name() const override { return "energy growth"; }

private:
    std::optional<Fault> faultOf(const StepFacts&) const override {
        const double growth = m_book.after() - m_book.before() - m_book.given();
        if (growth <= kGrowth * m_book.peak() + m_book.rounding() + kSmallest) return std::nullopt;
        return Fault{"", "the energy grows by " + partOf(growth, m_book.peak())};
    }
};

bool losesMass(const StepFacts& step) {
    double before = 0.0, after = 0.0;
    for (const BodyFacts& one : step.before.bodies) before += one.mass;
    for (const ThrownBody& thrown : step.thrown) before += thrown.mass;  // which may have broken already
    for (const BodyFacts& one : step.after.bodies) after += one.mass;
    return after < before * (1.0 - 1e-6);
}

class EnergyBalance : public EnergyInvariant {
public:
    const char* name() const override { return "energy balance"; }

private:
    std::optional<Fault> faultOf(const StepFacts& step) const override {
        if (!step.events.removed.empty() || step.hasInput<RemoveInput>() || losesMass(step)) return std::nullopt;
        const double reported = m_book.before() + m_book.work() - step.events.report.energy();
        const double slack =
            kGrowth * m_book.peak() + m_book.rounding() + m_book.freeFlight() + m_book.asleep() + kSmallest;
        const double missing = m_book.after() - reported;
        if (std::abs(missing) <= slack) return std::nullopt;
        return Fault{"", "the energy is other than reported by " + partOf(missing, m_book.peak())};
    }
};

class EnergySums : public EnergyInvariant {
public:
    const char* name() const override { return "energy sums"; }

private:
    std::optional<Fault> faultOf(const StepFacts& step) const override {
        const double least = -(kSumError * m_book.peak() + m_book.rounding() + kSmallest);
        const auto fault = [&](const char* what, double energy) {
            return Fault{"", std::string(what) + " is " + partOf(energy, m_book.peak())};
        };
        const EventReport& reported = step.events.report;
        if (reported.energy() < least) return fault("what is reported of the step", reported.energy());
        if (reported.restEnergy < least) return fault("restEnergy", reported.restEnergy);
        for (const OmittedEvents& omitted : reported.omitted) {
            if (omitted.energy < least) return fault("what is omitted", omitted.energy);
        }
        for (const EventRecord& record : reported.records) {
            if (record.energy < least) return fault("an event", record.energy);
        }
        return std::nullopt;
    }
};

}  // namespace

std::unique_ptr<Invariant> energyGrowth() { return std::make_unique<EnergyGrowth>(); }
std::unique_ptr<Invariant> energyBalance() { return std::make_unique<EnergyBalance>(); }
std::unique_ptr<Invariant> energySums() { return std::make_unique<EnergySums>(); }

}  // namespace rubble::soak
