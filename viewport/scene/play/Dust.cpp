#include "viewport/scene/play/Dust.h"

#include "core/base/Random.h"
#include "core/base/math/Roots.h"
#include "core/base/math/Trigonometry.h"
#include "viewport/scene/play/DustParticles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr std::size_t kMaxParticles = 2000;  // per scene, latest events first: more would only overlap
constexpr double kMaxSize = 1.0;             // m: what breaks off a larger body makes no larger clouds
constexpr Colour kPale{0.90, 0.88, 0.85};    // most of any dust's colour
constexpr Colour kSoil{0.50, 0.46, 0.40};    // of the ground, which has no material
constexpr Colour kHot{1.0, 0.78, 0.42};      // of sparks
constexpr double kNoGround = 1e9;            // m, a depth below all
constexpr double kMinEnergy = 4.0;           // J: a brick that falls 0.2 m makes no dust
constexpr double kSparkEnergy = 50.0;        // J
constexpr double kTough = 5e6;               // Pa·√m: above, as metals are, materials tear and make hardly any dust
constexpr double kLightest = 800.0;          // kg/m³: below, as wood is, materials make no dust
constexpr double kMineralDensity = 1000.0;   // kg/m³
constexpr std::uint64_t kStream = 0xd057;    // of random numbers

enum class Debris { Mineral, Glass, Metal, Wood };

Debris debrisOf(const Material& material) {
    if (material.opacity < 1.0) return Debris::Glass;
    if (material.fractureToughness.value_or(0.0) > kTough) return Debris::Metal;
    return material.density < kLightest ? Debris::Wood : Debris::Mineral;
}

glm::vec3 mixed(const Colour& colour, double pale) {
    return glm::vec3(
        glm::mix(Vec3(colour.red, colour.green, colour.blue), Vec3(kPale.red, kPale.green, kPale.blue), pale));
}

/// What the particles of a material are, and their colours.
struct ParticleMaterial {
    Debris debris = Debris::Mineral;
    Colour inside, outside;
};

/// What a body consists of; nothing of a plain projectile, which stays whole.
std::optional<ParticleMaterial> particleMaterialOf(const Project& project, Id material, bool isGround) {
    if (const Material* found = findMaterial(project, material)) {
        return ParticleMaterial{debrisOf(*found), found->inside, found->outside};
    }
    if (isGround) return ParticleMaterial{Debris::Mineral, kSoil, kSoil};
    return std::nullopt;
}

Vec3 randomDirection(Random& random) {
    const double height = random.between(-1.0, 1.0), angle = random.between(0.0, kFullTurn);
    const double radius = std::sqrt(1.0 - height * height);
    return {radius * cosine(angle), height, radius * sine(angle)};
}

/// In proportion to the cube root of an energy, J: `one` at a joule.
double scaledByEnergy(double energy, double one, double least, double most) {
    constexpr double kLeast = 1e-9;  // J: the root is of positive numbers only
    return std::clamp(one * cubeRoot(std::max(energy, kLeast)), least, most);
}
int countOf(double energy, double one, double least, double most) {
    return static_cast<int>(scaledByEnergy(energy, one, least, most));
}

/// Where the particles of an event start, and how fast.
class Emitter {
public:
    virtual ~Emitter() = default;
    struct Start {
        Vec3 from;
        Vec3 velocity;
    };
    virtual Start next(Random& random) const = 0;
};

/// On the surface that was hit and on the opposite one, away from the point.
class BreakEmitter : public Emitter {
public:
    BreakEmitter(const EventRecord& broken, double density)
        : m_broken(broken), m_extent(broken.box.max - broken.box.min), m_size(sizeOf(m_extent)) {
        const Vec3 across = glm::abs(broken.normal);
        const double shown = across.x * m_extent.y * m_extent.z + across.y * m_extent.z * m_extent.x +
                             across.z * m_extent.x * m_extent.y;  // m²: the box, seen along the normal
        if (shown > 0.0) m_thickness = std::min(broken.mass / density / shown, glm::dot(across, m_extent));
    }
    double size() const { return m_size; }

