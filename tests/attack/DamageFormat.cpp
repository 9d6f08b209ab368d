#include "core/play/damage/DamageBytes.h"
#include "tests/attack/Format.h"
#include "tests/attack/Mutator.h"
#include "tests/attack/Sessions.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/files/FuzzedReaders.h"

#include <cstdio>
#include <cstdlib>

namespace rubble::attack {
namespace {

using test::Sentence;

constexpr std::size_t kDamageChecksum = 8;
constexpr std::uint64_t kUncheckedShare = 8;  // one in so many inputs keeps the checksum that no longer fits
constexpr int kStepsBefore = 60, kStepsAfter = 10;

/// An instance that the damages are of, in a scene of its own.
struct Damaged {
    std::shared_ptr<const PlayScene> scene;
    Id instance = 0;
};

Damaged damagedIn(const Project& project) {
    return {*playScene(project, {.threads = 1}), project.instances.front().id};
}

/// One that breaks whole, one that is cut where it is hit, and a bonded one.
const std::vector<Damaged>& damagedInstances() {
    static const std::vector<Damaged> all = [] {
        const Project whole = boxProject(UniformScatter{.count = 12});
        Project cut = whole, bonded = whole;
        cut.assets.front().cutAtImpact = CutAtImpact{.fragments = 12};
        bonded.assets.front().breakAs = BreakAs::Bonded;
        bonded.assets.front().bonding.impulsePerArea = 100.0;
        return std::vector{damagedIn(whole), damagedIn(cut), damagedIn(bonded)};
    }();
    return all;
}

/// The damage of an instance that a blow hit, as bytes.
std::string sampleOf(const Damaged& damaged, double impulse) {
    Result<Session> session = Session::start(damaged.scene, {.threads = 1});
    const Vec3 centre = damaged.scene->project.instances.front().pose.position;
    if (!session->add(PlayInput(ShotInput{"blow", Hammer{centre, {0.0, 0.0, -impulse}}}))) std::exit(2);
    for (int step = 0; step < kStepsBefore; ++step) session->step();
    return damageBytes(session->damage().at(damaged.instance));
}

std::string withChecksum(std::string bytes) {
    if (bytes.size() < kDamageChecksum) return bytes;
    bytes.resize(bytes.size() - kDamageChecksum);
    const std::uint64_t sum = contentHash(bytes).low;
    for (std::size_t k = 0; k < kDamageChecksum; ++k) bytes.push_back(static_cast<char>(sum >> (8 * k)));
    return bytes;
}

/// A damage is merged with what the instance has, and played on.
Sentence applyFault(const Damaged& damaged, const InstanceDamage& damage, bool& isPlayed) {
    Result<Session> session = Session::start(damaged.scene, {.threads = 1});
    const Status applied = session->apply({{damaged.instance, damage}});
    if (!applied) return test::errorFault(applied.error());
    isPlayed = true;
    const Result<InstanceDamage> merged = mergedDamage(damage, session->damage().at(damaged.instance));
    if (!merged) return "A damage that was applied cannot be merged: " + merged.error().message;
    if (*merged != session->damage().at(damaged.instance)) return "An instance is less damaged than what was applied.";
    for (int step = 0; step < kStepsAfter; ++step) session->step();
    return outcomeFault(*session);
}

Verdict checkDamage(std::string_view bytes, Random&) {
    const Result<InstanceDamage> damage = damageOfBytes(bytes);
    Verdict verdict{.isAccepted = damage.hasValue()};
    if (!damage) {
        verdict.fault = test::errorFault(damage.error());
        return verdict;
    }
    if (damageBytes(*damage) != bytes) verdict.fault = "A damage is written otherwise than it was read.";
    const Result<InstanceDamage> merged = mergedDamage(*damage, *damage);
    if (!verdict.fault && (!merged || *merged != *damage)) verdict.fault = "A damage merged with itself is another.";
    for (const Damaged& damaged : damagedInstances()) {
        if (!verdict.fault) verdict.fault = applyFault(damaged, *damage, verdict.isPlayed);
    }
    return verdict;
}

}  // namespace

Format damageFormat() {
    std::vector<std::string> samples;
    for (const Damaged& damaged : damagedInstances()) {
        for (const double impulse : {1.0, 60.0, 3000.0}) samples.push_back(sampleOf(damaged, impulse));
    }
    return {.name = "Damage",
            .ending = ".damage",
            .mutated =
                [samples](Random& random) {
                    std::string bytes = mutatedBytes(samples[random.below(samples.size())], random);
                    return random.below(kUncheckedShare) == 0 ? bytes : withChecksum(std::move(bytes));
                },
            .check = checkDamage,
            .checks = 1};
}

}  // namespace rubble::attack
