#include "viewport/scene/play/Dust.h"

#include "viewport/scene/play/DebrisMaterial.h"
#include "viewport/scene/play/ParticleEmitters.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr double kMaxDust = 400.0;                // of a scene: where there were more, each event makes fewer
constexpr std::size_t kMaxSparks = 600;           // of a scene, latest events first
constexpr Colour kHot{1.0, 0.78, 0.42};           // of sparks
constexpr double kMinDustEnergy = 4.0;            // J: a brick that falls 0.2 m makes no dust
constexpr double kSparkEnergy = 50.0;             // J
constexpr double kLingerEnergy = 60.0;            // J, of an impact
constexpr double kBodyDensity = 1000.0;           // kg/m³, of a body without a material
constexpr double kUnitArea = 3.0;                 // m², of a break: dust lingers in proportion to it,
constexpr double kMinPart = 0.3, kMaxPart = 2.5;  // within these limits
constexpr double kMaxLingering = 2.0;             // m: larger bodies raise no larger clouds
constexpr std::uint64_t kDustStream = 0xd057;     // of random numbers

/// The puffs of one kind of an event.
struct Puffs {
    int count = 0;
    double lifetime = 0.0;  // s
    double opacity = 0.0;
    double radius = 0.0;  // m, of the smallest
    bool isLingering = false;
};

/// The dust of a kind of material: what bursts out of a break, and what lingers near the ground.
struct DustStyle {
    Puffs burst, lingering;
    double pale = 0.3;  // of its colour
};

/// Of a break; radii are those of a body of 1 m.
DustStyle dustStyleOf(DebrisKind kind) {
    constexpr double kLong = 5.5;  // s
    switch (kind) {
        case DebrisKind::Mineral: return {{10, 0.8, 0.75, 0.12}, {5, kLong, 0.34, 0.2, true}, 0.55};
        case DebrisKind::Powder: return {{14, 0.9, 0.85, 0.13}, {7, kLong, 0.4, 0.22, true}, 0.6};
        case DebrisKind::Glass: return {{3, 0.3, 0.12, 0.13}, {}, 0.9};
        case DebrisKind::Ice: return {{5, 0.6, 0.3, 0.12}, {1, 2.5, 0.12, 0.2, true}, 0.7};
        case DebrisKind::Metal: return {{2, 0.3, 0.2, 0.13}, {}, 0.3};
        case DebrisKind::Wood: return {{3, 0.5, 0.25, 0.13}, {1, 3.0, 0.1, 0.2, true}, 0.3};
    }
    return {};
}

int countOf(double energy, double one, double least, double most) {
    return static_cast<int>(scaledByEnergy(energy, one, least, most));
}

/// Puffs of one material of an event.
struct PuffGroup {
    const EventRecord* event = nullptr;
    Puffs puffs;
    glm::vec3 colour{1.0f};
    bool isImpact = false;
    std::uint64_t stream = 0;  // tells groups of the event apart
};

/// What the events that are shown raise.
class DustEvents {
public:
    explicit DustEvents(const Project& project) : m_project(project) {}
    const std::vector<PuffGroup>& puffs() const { return m_puffs; }
    const std::vector<const EventRecord*>& sparks() const { return m_sparks; }

    void add(const EventRecord& event, double age) {
        if (event.kind == EventKind::Bonds || event.kind == EventKind::Broken) addBreak(event, age);
        if (event.kind == EventKind::Impact && event.energy >= kMinDustEnergy) addImpact(event, age);
    }

private:
    void addPuffs(const PuffGroup& group, double age) {
        constexpr double kOldest = 1.1;  // of the lifetime: see addGroup()
        if (group.puffs.count > 0 && age < kOldest * group.puffs.lifetime) m_puffs.push_back(group);
    }
    void addSparks(const EventRecord& event) {
        if (event.energy >= kSparkEnergy) m_sparks.push_back(&event);
    }

    void addBreak(const EventRecord& broken, double age) {
        const std::optional<DebrisMaterial> fresh = debrisMaterialOf(m_project, broken.materials[1], false);
        if (!fresh) return;
        DustStyle style = dustStyleOf(fresh->kind);
        const BreakEmitter emitter(broken, kBodyDensity);
        style.burst.radius *= emitter.size();
        style.lingering.radius *= std::min(emitter.extent(), kMaxLingering);
        const double part = std::clamp(broken.area / kUnitArea, kMinPart, kMaxPart);
        style.lingering.count = static_cast<int>(part * style.lingering.count + 0.5);
        const glm::vec3 colour = paleColour(fresh->inside, style.pale);
        addPuffs({&broken, style.burst, colour, false, 0}, age);
        addPuffs({&broken, style.lingering, colour, false, 1}, age);
        if (fresh->kind == DebrisKind::Metal) addSparks(broken);
    }

