#include "core/physics/step/Solver.h"

#include "core/base/Assert.h"
#include "core/physics/islands/Rest.h"
#include "core/physics/solver/SpeedThresholds.h"
#include "core/physics/state/AngularMomentum.h"
#include "core/physics/step/Displacement.h"
#include "core/physics/step/WarmStart.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr int kMinSubSteps = 4;                       // per step, enough for 1/60 s
constexpr float kMaxSubStep = 1.0f / 240.0f + 1e-6f;  // s
// Soft contacts: springs that resolve overlaps. With softer ones stacks sink, a house at 30 Hz by 8 mm; the largest
// stable frequency is a quarter of the sub-step rate.
constexpr float kContactHertz = 50.0f;
constexpr float kDampingRatio = 2.0f;
constexpr float kPushOutSpeed = 3.0f;  // m/s

/// The coefficients β, α and γ of a spring by its frequency and damping ratio; SoftContactKernels.h has them.
/// Source: Catto 2011, "Soft constraints".
Softness softness(float hertz, float dampingRatio, float h) {
    const float omega = 2.0f * 3.14159265f * hertz;
    const float a1 = 2.0f * dampingRatio + h * omega, a2 = h * omega * a1, a3 = 1.0f / (1.0f + a2);
    return {omega / a1, a2 * a3, a3};
}

int subStepsOf(float dt) { return std::max(kMinSubSteps, static_cast<int>(std::ceil(dt / kMaxSubStep))); }

using Pass = void (*)(std::span<ContactBlock>, const SolverStep&);

/// The spring of World::grab(), of limited force: v' = ω (ω d / 2 - v) at the distance d, a damping ratio of 1/√2.
void pullGrabbed(WorldState& state, const SolverStep& step) {
    const std::uint32_t number = state.grabbed.index;
    if (number == 0 || !state.bodies[number].isDynamic()) return;
    BodyMotion& motion = state.motions[number];
    const BodyPose& pose = state.poses[number];
    const Vec3f arm = (motion.deltaRotation * pose.rotation).matrix() * state.grabPoint;
    const Vec3f at = pose.centre + motion.deltaPosition + arm;
    const Vec3f speed = motion.velocity + cross(motion.angularVelocity, arm);
    constexpr float kGrabHertz = 5.0f;
    const float omega = 2.0f * 3.14159265f * kGrabHertz;
    const Vec3f targetVelocity = (state.grabTarget - at) * (0.5f * omega);
    // The effective mass at the point along the change of velocity.
    const Vec3f change = targetVelocity - speed;
    const float size = length(change);
    if (size < 1e-6f) return;
    const Vec3f direction = change * (1.0f / size), turning = cross(arm, direction);
    const float mass = 1.0f / (motion.inverseMass + dot(turning, pose.inverseInertia * turning));
    const float impulse = std::min(mass * size * std::min(1.0f, omega * step.subStep), state.grabForce * step.subStep);
    state.grabWork += impulse * (dot(speed, direction) + 0.5f * impulse / mass);
    motion.velocity += direction * (impulse * motion.inverseMass);
    motion.angularVelocity += pose.inverseInertia * (turning * impulse);
}

/// What n sub-steps of h seconds lack of the parabola of a body that nothing touched, m. They move bodies by the
/// velocity at their end, which is too much by n g h² / 2 in all. Such a body, of velocity v at the end, has moved
/// by n h (v - (n - 1) g h / 2).
Vec3f parabolaCorrection(const WorldState& state, const BodyMotion& motion, int subSteps, float h) {
    constexpr float kTolerance = 0.02f;  // of the correction: less is no contact
    constexpr float kRounding = 1e-6f;   // of the displacement
    const auto n = static_cast<float>(subSteps);
    const Vec3f correction = state.gravity * (-0.5f * n * h * h);
    if (motion.inverseMass == 0.0f || motion.linearDamping != 0.0f) return Vec3f(0.0f);
    const Vec3f free = (motion.velocity - state.gravity * (0.5f * (n - 1.0f) * h)) * (n * h);
    const float most = kTolerance * kTolerance * lengthSquared(correction) +
                       kRounding * kRounding * lengthSquared(motion.deltaPosition);
    return lengthSquared(motion.deltaPosition - free) <= most ? correction : Vec3f(0.0f);
}

