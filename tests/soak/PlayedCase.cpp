#include "tests/soak/PlayedCase.h"

#include "core/io/play/ReplayFile.h"
#include "core/io/play/StateFile.h"
#include "core/play/scene/Projectile.h"
#include "tests/soak/FrameRate.h"
#include "tests/soak/Moment.h"
#include "tests/soak/NewProcess.h"

#include <algorithm>
#include <optional>

namespace rubble::soak {
namespace {

constexpr std::uint64_t kStepsAfterLoading = 30;  // that a new process plays from a saved state
constexpr std::uint64_t kVerifySteps = 25;        // between states that are saved and verified

/// A state that was saved after a step.
struct SavedState {
    std::uint64_t step = 0;
    std::string bytes;
};

/// An input for a body that is there, in place of the one that it names: the same place in the list, counted around.
PlayInput withPresentBody(PlayInput input, const Session& session) {
    const auto bodyAt = [&](std::uint32_t place) -> const PlayBody& {
        return session.bodies()[place % session.bodies().size()];
    };
    if (session.bodies().empty()) return input;
    if (auto* broken = std::get_if<BreakInput>(&input)) broken->body = bodyAt(broken->body).number;
    if (auto* grab = std::get_if<GrabInput>(&input)) {
        const PlayBody& body = bodyAt(grab->body);
        const World& world = session.world();
        const Vec3 centre = world.state(body.body).centre;
        grab->body = body.number;
        if (glm::distance(grab->point, centre) > world.shape(body.body).boundingRadius) grab->point = centre;
    }
    return input;
}

/// Whether a throw would begin inside of something: what is pushed apart then is no fault.
bool beginsInside(const Throw& thrown, const Session& session) {
    const PlayScene& scene = session.scene();
    const bool isAsset = thrown.kind == ProjectileKind::Asset;
    const auto asset = scene.assets.find({thrown.asset});
    if (isAsset && asset == scene.assets.end()) return true;
    const Material* const material =
        isAsset ? findMaterial(scene.project, findAsset(scene.project, thrown.asset)->material) : nullptr;
    const Result<BodyDefinition> body =
        projectileBody(thrown, isAsset ? asset->second->whole.shape : nullptr, material);
    if (!body) return true;
    std::vector<Polytope> hulls{};
    if (isAsset) hulls = wholeHullsInPrism(*asset->second->bake);
    if (!isAsset) hulls.push_back(projectileHull(thrown));
    return std::ranges::any_of(hulls, [&](const Polytope& hull) {
        const Result<std::vector<BodyId>> found = session.world().overlapping(hull, body->pose);
        return !found || !found->empty();
    });
}

/// A session that must go on as the one that is checked.
struct Shadow {
    Session session;
    std::string what;
    std::uint64_t steps = 0;  // that are left
};

/// Plays a case step by step.
class CasePlayer {
public:
    CasePlayer(const SoakCase& one, std::shared_ptr<const PlayScene> scene, Session session)
        : m_case(one),
          m_scene(std::move(scene)),
          m_session(std::move(session)),
          m_densities(densitiesOf(one.project)),
          m_inputs(one.steps) {}

    Outcome play(const std::string& invariant, const std::function<void(const Outcome&)>& progress) {
        m_wanted = invariant;
        m_before = momentOf(m_session, m_densities);
        for (std::unique_ptr<Invariant>& each : invariants()) {
            if (!isWanted(each->name())) continue;
            each->start(m_session, m_before);
            m_invariants.push_back(std::move(each));
        }
        if (m_case.isCompared) addCompared();
        while (m_outcome.steps < m_case.steps && (invariant.empty() || m_outcome.failures.empty())) {
            if (progress) progress(m_outcome);
            beginSnapshot();
            playStep();
            endSnapshot();
            saveIfDue();
        }
        if (isWanted(kSavedState) || isWanted(kSameState)) {
            for (const SavedState& saved : m_saved) compareWithNewProcess(saved);
        }
        if (invariant.empty()) m_outcome.agreement = frameRateAgreement(m_case);
        return m_outcome;
    }

private:
    bool isWanted(const std::string& name) const { return m_wanted.empty() || name == m_wanted; }

    void report(const std::string& invariant, const std::string& body, const std::string& text) {
        report({invariant, m_outcome.steps, body, text});
    }
    void report(const Failure& failure) {
        const auto isKnown = [&](const Failure& one) { return one.invariant == failure.invariant; };
        if (!isWanted(failure.invariant) || std::ranges::any_of(m_outcome.failures, isKnown)) return;
        m_outcome.failures.push_back(failure);
    }

    void addCompared() {
        SessionSettings settings{.dt = m_case.dt, .sleeping = m_case.isSleeping};
        settings.threads = 2;
        settings.lanes = SimdWidth::Scalar;
        Result<Session> session = Session::start(m_scene, settings);
        if (session) m_shadows.push_back({std::move(*session), "on two threads and one lane", m_case.steps});
    }

    /// The inputs of this step, for bodies that are there.
    void addInputs() {
        std::vector<PlayInput>& due = m_inputs[m_outcome.steps];
        for (const TimedInput& timed : m_case.inputs) {
            if (timed.step != m_outcome.steps) continue;
            const PlayInput input = withPresentBody(timed.input, m_session);
            const auto* shot = std::get_if<ShotInput>(&input);
            const Throw* const thrown = shot != nullptr ? std::get_if<Throw>(&shot->action) : nullptr;
            if (thrown != nullptr && beginsInside(*thrown, m_session)) continue;
            if (!m_session.add(input)) continue;
            due.push_back(input);
            if (const auto* material = std::get_if<MaterialInput>(&input)) {
                m_densities[material->material.id] = material->material.density;
            }
        }
        for (Shadow& shadow : m_shadows) addTo(shadow.session, due);
    }

