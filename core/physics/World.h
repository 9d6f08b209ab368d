#pragma once

#include "core/base/Hash.h"
#include "core/geometry/TriangleMesh.h"
#include "core/physics/Body.h"
#include "core/physics/ContactSeeds.h"
#include "core/physics/Lanes.h"
#include "core/physics/StepResults.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

/// What holds for all bodies of a world, and how it is computed. Results do not depend on threads or lanes.
struct WorldSettings {
    Vec3 gravity{0.0, -9.81, 0.0};  // m/s^2
    bool sleeping = true;           // bodies at rest are left out until something touches them
    int threads = 1;
    LaneWidth lanes = widestLanes();
};

/// What a ray or a hull meets first on a straight way.
struct CastHit {
    BodyId body;
    Vec3 point;             // where they touch; the middle of it where edges or faces do
    Vec3 normal;            // of the body outwards, length 1
    double fraction = 0.0;  // of the way
};

/// An impulse on a body.
struct BlastPush {
    BodyId body;
    Vec3 point;    // of the world
    Vec3 impulse;  // N s
};

struct Snapshot;
struct WorldState;

/// Rigid bodies in motion. A step is collide(), which finds who touches whom and how hard they are about to hit, then
/// solve(), which moves everything; between the two, bodies may be taken out and put in.
///
/// Positions are kept as float, relative to nothing: within 100 m of the origin they are good to 4 micrometres.
/// Sources: Catto 2024, "Solver2D" (soft steps); Gregorius 2013 (separating axes of hulls); Tonge 2012 (colouring).
class World {
public:
    explicit World(const WorldSettings& settings = {});
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    /// Errors: BadInput for a pose or velocity that is not finite, a rotation that is not of length 1, a density, friction,
    /// restitution or damping outside its range, naming what.
    Result<BodyId> addBody(const BodyDefinition& definition);
    /// Takes a body out; what lay on it wakes.
    void removeBody(BodyId body);
    bool contains(BodyId body) const;
    std::size_t bodyCount() const;
    /// All bodies in order of their indices.
    std::vector<BodyId> bodies() const;

    BodyState state(BodyId body) const;
    BodyKind kind(BodyId body) const;
    const Shape& shape(BodyId body) const;
    std::uint64_t tag(BodyId body) const;
    double mass(BodyId body) const;  // kg; 0 where static or kinematic
    double restitution(BodyId body) const;

    Vec3 gravity() const;  // m/s^2
    void setGravity(Vec3 gravity);
    /// Makes a body of something else, at once; its velocities stay.
    void setMaterial(BodyId body, const BodyMaterial& material);
    void setVelocity(BodyId body, Vec3 velocity, Vec3 angularVelocity);
    /// Puts a body elsewhere, at once.
    void setPose(BodyId body, const Pose& pose);
    void wake(BodyId body);
    /// An impulse in N s at a point of the world; wakes the body.
    void applyImpulse(BodyId body, Vec3 impulse, Vec3 point);
    /// What a blast does to every body within `radius`, those that never move, too: it pushes it away from a point by `impulse`
    /// N s/m^2 at 1 m on the area that the body turns to it, falling with the square of the distance.
    std::vector<BlastPush> blast(Vec3 point, double radius, double impulse) const;
    /// Gives dynamic bodies these pushes.
    void explode(Vec3 point, double radius, double impulse);
    /// Draws a point of a body to a place as a critically damped spring of at most `force` N does, until let go.
    void grab(BodyId body, Vec3 point, double force);
    void dragTo(Vec3 point);
    void letGo();

    /// Finds contacts and the impacts of the step about to be solved. Called again after bodies were exchanged, it looks at
    /// the newcomers only.
    void collide(double dt);
    /// Says that two bodies touch, as pieces of one broken body do, so that collide() need not search for it; nor look how, where
    /// that is known by the seeds of their shapes. To be called between collide() and solve(), and collide() after it.
    void expectContact(BodyId first, BodyId second, std::span<const ContactSeed> seeds = {});
    /// Those of the step about to be solved, as collide() left it, in order of bodies.
    std::vector<Impact> impacts();
    /// Moves all bodies by dt seconds.
    void solve(double dt);
    /// Both, with nothing in between.
    void step(double dt);

    const StepEvents& events() const;
    StepCounts counts() const;
    const StepTimes& times() const;
    /// Every contact point that pushes or is about to, for drawing; of bodies asleep as they fell asleep.
    std::vector<ContactPoint> contactPoints() const;
    /// The box that is kept around a body to find what comes near it: larger than it by how far it may go. For drawing.
    Box3 box(BodyId body) const;
    /// Which bodies hang together by contacts, for drawing: by index of body the least index of its island; 0 for what is
    /// not dynamic. Bodies asleep hang together with those that they fell asleep with.
    std::vector<std::uint32_t> islands() const;

    /// A ray that begins inside a hull does not meet it; of bodies met at once it is the one with the lowest index.
    std::optional<CastHit> castRay(Vec3 from, Vec3 to) const;
    /// The same of a convex polytope that goes along `way` from `pose` without turning. What it touches or overlaps at the
    /// start it meets there, along the axis along which they overlap least.
    ///
    /// Errors: those of makeHull(); BadInput for a pose or a way that is not finite, a rotation that is not of length 1, or
    /// places farther than kFarthest from the origin.
    Result<std::optional<CastHit>> castHull(const Polytope& polytope, const Pose& pose, Vec3 way) const;
    /// The bodies whose hulls overlap a convex polytope, in order of their indices.
    ///
    /// Errors: those of makeHull(); BadInput for a pose as above.
    Result<std::vector<BodyId>> overlapping(const Polytope& polytope, const Pose& pose) const;

    /// Everything that the next step depends on.
    std::shared_ptr<const Snapshot> snapshot() const;
    void restore(const Snapshot& snapshot);
    /// Over pose, velocities and sleep of every body, by index: equal bits give equal hashes.
    ContentHash hash() const;
    /// Kinetic and potential energy of the dynamic bodies, J; and their momenta about the origin.
    Momenta momenta() const;

private:
    struct Workshop;  // threads and memory that are used again; nothing of it outlasts a step

    std::unique_ptr<WorldState> m_state;
    std::unique_ptr<Workshop> m_workshop;
};

}  // namespace rubble