/// Applies the displacement of the step to the pose.
void finishBody(WorldState& state, std::uint32_t number, int subSteps, float h) {
    Body& body = state.bodies[number];
    BodyPose& pose = state.poses[number];
    BodyMotion& motion = state.motions[number];
    motion.deltaPosition += parabolaCorrection(state, motion, subSteps, h);
    const float arc = arcOf(state, number);
    pose.travel += length(motion.deltaPosition) + arc;
    pose.arc += arc;
    // Compensated summation: free flight stays on its parabola for minutes.
    const Vec3f moved = motion.deltaPosition + body.centreRemainder, centre = pose.centre + moved;
    body.centreRemainder = moved - (centre - pose.centre);
    pose.centre = centre;
    applyRotation(state, number, subSteps, h);
    motion.deltaPosition = Vec3f(0.0f);
    motion.deltaRotation = {};
}

/// Plans and runs the parallel stages of sub-steps, one region per thread.
class Stages {
public:
    Stages(WorldState& state, ThreadPool& threads, const Regions& regions, const SolverKernels& kernels,
           const SolverStep& step, SolveScratch& scratch, std::span<const StartMotion> starts)
        : m_state(state),
          m_threads(threads),
          m_regions(regions),
          m_kernels(kernels),
          m_step(step),
          m_scratch(scratch),
          m_starts(starts) {
        clearLists(m_scratch.fastRotating, m_regions.count());
        clearLists(m_scratch.slowRotating, m_regions.count());
        m_regions.forEach(threads, [&](std::size_t region) { classifyBodies(region); });
        planFirstSubStep();
        planSubStep();
        m_scratch.restitution.clear();
        if (m_state.bouncyBodies > 0) planColours(m_scratch.restitution, kernels.restitute);
    }

    void runFirstSubStep() const { run(m_scratch.firstSubStep); }
    void runSubStep() const { run(m_scratch.subStep); }
    void runRestitution() const { run(m_scratch.restitution); }

private:
    void run(const std::vector<SolveStage>& stages) const {
        m_threads.runStages(stages.size(), m_regions.count(),
                            [&](std::size_t stage, std::size_t region) { work(stages[stage], region); });
    }
    void classifyBodies(std::size_t region) const {
        for (std::uint32_t body : m_regions.bodies(region)) {
            const bool isFast = beginRotation(m_state, body, m_step.dt);
            (isFast ? m_scratch.fastRotating : m_scratch.slowRotating)[region].push_back(body);
        }
    }
    void planFirstSubStep() {
        clearLists(m_scratch.thrown, m_regions.count());
        std::vector<SolveStage>& stages = m_scratch.firstSubStep;
        stages.clear();
        planWarmStart(stages);
        if (m_state.colours.contactCount() > 0) {
            stages.push_back({.over = SolveStage::Over::Thrown});
            stages.push_back({.over = SolveStage::Over::Unbalanced});
        }
        planSolution(stages);
    }
    void planSubStep() {
        m_scratch.subStep.clear();
        planWarmStart(m_scratch.subStep);
        planSolution(m_scratch.subStep);
    }
    void planWarmStart(std::vector<SolveStage>& stages) const {
        stages.push_back({.over = SolveStage::Over::Velocities});
        if (!m_scratch.scaled.empty()) stages.push_back({.over = SolveStage::Over::Scaled});
        if (m_state.grabbed.index != 0) stages.push_back({.over = SolveStage::Over::Grabbed});
        planColours(stages, m_kernels.warmStart);
    }
    void planSolution(std::vector<SolveStage>& stages) const {
        planColours(stages, m_kernels.solve);
        stages.push_back({.over = SolveStage::Over::Positions});
        planColours(stages, m_kernels.relax);
    }
    /// Adds a stage per colour that has contacts, for both of its lists.
    void planColours(std::vector<SolveStage>& stages, Pass pass) const {
        const std::span<const ContactColours::List> lists = m_state.colours.lists();
        for (std::uint32_t list = 0; list < ContactColours::kLists; list += 2) {
            const bool hasFirst = lists[list].count > 0,
                       hasSecond = list + 1 < lists.size() && lists[list + 1].count > 0;
            if (hasFirst || hasSecond) stages.push_back({.pass = pass, .list = list});
        }
    }

