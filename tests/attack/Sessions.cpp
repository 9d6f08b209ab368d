#include "tests/attack/Sessions.h"

#include "core/io/play/SimulationJson.h"
#include "tests/support/asset/Packs.h"
#include "tests/support/files/FuzzedReaders.h"

#include <nlohmann/json.hpp>

namespace rubble::attack {
namespace {

using test::Sentence;

constexpr int kSteps = 30;

}  // namespace

const std::shared_ptr<const PlayScene>& blockScene() {
    static const std::shared_ptr<const PlayScene> scene = [] {
        Project project = boxProject(UniformScatter{.count = 5});
        return *playScene(project, {.threads = 1});
    }();
    return scene;
}

std::vector<TimedInput> sampleInputs() {
    const Throw thrown{.kind = ProjectileKind::Ball, .size = Vec3(0.3), .mass = 7.0, .speed = 5.0};
    return {{0, ShotInput{"ball", thrown}},
            {0, ShotInput{"blow", Hammer{{0, 1, 0}, {4, 5, 6}}}},
            {3, ShotInput{"bomb", Blast{{0, 1, 1}, 50.0, 2.0}}},
            {4, ThresholdInput{2, 0, 70.5}},
            {5, MaterialInput{{.id = 1, .name = "lead", .density = 11000.0}}},
            {6, GrabInput{1, {0, 1, 0}, 500.0}},
            {7, DragInput{{2, 2, 2}}},
            {8, ReleaseInput{}},
            {9, BreakInput{1}},
            {10, GravityInput{{0, -1, 0}}},
            {11, DestructionInput{false}}};
}

std::optional<std::string> outcomeFault(const Session& session) {
    SimulationOutcome outcome{.steps = session.stepsDone(), .hash = session.hash()};
    for (const PlayBody& body : session.bodies()) {
        const BodyState state = session.world().state(body.body);
        outcome.bodies.push_back({session.nameOf(body), state.pose, state.asleep});
    }
    for (const PlayBreak& broken : session.events().breaks) {
        outcome.breaks.push_back({broken.step, session.nameOf(broken.body), broken.impact, broken.threshold,
                                  broken.point, broken.fragmentCount, std::nullopt});
    }
    for (const Diagnostic& one : session.events().diagnostics) {
        if (Sentence fault = test::errorFault({ErrorCode::BadInput, one.message})) return fault;
    }
    if (nlohmann::json::accept(simulationJson(outcome))) return std::nullopt;
    return "The outcome of " + std::to_string(outcome.steps) + " steps is not JSON.";
}

std::optional<std::string> playFault(const std::shared_ptr<const PlayScene>& scene,
                                     const std::vector<TimedInput>& inputs) {
    Result<Session> session = Session::start(scene, {.threads = 1});
    if (!session) return test::errorFault(session.error());
    for (const Shot& shot : scene->project.shots) {
        if (const Status added = session->add(Shot{shot.id, shot.name, 0.0, shot.action}); !added)
            return test::errorFault(added.error());
    }
    for (const TimedInput& input : inputs) {
        if (const Status added = session->add(input); !added) {
            if (Sentence fault = test::errorFault(added.error())) return fault;
        }
    }
    for (int step = 0; step < kSteps; ++step) {
        session->step();
        if (Sentence fault = outcomeFault(*session)) return fault;
    }
    return std::nullopt;
}

}  // namespace rubble::attack
