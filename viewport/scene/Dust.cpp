#include "viewport/scene/Dust.h"

#include "core/base/Random.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace rubble {
namespace {

constexpr int kPuffs = 14;                 // of a break
constexpr std::size_t kMostPuffs = 1200;   // of a scene, the last breaks' first: they cover each other
constexpr double kLife = 0.8;              // s
constexpr double kRise = 0.04;             // s, until a puff is as thick as it gets
constexpr double kOpacity = 0.75;          // then
constexpr double kSlowing = 2.2;           // 1/s: air stops dust
constexpr Colour kPale{0.90, 0.88, 0.85};  // what any dust is most of
constexpr double kPaleShare = 0.7;
constexpr std::uint64_t kStream = 0xd057;

/// A puff as it begins. Lengths are in sizes of what broke.
struct Puff {
    Vec3 from;
    Vec3 velocity;
    double radius = 0.0;
    double life = 0.0;  // s
    double turn = 0.0;  // what its shape is told apart by

    Vec3 placeAt(double age) const { return from + velocity * (age / (1.0 + kSlowing * age)); }
    double radiusAt(double age) const { return radius * (1.0 + 2.6 * age / (0.3 + age)); }
    double opacityAt(double age) const {
        const double left = 1.0 - age / life;
        return kOpacity * std::min(1.0, age / kRise) * left * left;
    }
};

/// Where two pieces of a broken whole parted, in the frame of its asset.
Vec3 cutAt(const PlayBreak& broken, const PlayBreaking& breaking, Random& random) {
    if (breaking.neighbours.empty()) return broken.asset->pieces[breaking.first + random.below(breaking.count)].offset;
    const PlayNeighbours& parted = breaking.neighbours[random.below(breaking.neighbours.size())];
    return 0.5 * (broken.asset->pieces[parted.first].offset + broken.asset->pieces[parted.second].offset);
}

/// How far its pieces lie from its middle, at most.
double sizeOf(const PlayBreak& broken, const PlayBreaking& breaking, Vec3 middle) {
    double size = 0.0;
    for (std::uint32_t k = 0; k < breaking.count; ++k) {
        size = std::max(size, glm::distance(broken.asset->pieces[breaking.first + k].offset, middle));
    }
    return 2.0 * size;
}

Puff puffOf(const PlayBreak& broken, const PlayBreaking& breaking, Random& random) {
    const Vec3 middle = broken.asset->piece(broken.body.fragment).offset;
    const double size = sizeOf(broken, breaking, middle);
    const Vec3 from = broken.pose.position + broken.pose.orientation * (cutAt(broken, breaking, random) - middle);
    const Vec3 arm = from - broken.point;
    const Vec3 away = glm::dot(arm, arm) > 1e-12 ? glm::normalize(arm) : broken.normal;
    const Vec3 onwards = random.between(-0.9, 0.9) * broken.normal, up(0.0, random.between(0.1, 0.7), 0.0);
    return {.from = from,
            .velocity = size * (random.between(0.4, 1.6) * away + onwards + up),
            .radius = size * random.between(0.22, 0.42),
            .life = kLife * random.between(0.65, 1.1),
            .turn = random.unit()};
}

glm::vec3 colourOf(const PlayBreak& broken, const Project& project) {
    const AssetMaterials material = materialsOf(project, *findAsset(project, broken.asset->bake->asset));
    const Colour& colour = material.inside.inside;
    const Vec3 inside(colour.red, colour.green, colour.blue);
    return glm::vec3(glm::mix(inside, Vec3(kPale.red, kPale.green, kPale.blue), kPaleShare));
}

}  // namespace

void addDust(RenderScene& scene, const Session& session) {
    const std::vector<PlayBreak>& breaks = session.recentBreaks();
    const double dt = session.stepLength();
    for (auto broken = breaks.rbegin(); broken != breaks.rend() && scene.puffs.size() < kMostPuffs; ++broken) {
        const double age = dt * static_cast<double>(session.stepsDone() + 1 - broken->step);
        const PlayBreaking& breaking = *broken->asset->breakingOf(broken->body.fragment);
        const glm::vec3 colour = colourOf(*broken, session.scene().project);
        Random random(mixedWith(broken->body.number, kStream));
        for (int k = 0; k < kPuffs; ++k) {
            const Puff puff = puffOf(*broken, breaking, random);
            if (age >= puff.life) continue;
            const Vec3 place = puff.placeAt(age), then = puff.placeAt(age - dt);
            scene.puffs.push_back({glm::vec4(glm::vec3(place - scene.origin), puff.radiusAt(age)),
                                   glm::vec4(glm::vec3(then - place), puff.opacityAt(age)),
                                   glm::vec4(colour, puff.turn)});
        }
    }
}

}  // namespace rubble
