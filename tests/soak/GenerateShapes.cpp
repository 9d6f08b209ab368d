#include "tests/soak/GenerateShapes.h"

#include "core/base/math/Power.h"
#include "core/base/math/Trigonometry.h"
#include "tests/support/asset/RandomAssets.h"
#include "tests/support/fracture/PatternSamples.h"
#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/SolidShapes.h"

#include <glm/gtc/quaternion.hpp>

#include <array>
#include <numbers>
#include <set>

namespace rubble::soak {
namespace {

/// An outline within about a metre of the origin.
Polygon randomOutlineOf(Random& random) {
    const double a = random.between(0.2, 0.9), b = random.between(0.2, 0.9);
    switch (random.below(8)) {
        case 0: return {rectangle({-a, -b}, {a, b}), {}};
        case 1: return {rectangle({-1.0, -0.12 * a}, {1.0, 0.12 * a}), {}};
        case 2:  // an L
            return {{{-a, -b}, {a, -b}, {a, -0.3 * b}, {-0.3 * a, -0.3 * b}, {-0.3 * a, b}, {-a, b}}, {}};
        case 3: return {{{-a, -b}, {a, -b}, {a, 0.4 * b}, {0.0, b}, {-a, 0.4 * b}}, {}};  // a gable
        case 4: {
            const Vec2 hole(0.4 * a, 0.5 * b);
            return {rectangle({-a, -b}, {a, b}), {reversed(rectangle(-hole, hole))}};
        }
        case 5:  // a portal
            return {{{-a, -b},
                     {-0.5 * a, -b},
                     {-0.5 * a, 0.4 * b},
                     {0.5 * a, 0.4 * b},
                     {0.5 * a, -b},
                     {a, -b},
                     {a, b},
                     {-a, b}},
                    {}};
        default: return test::randomOutline(random, static_cast<int>(random.below(3)));
    }
}

/// A solid of revolution of random radii: a column, a vase, a spindle.
TriangleMesh revolved(Random& random) {
    const auto sides = static_cast<std::uint32_t>(6 + random.below(12));
    const auto rings = static_cast<std::uint32_t>(3 + random.below(4));
    TriangleMesh mesh;
    for (std::uint32_t ring = 0; ring < rings; ++ring) {
        const double radius = random.between(0.2, 0.6), height = 2.0 * ring / (rings - 1.0) - 1.0;
        for (std::uint32_t side = 0; side < sides; ++side) {
            const double angle = 2.0 * std::numbers::pi * side / sides;
            mesh.points.push_back({radius * cosine(angle), radius * sine(angle), height});
        }
    }
    const auto bottom = static_cast<std::uint32_t>(mesh.points.size()), top = bottom + 1;
    mesh.points.push_back({0.0, 0.0, -1.0});
    mesh.points.push_back({0.0, 0.0, 1.0});
    for (std::uint32_t side = 0; side < sides; ++side) {
        const std::uint32_t next = (side + 1) % sides, last = (rings - 1) * sides;
        mesh.triangles.push_back({bottom, next, side});
        mesh.triangles.push_back({top, last + side, last + next});
        for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
            const std::uint32_t low = ring * sides, high = low + sides;
            mesh.triangles.push_back({low + side, low + next, high + next});
            mesh.triangles.push_back({low + side, high + next, high + side});
        }
    }
    return mesh;
}

/// A bar of cubes with corners and branches.
TriangleMesh barOfCubes(Random& random) {
    std::set<std::array<int, 3>> filled;
    std::array<int, 3> at{};
    filled.insert(at);
    for (std::uint64_t k = 1 + random.below(6); k > 0; --k) {
        ++at[random.below(3)];  // never back, so that no two cubes meet at an edge only
        filled.insert(at);
    }
    return test::cubes(filled);
}

TriangleMesh randomUnitMesh(Random& random) {
    switch (random.below(6)) {
        case 0: return test::bumpySphere(4 + static_cast<int>(random.below(6)));
        case 1: return test::torus(6 + static_cast<int>(random.below(8)), 4 + static_cast<int>(random.below(4)));
        case 2: return barOfCubes(random);
        case 3: {
            const TriangleMesh ball = test::bumpySphere(6);
            return test::together(ball, test::insideOut(test::transformed(ball, Mat3(random.between(0.6, 0.9)))));
        }
        default: return revolved(random);
    }
}

void scaleRing(Ring& ring, double size) {
    for (Vec2& point : ring) point *= size;
}

/// A value of a parameter of a layer that was made for an outline of about a metre, for another size.
ParameterValue scaled(const LayerParameter& parameter, ParameterValue value, double size) {
    if (parameter.quantity == Quantity::Length && parameter.type == ParameterType::Real) {
        return std::get<double>(value) * size;
    }
    if (parameter.type == ParameterType::Point) return std::get<Vec2>(value) * size;
    if (parameter.type != ParameterType::Count) return value;
    SeedCount& count = std::get<SeedCount>(value);
    if (count.by == CountBy::Density) count.amount /= size * size;
    if (count.by == CountBy::FragmentSize) count.amount *= size;
    return value;
}

void scaleLayer(LayerParameters& layer, double size) {
    for (const LayerParameter& parameter : kindOf(layer).parameters) {
        parameter.write(layer, scaled(parameter, parameter.read(layer), size));
    }
    if (auto* placed = std::get_if<PlacedSeeds>(&layer)) {
        for (PlacedSeeds::Seed& seed : placed->seeds) seed.position *= size;
    }
    if (auto* cracks = std::get_if<CrackLines>(&layer)) {
        for (CrackLines::CrackLine& line : cracks->lines) scaleRing(line.points, size);
    }
}

}  // namespace

