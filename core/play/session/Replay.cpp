#include "core/play/session/Replay.h"

#include "core/base/Assert.h"
#include "core/base/MessageText.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rubble {
namespace {

std::uint32_t checkOf(const BodyState& state) {
    const Vec3 &position = state.pose.position, &velocity = state.velocity, &angularVelocity = state.angularVelocity;
    const Quat& rotation = state.pose.orientation;
    const std::array<double, 13> numbers{position.x,        position.y,        position.z,       rotation.w, rotation.x,
                                         rotation.y,        rotation.z,        velocity.x,       velocity.y, velocity.z,
                                         angularVelocity.x, angularVelocity.y, angularVelocity.z};
    return static_cast<std::uint32_t>(contentHash({reinterpret_cast<const char*>(numbers.data()), sizeof numbers}).low);
}

ReplayStep stepOf(const Session& session) {
    ReplayStep step{.hash = session.hash().low};
    for (const PlayBody& body : session.bodies()) {
        if (session.world().kind(body.body) == BodyKind::Static) continue;
        const BodyState state = session.world().state(body.body);
        if (!state.asleep) step.moved.push_back({body.number, checkOf(state)});
    }
    return step;
}

/// The number of the first body by which two steps differ.
std::optional<std::uint32_t> firstDifference(const ReplayStep& a, const ReplayStep& b) {
    for (std::size_t k = 0; k < std::min(a.moved.size(), b.moved.size()); ++k) {
        if (a.moved[k] != b.moved[k]) return std::min(a.moved[k].body, b.moved[k].body);
    }
    if (a.moved.size() == b.moved.size()) return std::nullopt;
    return (a.moved.size() > b.moved.size() ? a.moved[b.moved.size()] : b.moved[a.moved.size()]).body;
}

/// The largest distance of a body from its recorded position, of the bodies in both, m.
double largestOffset(const ReplayKeyframe& frame, const Session& session) {
    double farthest = 0.0;
    for (const ReplayBody& recorded : frame.bodies) {
        const PlayBody* body = session.body(recorded.number);
        if (body == nullptr) continue;
        const Vec3 offset = session.world().state(body->body).pose.position - recorded.pose.position;
        farthest = std::max(farthest, std::sqrt(glm::dot(offset, offset)));
    }
    return farthest;
}

}  // namespace

ReplayRecorder::ReplayRecorder(const Session& session, std::string program, ContentHash project) {
    RUBBLE_ASSERT(session.stepsDone() == 0);
    m_replay.program = std::move(program);
    m_replay.project = project;
    m_replay.dt = session.stepLength();
    m_replay.sleeping = session.isSleeping();
    m_replay.hasDestruction = session.hasDestruction();
}

void ReplayRecorder::add(const Session& session) {
    const PlayEvents& events = session.events();
    m_replay.inputs.insert(m_replay.inputs.end(), events.inputs.begin(), events.inputs.end());
    m_replay.steps.push_back(stepOf(session));
    if (session.stepsDone() % kKeyframeSteps != 0) return;
    ReplayKeyframe frame{.step = session.stepsDone()};
    for (const PlayBody& body : session.bodies()) {
        frame.bodies.push_back({body.number, session.world().state(body.body).pose});
    }
    m_replay.keyframes.push_back(std::move(frame));
}

Result<Replay> recordReplay(std::shared_ptr<const PlayScene> scene, const SessionSettings& settings,
                            std::vector<TimedInput> inputs, std::uint64_t steps, std::string program,
                            ContentHash project, const TaskContext& task) {
    Result<Session> session = Session::start(std::move(scene), settings);
    if (!session) return session.error();
    ReplayRecorder recorder(*session, std::move(program), project);
    Timeline timeline(std::move(*session), std::move(inputs), steps);
    const Status played = timeline.seek(steps, task, [&] {
        recorder.add(timeline.session());
        task.report(static_cast<double>(timeline.session().stepsDone()) / static_cast<double>(steps));
    });
    if (!played) return played.error();
    return recorder.replay();
}

std::string Divergence::sentence() const {
    std::string text = "At step " + std::to_string(step) + ' ' + (body.empty() ? "the scene" : '"' + body + '"') +
                       " diverged from the recording";
    if (distance) {
        text += "; at step " + std::to_string(distance->step) + ", the farthest body is " +
                messageText(distance->metres) + " m from its recorded position";
    }
    return text + '.';
}

Result<ReplayPlayer> ReplayPlayer::start(std::shared_ptr<const PlayScene> scene, Replay replay,
                                         const SessionSettings& settings) {
    SessionSettings same = settings;
    same.dt = replay.dt;
    same.sleeping = replay.sleeping;
    same.hasDestruction = replay.hasDestruction;
    Result<Session> session = Session::start(std::move(scene), same);
    if (!session) return session.error();
    Timeline timeline(std::move(*session), replay.inputs, replay.steps.size());
    return ReplayPlayer(std::move(replay), std::move(timeline));
}

Status ReplayPlayer::seek(std::uint64_t step, const TaskContext& task) {
    return m_timeline.seek(step, task, [this] { compare(); });
}

void ReplayPlayer::compare() {
    const std::uint64_t step = session().stepsDone();
    if (m_divergence) {
        const auto frame = std::ranges::find(m_replay.keyframes, step, &ReplayKeyframe::step);
        if (!m_divergence->distance && step >= m_divergence->step && frame != m_replay.keyframes.end()) {
            m_divergence->distance = {step, largestOffset(*frame, session())};
        }
        return;
    }
    const ReplayStep& recorded = m_replay.steps[step - 1];
    const ReplayStep now = stepOf(session());
    if (now == recorded) return;
    m_divergence = Divergence{.step = step};
    if (const std::optional<std::uint32_t> number = firstDifference(recorded, now)) {
        const PlayBody* body = session().body(*number);
        m_divergence->body = body != nullptr ? session().nameOf(*body) : "body " + std::to_string(*number);
    }
    compare();
}

}  // namespace rubble