    Start next(Random& random) const override {
        const Vec3 place = m_broken.box.min + Vec3(random.unit(), random.unit(), random.unit()) * m_extent;
        Vec3 from = glm::mix(m_broken.point, place, random.unit());  // denser near the point
        const bool isOpposite = random.unit() < 0.5;
        const bool isHit = m_broken.normal != Vec3(0.0);
        Vec3 out = isHit ? m_broken.normal : randomDirection(random);
        if (!isOpposite) out = -out;
        if (isHit) {
            from -= glm::dot(from - m_broken.point, m_broken.normal) * m_broken.normal;
            if (isOpposite) from += m_thickness * m_broken.normal;
        }
        const Vec3 arm = from - m_broken.point;
        const Vec3 away = glm::dot(arm, arm) > 1e-12 ? glm::normalize(arm) : out;
        const Vec3 up(0.0, random.between(0.1, 0.7), 0.0);
        return {from, m_size * (random.between(0.2, 1.2) * away + random.between(0.2, 1.2) * out + up)};
    }

private:
    static double sizeOf(Vec3 extent) { return std::min(std::max({extent.x, extent.y, extent.z}), kMaxSize); }

    const EventRecord& m_broken;
    Vec3 m_extent;
    double m_size;
    double m_thickness = 0.0;  // m, of the body along the normal
};

/// At the point, to all sides along the surface.
class ImpactEmitter : public Emitter {
public:
    explicit ImpactEmitter(const EventRecord& impact)
        : m_impact(impact), m_speed(scaledByEnergy(impact.energy, 0.3, 0.3, 3.0)) {}

    Start next(Random& random) const override {
        const Vec3 direction = randomDirection(random);
        const Vec3 along = direction - glm::dot(direction, m_impact.normal) * m_impact.normal;
        const Vec3 up(0.0, random.between(0.0, 0.3), 0.0);
        return {m_impact.point, m_speed * (random.between(0.3, 1.0) * along + 0.3 * direction + up)};
    }

private:
    const EventRecord& m_impact;
    double m_speed;  // m/s
};

/// Adds the particles of events to a scene.
class DustWriter {
public:
    DustWriter(RenderScene& scene, const Project& project, const DustMoment& moment)
        : m_scene(scene), m_project(project), m_moment(moment) {
        m_world = {.gravity = moment.gravity,
                   .ground = scene.hasGround ? scene.groundHeight : -kNoGround,
                   .origin = scene.origin,
                   .stepLength = moment.stepLength};
    }

    bool isFull() const { return m_scene.particles.size() >= kMaxParticles; }

    void add(const EventRecord& event) {
        m_age = m_moment.stepLength * static_cast<double>(m_moment.step + 1 - event.step);
        Random random(mixSeeds(mixSeeds(kStream + static_cast<std::uint64_t>(event.kind), event.step),
                               mixSeeds(event.body, event.other)));
        if (event.kind == EventKind::Bonds || event.kind == EventKind::Broken) addBreak(event, random);
        if (event.kind == EventKind::Impact && event.energy >= kMinEnergy) addImpact(event, random);
    }

private:
    void addBreak(const EventRecord& broken, Random& random) {
        const Material* body = findMaterial(m_project, broken.materials[0]);
        const std::optional<ParticleMaterial> fresh = particleMaterialOf(m_project, broken.materials[1], false);
        if (!fresh) return;
        const BreakEmitter emitter(broken, body != nullptr ? body->density : kMineralDensity);
        const double size = emitter.size(), energy = broken.energy;
        switch (fresh->debris) {
            case Debris::Mineral:
                addDust({14, 0.6, 0.85, 0.13 * size, mixed(fresh->inside, 0.3)}, emitter, random);
                addChips({ParticleKind::Chip, countOf(energy, 1.0, 4.0, 30.0), 0.012, 0.04, mixed(fresh->inside, 0.0)},
                         emitter, random);
                break;
            case Debris::Glass:
                addDust({3, 0.3, 0.12, 0.13 * size, mixed(fresh->inside, 0.9)}, emitter, random);
                addChips(
                    {ParticleKind::Splinter, countOf(energy, 6.0, 60.0, 90.0), 0.007, 0.02, mixed(fresh->outside, 0.0)},
                    emitter, random);
                break;
            case Debris::Metal:
                addDust({3, 0.3, 0.2, 0.13 * size, mixed(fresh->inside, 0.3)}, emitter, random);
                addSparks(energy, emitter, random);
                break;
            case Debris::Wood:
                addDust({3, 0.4, 0.25, 0.13 * size, mixed(fresh->inside, 0.3)}, emitter, random);
                addChips(
                    {ParticleKind::Splinter, countOf(energy, 1.5, 12.0, 40.0), 0.02, 0.06, mixed(fresh->inside, 0.0)},
                    emitter, random);
                break;
        }
    }

