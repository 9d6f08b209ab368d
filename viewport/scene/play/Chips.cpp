#include "viewport/scene/play/Chips.h"

#include "core/base/math/Power.h"
#include "core/base/math/Trigonometry.h"
#include "viewport/scene/play/ChipMotion.h"
#include "viewport/scene/play/DebrisMaterial.h"
#include "viewport/scene/play/ParticleEmitters.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kMinChipEnergy = 4.0;         // J, of an impact: a brick that falls 0.2 m chips nothing off
constexpr double kUnknownDensity = 1000.0;     // kg/m³, of a body without a material
constexpr double kFractalDimension = 2.5;      // of sizes, as of rock that was crushed or blasted
constexpr double kDropping = 0.65;             // of the chips of a break: they drop to its foot, others are flung away
constexpr std::uint64_t kChipStream = 0xdeb8;  // of random numbers

/// The chips of a kind of material.
struct ChipStyle {
    ChipShape shape = ChipShape::Angular;
    double ofArea = 0.0;    // 1/m², of what broke
    double ofEnergy = 0.0;  // at 1 J, as its cube root
    double ofImpact = 0.0;  // the same of impacts
    double most = 0.0;      // of an event
    double least = 0.0;     // m: the smallest radius
};

ChipStyle chipStyleOf(DebrisKind kind) {
    switch (kind) {
        case DebrisKind::Mineral: return {ChipShape::Angular, 35.0, 5.0, 1.2, 130.0, 0.007};
        case DebrisKind::Powder: return {ChipShape::Angular, 18.0, 3.0, 0.8, 80.0, 0.0045};
        case DebrisKind::Glass: return {ChipShape::Flat, 45.0, 8.0, 1.5, 140.0, 0.006};
        case DebrisKind::Ice: return {ChipShape::Angular, 30.0, 6.0, 1.2, 110.0, 0.007};
        case DebrisKind::Metal: return {ChipShape::Angular, 2.0, 0.5, 0.0, 8.0, 0.005};
        case DebrisKind::Wood: return {ChipShape::Long, 12.0, 3.0, 0.4, 50.0, 0.014};
    }
    return {};
}

/// The chips of one material of an event.
struct ChipGroup {
    const EventRecord* event = nullptr;
    DebrisMaterial material;
    int count = 0;
    std::uint64_t side = 0;  // of an impact: which body
    bool isImpact = false;
};

void addBreak(const Project& project, const EventRecord& broken, std::vector<ChipGroup>& groups) {
    const std::optional<DebrisMaterial> fresh = debrisMaterialOf(project, broken.materials[1], false);
    if (!fresh) return;
    const ChipStyle style = chipStyleOf(fresh->kind);
    const double ofArea = std::min(style.ofArea * std::max(broken.area, 0.0), style.most);
    const double ofEnergy = scaledByEnergy(broken.energy, style.ofEnergy, 0.0, style.most);
    const int count = static_cast<int>(std::min(ofArea + ofEnergy, style.most));
    if (count > 0) groups.push_back({&broken, *fresh, count});
}

void addImpact(const Project& project, const EventRecord& impact, std::vector<ChipGroup>& groups) {
    if (impact.energy < kMinChipEnergy) return;
    const bool isOnGround = project.ground.isOn && impact.other == 0;
    for (std::uint64_t side = 0; side < impact.materials.size(); ++side) {
        const auto material = debrisMaterialOf(project, impact.materials[side], side == 1 && isOnGround);
        if (!material) continue;
        const ChipStyle style = chipStyleOf(material->kind);
        const int count = static_cast<int>(scaledByEnergy(impact.energy, style.ofImpact, 0.0, 0.2 * style.most));
        if (count > 0) groups.push_back({&impact, *material, count, side, true});
    }
}

/// Those of the events that are shown, the latest first.
std::vector<ChipGroup> groupsOf(const Project& project, std::span<const EventRecord> events, const DustMoment& moment) {
    const auto shown = static_cast<std::uint64_t>(kDebrisTime / moment.stepLength);
    std::vector<ChipGroup> groups;
    for (auto event = events.rbegin(); event != events.rend(); ++event) {
        if (event->step > moment.step) continue;
        if (event->step + shown <= moment.step) break;
        if (event->kind == EventKind::Bonds || event->kind == EventKind::Broken) addBreak(project, *event, groups);
        if (event->kind == EventKind::Impact) addImpact(project, *event, groups);
    }
    return groups;
}

