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
constexpr float kPushOutSpeed = 3.0f;      // m/s
constexpr float kRestitutionSpeed = 1.0f;  // m/s
constexpr std::size_t kLeastBlocks = 8;    // of a chunk: a microsecond's work
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

/// The passes of a step, over all contacts or bodies. The blocks of a list, and awake bodies, are shared between the workers.
class Passes {
public:
    Passes(WorldState& state, WorkerTeam& team, const SolverStep& step) : m_state(state), m_team(team), m_step(step) {}

    /// One colour after another.
    void overContacts(Pass pass) const {
        const std::span<ContactColours::List> lists = m_state.colours.lists();
        for (std::size_t i = 0; i < lists.size(); ++i) {
            const std::span<ContactBlock> blocks = lists[i].blocks;
            if (blocks.empty()) continue;
            const std::size_t chunks =
                i == ContactColours::kOneByOne ? 1 : m_team.chunksOf(blocks.size(), kLeastBlocks);
            m_team.share(blocks.size(), chunks, [&](IndexRange range, std::size_t) {
                pass(blocks.subspan(range.begin, range.size()), m_step);
            });
        }
    }
    void overBodies(void (*pass)(std::span<const std::uint32_t>, const SolverStep&),
                    std::span<const std::uint32_t> bodies) const {
        m_team.share(bodies.size(), m_team.chunksOf(bodies.size(), kLeastBodies),
                     [&](IndexRange range, std::size_t) { pass(bodies.subspan(range.begin, range.size()), m_step); });
    }
    void turnSpinners(std::span<const std::uint32_t> spinners) const {
        const std::size_t chunks = m_team.chunksOf(spinners.size(), kLeastBodies);
        m_team.share(spinners.size(), chunks, [&](IndexRange range, std::size_t) {
            for (std::size_t i = range.begin; i < range.end; ++i) {
                BodyMotion& motion = m_state.motions[spinners[i]];
                motion.turned = turnedBySpin(m_state, spinners[i], m_step.subStep);
                motion.moved += motion.velocity * m_step.subStep;
            }
        });
    }

private:
    WorldState& m_state;
    WorkerTeam& m_team;
    const SolverStep& m_step;
};

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
    for (ContactColours::List& list : state.colours.lists()) {
        const std::size_t count = list.blocks.size();
        if (count == 0) continue;
        team.share(count, team.chunksOf(count, kLeastBlocks), [&](IndexRange range, std::size_t) {
            kernels.prepare(std::span(list.blocks).subspan(range.begin, range.size()),
                            std::span<const ReferenceBlock>(list.references).subspan(range.begin, range.size()), step);
        });
    }
}

void solveSubSteps(WorldState& state, WorkerTeam& team, SolveScratch& scratch, const SolverKernels& kernels,
                   const SolverStep& step) {
    scratch.spinners.clear();
    scratch.others.clear();
    for (std::uint32_t body : state.awake) {
        (isSpinner(state, body, step.dt) ? scratch.spinners : scratch.others).push_back(body);
    }
    const Passes passes(state, team, step);
    for (int i = subStepsOf(step.dt); i > 0; --i) {
        passes.overBodies(kernels.integrateVelocities, state.awake);
        if (state.grabbed.index != 0) pullGrabbed(state, step);
        passes.overContacts(kernels.warmStart);
        passes.overContacts(kernels.solve);
        passes.overBodies(kernels.integratePositions, scratch.others);
        passes.turnSpinners(scratch.spinners);
        passes.overContacts(kernels.relax);
    }
    passes.overContacts(kernels.restitute);
}

void finishBodies(WorldState& state, WorkerTeam& team) {
    const std::size_t chunks = team.chunksOf(state.awake.size(), kLeastBodies);
    team.share(state.awake.size(), chunks, [&](IndexRange range, std::size_t) {
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