    void addImpact(const EventRecord& impact, double age) {
        const bool isOnGround = m_project.ground.isOn && impact.other == 0;
        const double energy = impact.energy, radius = scaledByEnergy(energy, 0.018, 0.03, 0.25);
        for (std::uint64_t side = 0; side < impact.materials.size(); ++side) {
            const auto material = debrisMaterialOf(m_project, impact.materials[side], side == 1 && isOnGround);
            if (!material) continue;
            if (material->kind == DebrisKind::Metal) addSparks(impact);
            if (material->kind != DebrisKind::Mineral && material->kind != DebrisKind::Powder) continue;
            const glm::vec3 colour = paleColour(material->inside, dustStyleOf(material->kind).pale);
            const double opacity = scaledByEnergy(energy, 0.1, 0.2, 0.7);
            addPuffs({&impact, {countOf(energy, 0.6, 1.0, 6.0), 0.6, opacity, radius}, colour, true, 2 * side}, age);
            if (energy < kLingerEnergy) continue;
            const Puffs lingering{countOf(energy, 0.15, 1.0, 3.0), 4.5, 0.4 * opacity, 1.4 * radius, true};
            addPuffs({&impact, lingering, colour, true, 2 * side + 1}, age);
        }
    }

    const Project& m_project;
    std::vector<PuffGroup> m_puffs;
    std::vector<const EventRecord*> m_sparks;
};

/// Adds the particles of events to a scene.
class DustWriter {
public:
    DustWriter(RenderScene& scene, const Project& project, const DustMoment& moment)
        : m_scene(scene), m_project(project), m_moment(moment), m_world(particleWorldOf(scene, moment)) {}

    /// `part`: of the puffs that are shown.
    void add(const PuffGroup& group, double part) {
        withEmitter(*group.event, group.isImpact, [&](const ParticleEmitter& emitter) {
            Random random = randomOf(*group.event, kDustStream + 16 * group.stream);
            const Puffs& puffs = group.puffs;
            for (int k = 0; k < puffs.count; ++k) {
                const bool isShown = random.unit() < part;
                const EmittedStart start = emitter.next(random);
                const ParticleStart particle{.kind = ParticleKind::Dust,
                                             .from = start.from,
                                             .velocity = start.velocity,
                                             .radius = puffs.radius * random.between(1.0, 2.0),
                                             .lifetime = puffs.lifetime * random.between(0.65, 1.1),
                                             .opacity = puffs.opacity,
                                             .colour = group.colour,
                                             .seed = random.unit(),
                                             .isLingering = puffs.isLingering};
                if (isShown) add(particle, group.event->step);
            }
        });
    }

    /// Adds sparks, and a flash where they come from.
    void addSparks(const EventRecord& event) {
        withEmitter(event, event.kind == EventKind::Impact, [&](const ParticleEmitter& emitter) {
            Random random = randomOf(event, kDustStream + 16 * 4);
            const glm::vec3 hot(kHot.red, kHot.green, kHot.blue);
            Vec3 flash(0.0);
            for (int k = 0, count = countOf(event.energy, 1.5, 6.0, 40.0); k < count; ++k) {
                const EmittedStart start = emitter.next(random);
                if (k == 0) flash = start.from;
                const ParticleStart spark{.kind = ParticleKind::Spark,
                                          .from = start.from,
                                          .velocity = random.between(1.5, 4.0) * start.velocity,
                                          .radius = random.between(0.004, 0.008),
                                          .lifetime = random.between(0.15, 0.4),
                                          .colour = hot};
                add(spark, event.step);
            }
            const ParticleStart glow{.kind = ParticleKind::Flash,
                                     .from = flash,
                                     .radius = scaledByEnergy(event.energy, 0.03, 0.08, 0.4),
                                     .lifetime = 0.07,
                                     .opacity = 0.8,
                                     .colour = hot};
            add(glow, event.step);
        });
    }

private:
    template <class Emit>
    void withEmitter(const EventRecord& event, bool isImpact, const Emit& emit) const {
        if (isImpact) return emit(ImpactEmitter(event));
        const Material* body = findMaterial(m_project, event.materials[0]);
        emit(BreakEmitter(event, body != nullptr ? body->density : kBodyDensity));
    }
    void add(const ParticleStart& start, std::uint64_t step) {
        const double age = m_moment.ageOf(step);
        if (age < start.lifetime) m_scene.particles.push_back(particleAt(start, age, m_world));
    }

    RenderScene& m_scene;
    const Project& m_project;
    DustMoment m_moment;
    ParticleWorld m_world;
};

}  // namespace

void addDust(RenderScene& scene, const Project& project, std::span<const EventRecord> events,
             const DustMoment& moment) {
    const auto shown = static_cast<std::uint64_t>(kDustTime / moment.stepLength);
    DustEvents raised(project);
    for (auto event = events.rbegin(); event != events.rend(); ++event) {
        if (event->step > moment.step) continue;
        if (event->step + shown <= moment.step) break;
        raised.add(*event, moment.ageOf(event->step));
    }
    double wanted = 0.0;
    for (const PuffGroup& group : raised.puffs()) wanted += group.puffs.count;
    DustWriter writer(scene, project, moment);
    for (const PuffGroup& group : raised.puffs()) writer.add(group, wanted > kMaxDust ? kMaxDust / wanted : 1.0);
    const std::size_t most = scene.particles.size() + kMaxSparks;
    for (const EventRecord* event : raised.sparks()) {
        if (scene.particles.size() < most) writer.addSparks(*event);
    }
}

}  // namespace rubble
