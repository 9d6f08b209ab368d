#include "core/play/analysis/SwapAudit.h"

#include "core/asset/bake/FractureResult.h"
#include "core/asset/project/AssetShape.h"
#include "core/asset/project/Ids.h"
#include "core/base/Assert.h"
#include "core/base/MessageText.h"
#include "core/geometry/hull/InsetHull.h"
#include "core/physics/queries/Penetration.h"
#include "core/play/session/Session.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble {
namespace {

constexpr double kLeverFactor =
    3.0;                            // momenta lost with the gap, relative to its part of the mass: far parts carry more
constexpr int kSettlingSteps = 60;  // before the swap on the ground
const Quat kFlat{0.5 * std::sqrt(2.0), -0.5 * std::sqrt(2.0), 0.0, 0.0};  // z up

/// A project with one instance of an asset and no forces.
Project isolated(const Project& project, Id asset) {
    Project scene;
    scene.materials = project.materials;
    scene.assets = {*findAsset(project, asset)};
    scene.nextId = project.nextId;
    const Id instance = allocateId(scene);
    scene.instances = {{.id = instance, .name = "audited", .asset = asset}};
    scene.gravity = Vec3(0.0);
    scene.ground.isOn = false;
    return scene;
}

/// A bonded asset as if all of its bonds broke at once.
std::shared_ptr<const PlayAsset> breakingWhole(const PlayAsset& asset) {
    auto whole = std::make_shared<PlayAsset>(asset);
    whole->isBonded = false;
    for (PlaySolid& fragment : whole->fragments) fragment.neverBreaks = false;
    return whole;
}

Result<Session> started(const Project& project, const std::shared_ptr<const PlayAsset>& asset) {
    auto scene = std::make_shared<PlayScene>();
    scene->project = project;
    scene->assets[{asset->bake->asset}] = asset->isBonded ? breakingWhole(*asset) : asset;
    return Session::start(std::move(scene), {.sleeping = false, .hasDestruction = false, .checksEnergy = false});
}

/// Breaks all breakable bodies; false if there are none.
bool breakAll(Session& session) {
    bool isAny = false;
    for (const PlayBody& body : session.bodies()) {
        if (body.fracture() == nullptr) continue;
        const Status added = session.add(BreakInput{body.number});
        RUBBLE_ASSERT(added.hasValue());
        isAny = true;
    }
    return isAny;
}

void step(Session& session, int steps) {
    for (int k = 0; k < steps; ++k) session.step();
}

std::string idOf(const PlayBody& body) { return body.asset->bake->fragmentId(body.fragment); }

/// An upper bound of the speed of a body's corners.
double speedOf(const Session& session, const PlayBody& body) {
    const BodyState state = session.world().state(body.body);
    return glm::length(state.velocity) +
           glm::length(state.angularVelocity) * session.world().shape(body.body).boundingRadius;
}

void updateFastest(const Session& session, FragmentSpeed& fastest) {
    for (const PlayBody& body : session.bodies()) {
        if (body.role != PlayRole::Debris) continue;
        const double speed = speedOf(session, body);
        if (fastest.fragment.empty() || speed > fastest.speed) fastest = {idOf(body), placeOf(body), speed};
    }
}

void addWarning(SwapAudit& audit, DiagnosticCode code, const DiagnosticPlace& place, std::string message, double value,
                double limit) {
    audit.diagnostics.push_back(diagnostic(code, place, std::move(message), value, limit));
}

/// Measures the deepest overlap of two bodies, exactly; the diagnostic is about the first of them.
void measureOverlap(const Session& session, SwapAudit& audit) {
    std::vector<std::vector<Polytope>> hulls;
    std::vector<PosedHulls> placed;
    for (const PlayBody& body : session.bodies()) {
        hulls.push_back(hullsOf(body));
        placed.push_back({.pose = session.world().state(body.body).pose});
    }
    for (std::size_t k = 0; k < placed.size(); ++k) placed[k].hulls = hulls[k];
    DiagnosticPlace place;
    for (const BodyOverlap& overlap : overlapsOf(placed)) {
        if (overlap.depth <= audit.deepestOverlap) continue;
        audit.deepestOverlap = overlap.depth;
        place = placeOf(session.bodies()[overlap.first]);
    }
    if (audit.deepestOverlap <= kCleanOverlap) return;
    addWarning(audit, DiagnosticCode::OverlappingPieces, place,
               "Two fragments overlap by " + roundedText(1e3 * audit.deepestOverlap, 3) + " mm when the asset breaks.",
               audit.deepestOverlap, kCleanOverlap);
}

double massOf(const Session& session) {
    double mass = 0.0;
    for (const PlayBody& body : session.bodies()) mass += session.world().mass(body.body);
    return mass;
}

/// Measures the floating asset, level by level.
void measureResting(Session session, SwapAudit& audit) {
    for (int level = 0; breakAll(session); ++level) {
        session.step();
        if (level == 0) {
            const StepCounts counts = session.world().counts();
            audit.contacts = counts.contacts;
            audit.contactPoints = counts.contactPoints;
            measureOverlap(session, audit);
        }
        audit.fragments += static_cast<std::uint32_t>(session.events().born.size());
        step(session, kAuditSteps - 1);
        updateFastest(session, audit.resting);
        audit.restingEnergy = std::max(audit.restingEnergy, session.world().momenta().kinetic);
    }
}

/// The angle between two rotations, rad.
double angleBetween(Quat a, Quat b) {
    const Quat between = b * glm::conjugate(a);
    return 2.0 * std::asin(std::min(1.0, glm::length(Vec3(between.x, between.y, between.z))));
}

/// Measures the asset lying flat on the ground: how far fragments move, since what stands on its own rocks by microns.
void measureLying(Session session, SwapAudit& audit) {
    step(session, kSettlingSteps);
    breakAll(session);
    session.step();
    std::map<std::uint32_t, Pose> first;  // by number of the body
    for (const PlayBody& body : session.bodies()) first[body.number] = session.world().state(body.body).pose;
    step(session, kAuditSteps - 1);
    const double duration = (kAuditSteps - 1) * SessionSettings().dt;
    for (const PlayBody& body : session.bodies()) {
        if (body.role != PlayRole::Debris) continue;
        const Pose &from = first.at(body.number), to = session.world().state(body.body).pose;
        const double angle = angleBetween(from.orientation, to.orientation);
        const double path =
            glm::distance(from.position, to.position) + angle * session.world().shape(body.body).boundingRadius;
        if (audit.lying.fragment.empty() || path / duration > audit.lying.speed)
            audit.lying = {idOf(body), placeOf(body), path / duration};
    }
}

/// The speed, m/s, at which fragments of an asset move by their width in a step, 1 at most: faster ones sweep over so
/// many others that memory and time grow with the square of their number.
double flightSpeed(const PlayAsset& asset, double depth) {
    const double area = asset.bake->whole.volume / depth;
    const double width = std::sqrt(area / std::max(1.0, static_cast<double>(asset.bake->fragmentCount())));
    return std::min(1.0, width / SessionSettings().dt);
}

/// An off-centre hammer blow on the front, which makes the asset fly and rotate about all axes. `momentum` in N·s.
Hammer offCentreBlow(const PlayAsset& asset, double momentum) {
    const Shape& shape = *asset.whole.shape;
    const Hull& hull = *shape.hulls[0].hull;
    const Vec3f front(0.0f, 0.0f, 1.0f);
    const auto face = hull.face(hull.faceAlong(front));
    Vec3 middle(0.0);
    for (const std::uint16_t corner : face) middle += toDouble(hull.corner(corner)) / static_cast<double>(face.size());
    const Vec3 beside = middle + 0.7 * (toDouble(hull.corner(face[0])) - middle);
    return {.at = beside + shape.mass.centre, .impulse = momentum * Vec3(0.5, 0.3, -1.0)};
}

/// The simplified collision shapes of an asset: what else is reported about it violates no limit of a swap.
std::vector<Diagnostic> simplifiedShapesOf(const PlayAsset& asset) {
    std::vector<Diagnostic> simplified = asset.diagnostics;
    std::erase_if(simplified, [](const Diagnostic& one) { return one.code != DiagnosticCode::SimplifiedShape; });
    return simplified;
}

/// Advice for a fragment that is pushed.
std::string adviceOn(const PlayAsset& asset, const DiagnosticPlace& place) {
    const auto isAboutIt = [&](const Diagnostic& diagnostic) { return diagnostic.place.fragment == place.fragment; };
    const std::vector<Diagnostic> simplified = simplifiedShapesOf(asset);
    if (std::ranges::any_of(simplified, isAboutIt)) {
        return " Its collision shape is simplified: move its seed away from its neighbours', or delete it.";
    }
    if (!simplified.empty()) {
        return " Neighbours with simplified collision shapes may push it: move their seeds away from their "
               "neighbours', or delete them.";
    }
    return " Move its seed away from its neighbours', or delete it.";
}

void checkSpeed(const PlayAsset& asset, SwapAudit& audit, const std::string& when, const FragmentSpeed& fastest,
                double limit) {
    if (fastest.speed <= limit) return;
    addWarning(audit, DiagnosticCode::PushedPiece, fastest.place,
               "Fragment " + fastest.fragment + " moves at " + roundedText(1e3 * fastest.speed, 3) + " mm/s " + when +
                   "; at most " + messageText(1e3 * limit) + " mm/s is clean." + adviceOn(asset, fastest.place),
               fastest.speed, limit);
}

void checkDrift(const PlayAsset& asset, SwapAudit& audit, const std::string& what, double drift, double limit) {
    if (drift <= limit) return;
    addWarning(audit, DiagnosticCode::SwapDrift, {.asset = asset.bake->asset},
               "In flight the break " + what + " by " + roundedText(drift, 3) + " (relative); at most " +
                   messageText(limit) + " is clean.",
               drift, limit);
}

void checkLimits(const PlayAsset& asset, SwapAudit& audit) {
    const std::string steps = std::to_string(kAuditSteps) + " steps after the break";
    checkSpeed(asset, audit, steps + " without any force", audit.resting, kCleanSpeed);
    checkSpeed(asset, audit, "on average for " + steps + " lying flat on the ground", audit.lying, kCleanLyingSpeed);
    // The gap removes momenta along with mass; far from the centre that is more than its part of the mass.
    const double gap = audit.gapFraction;
    checkDrift(asset, audit, "changes the mass", audit.massDrift, kCleanDrift + gap);
    checkDrift(asset, audit, "changes the momentum", audit.momentumDrift, kCleanDrift + kLeverFactor * gap);
    checkDrift(asset, audit, "changes the angular momentum", audit.angularDrift, kCleanDrift + kLeverFactor * gap);
    checkDrift(asset, audit, "adds to the kinetic energy", audit.energyGain, kCleanDrift);
}

/// The part of the whole's volume that is removed by the gap between fragments; mortar is one.
double gapFractionOf(const Bake& bake) {
    const Fragments& fragments = bake.fractures[0].fragments;
    if (fragments.gap == 0.0) return 0.0;
    double volume = 0.0;
    for (std::uint32_t k = 0; k < fragments.count(); ++k) volume += fragments[k].volume();
    return 1.0 - volume / bake.whole.volume;
}

/// By how much the exported hulls of a fragment are inset, m: the least of them.
double insetOf(const Fragment& fragment) {
    double inset = kDefaultInset;
    for (const Polytope& hull : fragment.hulls()) inset = std::min(inset, kMaxInset * thinnestWidth(hull));
    return inset;
}

/// Measures how far the exported hulls of fragments that touch are apart: the gap between the fragments, and their
/// insets.
void measureExport(const Bake& bake, SwapAudit& audit) {
    for (const BakedFracture& fracture : bake.fractures) {
        std::vector<double> insets;
        for (std::uint32_t k = 0; k < fracture.fragments.count(); ++k) insets.push_back(insetOf(fracture.fragments[k]));
        for (std::uint32_t k = 0; k < fracture.fragments.count(); ++k) {
            for (const FragmentContact& contact : fracture.fragments[k].contacts()) {
                const double gap = fracture.fragments.gap + insets[k] + insets[contact.fragment];
                if (!audit.exported.fragment.empty() && gap >= audit.exported.gap) continue;
                const std::uint32_t thinner = insets[k] <= insets[contact.fragment] ? k : contact.fragment;
                const std::string id = bake.fragmentId(fracture.first + thinner);
                audit.exported = {
                    id, {.asset = bake.asset, .fragment = fracture.first + thinner, .path = pathOfId(id)}, gap};
            }
        }
    }
    if (audit.exported.fragment.empty() || audit.exported.gap >= kEngineGap) return;
    addWarning(audit, DiagnosticCode::CloseHulls, audit.exported.place,
               "Fragment " + audit.exported.fragment + " is so thin that its exported hulls are only " +
                   roundedText(1e6 * audit.exported.gap, 2) +
                   " µm from its neighbours': other engines push hulls apart "
                   "that are closer than " +
                   messageText(1e6 * kEngineGap) + " µm. Set a gap between the fragments, or make them thicker.",
               audit.exported.gap, kEngineGap);
}

double driftOf(Vec3 now, Vec3 before, double scale) { return glm::length(now - before) / scale; }

/// Measures the drift in the step of the swap in flight.
Status measureMoving(Session session, const PlayAsset& asset, SwapAudit& audit) {
    const double mass = massOf(session), depth = sizeOf(session.scene().project.assets[0]).z;
    const Hammer blow = offCentreBlow(asset, mass * flightSpeed(asset, depth));
    if (const Status added = session.add(ShotInput{"blow", blow}); !added) return added;
    step(session, 2);
    const Momenta before = session.world().momenta();
    if (!(before.kinetic > 0.0)) {
        return Error{ErrorCode::Degenerate,
                     "It left the world before it broke; move its outline nearer to its origin."};
    }
    breakAll(session);
    session.step();
    const Momenta after = session.world().momenta();
    audit.massDrift = std::abs(massOf(session) - mass) / mass;
    audit.momentumDrift = driftOf(after.linear, before.linear, glm::length(before.linear));
    audit.angularDrift = driftOf(after.angular, before.angular, glm::length(before.angular));
    audit.energyGain = (after.kinetic - before.kinetic) / before.kinetic;
    for (const PlayBody& body : session.bodies()) {  // one that is cut at the point of impact has other gaps
        if (body.fragment != kNone) audit.gapFraction = std::max(audit.gapFraction, gapFractionOf(*body.asset->bake));
    }
    return success();
}

}  // namespace

