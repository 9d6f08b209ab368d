#include "core/play/session/PlayTestRun.h"

#include "core/asset/bake/FragmentLookup.h"
#include "core/base/MessageText.h"
#include "core/play/session/StandingParts.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble {
namespace {

constexpr double kUntouched = 0.01;  // m
constexpr double kMinLoss = 1e-9;    // of the mass: the rounding of the sum of all fragments

/// What stands of an instance at the start of a test, m³, without what the test removes.
double standingVolume(const Session& session, const Instance& instance, const PlayTest& test) {
    const StandingParts standing = standingParts(session, instance.id);
    const auto removed = std::ranges::find(test.removed, instance.id, &InstancePart::instance);
    if (removed == test.removed.end()) return standing.volume;
    if (removed->fragments.empty()) return 0.0;
    const PlayAsset& asset = *session.scene().assets.at(variantOf(instance));
    double volume = standing.volume;
    for (const FragmentPath& path : removed->fragments) {
        const std::uint32_t fragment = fragmentAt(*asset.bake, path).value_or(kNone);
        if (std::ranges::binary_search(standing.fragments, fragment))
            volume -= asset.fragments[fragment].shape->mass.volume;
    }
    return volume;
}

/// Observes the run of a test.
class TestObserver {
public:
    TestObserver(const Session& session, const PlayTest& test)
        : m_session(session), m_firstStep(session.stepsDone()), m_hasRemovals(!test.removed.empty()) {
        const bool needsVolumes = std::ranges::find(test.expectations, ExpectationKind::StaysUp, &Expectation::kind) !=
                                  test.expectations.end();
        for (const Instance& instance : session.scene().project.instances)
            if (needsVolumes) m_standing[instance.id] = standingVolume(session, instance, test);
        for (const PlayBody& body : session.bodies()) {
            if (body.role == PlayRole::Instance)
                m_starts.push_back({body.number, session.world().state(body.body).centre});
        }
        m_fragmentCounts.assign(session.origins().size(), 1);
        m_brokenAt.assign(session.origins().size(), 0);
    }

    void afterStep() {
        m_fragmentCounts.resize(m_session.origins().size(), 1);
        m_brokenAt.resize(m_session.origins().size(), 0);
        for (const PlayBreak& broken : m_session.events().breaks)
            recordBreak(broken.body.origin, broken.fragmentCount - 1);
        for (const PlaySplit& split : m_session.events().splits)
            if (!isOfRemoval(split)) recordBreak(split.body.origin, static_cast<std::uint32_t>(split.freed.size()));
        for (const Start& start : m_starts) {
            const PlayBody* body = m_session.body(start.number);
            if (body == nullptr) continue;
            const double moved = glm::length(m_session.world().state(body->body).centre - start.centre);
            recordMove(body->origin, moved);
        }
    }

    ExpectationOutcome outcome(const Expectation& expectation) const {
        switch (expectation.kind) {
            case ExpectationKind::StandsUntouched: return standsUntouched(expectation);
            case ExpectationKind::Breaks: return breaks(expectation);
            case ExpectationKind::DoesNotBreak: return doesNotBreak(expectation);
            case ExpectationKind::BreaksIntoAtLeast: return breaksInto(expectation);
            case ExpectationKind::NothingAbove: return nothingAbove(expectation);
            case ExpectationKind::NothingFaster: return nothingFaster(expectation);
            case ExpectationKind::StaysUp: return staysUp(expectation);
            case ExpectationKind::HoleAtMost: return holeAtMost(expectation);
        }
        return {};
    }

private:
    struct Start {
        std::uint32_t number = 0;
        Vec3 centre;
    };
    /// When an instance had first moved by more than kUntouched.
    struct Move {
        std::uint32_t origin = 0;
        std::uint64_t step = 0;
    };

    /// Whether a body lost the mortar to what the test removes, and no more.
    bool isOfRemoval(const PlaySplit& split) const {
        const bool isFirst = m_session.stepsDone() == m_firstStep + 1;
        return m_hasRemovals && isFirst && split.impactorNumber == kNone && split.impulse == 0.0 && split.freed.empty();
    }

    void recordBreak(std::uint32_t origin, std::uint32_t added) {
        m_fragmentCounts[origin] += added;
        if (m_brokenAt[origin] == 0) m_brokenAt[origin] = m_session.stepsDone();
    }

    void recordMove(std::uint32_t origin, double moved) {
        const bool isRecorded = std::ranges::find(m_firstMoves, origin, &Move::origin) != m_firstMoves.end();
        if (moved > kUntouched && !isRecorded) m_firstMoves.push_back({origin, m_session.stepsDone()});
    }

