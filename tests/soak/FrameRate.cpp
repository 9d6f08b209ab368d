#include "tests/soak/FrameRate.h"

#include "tests/support/play/BrokenBonds.h"

#include <algorithm>

namespace rubble::soak {
namespace {

constexpr int kRate = 60;       // steps/s
constexpr int kFineRate = 240;  // steps/s
constexpr int kLongest = 2;     // s until the first bond breaks
constexpr double kNear = 0.1;   // of the speed: bonds that break by so much more, or not by so much less, don't count

using test::Bonds;
using test::brokenBonds;

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

/// What a throw in the first step breaks.
struct Broken {
    Bonds bonds;
    int steps = 0;  // until then
};

/// Plays until the end of the step in which bonds break, or for `steps`; nothing if that cannot be.
std::optional<Broken> played(const std::shared_ptr<const PlayScene>& scene, const ShotInput& shot, int rate,
                             std::optional<int> steps = std::nullopt) {
    Result<Session> session = Session::start(scene, {.dt = 1.0 / rate});
    if (!session || !session->add(shot)) return std::nullopt;
    Broken broken;
    while (broken.steps < steps.value_or(kLongest * rate)) {
        session->step();
        ++broken.steps;
        if (!steps && !session->events().splits.empty()) break;
    }
    broken.bonds = brokenBonds(*session);
    return broken;
}

}  // namespace

std::optional<double> frameRateAgreement(const SoakCase& one) {
    const std::optional<ShotInput> shot = firstThrow(one);
    if (!shot) return std::nullopt;
    Project still = one.project;
    still.gravity = Vec3(0.0);
    const Result<std::shared_ptr<const PlayScene>> scene = playScene(still);
    if (!scene) return std::nullopt;
    const std::optional<Broken> coarse = played(*scene, *shot, kRate);
    if (!coarse || coarse->bonds.empty()) return std::nullopt;
    const std::optional<Broken> fine = played(*scene, *shot, kFineRate, coarse->steps * (kFineRate / kRate));
    const std::optional<Broken> slower = played(*scene, atSpeed(*shot, 1.0 - kNear), kFineRate);
    const std::optional<Broken> faster = played(*scene, atSpeed(*shot, 1.0 + kNear), kFineRate);
    if (!fine || !slower || !faster) return std::nullopt;
    std::size_t all = 0, common = 0;
    Bonds any = coarse->bonds;
    any.insert(fine->bonds.begin(), fine->bonds.end());
    for (const auto& bond : any) {
        if (slower->bonds.contains(bond) != faster->bonds.contains(bond)) continue;
        ++all;
        common += coarse->bonds.contains(bond) && fine->bonds.contains(bond) ? 1 : 0;
    }
    return all > 0 ? std::optional(static_cast<double>(common) / static_cast<double>(all)) : std::nullopt;
}

}  // namespace rubble::soak
