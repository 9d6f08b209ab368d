#include "core/play/breaking/Blow.h"

#include "core/asset/project/HammerPatch.h"
#include "core/base/MessageText.h"
#include "core/play/breaking/BondBreaking.h"
#include "core/play/breaking/Splitting.h"
#include "core/play/breaking/Swap.h"
#include "core/play/state/InputDiagnostics.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace rubble {
namespace {

constexpr double kHammerRange = 0.1;  // m before and behind the target point
constexpr double kMinLost = 1e-6;     // of a blow: less is rounding

struct Blow {
    Vec3 direction;  // length 1
    Vec3 point;      // where it hits
    double radius;   // m, of its patch
    HammerHead head;
    std::string name;  // in messages: The blow "left"
};

/// A fragment under the hammer.
struct StruckFragment {
    double distance = 0.0;  // m, from the point that is hit
    std::uint32_t number = 0;
    BodyId body;
};

/// The free bodies from a number on, nearest first.
std::vector<StruckFragment> fragmentsByDistance(const SessionParts& parts, Vec3 point, std::uint32_t firstNumber) {
    std::vector<StruckFragment> fragments;
    const auto first = std::ranges::lower_bound(parts.state().bodies, firstNumber, {}, &PlayBody::number);
    for (auto body = first; body != parts.state().bodies.end(); ++body) {
        if (parts.world().kind(body->body) != BodyKind::Dynamic) continue;
        fragments.push_back({distanceToBody(parts.world(), body->body, point), body->number, body->body});
    }
    std::ranges::sort(fragments, {}, [](const auto& one) { return std::tuple(one.distance, one.number); });
    return fragments;
}

/// Gives what the head has left to the bodies that came free, from a number on.
void giveToFragments(SessionParts& parts, Blow& blow, std::uint32_t firstNumber) {
    const std::vector<StruckFragment> fragments = fragmentsByDistance(parts, blow.point, firstNumber);
    double mass = 0.0, momentum = 0.0, before = 0.0;  // of those taken; the momentum along the blow
    std::size_t taken = 0;
    const auto canTake = [&] { return mass > 0.0 ? blow.head.impulseOn(mass, momentum / mass) : 0.0; };
    for (; taken < fragments.size(); ++taken) {
        const auto& [distance, number, body] = fragments[taken];
        if (distance > blow.radius && canTake() >= blow.head.impulse) break;
        mass += parts.world().mass(body);
        momentum += parts.world().mass(body) * glm::dot(parts.world().state(body).velocity, blow.direction);
        before += kineticEnergy(parts.world(), body);
    }
    const double given = canTake();
    if (given <= 0.0) return;
    EnergyEntry entry{.change = EnergyChange::Blow, .body = fragments[0].number, .before = before};
    entry.given = blow.head.give(given, mass, momentum / mass);
    for (std::size_t k = 0; k < taken; ++k) {
        const BodyId body = fragments[k].body;
        const double fraction = parts.world().mass(body) / mass;
        applyImpulse(parts, body, fraction * given * blow.direction, parts.world().state(body).centre, blow.name);
        entry.after += kineticEnergy(parts.world(), body);
    }
    parts.state().events.energy.push_back(entry);
}

/// Gives the whole at most `most` N·s at the point that is hit. Returns what it was given.
double giveTo(SessionParts& parts, Blow& blow, std::uint32_t number, MovingMass& whole, double most) {
    const double mass = 1.0 / whole.inverseEffectiveMass(blow.point, blow.direction);
    const double speed = glm::dot(whole.velocityAt(blow.point), blow.direction);
    const double given = std::min(most, blow.head.impulseOn(mass, speed));
    EnergyEntry entry{.change = EnergyChange::Blow, .body = number, .before = whole.kineticEnergy()};
    entry.given = blow.head.give(given, mass, speed);
    whole.applyImpulse(given * blow.direction, blow.point);
    entry.after = whole.kineticEnergy();
    parts.state().events.energy.push_back(entry);
    return given;
}

void strikeAndBreak(SessionParts& parts, Blow& blow, const PlayBody& body, double threshold) {
    PendingBreak broken = pendingBreak(parts, body);
    broken.event.impact = blow.head.impulse;
    broken.event.point = blow.point;
    broken.event.normal = blow.direction;
    giveTo(parts, blow, body.number, broken.mass, threshold);
    applyBreaks(parts, {broken});
    giveToFragments(parts, blow, parts.state().events.breaks.back().firstFragment);
}

/// Gives a free body at most `most` N·s.
void strike(SessionParts& parts, Blow& blow, const PlayBody& body, double most) {
    MovingMass whole = movingMass(parts.world(), body.body);
    const double given = giveTo(parts, blow, body.number, whole, most);
    applyImpulse(parts, body.body, given * blow.direction, blow.point, blow.name);
}

/// Strikes a body with bonds: first these take what they hold, then what comes free takes the rest, or all of it a held
/// body from which nothing comes free.
void strikeBonds(SessionParts& parts, Blow& blow, std::uint32_t number) {
    const std::uint32_t firstFreed = parts.state().nextNumber;
    BrokenBonds broken;
    if (parts.state().hasDestruction) {
        broken = damageBonds(parts, *findBody(parts.state(), number), {&blow.point, 1}, blow.head.impulse);
        broken.normal = blow.direction;
    }
    const double taken = broken.impulse;
    const bool isHeld = parts.world().kind(findBody(parts.state(), number)->body) != BodyKind::Dynamic;
    if (isHeld) {
        blow.head.give(taken, std::numeric_limits<double>::infinity(), 0.0);
    } else {
        strike(parts, blow, *findBody(parts.state(), number), taken);
    }
    if (!broken.bonds.empty()) splitBodies(parts, {std::move(broken)});
    if (parts.state().nextNumber > firstFreed) {
        giveToFragments(parts, blow, firstFreed);
    } else if (!isHeld) {
        strike(parts, blow, *findBody(parts.state(), number), blow.head.impulse);
    } else {
        blow.head.impulse = 0.0;
    }
}

/// Strikes a body without bonds, which a fixed one that stays whole takes all of.
void strikeSolid(SessionParts& parts, Blow& blow, const PlayBody& body) {
    const double size = blow.head.impulse, threshold = thresholdOf(parts.state(), parts.scene(), body);
    if (body.fracture() != nullptr) parts.state().events.impacts.push_back({body.number, size, threshold, blow.point});
    if (parts.state().hasDestruction && size >= threshold) {
        strikeAndBreak(parts, blow, body, threshold);
    } else if (parts.world().kind(body.body) == BodyKind::Dynamic) {
        strike(parts, blow, body, size);
    } else {
        blow.head.impulse = 0.0;
    }
}

}  // namespace

