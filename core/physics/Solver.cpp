#include "core/physics/Solver.h"

#include "core/physics/Spin.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr int kSubSteps = 4;                              // of a step of 1/60 s; longer steps have more
constexpr float kLongestSubStep = 1.0f / 240.0f + 1e-6f;  // s
// Springs that push overlaps apart. Softer ones let a stack sink, by 8 mm for a house at 30 Hz; a quarter of the sub-steps' rate is
// the most that is stable.
constexpr float kContactHertz = 50.0f;
constexpr float kDampingRatio = 2.0f;
constexpr float kPushOutSpeed = 3.0f;        // m/s
constexpr float kRestitutionSpeed = 1.0f;    // m/s
constexpr std::size_t kLeastContacts = 384;  // in all, for a second worker to be worth its while
constexpr std::size_t kLeastBlocks = 12;     // of a colour, to be shared
constexpr std::size_t kLeastBodies = 128;

/// Source: Catto 2011, "Soft constraints", by the spring's frequency and damping ratio.
Softness softness(float hertz, float dampingRatio, float h) {
    const float omega = 2.0f * 3.14159265f * hertz;
    const float a1 = 2.0f * dampingRatio + h * omega, a2 = h * omega * a1, a3 = 1.0f / (1.0f + a2);
    return {omega / a1, a2 * a3, a3};
}

int subStepsOf(float dt) { return std::max(kSubSteps, static_cast<int>(std::ceil(dt / kLongestSubStep))); }

using Pass = void (*)(std::span<ContactBlock>, const SolverStep&);

/// The spring of grab(): critically damped, of limited force.
void pullGrabbed(WorldState& state, const SolverStep& step) {
    const std::uint32_t number = state.grabbed.index;
    if (number == 0 || !state.bodies[number].isDynamic()) return;
    BodyMotion& motion = state.motions[number];
    const BodyPlace& place = state.places[number];
    const Vec3f arm = (motion.turned * place.turn).matrix() * state.grabPlace;
    const Vec3f at = place.centre + motion.moved + arm;
    const Vec3f speed = motion.velocity + cross(motion.spin, arm);
    constexpr float kGrabHertz = 5.0f;
    const float omega = 2.0f * 3.14159265f * kGrabHertz;
    const Vec3f wanted = (state.grabTarget - at) * (0.5f * omega);
    // The mass that the point seems to have along the way wanted.
    const Vec3f change = wanted - speed;
    const float size = length(change);
    if (size < 1e-6f) return;
    const Vec3f direction = change * (1.0f / size), turning = cross(arm, direction);
    const float mass = 1.0f / (motion.inverseMass + dot(turning, place.inverseInertia * turning));
    const float impulse = std::min(mass * size * std::min(1.0f, omega * step.subStep), state.grabForce * step.subStep);
    motion.velocity += direction * (impulse * motion.inverseMass);
    motion.spin += place.inverseInertia * (turning * impulse);
}

/// What workers have begun since they last met. Lists of one colour may run side by side, and so may what one worker does alone.
struct Pending {
    static constexpr std::uint32_t kNoColour = ~0u, kSeveral = ~0u - 1;
    std::uint32_t colour = kNoColour;        // of all that was begun
    std::uint32_t sharedColour = kNoColour;  // of what all workers do

    bool mustEndBefore(std::uint32_t next, bool isShared) const {
        const std::uint32_t other = isShared ? colour : sharedColour;
        return other != kNoColour && other != next;
    }
    void add(std::uint32_t next, bool isShared) {
        colour = colour == kNoColour || colour == next ? next : kSeveral;
        if (isShared) sharedColour = next;
    }
};

/// The stages of a step on every worker. All workers call the same stages in the same order; what a stage is given to do is parted
/// between them, and they meet where the next stage reads what this one wrote.
class Stages {
public:
    Stages(WorldState& state, WorkerTeam& team, int worker, int workers, const SolverStep& step)
        : m_state(state), m_team(team), m_worker(worker), m_workers(workers), m_step(step) {}

    /// One pass over all colours in turn. Short lists are done by the first worker alone.
    void overContacts(Pass pass) {
        Pending pending;
        const std::span<ContactColours::List> lists = m_state.colours.lists();
        for (std::size_t i = 0; i < lists.size(); ++i) {
            const std::span<ContactBlock> blocks = lists[i].blocks;
            if (blocks.empty()) continue;
            const bool isShared = m_workers > 1 && i != ContactColours::kOneByOne &&
                                  blocks.size() >= kLeastBlocks * static_cast<std::size_t>(m_workers);
            if (pending.mustEndBefore(ContactColours::colourOf(i), isShared)) {
                meet();
                pending = {};
            }
            const IndexRange range = isShared ? share(blocks.size()) : IndexRange{0, m_worker == 0 ? blocks.size() : 0};
            pass(blocks.subspan(range.begin, range.size()), m_step);
            pending.add(ContactColours::colourOf(i), isShared);
        }
        meet();
    }

