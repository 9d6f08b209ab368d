#include "tests/soak/FrameRate.h"

#include <algorithm>
#include <set>

namespace rubble::soak {
namespace {

constexpr int kRate = 60;            // steps/s
constexpr int kFineRate = 240;       // steps/s
constexpr int kLongest = 2 * kRate;  // steps until the first bond breaks
constexpr int kStepsAfter = 2;
constexpr double kEqual = 0.95;  // of all bonds that break at one of both rates

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

/// A session in which something is thrown in the first step; nothing if that cannot be.
std::optional<Session> thrownSession(const std::shared_ptr<const PlayScene>& scene, const ShotInput& shot, int rate) {
    Result<Session> session = Session::start(scene, {.dt = 1.0 / rate});
    if (!session || !session->add(shot)) return std::nullopt;
    return std::move(*session);
}

/// Plays on until kStepsAfter after the first break of bonds. Returns the number of steps; 0: none broke.
int playedUntilBroken(Session& session) {
    for (int step = 1; step <= kLongest; ++step) {
        session.step();
        if (session.events().splits.empty()) continue;
        for (int k = 0; k < kStepsAfter; ++k) session.step();
        return step + kStepsAfter;
    }
    return 0;
}

}  // namespace

std::optional<Fault> frameRateFault(const SoakCase& one) {
    const std::optional<ShotInput> shot = firstThrow(one);
    if (!shot) return std::nullopt;
    Project still = one.project;
    still.gravity = Vec3(0.0);
    const Result<std::shared_ptr<const PlayScene>> scene = playScene(still);
    if (!scene) return std::nullopt;
    std::optional<Session> session = thrownSession(*scene, *shot, kRate),
                           fine = thrownSession(*scene, *shot, kFineRate);
    const int steps = session && fine ? playedUntilBroken(*session) : 0;
    if (steps == 0) return std::nullopt;
    for (int step = 0; step < steps * (kFineRate / kRate); ++step) fine->step();
    const Bonds bonds = brokenBonds(*session), fineBonds = brokenBonds(*fine);
    Bonds all = bonds;
    all.insert(fineBonds.begin(), fineBonds.end());
    const std::size_t common = bonds.size() + fineBonds.size() - all.size();
    if (static_cast<double>(common) >= kEqual * static_cast<double>(all.size())) return std::nullopt;
    return Fault{"", std::to_string(bonds.size()) + " bonds break at 60 steps a second, " +
                         std::to_string(fineBonds.size()) + " at 240, " + std::to_string(common) + " at both"};
}

}  // namespace rubble::soak