bool SwapAudit::isClean() const {
    return std::ranges::all_of(diagnostics,
                               [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::Note; });
}

Result<SwapAudit> swapAudit(const Project& project, const std::shared_ptr<const PlayAsset>& asset,
                            const TaskContext& task) {
    const Asset& authored = *findAsset(project, asset->bake->asset);
    if (asset->fractureOf(kNone) == nullptr) {
        return ofAsset(authored, {ErrorCode::NotFound, "It has no fragments, so there is no break to check."});
    }
    Project scene = isolated(project, authored.id);
    Result<Session> floating = started(scene, asset);
    if (!floating) return ofAsset(authored, floating.error());
    const std::shared_ptr<const SessionSnapshot> start = floating->snapshot();
    SwapAudit audit;
    audit.gapFraction = gapFractionOf(*asset->bake);
    audit.diagnostics = simplifiedShapesOf(*asset);
    Result<Session> moving = started(scene, asset);
    if (!moving) return ofAsset(authored, moving.error());
    if (const Status measured = measureMoving(std::move(*moving), *asset, audit); !measured) {
        return ofAsset(authored, measured.error());
    }
    if (audit.gapFraction > 0.0) {
        audit.diagnostics.push_back(diagnostic(DiagnosticCode::GapVolume, {.asset = authored.id},
                                               "The gap between fragments takes " +
                                                   roundedText(100.0 * audit.gapFraction, 3) +
                                                   " % of the mass and of its momenta.",
                                               audit.gapFraction));
    }
    if (task.isCancelled()) return TaskContext::cancelled();
    measureExport(*asset->bake, audit);
    measureResting(std::move(*floating), audit);
    if (task.isCancelled()) return TaskContext::cancelled();
    if (authored.mesh() == nullptr) {
        scene.gravity = {0.0, -9.81, 0.0};
        scene.ground.isOn = true;
        scene.instances[0].pose = {{0.0, -boundsOf(authored).min.z, 0.0}, kFlat};
        Result<Session> lying = started(scene, asset);
        if (!lying) return ofAsset(authored, lying.error());
        measureLying(std::move(*lying), audit);
    }
    checkLimits(*asset, audit);
    return audit;
}

Result<SwapAudit> swapAudit(const Project& project, const std::shared_ptr<const Bake>& bake, const TaskContext& task) {
    const Result<std::shared_ptr<const PlayAsset>> ready = playAsset(*findAsset(project, bake->asset), bake, task);
    if (!ready) return ready.error();
    return swapAudit(project, *ready, task);
}

}  // namespace rubble
