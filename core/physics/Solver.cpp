#include "core/physics/Solver.h"

#include "core/physics/ImpactSpeeds.h"
#include "core/physics/Sleeping.h"
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
constexpr float kPushOutSpeed = 3.0f;  // m/s

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

/// Takes the body's place over from its motion.
void finishBody(WorldState& state, std::uint32_t number) {
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

/// Goes through stages, each worker in its regions.
class Stages {
public:
    Stages(WorldState& state, WorkerTeam& team, const Regions& regions, const SolverKernels& kernels,
           const SolverStep& step, SolveScratch& scratch)
        : m_state(state), m_team(team), m_regions(regions), m_kernels(kernels), m_step(step), m_scratch(scratch) {
        m_scratch.spinners.resize(m_regions.count());
        m_scratch.others.resize(m_regions.count());
        m_regions.forEach(team, [&](std::size_t region) { listSpinners(region); });
        planSubStep();
        m_scratch.restitution.clear();
        if (m_state.bouncyBodies > 0) planColours(m_scratch.restitution, kernels.restitute);
    }

    void run(const std::vector<SolveStage>& stages) const {
        m_team.shareStages(stages.size(), m_regions.count(),
                           [&](std::size_t stage, std::size_t region) { work(stages[stage], region); });
    }

private:
    void listSpinners(std::size_t region) const {
        m_scratch.spinners[region].clear();
        m_scratch.others[region].clear();
        for (std::uint32_t body : m_regions.bodies(region)) {
            (isSpinner(m_state, body, m_step.dt) ? m_scratch.spinners : m_scratch.others)[region].push_back(body);
        }
    }
    void planSubStep() {
        std::vector<SolveStage>& stages = m_scratch.subStep;
        stages.clear();
        stages.push_back({.over = SolveStage::Over::Velocities});
        if (m_state.grabbed.index != 0) stages.push_back({.over = SolveStage::Over::Grabbed});
        planColours(stages, m_kernels.warmStart);
        planColours(stages, m_kernels.solve);
        stages.push_back({.over = SolveStage::Over::Positions});
        planColours(stages, m_kernels.relax);
    }
    /// One colour after another, in both of its lists at once.
    void planColours(std::vector<SolveStage>& stages, Pass pass) const {
        const std::span<const ContactColours::List> lists = m_state.colours.lists();
        for (std::uint32_t list = 0; list < ContactColours::kLists; list += 2) {
            const bool hasMany = lists[list].count > 0, hasNext = list + 1 < lists.size() && lists[list + 1].count > 0;
            if (hasMany || hasNext) stages.push_back({.pass = pass, .list = list});
        }
    }

    void work(const SolveStage& stage, std::size_t region) const {
        switch (stage.over) {
            case SolveStage::Over::Contacts: return passContacts(stage, region);
            case SolveStage::Over::Velocities: return m_kernels.integrateVelocities(m_regions.bodies(region), m_step);
            case SolveStage::Over::Positions: return moveBodies(region);
            case SolveStage::Over::Grabbed:
                if (region == 0) pullGrabbed(m_state, m_step);
        }
    }
    void passContacts(const SolveStage& stage, std::size_t region) const {
        const std::span<ContactColours::List> lists = m_state.colours.lists();
        if (stage.list == ContactColours::kOneByOne) {
            if (region == 0) stage.pass(lists[stage.list].blocks, m_step);
            return;
        }
        for (std::uint32_t list : {stage.list, stage.list + 1}) {
            const std::span blocks = m_regions.part(list, std::span(lists[list].blocks), region);
            m_regions.inTheirOrder(blocks.size(), region, [&](IndexRange range) {
                stage.pass(blocks.subspan(range.begin, range.size()), m_step);
            });
        }
    }
    void moveBodies(std::size_t region) const {
        m_kernels.integratePositions(m_scratch.others[region], m_step);
        for (std::uint32_t spinner : m_scratch.spinners[region]) {
            BodyMotion& motion = m_state.motions[spinner];
            motion.turned = turnedBySpin(m_state, spinner, m_step.subStep);
            motion.moved += motion.velocity * m_step.subStep;
        }
    }

    WorldState& m_state;
    WorkerTeam& m_team;
    const Regions& m_regions;
    const SolverKernels& m_kernels;
    const SolverStep& m_step;
    SolveScratch& m_scratch;
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

void prepareContacts(WorldState& state, WorkerTeam& team, const Regions& regions, const SolverKernels& kernels,
                     const SolverStep& step) {
    regions.forEach(team, [&](std::size_t region) {
        for (std::size_t number = 0; number < ContactColours::kLists; ++number) {
            ContactColours::List& list = state.colours.lists()[number];
            const std::span blocks = regions.part(number, std::span(list.blocks), region);
            const std::span references = regions.part(number, std::span<const ReferenceBlock>(list.references), region);
            regions.inTheirOrder(blocks.size(), region, [&](IndexRange range) {
                kernels.prepare(blocks.subspan(range.begin, range.size()),
                                references.subspan(range.begin, range.size()), step);
            });
        }
    });
}

void solveSubSteps(WorldState& state, WorkerTeam& team, const Regions& regions, SolveScratch& scratch,
                   const SolverKernels& kernels, const SolverStep& step) {
    const Stages stages(state, team, regions, kernels, step, scratch);
    for (int i = subStepsOf(step.dt); i > 0; --i) stages.run(scratch.subStep);
    stages.run(scratch.restitution);
}

void finishBodies(WorldState& state, WorkerTeam& team, const Regions& regions, float dt) {
    regions.forEach(team, [&](std::size_t region) {
        for (std::uint32_t number : regions.bodies(region)) {
            finishBody(state, number);
            noteRest(state, number, dt);
        }
    });
}

}  // namespace rubble