    bool matches(std::uint32_t origin, Id instance) const {
        const PlayOrigin& placed = m_session.origins()[origin];
        return instance == 0 ? placed.instance != 0 : placed.instance == instance;
    }
    std::string nameOf(Id instance, const std::string& any) const {
        for (const PlayOrigin& origin : m_session.origins()) {
            if (instance != 0 && origin.instance == instance) return quotedName(origin.name);
        }
        return any;
    }
    std::string when(std::uint64_t step) const {
        const double time = static_cast<double>(step) * m_session.stepLength();
        return "at step " + std::to_string(step) + " (" + roundedText(time, 4) + " s)";
    }
    /// The first matching origin that broke; nothing if none did.
    std::optional<std::uint32_t> firstBroken(Id instance) const {
        std::optional<std::uint32_t> first;
        for (std::uint32_t origin = 0; origin < m_brokenAt.size(); ++origin) {
            if (m_brokenAt[origin] == 0 || !matches(origin, instance)) continue;
            if (!first || m_brokenAt[origin] < m_brokenAt[*first]) first = origin;
        }
        return first;
    }
    static std::string noBreakText(const Expectation& expectation) {
        return expectation.instance == 0 ? "nothing broke" : "it did not break";
    }
    std::string brokeText(std::uint32_t origin) const {
        return quotedName(m_session.origins()[origin].name) + " broke " + when(m_brokenAt[origin]);
    }

    ExpectationOutcome standsUntouched(const Expectation& expectation) const {
        ExpectationOutcome outcome{.expected = nameOf(expectation.instance, "everything") + " stays intact for " +
                                               messageText(expectation.value) + " s"};
        const std::uint64_t until =
            m_firstStep + static_cast<std::uint64_t>(std::floor(expectation.value / m_session.stepLength() + 1e-6));
        outcome.step = std::min(until, m_session.stepsDone());
        outcome.isMet = until <= m_session.stepsDone();
        outcome.seen = !outcome.isMet              ? "the test ended earlier"
                       : expectation.instance == 0 ? "everything stayed intact"
                                                   : "it stayed intact";
        for (const Move& move : m_firstMoves) {
            if (move.step > outcome.step || !matches(move.origin, expectation.instance)) continue;
            outcome = {
                false, outcome.expected,
                quotedName(m_session.origins()[move.origin].name) + " had moved more than 1 cm " + when(move.step),
                move.step};
            break;
        }
        const std::optional<std::uint32_t> broken = firstBroken(expectation.instance);
        if (broken && m_brokenAt[*broken] <= outcome.step) {
            outcome = {false, outcome.expected, brokeText(*broken), m_brokenAt[*broken]};
        }
        return outcome;
    }

    ExpectationOutcome breaks(const Expectation& expectation) const {
        const std::optional<std::uint32_t> broken = firstBroken(expectation.instance);
        return {broken.has_value(), nameOf(expectation.instance, "something") + " breaks",
                broken ? brokeText(*broken) : noBreakText(expectation),
                broken ? m_brokenAt[*broken] : m_session.stepsDone()};
    }

    ExpectationOutcome doesNotBreak(const Expectation& expectation) const {
        const std::optional<std::uint32_t> broken = firstBroken(expectation.instance);
        return {!broken,
                expectation.instance == 0 ? "nothing breaks" : nameOf(expectation.instance, "") + " does not break",
                broken ? brokeText(*broken) : noBreakText(expectation),
                broken ? m_brokenAt[*broken] : m_session.stepsDone()};
    }

    ExpectationOutcome breaksInto(const Expectation& expectation) const {
        std::uint32_t most = 0;
        for (std::uint32_t origin = 0; origin < m_fragmentCounts.size(); ++origin) {
            if (matches(origin, expectation.instance)) most = std::max(most, m_fragmentCounts[origin]);
        }
        return {most >= expectation.value,
                nameOf(expectation.instance, "something") + " breaks into at least " + messageText(expectation.value) +
                    " fragments",
                most == 1 ? noBreakText(expectation) : "it broke into " + std::to_string(most) + " fragments",
                m_session.stepsDone()};
    }

    /// The matching dynamic body with the largest value of a measure.
    template <class Measure>
    std::pair<const PlayBody*, double> largest(Id instance, const Measure& measure) const {
        std::pair<const PlayBody*, double> found{nullptr, 0.0};
        for (const PlayBody& body : m_session.bodies()) {
            if (m_session.world().kind(body.body) != BodyKind::Dynamic) continue;
            if (instance != 0 && !matches(body.origin, instance)) continue;
            const double value = measure(body);
            if (found.first == nullptr || value > found.second) found = {&body, value};
        }
        return found;
    }

    ExpectationOutcome nothingAbove(const Expectation& expectation) const {
        const auto [body, height] =
            largest(expectation.instance, [&](const PlayBody& one) { return topHeight(one, m_session.world()); });
        return {body == nullptr || height <= expectation.value,
                nameOf(expectation.instance, "everything") + " ends below a height of " +
                    messageText(expectation.value) + " m",
                body == nullptr
                    ? "nothing was left"
                    : quotedName(m_session.nameOf(*body)) + " reached up to " + roundedText(height, 4) + " m",
                m_session.stepsDone()};
    }

    ExpectationOutcome nothingFaster(const Expectation& expectation) const {
        const auto [body, speed] = largest(expectation.instance, [&](const PlayBody& one) {
            return glm::length(m_session.world().state(one.body).velocity);
        });
        return {body == nullptr || speed <= expectation.value,
                nameOf(expectation.instance, "everything") + " ends below a speed of " +
                    messageText(expectation.value) + " m/s",
                body == nullptr ? "nothing was left"
                                : quotedName(m_session.nameOf(*body)) + " moved at " + roundedText(speed, 4) + " m/s",
                m_session.stepsDone()};
    }

