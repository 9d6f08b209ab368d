#include "tests/soak/FrameRate.h"

#include <algorithm>
#include <set>

namespace rubble::soak {
namespace {

constexpr int kRate = 60;                   // steps/s
constexpr int kFineRate = 240;              // steps/s
constexpr int kLongest = 2;                 // s until the first bond breaks
constexpr double kTimeAfter = 2.0 / kRate;  // s
constexpr double kNear = 0.1;  // of the speed: bonds that break by so much more, or not by so much less, don't count

using Bonds = std::set<std::pair<Id, std::size_t>>;  // by instance

Bonds brokenBonds(const Session& session) {
    Bonds bonds;
    for (const auto& [instance, damage] : session.damage()) {
        for (std::size_t bond = 0; bond < damage.broken.size(); ++bond)
            if (damage.broken[bond]) bonds.emplace(instance, bond);
    }
    return bonds;
}

std::optional<ShotInput> firstThrow(const SoakCase& one) {
    for (const TimedInput& timed : one.inputs) {
        const auto* shot = std::get_if<ShotInput>(&timed.input);
        if (shot != nullptr && std::holds_alternative<Throw>(shot->action)) return *shot;
    }
    return std::nullopt;
}

ShotInput atSpeed(ShotInput shot, double factor) {
    std::get<Throw>(shot.action).speed *= factor;
    return shot;
}

/// The bonds that have broken shortly after the first did, where something is thrown in the first step; nothing if that
/// cannot be.
std::optional<Bonds> bondsBroken(const std::shared_ptr<const PlayScene>& scene, const ShotInput& shot, int rate) {
    Result<Session> session = Session::start(scene, {.dt = 1.0 / rate});
    if (!session || !session->add(shot)) return std::nullopt;
    for (int step = 0; step < kLongest * rate; ++step) {
        session->step();
        if (session->events().splits.empty()) continue;
        for (double after = 0.0; after < kTimeAfter - 1e-9; after += 1.0 / rate) session->step();
        return brokenBonds(*session);
    }
    return Bonds{};
}

}  // namespace

std::optional<double> frameRateAgreement(const SoakCase& one) {
    const std::optional<ShotInput> shot = firstThrow(one);
    if (!shot) return std::nullopt;
    Project still = one.project;
    still.gravity = Vec3(0.0);
    const Result<std::shared_ptr<const PlayScene>> scene = playScene(still);
    if (!scene) return std::nullopt;
    const std::optional<Bonds> coarse = bondsBroken(*scene, *shot, kRate), fine = bondsBroken(*scene, *shot, kFineRate);
    if (!coarse || !fine) return std::nullopt;
    const Bonds slower = bondsBroken(*scene, atSpeed(*shot, 1.0 - kNear), kFineRate).value_or(Bonds{});
    const Bonds faster = bondsBroken(*scene, atSpeed(*shot, 1.0 + kNear), kFineRate).value_or(Bonds{});
    std::size_t all = 0, common = 0;
    Bonds any = *coarse;
    any.insert(fine->begin(), fine->end());
    for (const auto& bond : any) {
        if (slower.contains(bond) != faster.contains(bond)) continue;
        ++all;
        common += coarse->contains(bond) && fine->contains(bond) ? 1 : 0;
    }
    return all > 0 ? std::optional(static_cast<double>(common) / static_cast<double>(all)) : std::nullopt;
}

}  // namespace rubble::soak
