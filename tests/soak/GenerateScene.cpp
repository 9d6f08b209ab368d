#include "tests/soak/GenerateScene.h"

#include "core/asset/bake/Bake.h"
#include "core/asset/checks/VerifyProject.h"
#include "core/structure/clusters/ClusterEditing.h"
#include "tests/soak/GenerateShapes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

namespace rubble::soak {
namespace {

constexpr std::uint32_t kMaxFragments = 60;  // of an asset: more are slow to play

std::vector<Vec3> cornersOf(const Asset& asset) {
    if (const ClosedMesh* mesh = asset.mesh()) return mesh->mesh.points;
    std::vector<Vec3> corners;
    for (const Vec2& point : asset.prism().outline.outer) {
        for (const double z : {-0.5 * asset.prism().depth, 0.5 * asset.prism().depth})
            corners.push_back(Vec3(point, z));
    }
    return corners;
}

double heightOf(const Asset& asset, const Quat& orientation, double sign) {
    double most = -1e300;
    for (const Vec3& corner : cornersOf(asset)) most = std::max(most, sign * (orientation * corner).y);
    return most;
}

Material randomMaterial(Random& random, Id id) {
    return {.id = id,
            .name = "material " + std::to_string(id),
            .density = magnitudeIn(random, 400.0, 8000.0),
            .friction = random.between(0.0, 1.2),
            .restitution = chance(random, 0.6) ? 0.0 : random.between(0.0, 0.9)};
}

Vec3 randomGravity(Random& random) {
    constexpr std::array kStrengths{0.0, 0.1, 1.62, 20.0};
    const double strength = chance(random, 0.6) ? 9.81 : kStrengths[random.below(4)];
    if (chance(random, 0.9)) return {0.0, -strength, 0.0};
    return strength * randomDirection(random);
}

BondStroke randomStroke(Random& random, const Prism& prism, double size) {
    const Ring& ring = prism.outline.outer;
    const Vec2 from = ring[random.below(ring.size())], to = ring[random.below(ring.size())];
    return {.brush = static_cast<BondBrush>(random.below(3)),
            .strength = chance(random, 0.2) ? 0.0 : magnitudeIn(random, 0.1, 10.0),
            .radius = size * random.between(0.05, 0.3),
            .points = {from, to}};
}

Bonding randomBonding(Random& random, const Prism& prism, double size, double momentum) {
    Bonding bonding{.impulsePerArea = momentum * magnitudeIn(random, 0.003, 3.0),
                    .radius = size * magnitudeIn(random, 0.1, 2.0),
                    .falloff = static_cast<HitFalloff>(random.below(3)),
                    .damageFrom = random.between(0.1, 1.0),
                    .span = chance(random, 0.5) ? 0.0 : size * random.between(0.1, 2.0),
                    .collapseDelay = chance(random, 0.4) ? 0.0 : random.between(0.0, 0.4),
                    .minimumIsland = chance(random, 0.7) ? 1 : 2 + static_cast<std::uint32_t>(random.below(4))};
    while (chance(random, 0.25)) bonding.strokes.push_back(randomStroke(random, prism, size));
    if (chance(random, 0.15)) {
        bonding.heightStrengths = {{0.0, random.between(0.0, 2.0)}, {size, random.between(0.0, 4.0)}};
    }
    return bonding;
}

/// Puts the fragments of an asset into clusters of one or two levels.
void addClusters(Random& random, Asset& asset, const Bake& baked) {
    const std::uint64_t levels = 1 + random.below(2);
    for (std::uint32_t level = 0; level < levels; ++level) {
        const auto count = static_cast<std::uint32_t>(2 + random.below(4)) * (level + 1);
        asset.bonding.clusters = ClusterEditing(asset, baked, 0, level).propose({.value = count});
    }
}

/// Makes an asset's bake valid and small.
Bake smallBake(Asset& asset, Id& nextId) {
    const auto isSmall = [](const Result<Bake>& baked) { return baked && baked->fragmentCount() <= kMaxFragments; };
    Result<Bake> baked = bake(asset);
    if (!isSmall(baked)) {
        asset.levels.clear();
        baked = bake(asset);
    }
    if (!isSmall(baked)) {
        asset.pattern.layers = {{.id = nextId++, .randomSeed = 1, .parameters = UniformScatter{12}}};
        baked = bake(asset);
    }
    return std::move(*baked);
}

/// Makes one of ten assets one of a mesh, which plays slower. What is random in it depends on the size only, so that
/// scenes of prisms stay as they were.
void makeMesh(Asset& asset, double size) {
    Random random(std::bit_cast<std::uint64_t>(size));
    if (!chance(random, 0.1)) return;
    asset.shape = randomMesh(random, size);
    asset.bonding.strokes.clear();
}

Asset randomAsset(Random& random, Project& project, const RandomScene& scene) {
    const double size = scene.size * magnitudeIn(random, 0.5, 1.5);
    const Id id = project.nextId++;
    Asset asset{.id = id,
                .name = "asset " + std::to_string(id),
                .material = project.materials[random.below(project.materials.size())].id,
                .shape = randomPrism(random, size)};
    asset.pattern = randomPattern(random, size, project.nextId);
    const double density = findMaterial(project, asset.material)->density;
    const double momentum = density * size * scene.speed;  // N·s/m²: of a layer of that thickness
    asset.threshold = momentum * size * asset.prism().depth * magnitudeIn(random, 0.003, 1.0);
    while (chance(random, 0.2) && asset.levels.size() < 2) {
        asset.levels.push_back({.pattern = {{{.id = project.nextId++, .parameters = UniformScatter{3}}}},
                                .minimumVolume = chance(random, 0.5) ? 0.0 : 1e-3 * size * size * asset.prism().depth});
    }
    if (chance(random, 0.1)) asset.shaping.gap = 0.01 * size;
    if (chance(random, 0.15)) asset.shaping.smallPieces.rule = SmallPieceRule::Merge;
    const std::uint64_t kind = random.below(10);
    if (kind < 6) asset.breakAs = BreakAs::Bonded;
    if (kind == 9) {
        asset.cutAtImpact = CutAtImpact{.fragments = 2 + static_cast<std::uint32_t>(random.below(20)),
                                        .falloffRadius = size * magnitudeIn(random, 0.05, 1.0)};
    }
    asset.bonding = randomBonding(random, asset.prism(), size, momentum);
    makeMesh(asset, size);
    const Bake baked = smallBake(asset, project.nextId);
    if (asset.breakAs == BreakAs::Bonded && chance(random, 0.3)) addClusters(random, asset, baked);
    return asset;
}

/// A fixed slab that does not break along bonds, as a floor.
void addFloor(Random& random, Project& project, const RandomScene& scene) {
    const double half = scene.size * random.between(1.0, 3.0), thick = scene.size * random.between(0.05, 0.5);
    const Id id = project.nextId++;
    Asset floor{.id = id, .name = "floor", .material = project.materials[0].id};
    floor.shape = Prism{{{{-half, -thick}, {half, -thick}, {half, 0.0}, {-half, 0.0}}, {}}, 2.0 * half};
    floor.pattern.layers = {{.id = project.nextId++, .randomSeed = id, .parameters = UniformScatter{8}}};
    project.assets.push_back(floor);
    project.instances.push_back({.id = project.nextId++,
                                 .name = "floor",
                                 .asset = id,
                                 .pose = {.position = {0.0, project.ground.height + thick, 0.0}},
                                 .isFixed = true,
                                 .isUnbreakable = chance(random, 0.7)});
}

/// Places instances on, beside, over and a little in each other.
class Placement {
public:
    Placement(Random& random, Project& project, double size) : m_random(random), m_project(project), m_size(size) {
        if (!project.instances.empty()) m_floor = project.instances.front().pose.position.y;
        m_top = m_floor;
    }

