#include "core/asset/bake/Bake.h"
#include "core/asset/project/AssetShape.h"
#include "core/base/Random.h"
#include "tests/soak/GenerateScene.h"
#include "tests/soak/GenerateShapes.h"
#include "tests/soak/SoakCase.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rubble::soak {
namespace {

/// What is done to a scene, with impulses and distances that suit it.
class InputGenerator {
public:
    InputGenerator(Random& random, const RandomScene& scene) : m_random(random), m_scene(scene) {}

    /// The inputs of something that begins at a step: one, but what is grabbed is dragged and released later.
    void addAt(std::uint64_t step, std::vector<TimedInput>& inputs) {
        switch (m_random.below(16)) {
            case 0:
            case 1:
            case 2:
            case 3:
            case 4: inputs.push_back({step, ShotInput{"throw", randomThrow()}}); break;
            case 5:
            case 6: inputs.push_back({step, ShotInput{"blow", randomBlow()}}); break;
            case 7:
            case 8: inputs.push_back({step, ShotInput{"blast", randomBlast()}}); break;
            case 9: addGrab(step, inputs); break;
            case 10: inputs.push_back({step, RemoveInput{randomPart()}}); break;
            case 11: inputs.push_back({step, BreakInput{bodyPlace()}}); break;
            case 12: inputs.push_back({step, randomThreshold()}); break;
            case 13: inputs.push_back({step, randomMaterial()}); break;
            case 14: inputs.push_back({step, DestructionInput{m_random.below(2) == 0}}); break;
            default: inputs.push_back({step, GravityInput{randomGravity()}});
        }
    }

private:
    const Project& project() const { return m_scene.project; }
    const Instance& instance() { return project().instances[m_random.below(project().instances.size())]; }
    std::uint32_t bodyPlace() { return static_cast<std::uint32_t>(m_random.below(50)); }
    Vec3 near(double distance) { return distance * m_random.unit() * randomDirection(m_random); }
    Vec3 target() { return instance().pose.position + near(0.6 * m_scene.size); }

    /// The mass of an instance, kg, at most.
    double massOf(const Instance& one) const {
        const Asset& asset = *findAsset(project(), one.asset);
        return volumeOf(asset) * findMaterial(project(), asset.material)->density;
    }

    Throw randomThrow() {
        const Vec3 to = target();
        Vec3 side = randomDirection(m_random);
        side.y = std::abs(side.y);
        Throw thrown{.kind = static_cast<ProjectileKind>(m_random.below(4)),
                     .size = m_scene.size * Vec3(magnitudeIn(m_random, 0.05, 0.6)),
                     .mass = massOf(instance()) * magnitudeIn(m_random, 0.01, 2.0),
                     .from = to + m_scene.size * random().between(2.0, 4.0) * side,
                     .to = to,
                     .speed = m_scene.speed * magnitudeIn(m_random, 0.5, 10.0)};
        if (thrown.kind == ProjectileKind::Asset) {
            thrown.asset = project().assets[m_random.below(project().assets.size())].id;
        }
        if (thrown.kind == ProjectileKind::Plank) thrown.size.z *= 4.0;
        constexpr double kDensest = 2e4;  // kg/m³: heavier than lead is nothing
        thrown.mass = std::min(thrown.mass, kDensest * thrown.size.x * thrown.size.y * thrown.size.z);
        return thrown;
    }

    Hammer randomBlow() {
        const Instance& one = instance();
        return {.at = one.pose.position + near(0.6 * m_scene.size),
                .impulse = massOf(one) * m_scene.speed * magnitudeIn(m_random, 0.01, 2.0) * randomDirection(m_random)};
    }

    Blast randomBlast() {
        const Instance& one = instance();
        const double perArea = massOf(one) * m_scene.speed / (m_scene.size * m_scene.size);
        return {.at = one.pose.position + near(1.5 * m_scene.size),
                .impulse = perArea * magnitudeIn(m_random, 0.1, 5.0),
                .radius = m_scene.size * random().between(0.5, 4.0)};
    }