double magnitudeIn(Random& random, double low, double high) { return low * power(high / low, random.unit()); }

bool chance(Random& random, double probability) { return random.unit() < probability; }

Vec3 randomDirection(Random& random) {
    for (;;) {
        const Vec3 point(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        const double length = glm::length(point);
        if (length > 0.1 && length <= 1.0) return point / length;
    }
}

Quat randomRotation(Random& random) {
    const std::uint64_t kind = random.below(10);
    if (kind < 5) return Quat{1.0, 0.0, 0.0, 0.0};
    constexpr double kHalf = 0.70710678118654752;
    constexpr std::array<Quat, 4> kQuarters{
        {{kHalf, kHalf, 0.0, 0.0}, {kHalf, 0.0, kHalf, 0.0}, {kHalf, 0.0, 0.0, kHalf}, {0.0, 0.0, 1.0, 0.0}}};
    if (kind < 8) return glm::normalize(kQuarters[random.below(4)]);
    const double angle = random.between(0.0, std::numbers::pi);
    const Vec3 axis = sine(angle / 2.0) * randomDirection(random);
    return glm::normalize(Quat{cosine(angle / 2.0), axis.x, axis.y, axis.z});
}

Prism randomPrism(Random& random, double size) {
    Prism prism{randomOutlineOf(random), size * magnitudeIn(random, 0.05, 1.0)};
    scaleRing(prism.outline.outer, size);
    for (Ring& hole : prism.outline.holes) scaleRing(hole, size);
    return prism;
}

std::shared_ptr<const ClosedMesh> randomMesh(Random& random, double size) {
    TriangleMesh mesh = randomUnitMesh(random);
    const Vec3 stretch(magnitudeIn(random, 0.2, 1.0), magnitudeIn(random, 0.2, 1.0), magnitudeIn(random, 0.2, 1.0));
    Mat3 shape(Vec3(stretch.x, 0.0, 0.0), Vec3(0.0, stretch.y, 0.0), Vec3(0.0, 0.0, stretch.z));
    if (chance(random, 0.3)) shape = glm::mat3_cast(randomRotation(random)) * shape;
    mesh = test::transformed(std::move(mesh), shape);
    const Box3 box = boundsOf(mesh);
    const double scale = 2.0 * size / box.diagonal();
    mesh = test::transformed(std::move(mesh), Mat3(scale), -scale * box.centre());
    return closedMesh(std::move(mesh)).value();
}

Pattern randomPattern(Random& random, double size, Id& nextId) {
    static const std::vector<LayerParameters> samples = patternSamples();
    Pattern pattern;
    const std::uint64_t layers = chance(random, 0.75) ? 1 : 2;
    for (std::uint64_t k = 0; k < layers; ++k) {
        LayerParameters parameters = samples[random.below(samples.size())];
        scaleLayer(parameters, size);
        if (chance(random, 0.4)) parameters = UniformScatter{.count = 2 + static_cast<std::uint32_t>(random.below(30))};
        pattern.layers.push_back({.id = nextId++, .randomSeed = random.below(1000), .parameters = parameters});
    }
    const LayerRole role = kindOf(pattern.layers.front().parameters).role;
    if (role == LayerRole::Moves || role == LayerRole::Measures) {  // it needs seeds
        pattern.layers.insert(pattern.layers.begin(),
                              {.id = nextId++, .randomSeed = random.below(1000), .parameters = UniformScatter{8}});
    }
    return pattern;
}

}  // namespace rubble::soak
