#pragma once

#include "core/base/Hash.h"
#include "core/geometry/mesh/TriangleMesh.h"
#include "core/physics/math/Lanes.h"
#include "core/physics/narrowphase/ManifoldCache.h"
#include "core/physics/queries/SceneQueries.h"
#include "core/physics/state/BodyDefinition.h"
#include "core/physics/state/StepResults.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

/// Settings of a world. Results do not depend on the number of threads and the SIMD width.
struct WorldSettings {
    Vec3 gravity{0.0, -9.81, 0.0};  // m/s²
    bool sleeping = true;           // bodies at rest are not simulated until something touches them
    int threads = 1;
    SimdWidth lanes = widestSimd();
};

/// The spring of World::grab() that pulls a point of a body to a target.
struct GrabSpring {
    BodyId body;
    Vec3 point;          // of the body, in world space
    Vec3 target;         // in world space
    double force = 0.0;  // N, at most
};

/// The impulse of a blast on a body: the sum of those on its faces.
struct BlastImpulse {
    BodyId body;
    Vec3 point;    // in world space: the centre of pressure, in line with the blast
    Vec3 impulse;  // N·s
};

struct Snapshot;
struct SolverStep;
struct SplitPart;
struct WorldState;

/// A rigid body simulation. A step is collide(), which finds contacts and imminent impacts, then solve(), which moves
/// the bodies; bodies may be removed and added between the two.
///
/// Positions are floats relative to the origin, with a resolution of 8 micrometres within 100 m.
/// Sources: Catto 2024, "Solver2D" (soft steps); Gregorius 2013 (separating axes of hulls); Tonge 2012 (colouring).
class World {
public:
    /// The gravity must be within kMaxSpeed along each axis.
    explicit World(const WorldSettings& settings = {});
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    /// Errors: BadInput for a pose or velocity that is not finite, an orientation that is not of length 1, or a
    /// density, friction, restitution or damping out of range, or a mass beyond single precision.
    Result<BodyId> addBody(const BodyDefinition& definition);
    /// Removes a body and wakes those that touch it.
    void removeBody(BodyId body);
    /// Replaces a body by the parts that it falls apart into, where they were in it. The first keeps its id. A hull
    /// keeps its contacts, with their impulses, at the part that has it; contacts of hulls that no part has are
    /// removed. Parts of a static body may be static and stay in place: the first must then have the same centre of
    /// mass. Wakes what touches the body, unless it stays static and keeps the hull that is touched. Add the contacts
    /// of the parts with each other by addContact(), or collide() finds them. Returns their ids.
    ///
    /// Errors: BadInput as addBody(), with the number of the part; nothing changes then.
    Result<std::vector<BodyId>> split(BodyId body, std::span<const SplitPart> parts);
    bool contains(BodyId body) const;
    std::size_t bodyCount() const;
    /// All bodies by ascending index.
    std::vector<BodyId> bodies() const;
    /// Whether a body can be simulated on: its centre is within kMaxCoordinate of the origin along each axis, and its
    /// motion and orientation are finite. Remove others after each step.
    bool isWithinBounds(BodyId body) const;

    BodyState state(BodyId body) const;
    /// BodyState::centre alone.
    Vec3 centre(BodyId body) const;
    BodyKind kind(BodyId body) const;
    const Shape& shape(BodyId body) const;
    std::uint64_t tag(BodyId body) const;
    double mass(BodyId body) const;  // kg; 0 where static or kinematic
    double friction(BodyId body) const;
    double restitution(BodyId body) const;

    Vec3 gravity() const;  // m/s²

    // Nothing that is not finite or out of range gets into the world: the functions below return BadInput and change
    // nothing.

    /// Errors: BadInput for more than kMaxSpeed m/s² along an axis.
    Status setGravity(Vec3 gravity);
    /// Sets the material; velocities are kept.
    ///
    /// Errors: BadInput as addBody().
    Status setMaterial(BodyId body, const BodyMaterial& material);
    /// Errors: BadInput for more than kMaxSpeed along an axis.
    Status setVelocity(BodyId body, Vec3 velocity, Vec3 angularVelocity);
    /// Teleports a body.
    ///
    /// Errors: BadInput as addBody().
    Status setPose(BodyId body, const Pose& pose);
    void wake(BodyId body);
    /// Applies an impulse, N·s, at a point in world space; wakes the body. A body that would become faster than
    /// kMaxSpeed moves that fast.
    ///
    /// Errors: BadInput for more than kMaxImpulse or kMaxCoordinate along an axis.
    Status applyImpulse(BodyId body, Vec3 impulse, Vec3 point);
    /// Where a blast at a point goes off: there, unless the point is in a body or within a millimetre of it. Then it is
    /// 0.1 m off the nearest face of the body from which it is in no other body; of equally near faces, off the lowest.
    Vec3 blastOrigin(Vec3 point) const;
    /// The impulses of a blast on all bodies, including those that are not dynamic, by ascending body. On each small
    /// area dA of a face that is visible from `point`, at the distance d and under the angle θ to its normal, acts
    /// impulse · (1 - d / radius) · cos θ · dA away from `point`, in N·s; beyond the radius, none. So bodies cast
    /// shadows, faces between touching bodies get nothing, and fragments together get what the whole would get. A body
    /// that contains `point` gets nothing and casts no shadow: see blastOrigin().
    ///
    /// O(n log n) for n bodies within the radius of which each is shadowed by few others; see also kMaxVisibleParts.
    std::vector<BlastImpulse> blast(Vec3 point, double radius, double impulse) const;
    /// Applies the impulses of blast() from blastOrigin() to the dynamic bodies; none becomes faster than kMaxSpeed.
    ///
    /// Errors: BadInput for a point or radius beyond kMaxCoordinate, or an impulse beyond kMaxImpulse.
    Status explode(Vec3 point, double radius, double impulse);
    /// Pulls a point of a body to a target, as a damped spring of at most `force` N, until release().
    ///
    /// Errors: BadInput for a point beyond kMaxCoordinate or a force beyond kMaxImpulse; so dragTo().
    Status grab(BodyId body, Vec3 point, double force);
    Status dragTo(Vec3 point);
    void release();
    /// The spring of grab(); nothing if no body is grabbed or the body was removed.
    std::optional<GrabSpring> grabSpring() const;

