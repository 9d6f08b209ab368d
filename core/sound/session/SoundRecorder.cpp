#include "core/sound/session/SoundRecorder.h"

#include "core/geometry/search/Box3.h"

#include <algorithm>
#include <iterator>

namespace rubble {
namespace {

constexpr double kMinEnergy = 1.0;    // J: breaks without a blow are heard, too
constexpr double kMinMass = 1e-3;     // kg
constexpr double kNearestView = 3.0;  // m

/// What a material of the project sounds like; stone for the ground, metal for projectiles that are no asset.
SoundMaterial soundMaterialOf(const Session& session, Id id, std::uint32_t body) {
    if (id == 0) return session.scene().project.ground.isOn && body == 0 ? SoundMaterial::Stone : SoundMaterial::Metal;
    const Material& material = *findMaterial(session.scene().project, id);
    return closestSoundMaterial(material.density, material.youngsModulus);
}

/// The mass of a body, kg; 0 if it is fixed, or gone since.
double massOf(const Session& session, std::uint32_t number) {
    const PlayBody* const body = session.body(number);
    return body != nullptr ? session.world().mass(body->body) : 0.0;
}

/// The lighter body rings most; what is fixed does not.
SoundCue impactCue(const Session& session, const EventRecord& impact) {
    const double mass = massOf(session, impact.body), otherMass = massOf(session, impact.other);
    const SoundMaterial material = soundMaterialOf(session, impact.materials[0], impact.body),
                        other = soundMaterialOf(session, impact.materials[1], impact.other);
    const bool isOwn = otherMass == 0.0 || (mass > 0.0 && mass <= otherMass);
    return {.kind = CueKind::Impact,
            .first = isOwn ? material : other,
            .second = isOwn ? other : material,
            .energy = impact.energy,
            .mass = std::max(isOwn ? mass : otherMass, kMinMass),
            .point = impact.point};
}

SoundCue breakCue(const Session& session, const EventRecord& broken) {
    const SoundMaterial material = soundMaterialOf(session, broken.materials[0], broken.body);
    return {.kind = CueKind::Broken,
            .first = material,
            .second = material,
            .energy = std::max(broken.energy, kMinEnergy),
            .mass = std::max(broken.mass, kMinMass),
            .point = broken.point};
}

}  // namespace

std::vector<SoundCue> cuesOf(const Session& session) {
    std::vector<SoundCue> cues;
    for (const EventRecord& record : session.events().report.records) {
        const bool isImpact = record.kind == EventKind::Impact;
        if (!isImpact && record.kind != EventKind::Bonds && record.kind != EventKind::Broken) continue;
        cues.push_back(isImpact ? impactCue(session, record) : breakCue(session, record));
        cues.back().time = static_cast<double>(session.stepsDone()) * session.stepLength();
    }
    return cues;
}

Listener frontListener(const Session& session) {
    Box3 around;
    for (const PlayBody& body : session.bodies()) {
        if (body.role != PlayRole::Ground) around.include(session.world().box(body.body));
    }
    if (around.isEmpty()) return {};
    return {.position = around.centre() + Vec3(0.0, 0.0, std::max(kNearestView, around.diagonal()))};
}

void SoundRecorder::add(const Session& session) {
    m_seconds = static_cast<double>(session.stepsDone()) * session.stepLength();
    std::ranges::copy(cuesOf(session), std::back_inserter(m_cues));
}

}  // namespace rubble