    void addGrab(std::uint64_t step, std::vector<TimedInput>& inputs) {
        const double weight = massOf(instance()) * std::max(1.0, glm::length(project().gravity));
        const Vec3 from = target();
        inputs.push_back({step, GrabInput{bodyPlace(), from, weight * magnitudeIn(m_random, 0.5, 4.0)}});
        for (int k = 0; k < 3; ++k) {
            step += 2 + m_random.below(10);
            inputs.push_back({step, DragInput{from + near(2.0 * m_scene.size)}});
        }
        if (chance(m_random, 0.8)) inputs.push_back({step + m_random.below(30), ReleaseInput{}});
    }

    InstancePart randomPart() {
        const Instance& one = instance();
        InstancePart part{.instance = one.id};
        const Asset& asset = *findAsset(project(), one.asset);
        if (asset.breakAs != BreakAs::Bonded || chance(m_random, 0.2)) return part;
        const Result<Bake> baked = bake(asset);
        const std::uint32_t count = baked ? baked->fragmentCount() : 0;
        for (std::uint32_t fragment = 0; fragment < count; ++fragment) {
            if (chance(m_random, 0.15)) part.fragments.push_back(baked->fragmentPath(fragment));
        }
        std::ranges::sort(part.fragments);
        return part;
    }

    ThresholdInput randomThreshold() {
        const Instance& one = instance();
        const double threshold = findAsset(project(), one.asset)->threshold * magnitudeIn(m_random, 0.01, 10.0);
        if (m_random.below(2) == 0) return {.instance = one.id, .threshold = threshold};
        return {.asset = one.asset, .threshold = threshold};
    }

    MaterialInput randomMaterial() {
        Material material = project().materials[m_random.below(project().materials.size())];
        material.density *= magnitudeIn(m_random, 0.3, 3.0);
        material.friction = m_random.between(0.0, 1.0);
        return {material};
    }

    Vec3 randomGravity() {
        constexpr std::array kStrengths{0.0, 0.1, 1.62, 9.81, 20.0};
        const double strength = kStrengths[m_random.below(kStrengths.size())];
        return strength * (chance(m_random, 0.7) ? Vec3(0.0, -1.0, 0.0) : randomDirection(m_random));
    }

    Random& random() { return m_random; }

    Random& m_random;
    const RandomScene& m_scene;
};

void addRewinds(Random& random, SoakCase& one) {
    if (!chance(random, 0.3)) return;
    one.rewinds.push_back({.step = random.below(one.steps / 2), .steps = 5 + random.below(30)});
}

/// Has a few scenes break by the simplified method of the thesis. From a generator of their own: the others stay as
/// they were.
void chooseMethod(std::uint64_t seed, const RandomScene& scene, Project& project) {
    Random random(mixSeeds(seed, 0x7e515));
    if (!chance(random, 0.06)) return;
    project.damage.isThesis = true;
    const double mass = 1000.0 * scene.size * scene.size * scene.size;
    project.damage.thesisThreshold = mass * scene.speed * magnitudeIn(random, 1e-3, 1.0);
}

}  // namespace

SoakCase generatedCase(std::uint64_t seed) {
    Random random(mixSeeds(seed, 0x50a4));
    const RandomScene scene = randomScene(random);
    SoakCase one{.project = scene.project};
    chooseMethod(seed, scene, one.project);
    constexpr std::array kSteps{1.0 / 30.0, 1.0 / 60.0, 1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0};
    one.dt = kSteps[random.below(kSteps.size())];
    one.isSleeping = chance(random, 0.9);
    one.steps = std::min<std::uint64_t>(240, static_cast<std::uint64_t>(random.between(1.5, 4.0) / one.dt));
    InputGenerator generator(random, scene);
    const std::uint64_t inputs = random.below(6);
    for (std::uint64_t k = 0; k < inputs; ++k) generator.addAt(random.below(one.steps / 2), one.inputs);
    std::ranges::stable_sort(one.inputs, {}, &TimedInput::step);
    addRewinds(random, one);
    while (chance(random, 0.3)) one.saves.push_back(random.below(one.steps));
    std::ranges::sort(one.saves);
    one.isCompared = chance(random, 0.15);
    return one;
}

}  // namespace rubble::soak
