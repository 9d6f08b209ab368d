#include "tests/oracle/FractureCases.h"

#include "core/base/Random.h"
#include "core/geometry/polygon/PolygonFaults.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace rubble::oracle {
namespace {

struct NamedOutline {
    const char* name;
    Polygon (*make)(Random& random);
};
struct NamedSeeds {
    const char* name;
    std::vector<Vec2> (*make)(const Polygon& outline, Random& random);
};

int integerBetween(Random& random, int low, int high) {
    return low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low + 1)));
}

/// A star-shaped ring around `centre`, its corners at a distance between `min` and `max`.
Ring star(Random& random, Vec2 centre, int corners, double min, double max) {
    Ring ring;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * (k + random.between(0.1, 0.9)) / corners;
        ring.push_back(centre + random.between(min, max) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return ring;
}

Ring reversed(Ring ring) {
    std::reverse(ring.begin() + 1, ring.end());
    return ring;
}

Polygon rectangle(Random& random) {
    const Vec2 size(integerBetween(random, 1, 8), integerBetween(random, 1, 8));
    return {{{0, 0}, {size.x, 0}, size, {0, size.y}}, {}};
}

Polygon rotatedRectangle(Random& random) {
    const double angle = random.between(0.0, 6.28);
    const Vec2 along = random.between(0.1, 3.0) * Vec2(std::cos(angle), std::sin(angle));
    const Vec2 across = random.between(0.1, 3.0) * Vec2(-std::sin(angle), std::cos(angle));
    return {{{0, 0}, along, along + across, across}, {}};
}

Polygon sliver(Random& random) {
    const double height = random.below(2) == 0 ? 0.001 : random.between(1e-6, 1e-3);
    return {{{0, 0}, {1, 0}, {1, height}, {0, height}}, {}};
}

Polygon triangle(Random& random) { return {star(random, {0, 0}, 3, 0.2, 1.0), {}}; }

Polygon starWithHoles(Random& random) {
    Polygon polygon{star(random, {0, 0}, integerBetween(random, 5, 24), 0.5, 1.0), {}};
    const std::array<Vec2, 3> places{Vec2(0.22, 0.0), Vec2(-0.11, 0.19), Vec2(-0.11, -0.19)};
    const int holes = integerBetween(random, 0, 3);
    for (int hole = 0; hole < holes; ++hole)
        polygon.holes.push_back(
            reversed(star(random, places[static_cast<std::size_t>(hole)], integerBetween(random, 3, 7), 0.03, 0.17)));
    // A star with few corners may come too close to its centre.
    while (!validated(polygon)) polygon.holes.pop_back();
    return polygon;
}

Polygon thousandCorners(Random& random) { return {star(random, {0.5, 0.5}, 1000, 0.3, 0.5), {}}; }

/// A comb with integer coordinates, so that bisectors of lattice seeds run along its sides.
Polygon comb(Random& random) {
    const int teeth = integerBetween(random, 2, 5);
    const double depth = integerBetween(random, 1, 5);
    Polygon polygon{{{0, 0}, {2.0 * teeth - 1.0, 0}}, {}};
    for (int tooth = teeth - 1; tooth >= 0; --tooth) {
        polygon.outer.insert(polygon.outer.end(), {{2.0 * tooth + 1.0, 1.0 + depth}, {2.0 * tooth, 1.0 + depth}});
        if (tooth > 0) polygon.outer.insert(polygon.outer.end(), {{2.0 * tooth, 1.0}, {2.0 * tooth - 1.0, 1.0}});
    }
    return polygon;
}

Polygon elbow(Random& random) {
    const double width = integerBetween(random, 2, 6);
    const double height = integerBetween(random, 2, 6);
    return {{{0, 0}, {width, 0}, {width, 1}, {1, 1}, {1, height}, {0, height}}, {}};
}

/// A plate with square holes on a lattice and points on its straight sides.
Polygon lattice(Random& random) {
    const int columns = integerBetween(random, 1, 3);
    Polygon polygon;
    const double width = 2.0 * columns + 1.0;
    for (int k = 0; k < columns; ++k) polygon.outer.emplace_back(2.0 * k, 0.0);
    polygon.outer.insert(polygon.outer.end(), {{width, 0}, {width, 3}, {0, 3}});
    for (int k = 0; k < columns; ++k) {
        if (random.below(3) == 0) continue;
        const double x = 2.0 * k + 1.0;
        polygon.holes.push_back({{x, 1}, {x, 2}, {x + 1, 2}, {x + 1, 1}});
    }
    return polygon;
}

Polygon moved(Polygon polygon, Vec2 by, double scale) {
    for (Vec2& corner : polygon.outer) corner = by + scale * corner;
    for (Ring& hole : polygon.holes)
        for (Vec2& corner : hole) corner = by + scale * corner;
    return polygon;
}

/// A million away, with sides of 256 steps of 1e-6, rounded.
Polygon farAway(Random& random) {
    const Vec2 corner(random.between(9e5, 1.1e6), random.between(-1.1e6, -9e5));
    return moved({{{0, 0}, {256, 0}, {256, 256}, {128, 128}, {0, 256}}, {}}, corner, 1e-6);
}

Vec2 inBox(Random& random, const Box2& box) {
    return {random.between(box.min.x, box.max.x), random.between(box.min.y, box.max.y)};
}

Box2 boxOf(const Polygon& outline) {
    Box2 box;
    for (const Vec2 corner : outline.outer) {
        box.min = {std::min(box.min.x, corner.x), std::min(box.min.y, corner.y)};
        box.max = {std::max(box.max.x, corner.x), std::max(box.max.y, corner.y)};
    }
    return box;
}

std::vector<Vec2> uniform(const Polygon& outline, Random& random) {
    std::vector<Vec2> seeds;
    const int count = integerBetween(random, 4, 30);
    for (int k = 0; k < count; ++k) seeds.push_back(inBox(random, boxOf(outline)));
    return seeds;
}

std::vector<Vec2> few(const Polygon& outline, Random& random) {
    std::vector<Vec2> seeds = uniform(outline, random);
    seeds.resize(1 + random.below(3));
    return seeds;
}

/// On a half-integer lattice, also outside the outline: cocircular, collinear, equal, on corners and sides.
std::vector<Vec2> latticeSeeds(const Polygon& outline, Random& random) {
    std::vector<Vec2> seeds;
    const int count = integerBetween(random, 3, 24);
    for (int k = 0; k < count; ++k)
        seeds.push_back(outline.outer[0] + 0.5 * Vec2(integerBetween(random, -2, 14), integerBetween(random, -2, 8)));
    return seeds;
}

std::vector<Vec2> grid(const Polygon& outline, Random& random) {
    const Box2 box = boxOf(outline);
    const int columns = integerBetween(random, 1, 6);
    const int rows = integerBetween(random, 1, 6);
    std::vector<Vec2> seeds;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            seeds.push_back(box.min + Vec2((column + 0.5) / columns, (row + 0.5) / rows) * (box.max - box.min));
    return seeds;
}

/// On a line with a direction of small integers, so that the sites are exactly collinear.
std::vector<Vec2> collinear(const Polygon& outline, Random& random) {
    const Box2 box = boxOf(outline);
    const double step = std::exp2(std::floor(std::log2(std::max(box.max.x - box.min.x, box.max.y - box.min.y))) - 5.0);
    const Vec2 start(std::round(box.min.x / step) * step, std::round(box.min.y / step) * step);
    const Vec2 direction = step * Vec2(integerBetween(random, -2, 3), integerBetween(random, 1, 2));
    std::vector<Vec2> seeds;
    const int count = integerBetween(random, 2, 16);
    for (int k = 0; k < count; ++k)
        seeds.push_back(start + static_cast<double>(integerBetween(random, 0, 20)) * direction);
    return seeds;
}

std::vector<Vec2> duplicates(const Polygon& outline, Random& random) {
    std::vector<Vec2> seeds = uniform(outline, random);
    const std::size_t count = seeds.size();
    for (std::size_t k = 0; k < count; k += 2) seeds.push_back(seeds[random.below(count)]);
    return seeds;
}

std::vector<Vec2> oneUlpApart(const Polygon& outline, Random& random) {
    std::vector<Vec2> seeds = uniform(outline, random);
    const std::size_t count = seeds.size();
    for (std::size_t k = 0; k < count; k += 3) {
        Vec2 twin = seeds[k];
        double& coordinate = random.below(2) == 0 ? twin.x : twin.y;
        coordinate = std::nextafter(coordinate, random.below(2) == 0 ? 1e300 : -1e300);
        seeds.push_back(twin);
    }
    return seeds;
}

/// Its corners and points on its sides, and a few others.
std::vector<Vec2> onTheOutline(const Polygon& outline, Random& random) {
    const std::size_t corners = outline.outer.size();
    std::vector<Vec2> seeds = few(outline, random);
    for (int k = 0; k < 12; ++k) {
        const std::size_t corner = random.below(corners);
        const Vec2 from = outline.outer[corner];
        const Vec2 to = outline.outer[(corner + 1) % corners];
        seeds.push_back(from + 0.25 * static_cast<double>(random.below(5)) * (to - from));
    }
    return seeds;
}

std::vector<Vec2> outside(const Polygon& outline, Random& random) {
    const Box2 box = boxOf(outline);
    const Vec2 size = box.max - box.min;
    const Box2 around{box.min - 2.0 * size, box.max + 2.0 * size};
    std::vector<Vec2> seeds;
    const int count = integerBetween(random, 1, 20);
    for (int k = 0; k < count; ++k) seeds.push_back(inBox(random, around));
    return seeds;
}

constexpr std::array kOutlines{NamedOutline{"rectangle", rectangle},
                               NamedOutline{"rotated rectangle", rotatedRectangle},
                               NamedOutline{"sliver", sliver},
                               NamedOutline{"triangle", triangle},
                               NamedOutline{"star with holes", starWithHoles},
                               NamedOutline{"comb", comb},
                               NamedOutline{"elbow", elbow},
                               NamedOutline{"lattice", lattice},
                               NamedOutline{"far away", farAway},
                               NamedOutline{"star with holes", starWithHoles},
                               NamedOutline{"comb", comb}};
constexpr std::array kSeeds{NamedSeeds{"uniform", uniform},         NamedSeeds{"few", few},
                            NamedSeeds{"lattice", latticeSeeds},    NamedSeeds{"grid", grid},
                            NamedSeeds{"collinear", collinear},     NamedSeeds{"duplicates", duplicates},
                            NamedSeeds{"1 ulp apart", oneUlpApart}, NamedSeeds{"on the outline", onTheOutline},
                            NamedSeeds{"outside", outside}};
constexpr std::uint64_t kThousandCornersEvery = 200;

std::string jsonOf(const std::vector<Vec2>& points) {
    std::string text;
    for (const Vec2 point : points) {
        std::array<char, 64> buffer;
        std::snprintf(buffer.data(), buffer.size(), "%s[%.17g,%.17g]", text.empty() ? "" : ",", point.x, point.y);
        text += buffer.data();
    }
    return "[" + text + "]";
}

}  // namespace

FractureCase fractureCase(std::uint64_t number) {
    Random random(number);
    NamedOutline outline = kOutlines[number % kOutlines.size()];
    if (number % kThousandCornersEvery == 7) outline = {"1,000 corners", thousandCorners};
    const NamedSeeds seeds = kSeeds[number / kOutlines.size() % kSeeds.size()];
    FractureCase result{number,
                        std::string(outline.name) + ", " + seeds.name + " seeds",
                        withCanonicalWinding(outline.make(random)),
                        {}};
    result.seeds = seeds.make(result.outline, random);
    return result;
}

std::string jsonOf(const FractureCase& fractureCase) {
    std::string holes;
    for (const Ring& hole : fractureCase.outline.holes) holes += (holes.empty() ? "" : ",") + jsonOf(hole);
    return "{\"outline\":" + jsonOf(fractureCase.outline.outer) + ",\"holes\":[" + holes +
           "],\"depth\":1,\"seeds\":" + jsonOf(fractureCase.seeds) + "}";
}

}  // namespace rubble::oracle