    void add() {
        const Asset& asset = m_project.assets[m_random.below(m_project.assets.size())];
        const Quat orientation = randomRotation(m_random);
        const double below = heightOf(asset, orientation, -1.0), above = heightOf(asset, orientation, 1.0);
        Vec3 at(m_last.x, m_top + below, m_last.z);
        switch (m_random.below(5)) {
            case 0: break;  // on the last one
            case 1: at = sideways(asset, orientation, below, 0.0); break;
            case 2: at = sideways(asset, orientation, below, m_size * m_random.between(0.01, 0.5)); break;
            case 3: at.y += m_size * magnitudeIn(m_random, 0.05, 4.0); break;
            default:
                at += m_size *
                      Vec3(m_random.between(-0.5, 0.5), m_random.between(-0.02, 0.3), m_random.between(-0.5, 0.5));
        }
        place(asset, {at, orientation});
        m_last = at;
        m_top = at.y + above;
        m_right = std::max(m_right, at.x + extentOf(asset, orientation));
    }

private:
    static double extentOf(const Asset& asset, const Quat& orientation) {
        const Quat quarter(0.70710678118654752, 0.0, 0.0, 0.70710678118654752);  // x becomes y
        return heightOf(asset, quarter * orientation, 1.0);
    }

    Vec3 sideways(const Asset& asset, const Quat& orientation, double below, double apart) const {
        const Quat quarter(0.70710678118654752, 0.0, 0.0, 0.70710678118654752);
        const double left = heightOf(asset, quarter * orientation, -1.0);
        return {m_right + left + apart, m_floor + below, 0.0};
    }