    void work(const SolveStage& stage, std::size_t region) const {
        switch (stage.over) {
            case SolveStage::Over::Contacts: return passContacts(stage, region);
            case SolveStage::Over::Velocities: return m_kernels.integrateVelocities(m_regions.bodies(region), m_step);
            case SolveStage::Over::Positions: return moveBodies(region);
            case SolveStage::Over::Scaled:
                if (region == 0) correctGravity(m_state, m_scratch.scaled, m_step);
                return;
            case SolveStage::Over::Grabbed:
                if (region == 0) pullGrabbed(m_state, m_step);
                return;
            case SolveStage::Over::Thrown: return findThrown(region);
            case SolveStage::Over::Unbalanced:
                if (region == 0) dropUnbalancedImpulses(m_state, mergeSorted(m_scratch.thrown), m_starts, m_step);
        }
    }
    void passContacts(const SolveStage& stage, std::size_t region) const {
        const std::span<ContactColours::List> lists = m_state.colours.lists();
        if (stage.list == ContactColours::kOverflow) {
            if (region == 0) stage.pass(lists[stage.list].blocks, m_step);
            return;
        }
        for (std::uint32_t list : {stage.list, stage.list + 1}) {
            const std::span blocks = m_regions.part(list, std::span(lists[list].blocks), region);
            m_regions.forEachBlockRange(blocks.size(), region, [&](IndexRange range) {
                stage.pass(blocks.subspan(range.begin, range.size()), m_step);
            });
        }
    }
    void findThrown(std::size_t region) const {
        for (const std::uint32_t body : m_regions.bodies(region)) {
            if (isThrown(m_state, body, m_starts[body], m_step)) m_scratch.thrown[region].push_back(body);
        }
    }
    void moveBodies(std::size_t region) const {
        m_kernels.integratePositions(m_scratch.slowRotating[region], m_step);
        for (std::uint32_t body : m_scratch.fastRotating[region]) {
            rotateFreely(m_state, body, m_step.subStep);
            m_state.motions[body].deltaPosition += m_state.motions[body].velocity * m_step.subStep;
        }
    }

    WorldState& m_state;
    ThreadPool& m_threads;
    const Regions& m_regions;
    const SolverKernels& m_kernels;
    const SolverStep& m_step;
    SolveScratch& m_scratch;
    std::span<const StartMotion> m_starts;
};

}  // namespace

SolverStep solverStep(WorldState& state, float dt) {
    RUBBLE_ASSERT(dt > 0.0f);
    const float h = dt / static_cast<float>(subStepsOf(dt));
    const float hertz = std::min(kContactHertz, 0.25f / h);
    return {state.motions.data(),
            state.poses.data(),
            dt,
            h,
            state.gravity,
            softness(hertz, kDampingRatio, h),
            softness(2.0f * hertz, kDampingRatio, h),
            kPushOutSpeed,
            kMinRestitutionSpeed};
}

void prepareContacts(WorldState& state, ThreadPool& threads, const Regions& regions, SolveScratch& scratch,
                     const SolverKernels& kernels, const SolverStep& step) {
    clearLists(scratch.unequalBlocks, regions.count());
    clearLists(scratch.deepBlocks, regions.count());
    regions.forEach(threads, [&](std::size_t region) {
        for (std::size_t number = 0; number < ContactColours::kLists; ++number) {
            ContactColours::List& list = state.colours.lists()[number];
            const std::span blocks = regions.part(number, std::span(list.blocks), region);
            const std::span references = regions.part(number, std::span<const ReferenceBlock>(list.references), region);
            regions.forEachBlockRange(blocks.size(), region, [&](IndexRange range) {
                for (std::size_t i = range.begin; i < range.end; ++i) {
                    const BlockTraits traits = kernels.prepare(blocks.subspan(i, 1), references.subspan(i, 1), step);
                    if (traits.isUnequal) scratch.unequalBlocks[region].push_back(&blocks[i]);
                    if (traits.isDeep) scratch.deepBlocks[region].push_back(&blocks[i]);
                }
            });
        }
    });
}

void solveSubSteps(WorldState& state, ThreadPool& threads, const Regions& regions, SolveScratch& scratch,
                   const SolverKernels& kernels, const SolverStep& step, std::span<const StartMotion> starts) {
    state.grabWork = 0.0;
    const Stages stages(state, threads, regions, kernels, step, scratch, starts);
    stages.runFirstSubStep();
    for (int i = subStepsOf(step.dt); i > 1; --i) stages.runSubStep();
    stages.runRestitution();
}

void limitSpins(WorldState& state, ThreadPool& threads, const Regions& regions) {
    regions.forEach(threads, [&](std::size_t region) {
        for (const std::uint32_t number : regions.bodies(region)) {
            Vec3f& spin = state.motions[number].angularVelocity;
            const float squared = lengthSquared(spin);
            const bool isFast = squared > kMaxSpin * kMaxSpin && state.bodies[number].firstContact != kNone;
            if (isFast && state.bodies[number].isDynamic()) spin *= kMaxSpin / std::sqrt(squared);
        }
    });
}

void finishBodies(WorldState& state, ThreadPool& threads, const Regions& regions, float dt) {
    const int subSteps = subStepsOf(dt);
    const float h = dt / static_cast<float>(subSteps);
    regions.forEach(threads, [&](std::size_t region) {
        for (std::uint32_t number : regions.bodies(region)) {
            const StepMovement movement = movementOf(state.motions[number]);
            finishBody(state, number, subSteps, h);
            updateRestTime(state, number, movement, dt);
        }
    });
}

}  // namespace rubble