    void overBodies(void (*pass)(std::span<const std::uint32_t>, const SolverStep&),
                    std::span<const std::uint32_t> bodies) {
        const IndexRange range = share(bodies.size());
        pass(bodies.subspan(range.begin, range.size()), m_step);
    }
    void turnSpinners(std::span<const std::uint32_t> spinners) {
        const IndexRange range = share(spinners.size());
        for (std::size_t i = range.begin; i < range.end; ++i) {
            BodyMotion& motion = m_state.motions[spinners[i]];
            motion.turned = turnedBySpin(m_state, spinners[i], m_step.subStep);
            motion.moved += motion.velocity * m_step.subStep;
        }
    }
    void pull() {
        if (m_worker == 0) pullGrabbed(m_state, m_step);
        meet();
    }
    void meet() {
        if (m_workers > 1) m_team.meet();
    }

private:
    IndexRange share(std::size_t count) const {
        return partOf(count, static_cast<std::size_t>(m_worker), static_cast<std::size_t>(m_workers));
    }

    WorldState& m_state;
    WorkerTeam& m_team;
    const int m_worker;
    const int m_workers;
    const SolverStep& m_step;
};

void runSubSteps(Stages& stages, WorldState& state, const SolveScratch& scratch, const SolverKernels& kernels,
                 int count) {
    for (int i = 0; i < count; ++i) {
        stages.overBodies(kernels.integrateVelocities, state.awake);
        stages.meet();
        if (state.grabbed.index != 0) stages.pull();
        stages.overContacts(kernels.warmStart);
        stages.overContacts(kernels.solve);
        stages.overBodies(kernels.integratePositions, scratch.others);
        stages.turnSpinners(scratch.spinners);
        stages.meet();
        stages.overContacts(kernels.relax);
    }
    stages.overContacts(kernels.restitute);
}

}  // namespace

SolverStep solverStep(WorldState& state, float dt) {
    const float h = dt / static_cast<float>(subStepsOf(dt));
    const float hertz = std::min(kContactHertz, 0.25f / h);
    return {state.motions.data(),
            state.places.data(),
            dt,
            h,
            state.gravity,
            softness(hertz, kDampingRatio, h),
            softness(2.0f * hertz, kDampingRatio, h),
            kPushOutSpeed,
            kRestitutionSpeed};
}

void prepareContacts(WorldState& state, WorkerTeam& team, const SolverKernels& kernels, const SolverStep& step) {
    const auto prepare = [&](ContactColours::List& list, IndexRange range) {
        kernels.prepare(std::span(list.blocks).subspan(range.begin, range.size()),
                        std::span<const ReferenceBlock>(list.references).subspan(range.begin, range.size()), step);
    };
    const auto workers = static_cast<std::size_t>(team.size());
    if (workers == 1 || state.colours.contactCount() < kLeastContacts) {
        for (ContactColours::List& list : state.colours.lists()) prepare(list, {0, list.blocks.size()});
        return;
    }
    team.run([&](int worker) {
        for (ContactColours::List& list : state.colours.lists()) {
            prepare(list, partOf(list.blocks.size(), static_cast<std::size_t>(worker), workers));
        }
    });
}

void solveSubSteps(WorldState& state, WorkerTeam& team, SolveScratch& scratch, const SolverKernels& kernels,
                   const SolverStep& step) {
    scratch.spinners.clear();
    scratch.others.clear();
    for (std::uint32_t body : state.awake) {
        (isSpinner(state, body, step.dt) ? scratch.spinners : scratch.others).push_back(body);
    }
    const int count = subStepsOf(step.dt);
    if (team.size() == 1 || state.colours.contactCount() < kLeastContacts) {
        Stages stages(state, team, 0, 1, step);
        runSubSteps(stages, state, scratch, kernels, count);
        return;
    }
    team.run([&](int worker) {
        Stages stages(state, team, worker, team.size(), step);
        runSubSteps(stages, state, scratch, kernels, count);
    });
}

void finishBodies(WorldState& state, WorkerTeam& team) {
    team.share(state.awake.size(), kLeastBodies, [&](IndexRange range, int) {
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const std::uint32_t number = state.awake[i];
            Body& body = state.bodies[number];
            BodyPlace& place = state.places[number];
            BodyMotion& motion = state.motions[number];
            place.travel += length(motion.moved) + 2.0f * length(motion.turned.vector()) * place.reach;
            // Summed up with what rounding left out, so that free flight keeps to its line for minutes.
            const Vec3f moved = motion.moved + body.centreRest, centre = place.centre + moved;
            body.centreRest = moved - (centre - place.centre);
            place.centre = centre;
            takeTurn(state, number);
            motion.moved = Vec3f(0.0f);
            motion.turned = {};
        }
    });
}

}  // namespace rubble