    static void addTo(Session& session, const std::vector<PlayInput>& inputs) {
        for (const PlayInput& input : inputs) static_cast<void>(session.add(input));
    }

    void playStep() {
        addInputs();
        m_session.step();
        ++m_outcome.steps;
        m_outcome.breaks += m_session.events().breaks.size();
        m_outcome.splits += m_session.events().splits.size();
        Moment after = momentOf(m_session, m_densities);
        check({m_session, m_before, after, m_session.events(), thrownBodies(m_session, m_densities)});
        m_before = std::move(after);
        m_traces.push_back(traceOf(m_session));
        stepShadows();
    }

    void check(const StepFacts& step) {
        std::erase_if(m_invariants, [&](const std::unique_ptr<Invariant>& one) {
            const std::optional<Fault> fault = one->check(step);
            if (fault) report(one->name(), fault->body, fault->text);
            return fault.has_value();
        });
    }

    void stepShadows() {
        for (Shadow& shadow : m_shadows) {
            shadow.session.step();
            --shadow.steps;
            if (traceOf(shadow.session) == m_traces.back()) continue;
            report(kSameState, "", shadow.what + ", the state or the events differ");
            shadow.steps = 0;
        }
        std::erase_if(m_shadows, [](const Shadow& shadow) { return shadow.steps == 0; });
    }

    void beginSnapshot() {
        const auto isDue = [&](const Rewind& one) { return one.step == m_outcome.steps; };
        const auto due = std::ranges::find_if(m_case.rewinds, isDue);
        if (due == m_case.rewinds.end() || m_snapshot) return;
        m_rewind = *due;
        m_snapshot = m_session.snapshot();
    }

    /// Goes back to the snapshot, and plays the same steps again.
    void endSnapshot() {
        if (!m_snapshot || m_outcome.steps < m_rewind.step + m_rewind.steps) return;
        m_session.restore(*m_snapshot);
        m_snapshot = nullptr;
        for (std::uint64_t step = m_rewind.step; step < m_outcome.steps; ++step) {
            addTo(m_session, m_inputs[step]);
            m_session.step();
            if (traceOf(m_session) == m_traces[step]) continue;
            report(kSameState, "", "played again from a snapshot, step " + std::to_string(step + 1) + " differs");
        }
        m_before = momentOf(m_session, m_densities);
    }

    void saveIfDue() {
        const bool isSaved = std::ranges::count(m_case.saves, m_outcome.steps) > 0;
        if (!isSaved && m_outcome.steps % kVerifySteps != 0) return;
        const ContentHash scene = sceneHash(m_case.project);
        const std::string bytes = stateBytes(savedSession(m_session, StateKind::Whole), scene);
        Result<SavedSession> saved = readStateBytes(bytes, scene);
        if (!saved) return report(kSavedState, "", saved.error().message);
        SessionSettings settings;
        settings.threads = 2;
        settings.lanes = SimdWidth::Four;
        Result<Session> session = resumedSession(m_scene, std::move(*saved), settings);
        if (!session) return report(kSavedState, "", session.error().message);
        if (session->hash() != m_session.hash()) report(kSavedState, "", "the loaded state has another hash");
        if (isSaved) m_saved.push_back({m_outcome.steps, bytes});
    }

    /// Compares what was played since a state was saved with what a new process plays that loads it.
    void compareWithNewProcess(const SavedState& saved) {
        SoakCase rest{.project = m_case.project, .dt = m_case.dt, .isSleeping = m_case.isSleeping};
        rest.steps = std::min(kStepsAfterLoading, m_outcome.steps - saved.step);
        for (std::uint64_t step = saved.step; step < saved.step + rest.steps; ++step)
            for (const PlayInput& input : m_inputs[step]) rest.inputs.push_back({step, input});
        const int threads = 1 + static_cast<int>(saved.step % 4);
        const Result<std::vector<Trace>> traces = tracesOfNewProcess(rest, saved.bytes, threads);
        const std::string from = "after the state of step " + std::to_string(saved.step) + ", ";
        if (!traces) return report({kSavedState, saved.step, "", from + traces.error().message});
        for (std::uint64_t k = 0; k < rest.steps; ++k) {
            if (k < traces->size() && (*traces)[k] == m_traces[saved.step + k]) continue;
            return report({kSameState, saved.step + k + 1, "", from + "a step in a new process differs"});
        }
    }

    const SoakCase& m_case;
    std::shared_ptr<const PlayScene> m_scene;
    Session m_session;
    Densities m_densities;
    std::vector<std::vector<PlayInput>> m_inputs;  // of each step, as they were applied
    std::vector<Trace> m_traces;                   // after each step
    std::vector<Shadow> m_shadows;
    std::vector<SavedState> m_saved;
    std::vector<std::unique_ptr<Invariant>> m_invariants;
    std::string m_wanted;
    Moment m_before;
    Rewind m_rewind;
    std::shared_ptr<const SessionSnapshot> m_snapshot;
    Outcome m_outcome;
};

}  // namespace

Outcome playedCase(const SoakCase& one, const std::string& invariant,
                   const std::function<void(const Outcome&)>& progress) {
    const auto refused = [](const Error& error) { return Outcome{.failures = {{kPlayable, 0, "", error.message}}}; };
    Result<std::shared_ptr<const PlayScene>> scene = playScene(one.project);
    if (!scene) return refused(scene.error());
    Result<Session> session = Session::start(*scene, {.dt = one.dt, .sleeping = one.isSleeping});
    if (!session) return refused(session.error());
    return CasePlayer(one, *scene, std::move(*session)).play(invariant, progress);
}

}  // namespace rubble::soak
