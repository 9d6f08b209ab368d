#pragma once

#include "core/play/session/Session.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rubble::soak {

/// A body as a checker sees it.
struct BodyFacts {
    PlayBody body;
    BodyKind kind = BodyKind::Static;
    BodyState state;
    double mass = 0.0;            // kg, also of what does not move; 0 for the ground
    Vec3 massCentre{0.0};         // m, in the world; of a held body that of what is left of it
    double kinetic = 0.0;         // J
    Vec3 spin{0.0};               // kg·m²/s: its angular momentum about its centre
    double boundingRadius = 0.0;  // m
    double minWidth = 0.0;        // m: of its thinnest hull

    bool isDynamic() const { return kind == BodyKind::Dynamic; }
};

/// All bodies of a session between two steps, by ascending number.
struct Moment {
    std::vector<BodyFacts> bodies;
    Vec3 gravity{0.0};  // m/s²

    const BodyFacts* find(std::uint32_t number) const;
    const BodyFacts* find(BodyId id) const;
};

/// The densities of materials, kg/m³, by id: those of a project until inputs change them.
using Densities = std::map<Id, double>;
Densities densitiesOf(const Project& project);

Moment momentOf(const Session& session, const Densities& densities);

/// What was thrown before a step. It may have broken in it.
struct ThrownBody {
    double mass = 0.0;  // kg
    Vec3 from{0.0};     // m
};
/// Those of the last step of a session.
std::vector<ThrownBody> thrownBodies(const Session& session, const Densities& densities);

/// A step as a checker sees it.
struct StepFacts {
    const Session& session;  // after it
    const Moment& before;
    const Moment& after;
    const PlayEvents& events;
    std::vector<ThrownBody> thrown;

    template <class Input>
    bool hasInput() const {
        for (const TimedInput& timed : events.inputs) {
            if (std::holds_alternative<Input>(timed.input)) return true;
        }
        return false;
    }
    /// Whether the method of the thesis gave fragments masses of its own.
    bool changesMasses() const { return session.scene().project.damage.isThesis && !events.breaks.empty(); }
};

/// A promise that was broken.
struct Fault {
    std::string body;  // its name; empty: none
    std::string text;  // with figures
};

/// Something that holds after every step of every session.
class Invariant {
public:
    virtual ~Invariant() = default;
    virtual const char* name() const = 0;
    /// Called before the first step.
    virtual void start(const Session&, const Moment&) {}
    /// The first fault after a step.
    virtual std::optional<Fault> check(const StepFacts& step) = 0;
};

/// All that are checked after each step.
std::vector<std::unique_ptr<Invariant>> invariants();

std::unique_ptr<Invariant> staticOverlap();    // nothing sinks into what is static
std::unique_ptr<Invariant> restingOverlap();   // sleeping bodies are not inside of each other
std::unique_ptr<Invariant> nothingTunnels();   // nothing passes through what is static
std::unique_ptr<Invariant> energyGrowth();     // only sources add energy
std::unique_ptr<Invariant> energyBalance();    // what is reported of energy is what happened
std::unique_ptr<Invariant> energySums();       // no sum that is reported is below zero
std::unique_ptr<Invariant> freeMomentum();     // only gravity changes the momentum of what touches nothing static
std::unique_ptr<Invariant> heldByAnchors();    // what reaches an anchor is held, and nothing else
std::unique_ptr<Invariant> heldStays();        // what is held does not move, and nothing free becomes held
std::unique_ptr<Invariant> supportLost();      // only what lost support collapses
std::unique_ptr<Invariant> oneComponent();     // the fragments of a body are one component of unbroken bonds
std::unique_ptr<Invariant> nothingLost();      // each fragment is in one body at most, and no mass is lost
std::unique_ptr<Invariant> uniqueNumbers();    // numbers and ids are never used again
std::unique_ptr<Invariant> sleepsSupported();  // nothing sleeps in the air, or out of balance
std::unique_ptr<Invariant> finiteNumbers();    // every number is finite
std::unique_ptr<Invariant> eventsTellAll();    // the file of events alone has all bodies and the damage

std::string textOf(double value);
std::string textOf(Vec3 value);

}  // namespace rubble::soak
