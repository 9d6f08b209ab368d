#include "core/sound/session/SoundRecorder.h"

#include "core/geometry/search/Box3.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rubble {
namespace {

constexpr double kLeastEnergy = 1.0;  // J
constexpr double kParted = 0.1;       // s: bodies that touch again sooner have not parted
constexpr double kNearestView = 3.0;  // m

Listener listenerOf(const Session& session) {
    Box3 around;
    for (const PlayBody& body : session.bodies()) {
        if (body.role != PlayRole::Ground) around.include(session.world().box(body.body));
    }
    if (around.isEmpty()) return {};
    return {.position = around.centre() + Vec3(0.0, 0.0, std::max(kNearestView, around.diagonal()))};
}

/// The material of an asset; stone for the ground, metal for projectiles that are no asset.
SoundMaterial materialOf(const Session& session, const PlayBody& body) {
    if (body.asset == nullptr) return body.role == PlayRole::Ground ? SoundMaterial::Stone : SoundMaterial::Metal;
    const Project& project = session.scene().project;
    const Material* material = findMaterial(project, findAsset(project, body.asset->bake->asset)->material);
    return closestSoundMaterial(material->density, material->youngsModulus);
}

/// The body of an event; null if it is gone since.
const PlayBody* bodyOf(const Session& session, BodyId body) {
    if (!session.world().contains(body)) return nullptr;
    return session.body(static_cast<std::uint32_t>(session.world().tag(body)));
}

double timeOf(const Session& session) { return static_cast<double>(session.stepsDone()) * session.stepLength(); }

}  // namespace

SoundRecorder::SoundRecorder(const Session& session) : m_listener(listenerOf(session)) {}

void SoundRecorder::add(const Session& session) {
    m_seconds = timeOf(session);
    for (const HitEvent& hit : session.world().events().hits) addImpact(session, hit);
    for (const PlayBreak& broken : session.events().breaks) addBreak(session, broken);
}

void SoundRecorder::addImpact(const Session& session, const HitEvent& hit) {
    const PlayBody *first = bodyOf(session, hit.first), *second = bodyOf(session, hit.second);
    if (first == nullptr || second == nullptr) return;
    // An impulse that stops an approach takes half its product with the speed.
    const double energy = 0.5 * hit.impulse * hit.approachSpeed;
    if (energy < kLeastEnergy) return;
    const std::uint64_t step = session.stepsDone();
    const auto [last, isNew] = m_lastHits.try_emplace({first->number, second->number}, step);
    const bool isAgain = !isNew && static_cast<double>(step - last->second) * session.stepLength() < kParted;
    last->second = step;
    if (isAgain) return;
    const double firstMass = session.world().mass(hit.first), secondMass = session.world().mass(hit.second);
    // The lighter body rings most; what is fixed has the mass 0 here, and does not.
    const bool isFirst = secondMass == 0.0 || (firstMass > 0.0 && firstMass <= secondMass);
    m_cues.push_back({.time = m_seconds,
                      .kind = CueKind::Impact,
                      .first = materialOf(session, isFirst ? *first : *second),
                      .second = materialOf(session, isFirst ? *second : *first),
                      .energy = energy,
                      .mass = std::max(isFirst ? firstMass : secondMass, 1e-3),
                      .point = hit.point});
}

void SoundRecorder::addBreak(const Session& session, const PlayBreak& broken) {
    const SoundMaterial material = materialOf(session, broken.body);
    const double mass =
        propertiesOf(material).density * broken.body.asset->solid(broken.body.fragment).shape->mass.volume;
    const double energy = std::max(kLeastEnergy, broken.impact * broken.impact / (2.0 * mass));
    m_cues.push_back({.time = m_seconds,
                      .kind = CueKind::Broken,
                      .first = material,
                      .second = material,
                      .energy = energy,
                      .mass = mass,
                      .point = broken.point});
}

}  // namespace rubble