    /// Finds the contacts of the coming step of dt > 0 seconds. Called again in a step, with the same dt, after bodies
    /// were added, removed and pushed, it considers only those.
    void collide(double dt);
    /// Begins the step anew, with a length of its own; the pairs stay if it has that length already. Manifolds of some
    /// bodies with what they do not touch are not recycled: the features that were closest then need not be the ones
    /// that meet.
    void recollide(double dt, std::span<const BodyId> bodies);
    /// Whether bodies were added, moved or pushed since the last collide().
    bool hasUncollided() const;
    /// Adds a contact of two bodies known to touch, such as sibling fragments, so that collide() need not find it, with
    /// the manifolds if these are cached. Call collide(), also if it was called in this step, between it and solve().
    void addContact(BodyId first, BodyId second, std::span<const CachedManifold> manifolds = {});
    /// Whether two bodies have a contact with a manifold, as of the last collide().
    bool areTouching(BodyId first, BodyId second) const;
    /// Finds the contacts of all bodies as they are, and puts the dynamic ones to sleep without moving them, if
    /// sleeping is on. Not between collide() and solve().
    void sleepInPlace(double dt);
    /// The impacts of the coming step, after collide(), sorted by bodies.
    std::vector<Impact> impacts();
    /// Those of some bodies, with any others.
    std::vector<Impact> impacts(std::span<const BodyId> bodies);
    /// Simulates dt seconds, after collide() with the same dt.
    void solve(double dt);
    /// Calls collide() and solve().
    void step(double dt);

    const StepEvents& events() const;
    StepCounts counts() const;
    const StepTimes& times() const;
    /// All contact points, ascending by bodies; those of sleeping bodies as of when they fell asleep.
    std::vector<ContactPoint> contactPoints() const;
    /// The fat bounding box of a body in the broad phase, for debug drawing.
    Box3 box(BodyId body) const;
    /// The islands, bodies connected by contacts, for debug drawing: for each body index the lowest body index of its
    /// island; 0 if not dynamic. Sleeping bodies are in the island that they fell asleep in.
    std::vector<std::uint32_t> islands() const;

    /// The first body that a ray hits; of several at the same distance, the one with the lowest index. Hulls that
    /// contain the start are not hit.
    std::optional<CastHit> castRay(Vec3 from, Vec3 to) const;
    /// The first body that a convex polytope hits when it moves by `displacement` from `pose` without rotating. Bodies
    /// that it touches or overlaps at the start are hit there, with the axis of least overlap as normal.
    ///
    /// Errors: those of makeHull(); BadInput for a pose or displacement that is not finite, an orientation that is not
    /// of length 1, or a position farther than kMaxCoordinate from the origin.
    Result<std::optional<CastHit>> castHull(const Polytope& polytope, const Pose& pose, Vec3 displacement) const;
    /// The bodies that overlap a convex polytope, by ascending index.
    ///
    /// Errors: those of makeHull(); BadInput for a pose as above.
    Result<std::vector<BodyId>> overlapping(const Polytope& polytope, const Pose& pose) const;

    /// The complete state: everything that the next step depends on.
    std::shared_ptr<const Snapshot> snapshot() const;
    void restore(const Snapshot& snapshot);
    /// The memory that a snapshot taken now needs, in bytes.
    std::size_t snapshotBytes() const;
    /// A hash of pose, velocities and sleep state of all bodies, by index.
    ContentHash hash() const;
    /// The energy of the dynamic bodies and their momenta about the origin.
    Momenta momenta() const;

private:
    struct StepContext;  // threads and memory reused from step to step; not part of the state
    enum class CollideBodies : std::uint8_t { All, Changed };
    void collide(double dt, CollideBodies paired, CollideBodies collided);
    /// Sets the hits and the energy that contacts took, after the sub-steps.
    void findContactEvents(const SolverStep& step, std::span<const std::array<std::uint32_t, 2>> clamped);

    std::unique_ptr<WorldState> m_state;
    std::unique_ptr<StepContext> m_context;
};

}  // namespace rubble
