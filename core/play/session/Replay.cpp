#include "core/play/session/Replay.h"

#include "core/base/Assert.h"
#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"

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

/// Returns a velocity as recordings hold it.
Vec3 rounded(Vec3 velocity) {
    constexpr double kPerMetre = 1e6;
    const auto round = [](double value) { return std::round(value * kPerMetre) / kPerMetre + 0.0; };  // no -0
    return {round(velocity.x), round(velocity.y), round(velocity.z)};
}

ReplayStep stepOf(const Session& session) {
    ReplayStep step{.hash = session.hash().low};
    for (const PlayBreak& broken : session.events().breaks) step.broke.push_back({broken.body.number, broken.impact});
    for (const PlayBody& body : session.bodies()) {
        if (session.world().kind(body.body) == BodyKind::Static) continue;
        const BodyState state = session.world().state(body.body);
        if (!state.asleep) step.moved.push_back({body.number, checkOf(state), rounded(state.velocity)});
    }
    step.events = session.events().report.hash();
    return step;
}

bool reportsOther(const ReplayStep& recorded, const ReplayStep& now) {
    return recorded.events && recorded.events != now.events;
}

bool differs(const ReplayStep& recorded, const ReplayStep& now) {
    const auto isSame = [](const BodyCheck& a, const BodyCheck& b) { return a.body == b.body && a.check == b.check; };
    return recorded.hash != now.hash || !std::ranges::equal(recorded.moved, now.moved, isSame) ||
           reportsOther(recorded, now);
}

/// A body by which two steps differ.
struct BodyDifference {
    std::uint32_t body = 0;
    DivergenceKind kind = DivergenceKind::Unmeasured;
    double size = 0.0;
};

/// Adds the bodies that broke in one of two steps only.
void addBreaks(const std::vector<ReplayBreak>& breaks, const std::vector<ReplayBreak>& others, DivergenceKind kind,
               std::vector<BodyDifference>& differences) {
    for (const ReplayBreak& broken : breaks) {
        if (std::ranges::find(others, broken.body, &ReplayBreak::body) == others.end())
            differences.push_back({broken.body, kind, broken.impact});
    }
}

/// Returns the bodies whose checks differ. A body that is in one list only rests in the other step, or is gone.
std::vector<BodyDifference> differentChecks(const ReplayStep& recorded, const ReplayStep& now, DivergenceKind kind) {
    std::vector<BodyDifference> differences;
    const auto add = [&](std::uint32_t body, Vec3 offset) {
        differences.push_back({body, kind, std::sqrt(glm::dot(offset, offset))});
    };
    auto a = recorded.moved.begin();
    auto b = now.moved.begin();
    while (a != recorded.moved.end() || b != now.moved.end()) {
        if (b == now.moved.end() || (a != recorded.moved.end() && a->body < b->body)) {
            add(a->body, a->velocity);
            ++a;
        } else if (a == recorded.moved.end() || b->body < a->body) {
            add(b->body, b->velocity);
            ++b;
        } else {
            if (a->check != b->check) add(a->body, b->velocity - a->velocity);
            ++a;
            ++b;
        }
    }
    return differences;
}

/// The body by which two steps differ most, as Divergence describes it.
std::optional<BodyDifference> largestDifference(const ReplayStep& recorded, const ReplayStep& now, bool isDetailed) {
    std::vector<BodyDifference> differences;
    if (isDetailed) {
        addBreaks(now.broke, recorded.broke, DivergenceKind::Broke, differences);
        addBreaks(recorded.broke, now.broke, DivergenceKind::DidNotBreak, differences);
    }
    if (differences.empty()) {
        differences =
            differentChecks(recorded, now, isDetailed ? DivergenceKind::Velocity : DivergenceKind::Unmeasured);
        if (!isDetailed && !differences.empty()) return differences[0];
    }
    const auto largest = std::ranges::max_element(differences, {}, &BodyDifference::size);
    return largest == differences.end() ? std::nullopt : std::optional(*largest);
}

/// The body of a session that is or was farthest from its recorded position, of the bodies in both.
Divergence::Distance largestOffset(const ReplayKeyframe& frame, const Session& session) {
    Divergence::Distance farthest{.step = frame.step};
    for (const ReplayBody& recorded : frame.bodies) {
        const PlayBody* body = session.body(recorded.number);
        if (body == nullptr) continue;
        const Vec3 offset = session.world().state(body->body).pose.position - recorded.pose.position;
        const double metres = std::sqrt(glm::dot(offset, offset));
        if (metres > farthest.metres) farthest = {frame.step, session.nameOf(*body), metres};
    }
    return farthest;
}

std::string differenceText(const Divergence& divergence) {
    const std::string impact = quantityText(QuantityKind::Impulse, divergence.difference);
    switch (divergence.kind) {
        case DivergenceKind::Unmeasured: break;
        case DivergenceKind::Broke: return "breaks under an impact of " + impact + "; in the recording it does not";
        case DivergenceKind::DidNotBreak:
            return "does not break; in the recording it does, under an impact of " + impact;
        case DivergenceKind::Velocity:
            if (divergence.difference < 1e-6) return "diverged from the recording, in velocity by less than 1e-6 m/s";
            return "diverged most from the recording, in velocity by " +
                   quantityText(QuantityKind::Speed, divergence.difference);
        case DivergenceKind::Events: return "reports other events than in the recording";
    }
    return "diverged from the recording";
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

Diagnostic Divergence::diagnostic() const {
    std::string text = "At step " + std::to_string(step) + ' ' + (body.empty() ? "the scene" : quotedName(body)) + ' ' +
                       differenceText(*this);
    if (distance && distance->metres > 0.0) {
        text += "; at step " + std::to_string(distance->step) + ", " + quotedName(distance->body) +
                " is farthest from its recorded position, by " + quantityText(QuantityKind::Length, distance->metres);
    }
    return rubble::diagnostic(DiagnosticCode::ReplayMismatch, place, text + '.', difference);
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
            m_divergence->distance = largestOffset(*frame, session());
        }
        return;
    }
    const ReplayStep& recorded = m_replay.steps[step - 1];
    const ReplayStep now = stepOf(session());
    if (!differs(recorded, now)) return;
    m_divergence = Divergence{.step = step};
    if (const std::optional<BodyDifference> largest = largestDifference(recorded, now, m_replay.isDetailed)) {
        const PlayBody* body = session().recentBody(largest->body);
        m_divergence->body = body != nullptr ? session().nameOf(*body) : "body " + std::to_string(largest->body);
        if (body != nullptr) m_divergence->place = placeOf(*body);
        m_divergence->kind = largest->kind;
        m_divergence->difference = largest->size;
    } else if (reportsOther(recorded, now)) {
        m_divergence->kind = DivergenceKind::Events;
    }
    compare();
}

}  // namespace rubble
