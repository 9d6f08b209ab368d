#include "viewport/scene/Dust.h"

#include "core/base/Random.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr std::size_t kMaxPuffs = 1200;    // per scene, latest breaks first: more would only overlap
constexpr double kFadeIn = 0.04;           // s
constexpr double kDrag = 2.2;              // 1/s, air drag
constexpr double kMostSize = 1.0;          // m: what breaks off a larger body makes no larger clouds
constexpr Colour kPale{0.90, 0.88, 0.85};  // most of any dust's colour
constexpr double kNoGround = 1e9;          // m, a depth below all
constexpr double kTough = 5e6;             // Pa·√m: above, as metals are, materials tear and make hardly any dust

/// What a material makes when it breaks.
struct DebrisStyle {
    int puffs = 14;  // per break
    int splinters = 0;
    double lifetime = 0.6;  // s, of dust
    double opacity = 0.85;  // of dust, after the fade-in
    double pale = 0.3;      // part of kPale in the colour of its dust
};

/// Transparent materials, as glass and ice, splinter; tough ones tear; all others are ground to dust.
DebrisStyle styleOf(const Material& material) {
    if (material.opacity < 1.0) return {.puffs = 3, .splinters = 60, .lifetime = 0.3, .opacity = 0.12, .pale = 0.9};
    if (material.fractureToughness.value_or(0.0) > kTough) return {.puffs = 3, .lifetime = 0.3, .opacity = 0.2};
    return {};
}

constexpr std::uint64_t kStream = 0xd057;

/// A puff at its start.
struct Puff {
    Vec3 from;
    Vec3 velocity;
    double radius = 0.0;
    double lifetime = 0.0;  // s
    double opacity = 0.0;   // after the fade-in
    double seed = 0.0;      // of its noise

    Vec3 positionAt(double age) const { return from + velocity * (age / (1.0 + kDrag * age)); }
    double radiusAt(double age) const { return radius * (1.0 + 2.0 * age / (0.25 + age)); }
    double opacityAt(double age) const {
        const double left = 1.0 - age / lifetime;
        return opacity * std::min(1.0, age / kFadeIn) * left * left;
    }
};

/// A splinter at its start: it falls, and lies on the ground until it fades.
struct Splinter {
    Vec3 from;
    Vec3 velocity;
    double radius = 0.0;
    double lifetime = 0.0;  // s
    double turn = 0.0;      // its rotation, in turns
    double spin = 0.0;      // turns/s

    /// `gravity`: m/s²; `lowest`: the height at which it lies on the ground.
    Vec3 positionAt(double age, Vec3 gravity, double lowest) const {
        Vec3 position = from + velocity * (age / (1.0 + kDrag * age)) + 0.5 * age * age * gravity;
        position.y = std::max(position.y, lowest);
        return position;
    }
    double turnAt(double age) const {
        const double turned = turn + spin * age;
        return turned - std::floor(turned);
    }
    double opacityAt(double age) const { return std::min(1.0, 4.0 * (1.0 - age / lifetime)); }
};

/// A point of a random cut between two solids of a broken body, in the frame of its asset.
Vec3 cutAt(const PlayBreak& broken, const PlayFracture& fracture, Random& random) {
    if (fracture.neighbours.empty())
        return broken.asset->fragments[fracture.first + random.below(fracture.count)].offset;
    const PlayContact& parted = fracture.neighbours[random.below(fracture.neighbours.size())];
    return 0.5 * (broken.asset->fragments[parted.first].offset + broken.asset->fragments[parted.second].offset);
}

/// Twice the largest distance of its solids from its centre.
double sizeOf(const PlayBreak& broken, const PlayFracture& fracture, Vec3 centre) {
    double size = 0.0;
    for (std::uint32_t k = 0; k < fracture.count; ++k) {
        size = std::max(size, glm::distance(broken.asset->fragments[fracture.first + k].offset, centre));
    }
    return 2.0 * size;
}

/// Where a particle starts, and how fast: at a cut, where it meets the surface that was hit or the opposite one.
struct Start {
    Vec3 from;
    Vec3 velocity;      // m/s
    double size = 0.0;  // m, of the broken body
};