/// The colour of a chip: most show the inside, some the surface that was outside.
glm::vec3 colourOf(const DebrisMaterial& material, Random& random) {
    const double pale = material.kind == DebrisKind::Ice ? 0.5 : 0.0, shade = random.between(0.82, 1.08);
    const bool isOutside = material.kind == DebrisKind::Glass || random.unit() < 0.25;
    return glm::min(paleColour(isOutside ? material.outside : material.inside, pale) * static_cast<float>(shade),
                    glm::vec3(1.0f));
}

Vec3 velocityOf(const EventRecord& event, const EmittedStart& start, bool isImpact, Random& random) {
    const Vec3 aside(random.between(-0.3, 0.3), random.between(0.0, 0.4), random.between(-0.3, 0.3));
    if (!isImpact && random.unit() < kDropping) return 0.3 * start.velocity + aside;
    const double strength = scaledByEnergy(event.energy, 0.22, 0.6, 2.5) * random.between(0.5, 1.3);
    return strength * start.velocity + 2.0 * aside;
}

/// Larger bodies make larger chips: a factor for a body of a size, m.
double sizeFactor(double size) { return 0.6 + 1.1 * size; }

/// The radius of the k-th largest of `count` chips: as many are larger than a radius as its power of minus the fractal
/// dimension says.
double radiusOf(const ChipStyle& style, double size, int k, int count) {
    return style.least * size * power(static_cast<double>(count) / (k + 1.0), 1.0 / kFractalDimension);
}

void addGroup(RenderScene& scene, const Project& project, const ChipGroup& group, double part, double age,
              const ParticleWorld& world) {
    const EventRecord& event = *group.event;
    const Material* body = findMaterial(project, event.materials[0]);
    const BreakEmitter broken(event, body != nullptr ? body->density : kUnknownDensity);
    const ImpactEmitter impact(event);
    const ParticleEmitter& emitter = group.isImpact ? static_cast<const ParticleEmitter&>(impact) : broken;
    const ChipStyle style = chipStyleOf(group.material.kind);
    const double size = group.isImpact ? 1.0 : sizeFactor(broken.size());
    Random random = randomOf(event, kChipStream + 16 * group.side);
    for (int k = 0; k < group.count && (k + random.unit()) / group.count < part; ++k) {
        const EmittedStart emitted = emitter.next(random);
        const Vec3 velocity = velocityOf(event, emitted, group.isImpact, random);
        const double radius = radiusOf(style, size, k, group.count), turn = random.between(0.0, kFullTurn);
        const ChipStart start{.shape = style.shape,
                              .from = emitted.from,
                              .velocity = velocity,
                              .radius = radius,
                              .lifetime = random.between(0.6, 1.0) * kDebrisTime,
                              .axis = {cosine(turn), 0.0, sine(turn)},
                              .spin = random.between(-20.0, 20.0),
                              .seed = random.unit(),
                              .colour = colourOf(group.material, random)};
        if (age < start.lifetime && scene.chips.size() < kMaxChips) scene.chips.push_back(chipAt(start, age, world));
    }
}

}  // namespace

void addDebris(RenderScene& scene, const Project& project, std::span<const EventRecord> events,
               const DustMoment& moment) {
    const std::vector<ChipGroup> groups = groupsOf(project, events, moment);
    std::size_t wanted = 0;
    for (const ChipGroup& group : groups) wanted += static_cast<std::size_t>(group.count);
    const double part = wanted > 0 ? static_cast<double>(kMaxChips) / static_cast<double>(wanted) : 1.0;
    const ParticleWorld world = particleWorldOf(scene, moment);
    for (const ChipGroup& group : groups) {
        addGroup(scene, project, group, part, moment.ageOf(group.event->step), world);
    }
}

}  // namespace rubble
