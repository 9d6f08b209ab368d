#include "core/base/Assert.h"
#include "core/base/Stopwatch.h"
#include "core/play/CutAtImpact.h"
#include "core/play/Damage.h"
#include "core/play/SessionState.h"

#include <algorithm>

namespace rubble {
namespace {

/// The damage of a step to the bodies that can break, by number.
std::vector<std::pair<PlayBody, DamageDone>> damageToBreakables(const SessionParts& parts,
                                                                std::span<const Impact> impacts) {
    std::vector<std::pair<PlayBody, DamageDone>> damaged;
    for (const DamageDone& damage : damageOf(impacts, parts.world, parts.scene.project.damage.rule)) {
        const PlayBody* body = findBody(parts.state, static_cast<std::uint32_t>(parts.world.tag(damage.body)));
        RUBBLE_ASSERT(body != nullptr);
        if (body->breaking() != nullptr) damaged.emplace_back(*body, damage);
    }
    std::ranges::sort(damaged, {}, [](const auto& one) { return one.first.number; });
    return damaged;
}

PendingBreak breakBy(const SessionParts& parts, const PlayBody& body, const Impact& impact, double damage) {
    PendingBreak broken = pendingBreak(parts, body);
    const bool isFirst = impact.first == body.body;
    broken.told.impact = damage;
    broken.told.point = impact.point;
    broken.told.normal = isFirst ? -impact.normal : impact.normal;
    broken.told.striker = isFirst ? impact.second : impact.first;
    broken.restitution = impact.restitution;
    return broken;
}

/// The asset of which the whole is swapped for pieces: its own, or one cut where it is hit.
std::shared_ptr<const PlayAsset> assetToSwap(const SessionParts& parts, const PendingBreak& broken) {
    const PlayBody& body = broken.told.body;
    const Asset& asset = *findAsset(parts.scene.project, body.asset->bake->asset);
    if (!asset.cutAtImpact || body.fragment != kNone) return body.asset;
    const Vec3 local = glm::conjugate(broken.pose.orientation) * (broken.told.point - broken.pose.position);
    Result<std::shared_ptr<const PlayAsset>> cut = cutAtImpact(asset, Vec2(local), body.number);
    if (cut && (*cut)->breakingOf(kNone) != nullptr) return std::move(*cut);
    parts.state.events.notices.push_back(
        "It broke into the pieces of its pattern, since it cannot be cut where it is hit: " +
        (cut ? std::string("one piece would be left.") : cut.error().message));
    return body.asset;
}

/// A piece of the whole in its place; by the thesis's preset it moves as the whole did, else as that point of it did.
BodyDefinition pieceDefinition(const SessionParts& parts, const PendingBreak& broken, const PlayAsset& asset,
                               std::uint32_t fragment) {
    const PlayPiece& piece = asset.pieces[fragment];
    const Vec3 offset = piece.offset - asset.piece(broken.told.body.fragment).offset;
    const BodyMaterial material = bodyMaterial(parts, asset, fragment, PlayRole::Piece);
    BodyDefinition definition{
        .shape = piece.shape,
        .pose = {broken.pose.position + broken.pose.orientation * offset, broken.pose.orientation},
        .velocity = broken.mass.velocity,
        .angularVelocity = broken.mass.spin,
        .density = material.density,
        .friction = material.friction,
        .restitution = material.restitution};
    if (!parts.scene.project.damage.isThesis) {
        const Vec3 centre = definition.pose.position + broken.pose.orientation * piece.shape->mass.centre;
        definition.velocity = broken.mass.velocityAt(centre);
    }
    return definition;
}

/// Takes the whole out.
void removeWhole(const SessionParts& parts, PendingBreak& broken, Stopwatch& watch) {
    broken.told.asset = assetToSwap(parts, broken);
    broken.told.pose = broken.pose;
    takeOut(parts, broken.told.body.number);
    broken.told.milliseconds = watch.lap();
}

/// Puts the pieces in.
void addPieces(const SessionParts& parts, PendingBreak& broken, Stopwatch& watch) {
    PlayBreak& told = broken.told;
    const PlayBreaking& breaking = *told.asset->breakingOf(told.body.fragment);
    told.firstPiece = parts.state.nextNumber;
    told.pieces = breaking.count;
    for (std::uint32_t k = 0; k < breaking.count; ++k) {
        const std::uint32_t fragment = breaking.first + k;
        const Result<std::uint32_t> added =
            addBody(parts, pieceDefinition(parts, broken, *told.asset, fragment),
                    {.role = PlayRole::Piece, .origin = told.body.origin, .asset = told.asset, .fragment = fragment});
        RUBBLE_ASSERT(added.hasValue());
        parts.state.events.born.push_back(parts.state.bodies.back());
    }
    const PlayBody* pieces = &parts.state.bodies[parts.state.bodies.size() - breaking.count];
    const auto bodyOf = [&](std::uint32_t fragment) { return pieces[fragment - breaking.first].body; };
    for (const PlayNeighbours& pair : breaking.neighbours) {
        parts.world.expectContact(bodyOf(pair.first), bodyOf(pair.second), pair.seeds);
    }
    told.milliseconds += watch.lap();
    parts.state.events.breaks.push_back(told);
    parts.state.recentBreaks.push_back(told);
}

}  // namespace

PendingBreak pendingBreak(const SessionParts& parts, const PlayBody& body) {
    PendingBreak broken;
    broken.told = {
        .step = parts.state.step + 1, .body = body, .threshold = thresholdOf(parts.state, parts.scene, body)};
    broken.pose = parts.world.state(body.body).pose;
    const BodyMaterial material = bodyMaterial(parts, *body.asset, body.fragment, body.role);
    broken.mass = parts.world.kind(body.body) == BodyKind::Dynamic
                      ? movingMass(parts.world, body.body)
                      : restingMass(parts.world.shape(body.body), material.density, broken.pose);
    return broken;
}

void carryOut(const SessionParts& parts, std::vector<PendingBreak> breaks) {
    if (!parts.scene.project.damage.isThesis) payForBreaks(parts.world, breaks);
    Stopwatch watch;
    for (PendingBreak& broken : breaks) removeWhole(parts, broken, watch);
    forgetTakenOut(parts.state);
    watch.lap();
    for (PendingBreak& broken : breaks) addPieces(parts, broken, watch);
}

bool breakWhatIsHit(const SessionParts& parts) {
    const std::vector<Impact> impacts = parts.world.impacts();
    std::vector<PendingBreak> breaks;
    for (const auto& [body, damage] : damageToBreakables(parts, impacts)) {
        const double threshold = thresholdOf(parts.state, parts.scene, body);
        const Impact& impact = impacts[damage.impact];
        parts.state.events.impacts.push_back({body.number, damage.amount, threshold, impact.point});
        if (parts.state.hasDestruction && damage.amount >= threshold) {
            breaks.push_back(breakBy(parts, body, impact, damage.amount));
        }
    }
    if (breaks.empty()) return false;
    carryOut(parts, std::move(breaks));
    return true;
}

}  // namespace rubble
