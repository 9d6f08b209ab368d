#include "tests/support/scenes/SlidingScenes.h"

#include "core/base/math/Trigonometry.h"
#include "tests/support/scenes/BodyShapes.h"
#include "tests/support/scenes/SceneParts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rubble::test {
namespace {

constexpr double kGravity = 9.81;       // m/s²
constexpr double kTileThickness = 0.5;  // m
constexpr double kMargin = 2.0;         // m: tiles beyond the ends of the path
constexpr double kDegree = std::numbers::pi / 180.0;

enum class TileArrangement { Row, Grid, RunningBond };
enum class TileBodies { OnePerTile, OneOfAllTiles };

struct Tiles {
    Vec2 size{1.0, 1.0};  // m, along x and z
    TileArrangement arrangement = TileArrangement::Row;
    TileBodies bodies = TileBodies::OnePerTile;
};

struct Slide {
    std::string name;
    std::vector<Polytope> hulls;
    double height = 0.0;  // m, of the sliding body
    double speed = 0.0;   // m/s
    double friction = 0.1;
    double direction = 0.0;  // degrees from x to z
    double rotation = 0.0;   // degrees about the vertical
    Tiles tiles;
};

double slidingDistance(const Slide& slide) { return slide.speed * slide.speed / (2.0 * slide.friction * kGravity); }

/// Tiles under a path from the origin.
std::vector<Vec3> tileCentres(const Tiles& tiles, Vec3 end) {
    std::vector<Vec3> centres;
    const auto first = [](double low, double size) { return static_cast<int>(std::floor((low - kMargin) / size)); };
    const auto last = [](double high, double size) { return static_cast<int>(std::ceil((high + kMargin) / size)); };
    const bool isRow = tiles.arrangement == TileArrangement::Row;
    const int rowFirst = isRow ? 0 : first(std::min(0.0, end.z), tiles.size.y);
    const int rowLast = isRow ? 0 : last(std::max(0.0, end.z), tiles.size.y);
    for (int row = rowFirst; row <= rowLast; ++row) {
        const bool isShifted = tiles.arrangement == TileArrangement::RunningBond && row % 2 != 0;
        for (int k = first(std::min(0.0, end.x), tiles.size.x); k <= last(std::max(0.0, end.x), tiles.size.x); ++k) {
            const double place = k + (isShifted ? 0.5 : 0.0);
            centres.push_back({tiles.size.x * place, -0.5 * kTileThickness, tiles.size.y * row});
        }
    }
    return centres;
}

void addTiles(BodyScene& scene, const Tiles& tiles, Vec3 end) {
    const Polytope tile = boxOf({tiles.size.x, kTileThickness, tiles.size.y});
    const std::vector<Vec3> centres = tileCentres(tiles, end);
    if (tiles.bodies == TileBodies::OneOfAllTiles) {
        std::vector<Polytope> hulls;
        for (const Vec3& centre : centres) hulls.push_back(translated(tile, centre));
        scene.bodies.push_back({.name = "tiles", .kind = BodyKind::Static, .shape = addShape(scene, std::move(hulls))});
        return;
    }
    const std::uint32_t shape = addShape(scene, {tile});
    for (const Vec3& centre : centres) {
        scene.bodies.push_back({.name = "tile " + std::to_string(scene.bodies.size()),
                                .kind = BodyKind::Static,
                                .pose = {.position = centre},
                                .shape = shape});
    }
}

SlidingScene sceneOf(const Slide& slide) {
    SlidingScene result{.name = slide.name, .distance = slidingDistance(slide)};
    result.direction = {cosine(kDegree * slide.direction), 0.0, sine(kDegree * slide.direction)};
    addTiles(result.scene, slide.tiles, result.distance * result.direction);
    const double half = 0.5 * kDegree * slide.rotation;
    const std::uint32_t shape = addShape(result.scene, slide.hulls);
    addFreeBody(result.scene, "sliding", shape,
                {{0.0, 0.5 * slide.height, 0.0}, Quat(cosine(half), 0.0, sine(half), 0.0)});
    result.scene.bodies.back().velocity = slide.speed * result.direction;
    for (SceneBody& body : result.scene.bodies) body.friction = slide.friction;
    return result;
}

constexpr Tiles gridOf(double width) { return {.size = {width, width}, .arrangement = TileArrangement::Grid}; }

std::vector<Polytope> cube(double side) { return {boxOf(Vec3(side))}; }

std::vector<Polytope> twoHalves(double side) {
    const Polytope half = boxOf({0.5 * side, side, side});
    return {translated(half, {-0.25 * side, 0.0, 0.0}), translated(half, {0.25 * side, 0.0, 0.0})};
}

std::vector<Slide> slidesOverRows() {
    return {
        {.name = "row of 1 m", .hulls = cube(0.5), .height = 0.5, .speed = 5.0, .tiles = {{1.0, 4.0}}},
        {.name = "row of 25 cm", .hulls = cube(0.5), .height = 0.5, .speed = 5.0, .tiles = {{0.25, 4.0}}},
        {.name = "rotated by 30 degrees",
         .hulls = cube(0.5),
         .height = 0.5,
         .speed = 5.0,
         .rotation = 30.0,
         .tiles = {{0.5, 4.0}}},
        {.name = "slow", .hulls = cube(0.5), .height = 0.5, .speed = 0.5, .friction = 0.02, .tiles = {{0.1, 4.0}}},
        {.name = "fast", .hulls = cube(0.5), .height = 0.5, .speed = 15.0, .friction = 0.3, .tiles = {{1.0, 4.0}}},
        {.name = "box of 10 cm", .hulls = cube(0.1), .height = 0.1, .speed = 3.0, .tiles = {{0.5, 4.0}}},
        {.name = "plate",
         .hulls = {boxOf({0.6, 0.05, 0.6})},
         .height = 0.05,
         .speed = 4.0,
         .friction = 0.2,
         .tiles = {{0.3, 4.0}}},
        {.name = "frame", .hulls = frameHulls(0.6, 0.1, 0.1), .height = 0.1, .speed = 4.0, .tiles = {{0.5, 4.0}}},
        {.name = "two hulls", .hulls = twoHalves(0.5), .height = 0.5, .speed = 4.0, .tiles = {{0.5, 4.0}}},
        {.name = "tiles of one body",
         .hulls = cube(0.5),
         .height = 0.5,
         .speed = 4.0,
         .tiles = {.size = {0.5, 4.0}, .bodies = TileBodies::OneOfAllTiles}},
    };
}

std::vector<Slide> slidesOverGrids() {
    return {
        {.name = "grid", .hulls = cube(0.5), .height = 0.5, .speed = 4.0, .tiles = gridOf(0.5)},
        {.name = "diagonal", .hulls = cube(0.5), .height = 0.5, .speed = 4.0, .direction = 45.0, .tiles = gridOf(0.5)},
        {.name = "at 20 degrees",
         .hulls = cube(0.5),
         .height = 0.5,
         .speed = 4.0,
         .direction = 20.0,
         .tiles = gridOf(0.4)},
        {.name = "diagonal and rotated",
         .hulls = cube(0.5),
         .height = 0.5,
         .speed = 4.0,
         .direction = 45.0,
         .rotation = 45.0,
         .tiles = gridOf(0.5)},
        {.name = "box of 1.5 m", .hulls = cube(1.5), .height = 1.5, .speed = 4.0, .tiles = gridOf(0.4)},
        {.name = "running bond",
         .hulls = cube(0.4),
         .height = 0.4,
         .speed = 4.0,
         .direction = 10.0,
         .tiles = {.size = {0.6, 0.3}, .arrangement = TileArrangement::RunningBond}},
    };
}

/// A box that slides over one tile, in the `direction`-th of sixteen directions.
Slide slideAcross(Vec2 footprint, double height, int direction) {
    const std::string name = std::to_string(footprint.x) + " x " + std::to_string(height) + " x " +
                             std::to_string(footprint.y) + ", direction " + std::to_string(direction);
    return {.name = name,
            .hulls = {boxOf({footprint.x, height, footprint.y})},
            .height = height,
            .speed = 4.0,
            .friction = 0.3,
            .direction = 22.5 * direction,
            .tiles = {.size = {20.0, 20.0}}};
}

}  // namespace

std::vector<SlidingScene> obliqueSlidingScenes() {
    constexpr std::array kFootprints{Vec2(0.7, 0.3), Vec2(0.3, 0.3), Vec2(1.0, 0.2), Vec2(2.0, 0.5),  Vec2(0.5, 0.1),
                                     Vec2(0.2, 0.8), Vec2(0.4, 0.5), Vec2(1.5, 0.3), Vec2(0.6, 0.15), Vec2(0.9, 0.7)};
    std::vector<SlidingScene> scenes;
    for (const Vec2& footprint : kFootprints) {
        for (const double fraction : {0.3, 0.8, 1.5}) {
            const double height = fraction * std::min(footprint.x, footprint.y);
            for (int direction = 0; direction < 16; ++direction) {
                scenes.push_back(sceneOf(slideAcross(footprint, height, direction)));
            }
        }
    }
    return scenes;
}

std::vector<SlidingScene> slidingScenes() {
    std::vector<SlidingScene> scenes;
    for (const Slide& slide : slidesOverRows()) scenes.push_back(sceneOf(slide));
    for (const Slide& slide : slidesOverGrids()) scenes.push_back(sceneOf(slide));
    return scenes;
}

}  // namespace rubble::test