    void addImpact(const EventRecord& impact, Random& random) {
        const std::optional<ParticleMaterial> sides[] = {
            particleMaterialOf(m_project, impact.materials[0], false),
            particleMaterialOf(m_project, impact.materials[1], m_project.ground.isOn && impact.other == 0)};
        const ImpactEmitter emitter(impact);
        const double energy = impact.energy;
        for (const std::optional<ParticleMaterial>& side : sides) {
            if (!side) continue;
            switch (side->debris) {
                case Debris::Mineral:
                    addDust({countOf(energy, 0.6, 1.0, 6.0), 0.5, scaledByEnergy(energy, 0.1, 0.2, 0.7),
                             scaledByEnergy(energy, 0.018, 0.03, 0.25), mixed(side->inside, 0.3)},
                            emitter, random);
                    addChips(
                        {ParticleKind::Chip, countOf(energy, 0.5, 1.0, 12.0), 0.008, 0.022, mixed(side->inside, 0.0)},
                        emitter, random);
                    break;
                case Debris::Glass:
                    addChips({ParticleKind::Splinter, countOf(energy, 1.5, 3.0, 20.0), 0.005, 0.014,
                              mixed(side->outside, 0.0)},
                             emitter, random);
                    break;
                case Debris::Metal: addSparks(energy, emitter, random); break;
                case Debris::Wood:
                    addChips(
                        {ParticleKind::Splinter, countOf(energy, 0.4, 0.0, 8.0), 0.012, 0.03, mixed(side->inside, 0.0)},
                        emitter, random);
                    break;
            }
        }
    }

    struct DustStyle {
        int count;
        double lifetime;  // s
        double opacity;
        double radius;  // m, of the smallest
        glm::vec3 colour;
    };
    void addDust(const DustStyle& style, const Emitter& emitter, Random& random) {
        for (int k = 0; k < style.count; ++k) {
            const Emitter::Start start = emitter.next(random);
            add({.kind = ParticleKind::Dust,
                 .from = start.from,
                 .velocity = start.velocity,
                 .radius = style.radius * random.between(1.0, 2.0),
                 .lifetime = style.lifetime * random.between(0.65, 1.1),
                 .opacity = style.opacity,
                 .colour = style.colour,
                 .phase = random.unit()});
        }
    }

    struct ChipStyle {
        ParticleKind kind;
        int count;
        double least, most;  // m: radii
        glm::vec3 colour;
    };
    /// Chips or splinters.
    void addChips(const ChipStyle& style, const Emitter& emitter, Random& random) {
        for (int k = 0; k < style.count; ++k) {
            const Emitter::Start start = emitter.next(random);
            const Vec3 aside(random.between(-0.8, 0.8), random.between(0.0, 1.2), random.between(-0.8, 0.8));
            add({.kind = style.kind,
                 .from = start.from,
                 .velocity = start.velocity + aside,
                 .radius = random.between(style.least, style.most),
                 .lifetime = random.between(0.5, 0.9),
                 .colour = style.colour,
                 .phase = random.unit(),
                 .spin = random.between(-4.0, 4.0)});
        }
    }

    /// Sparks, and a flash where they come from.
    void addSparks(double energy, const Emitter& emitter, Random& random) {
        if (energy < kSparkEnergy) return;
        const glm::vec3 hot(kHot.red, kHot.green, kHot.blue);
        const int count = countOf(energy, 1.5, 6.0, 40.0);
        Vec3 flash(0.0);
        for (int k = 0; k < count; ++k) {
            const Emitter::Start start = emitter.next(random);
            if (k == 0) flash = start.from;
            add({.kind = ParticleKind::Spark,
                 .from = start.from,
                 .velocity = random.between(1.5, 4.0) * start.velocity,
                 .radius = random.between(0.005, 0.01),
                 .lifetime = random.between(0.15, 0.4),
                 .colour = hot});
        }
        add({.kind = ParticleKind::Flash,
             .from = flash,
             .radius = scaledByEnergy(energy, 0.03, 0.08, 0.4),
             .lifetime = 0.07,
             .opacity = 0.8,
             .colour = hot});
    }

    void add(const ParticleStart& start) {
        if (m_age < start.lifetime && !isFull()) m_scene.particles.push_back(particleAt(start, m_age, m_world));
    }

    RenderScene& m_scene;
    const Project& m_project;
    DustMoment m_moment;
    ParticleWorld m_world;
    double m_age = 0.0;  // s, of the event
};

}  // namespace

void addDust(RenderScene& scene, const Project& project, std::span<const EventRecord> events,
             const DustMoment& moment) {
    const auto shown = static_cast<std::uint64_t>(kDustTime / moment.stepLength);
    DustWriter writer(scene, project, moment);
    for (auto event = events.rbegin(); event != events.rend() && !writer.isFull(); ++event) {
        if (event->step > moment.step) continue;
        if (event->step + shown <= moment.step) break;
        writer.add(*event);
    }
}

}  // namespace rubble
