#pragma once

#include "docs/formats/rubble_pack.hpp"

#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>
#include <vector>

/// What conformance.mjs does for engines of node, for those in C++: places the fragments of a pack in a world of the
/// engine, and prints, as a line of JSON, what bodies it has and how they move. conformance.mjs checks it.
namespace rubble::exchange {

using rubble_pack::Vec3;

struct Quaternion {
    double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
};

/// A fragment and its pose in the world.
struct Placed {
    const rubble_pack::Body* body = nullptr;
    Vec3 position;
    Quaternion rotation;
};

/// A body as an engine has it.
struct Found {
    double mass = 0.0;
    std::array<double, 6> inertia{};  // xx, yy, zz, xy, xz, yz
    double friction = 0.0;
    Vec3 position;
};

/// What to measure: the arguments of a program.
struct Task {
    rubble_pack::Pack pack;
    std::vector<Placed> bodies;
    std::string setting;
};

constexpr double kStep = 1.0 / 60.0;  // s
constexpr int kStandingSteps = 300;

/// A rotation by a right angle about x, after which the outline is level.
inline Vec3 laid(Vec3 point) { return {point.x, point.z, -point.y}; }
inline Quaternion laying() { return {-std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)}; }

/// `program PACK whole|leaves stands|lies SETTING`. Exits with 2 where these are wrong.
inline Task taskOf(int count, char** arguments) {
    Task task;
    std::string fault = "usage: PACK whole|leaves stands|lies SETTING";
    if (count != 5 || !rubble_pack::load(arguments[1], task.pack, fault)) {
        std::cerr << fault << '\n';
        std::exit(2);
    }
    const bool isLeaves = std::strcmp(arguments[2], "leaves") == 0;
    const bool lies = std::strcmp(arguments[3], "lies") == 0;
    task.setting = arguments[4];
    for (std::uint32_t k = 0; k < task.pack.fragments.size(); ++k) {
        const rubble_pack::Body& body = task.pack.fragments[k];
        if (isLeaves ? !task.pack.piecesOf(k).empty() : body.parent != rubble_pack::kNone) continue;
        task.bodies.push_back({&body, lies ? laid(body.offset) : body.offset, lies ? laying() : Quaternion{}});
    }
    return task;
}

inline double lowest(const std::vector<Placed>& bodies) {
    double least = std::numeric_limits<double>::infinity();
    for (const Placed& placed : bodies) {
        for (const rubble_pack::Hull& hull : placed.body->hulls) {
            for (const Vec3& vertex : hull.vertices) {
                least = std::min(least, placed.position.y + (placed.rotation.w < 1.0 ? laid(vertex) : vertex).y);
            }
        }
    }
    return least;
}

inline double distance(Vec3 a, Vec3 b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

/// The largest distance between two lists of points.
inline double farthest(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
    double most = 0.0;
    for (std::size_t k = 0; k < from.size(); ++k) {
        const double moved = distance(from[k], to[k]);
        if (!(moved <= most)) most = moved;  // also what is no number
    }
    return most;
}

/// `World`: World(gravity, setting), addFloor(height, friction), add(placed, material), step(), and of its bodies, in
/// the order in which they were added, found(k), position(k), velocity(k).
template <class World>
std::vector<Vec3> positionsIn(const World& world, std::size_t count) {
    std::vector<Vec3> positions;
    for (std::size_t k = 0; k < count; ++k) positions.push_back(world.position(k));
    return positions;
}

template <class World>
void printFound(const World& world, std::size_t count) {
    std::printf("\"found\":[");
    for (std::size_t k = 0; k < count; ++k) {
        const Found is = world.found(k);
        const auto& i = is.inertia;
        std::printf("%s{\"mass\":%.9g,\"inertia\":[[%.9g,%.9g,%.9g],[%.9g,%.9g,%.9g],[%.9g,%.9g,%.9g]],",
                    k == 0 ? "" : ",", is.mass, i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2]);
        std::printf("\"friction\":%.9g,\"position\":[%.9g,%.9g,%.9g]}", is.friction, is.position.x, is.position.y,
                    is.position.z);
    }
    std::printf("],");
}

/// m/s: engines may also move bodies without giving them a velocity.
template <class World>
double fastest(const World& world, const std::vector<Vec3>& start) {
    std::vector<Vec3> velocities;
    for (std::size_t k = 0; k < start.size(); ++k) velocities.push_back(world.velocity(k));
    return std::max(farthest(std::vector<Vec3>(start.size()), velocities),
                    farthest(start, positionsIn(world, start.size())) / kStep);
}

template <class World>
int measure(const Task& task) {
    const std::vector<Placed>& bodies = task.bodies;
    double swap = 0.0;
    {
        World world({}, task.setting);
        for (const Placed& body : bodies) world.add(body, task.pack.material);
        std::printf("{");
        printFound(world, bodies.size());
        const std::vector<Vec3> start = positionsIn(world, bodies.size());
        world.step();
        swap = fastest(world, start);
    }
    World world({0.0, -9.81, 0.0}, task.setting);
    world.addFloor(lowest(bodies), task.pack.material.friction);
    for (const Placed& body : bodies) world.add(body, task.pack.material);
    const std::vector<Vec3> start = positionsIn(world, bodies.size());
    std::vector<Vec3> halfway;
    for (int step = 0; step < kStandingSteps; ++step) {
        world.step();
        if (step == kStandingSteps / 2) halfway = positionsIn(world, bodies.size());
    }
    const std::vector<Vec3> end = positionsIn(world, bodies.size());
    std::printf("\"swap\":%.9g,\"standing\":%.9g,\"drift\":%.9g}\n", swap, farthest(start, end),
                farthest(halfway, end));
    return 0;
}

}  // namespace rubble::exchange