Start startOf(const PlayBreak& broken, const PlayFracture& fracture, Random& random) {
    const Vec3 centre = broken.asset->solid(broken.body.fragment).offset;
    const double size = std::min(sizeOf(broken, fracture, centre), kMostSize);
    const double deep = glm::dot(broken.point - broken.pose.position, broken.normal);  // the surface that was hit
    const Vec3 out = random.unit() < 0.5 ? -broken.normal : broken.normal;
    const Vec3 cut = broken.pose.orientation * (cutAt(broken, fracture, random) - centre);
    const Vec3 from = broken.pose.position + cut + std::abs(deep) * out;
    const Vec3 arm = from - broken.point;
    const Vec3 away = glm::dot(arm, arm) > 1e-12 ? glm::normalize(arm) : out;
    const Vec3 up(0.0, random.between(0.1, 0.7), 0.0);
    return {from, size * (random.between(0.2, 1.2) * away + random.between(0.2, 1.2) * out + up), size};
}

Puff puffOf(const Start& start, const DebrisStyle& style, Random& random) {
    return {.from = start.from,
            .velocity = start.velocity,
            .radius = start.size * random.between(0.13, 0.25),
            .lifetime = style.lifetime * random.between(0.65, 1.1),
            .opacity = style.opacity,
            .seed = random.unit()};
}

Splinter splinterOf(const Start& start, Random& random) {
    const Vec3 aside(random.between(-0.8, 0.8), random.between(0.0, 1.2), random.between(-0.8, 0.8));
    return {.from = start.from,
            .velocity = start.velocity + aside,
            .radius = random.between(0.007, 0.02),
            .lifetime = random.between(0.5, 0.9),
            .turn = random.unit(),
            .spin = random.between(-4.0, 4.0)};
}

glm::vec3 mixed(const Colour& colour, double pale) {
    return glm::vec3(
        glm::mix(Vec3(colour.red, colour.green, colour.blue), Vec3(kPale.red, kPale.green, kPale.blue), pale));
}

/// Adds the particles of breaks to a scene.
class DustWriter {
public:
    DustWriter(RenderScene& scene, const Session& session) : m_scene(scene), m_session(session) {}

    bool isFull() const { return m_scene.puffs.size() >= kMaxPuffs; }

    void add(const PlayBreak& broken) {
        const Project& project = m_session.scene().project;
        const Material material = materialsOf(project, *findAsset(project, broken.asset->bake->asset)).inside;
        const DebrisStyle style = styleOf(material);
        const PlayFracture& fracture = *broken.asset->fractureOf(broken.body.fragment);
        const double age = m_dt * static_cast<double>(m_session.stepsDone() + 1 - broken.step);
        Random random(mixSeeds(broken.body.number, kStream));
        for (int k = 0; k < style.puffs; ++k) {
            const Puff puff = puffOf(startOf(broken, fracture, random), style, random);
            if (age >= puff.lifetime) continue;
            write({puff.positionAt(age), puff.positionAt(age - m_dt)}, puff.radiusAt(age), puff.opacityAt(age),
                  {mixed(material.inside, style.pale), puff.seed});
        }
        const Vec3 gravity = m_session.world().gravity();
        for (int k = 0; k < style.splinters; ++k) {
            const Splinter splinter = splinterOf(startOf(broken, fracture, random), random);
            if (age >= splinter.lifetime) continue;
            const double lowest = m_scene.hasGround ? m_scene.groundHeight + splinter.radius : -kNoGround;
            write({splinter.positionAt(age, gravity, lowest), splinter.positionAt(age - m_dt, gravity, lowest)},
                  splinter.radius, splinter.opacityAt(age), {mixed(material.outside, 0.0), 1.0 + splinter.turnAt(age)});
        }
    }

private:
    struct Places {
        Vec3 now, before;
    };
    void write(const Places& places, double radius, double opacity, glm::vec4 colour) {
        m_scene.puffs.push_back({glm::vec4(glm::vec3(places.now - m_scene.origin), radius),
                                 glm::vec4(glm::vec3(places.before - places.now), opacity), colour});
    }

    RenderScene& m_scene;
    const Session& m_session;
    double m_dt = m_session.stepLength();
};

}  // namespace

void addDust(RenderScene& scene, const Session& session) {
    const std::vector<PlayBreak>& breaks = session.recentBreaks();
    DustWriter writer(scene, session);
    for (auto broken = breaks.rbegin(); broken != breaks.rend() && !writer.isFull(); ++broken) writer.add(*broken);
}

}  // namespace rubble