HammerHead HammerHead::ofImpulse(double impulse) { return {impulse, 0.5 * impulse * kHammerSpeed}; }

double HammerHead::impulseOn(double mass, double speed) const {
    if (speed >= kHammerSpeed || energy <= 0.0) return 0.0;
    // The work of an impulse p is p v + p² / 2m. The root is written so that it does not cancel where v > 0.
    const double root = std::sqrt(speed * speed + 2.0 * energy / mass);
    const double byEnergy = speed > 0.0 ? 2.0 * energy / (speed + root) : mass * (root - speed);
    return std::min({impulse, mass * (kHammerSpeed - speed), byEnergy});
}

double HammerHead::give(double given, double mass, double speed) {
    const double work = given * (speed + 0.5 * given / mass);
    impulse -= given;
    energy -= std::max(0.0, work);
    return work;
}

void applyBlow(SessionParts& parts, const std::string& name, const Hammer& hammer) {
    const double size = glm::length(hammer.impulse);
    if (size == 0.0) return;
    const Vec3 direction = hammer.impulse / size;
    const std::optional<CastHit> hit =
        parts.world().castRay(hammer.at - kHammerRange * direction, hammer.at + kHammerRange * direction);
    const std::string title = "The blow " + quotedName(name);
    if (!hit) return addUnapplied(parts, nullptr, title + " hit nothing.");
    Blow blow{direction, hit->point, patchRadius(hammer), HammerHead::ofImpulse(size), title};
    const PlayBody body = *findBody(parts.state(), static_cast<std::uint32_t>(parts.world().tag(hit->body)));
    if (body.bondedFracture() != nullptr) {
        strikeBonds(parts, blow, body.number);
    } else {
        strikeSolid(parts, blow, body);
    }
    if (blow.head.impulse <= kMinLost * size) return;
    addUnapplied(parts, &body,
                 title + " gave " + roundedText(size - blow.head.impulse, 3) + " of its " + roundedText(size, 3) +
                     " N·s: a hammer makes nothing faster than itself, " + messageText(kHammerSpeed) + " m/s.");
}

}  // namespace rubble