    void place(const Asset& asset, const Pose& pose) {
        const Id id = m_project.nextId++;
        Instance instance{.id = id, .name = "instance " + std::to_string(id), .asset = asset.id, .pose = pose};
        instance.isFixed = chance(m_random, 0.2);
        instance.isAnchored = chance(m_random, 0.5);
        instance.isUnbreakable = chance(m_random, 0.05);
        if (chance(m_random, 0.2)) instance.bondStrength = magnitudeIn(m_random, 0.1, 10.0);
        if (chance(m_random, 0.1)) instance.threshold = asset.threshold * magnitudeIn(m_random, 0.1, 10.0);
        m_project.instances.push_back(instance);
    }

    Random& m_random;
    Project& m_project;
    double m_size;
    double m_floor = 0.0;
    double m_top = 0.0;
    double m_right = 0.0;
    Vec3 m_last{0.0};
};

void addMortars(Random& random, Project& project, const RandomScene& scene) {
    if (!chance(random, 0.4)) return;
    const Id id = project.nextId++;
    project.mortars.push_back({.id = id,
                               .name = "mortar",
                               .tolerance = 0.005 * scene.size,
                               .leastArea = 0.0,
                               .impulsePerArea = 1000.0 * scene.size * scene.speed * magnitudeIn(random, 0.01, 1.0)});
}

void setRules(Random& random, Project& project) {
    project.ground.isOn = chance(random, 0.9);
    if (chance(random, 0.1)) project.ground.height = random.between(-3.0, 3.0);
    project.ground.friction = random.between(0.0, 1.0);
    if (chance(random, 0.3)) project.ground.restitution = random.between(0.0, 0.8);
    if (chance(random, 0.3)) project.damage.rule = DamageRule::Momentum;
    if (chance(random, 0.1)) project.debris.lifetime = random.between(0.1, 1.0);
    if (chance(random, 0.1)) project.debris.maxFragments = 1 + static_cast<std::uint32_t>(random.below(20));
}

/// Moves a scene to a place where positions are coarser.
void moveFarOut(Random& random, Project& project) {
    const Vec3 far(random.between(-300.0, 300.0), 0.0, random.between(-300.0, 300.0));
    for (Instance& instance : project.instances) instance.pose.position += far;
}

std::optional<RandomScene> attemptedScene(Random& random) {
    RandomScene scene;
    scene.size = chance(random, 0.7) ? magnitudeIn(random, 0.3, 3.0) : magnitudeIn(random, 0.05, 10.0);
    Project& project = scene.project;
    project.gravity = randomGravity(random);
    scene.speed = std::max(2.0, 2.0 * std::sqrt(glm::length(project.gravity) * scene.size));
    const std::uint64_t materials = 1 + random.below(2);
    for (std::uint64_t k = 0; k < materials; ++k) {
        const Id id = project.nextId++;
        project.materials.push_back(randomMaterial(random, id));
    }
    setRules(random, project);
    const std::uint64_t assets = 1 + random.below(3);
    for (std::uint64_t k = 0; k < assets; ++k) project.assets.push_back(randomAsset(random, project, scene));
    if (chance(random, 0.25)) addFloor(random, project, scene);
    Placement placement(random, project, scene.size);
    const std::uint64_t instances = 1 + random.below(4);
    for (std::uint64_t k = 0; k < instances; ++k) placement.add();
    addMortars(random, project, scene);
    if (chance(random, 0.03)) moveFarOut(random, project);
    if (verifyProject(project)) return std::nullopt;
    return scene;
}

}  // namespace

RandomScene randomScene(Random& random) {
    for (;;) {
        if (std::optional<RandomScene> scene = attemptedScene(random)) return std::move(*scene);
    }
}

}  // namespace rubble::soak