    /// The matching instance with the largest measure; nothing if none has one.
    template <class Measure>
    std::optional<std::pair<Id, double>> worst(Id instance, const Measure& measure) const {
        std::optional<std::pair<Id, double>> found;
        for (const Instance& one : m_session.scene().project.instances) {
            if (instance != 0 && one.id != instance) continue;
            const std::optional<double> value = measure(one.id);
            if (value && (!found || *value > found->second)) found = {one.id, *value};
        }
        return found;
    }

    ExpectationOutcome staysUp(const Expectation& expectation) const {
        const auto lost = worst(expectation.instance, [&](Id instance) -> std::optional<double> {
            const double before = m_standing.at(instance);
            if (before <= 0.0) return std::nullopt;
            const double part = 1.0 - standingParts(m_session, instance).volume / before;
            return part > kMinLoss ? part : 0.0;
        });
        return {lost && lost->second <= expectation.value,
                nameOf(expectation.instance, "every instance") + " loses at most " +
                    roundedText(100.0 * expectation.value, 4) + " % of its mass",
                lost ? nameOf(lost->first, "") + " lost " + roundedText(100.0 * lost->second, 3) + " %"
                     : "it did not stand at the start",
                m_session.stepsDone()};
    }

    ExpectationOutcome holeAtMost(const Expectation& expectation) const {
        const auto hole = worst(expectation.instance, [&](Id instance) -> std::optional<double> {
            const auto structure = m_session.scene().structures.find(instance);
            if (structure == m_session.scene().structures.end()) return std::nullopt;
            return holeWidth(*structure->second, standingParts(m_session, instance).fragments);
        });
        return {hole && hole->second <= expectation.value,
                nameOf(expectation.instance, "every instance") + " has holes of at most " +
                    messageText(expectation.value) + " m",
                hole ? nameOf(hole->first, "") + " has one of " + roundedText(hole->second, 3) + " m"
                     : "it does not break along bonds",
                m_session.stepsDone()};
    }

    const Session& m_session;
    const std::uint64_t m_firstStep;
    const bool m_hasRemovals;
    std::map<Id, double> m_standing;  // m³, of each instance at the start, without what is removed
    std::vector<Start> m_starts;
    std::vector<Move> m_firstMoves;
    std::vector<std::uint32_t> m_fragmentCounts;  // by origin
    std::vector<std::uint64_t> m_brokenAt;        // by origin; 0: not broken
};

}  // namespace

bool PlayTestOutcome::isPassed() const { return std::ranges::all_of(expectations, &ExpectationOutcome::isMet); }

std::uint64_t PlayTestOutcome::failedAt() const {
    const auto failed = std::ranges::find(expectations, false, &ExpectationOutcome::isMet);
    return failed == expectations.end() ? 0 : failed->step;
}

std::vector<TimedInput> inputsOf(const Project& project, const PlayTest& test, std::uint64_t first, double dt) {
    std::vector<TimedInput> inputs;
    for (const InstancePart& part : test.removed) inputs.push_back({first, RemoveInput{part}});
    for (const Shot& shot : project.shots) {
        if (std::ranges::find(test.shots, shot.id) == test.shots.end()) continue;
        inputs.push_back({first + stepOf(shot.time, dt), ShotInput{shot.name, shot.action}});
    }
    std::ranges::stable_sort(inputs, {}, &TimedInput::step);
    return inputs;
}

Result<Session> sessionOf(std::shared_ptr<const PlayScene> scene, const PlayTest& test, const SessionSettings& settings,
                          const SavedSession* start) {
    Result<Session> session =
        start != nullptr ? resumedSession(scene, *start, settings) : Session::start(scene, settings);
    if (!session) return session.error();
    for (const TimedInput& input : inputsOf(scene->project, test, session->stepsDone(), session->stepLength())) {
        if (const Status added = session->add(input); !added) return added.error();
    }
    return session;
}

Result<PlayTestOutcome> runPlayTest(std::shared_ptr<const PlayScene> scene, const PlayTest& test,
                                    const SessionSettings& settings, const TaskContext& task,
                                    const SavedSession* start) {
    Result<Session> session = sessionOf(std::move(scene), test, settings, start);
    if (!session) return session.error();
    TestObserver observer(*session, test);
    const std::uint64_t steps = std::max<std::uint64_t>(stepOf(test.duration, session->stepLength()), 1);
    for (std::uint64_t step = 1; step <= steps; ++step) {
        if (task.isCancelled()) return TaskContext::cancelled();
        session->step();
        observer.afterStep();
        task.report(static_cast<double>(step) / static_cast<double>(steps));
    }
    PlayTestOutcome outcome{.test = test.id, .name = test.name, .steps = steps, .hash = session->hash()};
    for (const Expectation& expectation : test.expectations)
        outcome.expectations.push_back(observer.outcome(expectation));
    return outcome;
}

}  // namespace rubble
