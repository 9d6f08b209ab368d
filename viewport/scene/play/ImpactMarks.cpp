#include "viewport/scene/play/ImpactMarks.h"

#include "viewport/scene/play/DebrisMaterial.h"
#include "viewport/scene/play/ParticleEmitters.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <iterator>

namespace rubble {
namespace {

constexpr double kMinMarkEnergy = 10.0;              // J, of an impact
constexpr double kMarkSize = 0.014;                  // m: the radius at 1 J, as its cube root
constexpr double kMinMark = 0.025, kMaxMark = 0.22;  // m
constexpr double kSootRadius = 0.75;                 // of a blast's radius
constexpr std::size_t kMaxSoot = 24;                 // bodies that one blast marks
constexpr std::size_t kMaxKept = 4096;               // marks of a session
constexpr std::uint64_t kMarkStream = 0x3a7c;        // of random numbers

/// A point in the frame of a body's asset, m.
Vec3 inAsset(const PlayBody& body, const Pose& pose, Vec3 point) {
    return glm::conjugate(pose.orientation) * (point - pose.position) + frameOf(body);
}

const PlayBody* bodyNumbered(const Session& session, std::uint32_t number) {
    const auto found = std::ranges::find(session.bodies(), number, &PlayBody::number);
    return found != session.bodies().end() && found->asset != nullptr ? &*found : nullptr;
}

/// Whether impacts chip a material: glass and ice shatter.
bool hasMarks(const Project& project, Id material) {
    const Material* found = findMaterial(project, material);
    return found != nullptr && found->opacity >= 1.0;
}

}  // namespace

/// Chipped where bodies were hit: on what broke, and on both bodies of an impact. A body that broke is gone: the pose
/// that it had is known.
void ImpactMarks::addImpact(const Session& session, const EventRecord& record, std::vector<Mark>& marks) {
    const bool isImpact = record.kind == EventKind::Impact;
    if (!isImpact && record.kind != EventKind::Bonds && record.kind != EventKind::Broken) return;
    if (record.normal == Vec3(0.0) || record.energy < kMinMarkEnergy) return;
    const double radius = scaledByEnergy(record.energy, kMarkSize, kMinMark, kMaxMark);
    const auto add = [&](const PlayBody& body, const Pose& pose, Vec3 outwards, std::uint64_t side) {
        Random random = randomOf(record, kMarkStream + 16 * side);
        marks.push_back({session.stepsDone(), body.origin, inAsset(body, pose, record.point),
                         glm::conjugate(pose.orientation) * outwards, radius, random.unit()});
    };
    const Project& project = session.scene().project;
    const std::uint32_t numbers[] = {record.body, isImpact ? record.other : kNone};
    for (std::uint64_t side = 0; side < 2; ++side) {
        if (numbers[side] == kNone || !hasMarks(project, record.materials[isImpact ? side : 0])) continue;
        const Vec3 outwards = side == 0 ? -record.normal : record.normal;
        const auto isBroken = [&](const PlayBreak& one) { return one.body.number == numbers[side]; };
        const auto broken = std::ranges::find_if(session.events().breaks, isBroken);
        if (broken != session.events().breaks.end()) {
            add(broken->body, broken->pose, outwards, side);
        } else if (const PlayBody* body = bodyNumbered(session, numbers[side])) {
            add(*body, session.world().state(body->body).pose, outwards, side);
        }
    }
}

/// On the bodies that are nearest to a blast, one mark for all that an asset has become.
void ImpactMarks::addSoot(const Session& session, const Blast& blast, std::vector<Mark>& marks) {
    const double radius = kSootRadius * blast.radius;
    std::vector<std::uint32_t> origins;
    for (const PlayBody& body : session.bodies()) {
        if (body.asset == nullptr || origins.size() == kMaxSoot) continue;
        const Box3 box = session.world().box(body.body);
        const Vec3 nearest = glm::clamp(blast.at, box.min, box.max);
        if (glm::distance(nearest, blast.at) > radius || std::ranges::find(origins, body.origin) != origins.end())
            continue;
        origins.push_back(body.origin);
        Random random(mixSeeds(mixSeeds(kMarkStream, session.stepsDone()), body.number));
        const Pose pose = session.world().state(body.body).pose;
        marks.push_back(
            {session.stepsDone(), body.origin, inAsset(body, pose, blast.at), Vec3(0.0), radius, random.unit()});
    }
}

std::vector<ImpactMarks::Mark> ImpactMarks::marksOf(const Session& session) {
    std::vector<Mark> marks;
    for (const TimedInput& input : session.events().inputs) {
        const auto* const shot = std::get_if<ShotInput>(&input.input);
        const auto* const blast = shot != nullptr ? std::get_if<Blast>(&shot->action) : nullptr;
        if (blast != nullptr) addSoot(session, *blast, marks);
    }
    for (const EventRecord& record : session.events().report.records) addImpact(session, record, marks);
    return marks;
}

std::span<const ImpactMarks::Mark> ImpactMarks::between(std::uint64_t first, std::uint64_t last) const {
    const auto begin = std::ranges::lower_bound(m_marks, first, {}, &Mark::step);
    const auto end = std::ranges::upper_bound(m_marks, last, {}, &Mark::step);
    if (begin >= end) return {};
    return {begin, end};
}

void ImpactMarks::record(const Session& session) {
    const std::uint64_t step = session.stepsDone();
    const std::vector<Mark> added = marksOf(session);
    const bool isKnown = step >= m_first && step <= m_last;
    if (isKnown && std::ranges::equal(added, between(step, step))) return;
    if (!isKnown && step != m_last + 1) {
        m_marks.clear();
        m_first = step;
    }
    std::erase_if(m_marks, [step](const Mark& one) { return one.step >= step; });
    m_marks.insert(m_marks.end(), added.begin(), added.end());
    m_last = step;
    if (m_marks.size() <= kMaxKept) return;
    m_first = m_marks[m_marks.size() - kMaxKept / 2].step + 1;
    std::erase_if(m_marks, [this](const Mark& one) { return one.step < m_first; });
}

void ImpactMarks::addTo(RenderScene& scene, const Session& session, const SceneBody& sceneBody,
                        const std::function<bool(const PlayBody&)>& isApart) const {
    std::span<const Mark> shown = between(0, session.stepsDone());
    if (shown.size() > kMaxMarks) shown = shown.last(kMaxMarks);
    if (shown.empty()) return;
    for (const PlayBody& body : session.bodies()) {
        const auto isIts = [&](const Mark& mark) { return mark.origin == body.origin; };
        if (body.asset == nullptr || std::ranges::none_of(shown, isIts)) continue;
        forEachSolid(body, isApart(body), [&](std::uint32_t fragment, Vec3) {
            const PlaySolid& solid = body.asset->solid(fragment);
            for (const Mark& mark : shown) {
                const Vec3 centre = mark.centre - solid.offset;
                const double apart = glm::distance(centre, Vec3(solid.shape->mass.centre));
                if (!isIts(mark) || apart > mark.radius + solid.shape->boundingRadius) continue;
                scene.surfaceMarks.push_back({glm::vec4(glm::vec3(centre), mark.radius),
                                              glm::vec4(glm::vec3(mark.normal), mark.seed), sceneBody(body, fragment)});
            }
        });
    }
    std::ranges::stable_sort(scene.surfaceMarks, {}, &SurfaceMark::body);
}

}  // namespace rubble
