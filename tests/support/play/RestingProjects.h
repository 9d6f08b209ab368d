#pragma once

#include "core/base/math/Trigonometry.h"
#include "tests/support/asset/House.h"

#include <array>
#include <numbers>

namespace rubble::test {

/// A project of one material, whose bodies have a block of 1 x 0.5 x 0.5 m, in eight fragments.
inline Project blockProject() {
    Project project;
    const Id stone = addMaterial(project, {.name = "stone", .density = 2000.0, .friction = 0.7});
    addAsset(project,
             {.name = "block",
              .material = stone,
              .shape = Prism{{rectangle({-0.5, -0.25}, {0.5, 0.25}), {}}, 0.5},
              .threshold = 5000.0},
             {UniformScatter{.count = 8}, LloydRelaxation{.rounds = 2}});
    return project;
}

inline void addBlock(Project& project, Vec3 at) {
    addInstance(project, project.assets[0].id, "block " + std::to_string(project.instances.size()), {.position = at});
}

/// Six stacks of five blocks.
inline Project stackProject() {
    Project project = blockProject();
    for (int stack = 0; stack < 6; ++stack) {
        for (int height = 0; height < 5; ++height) addBlock(project, {2.0 * stack, 0.25 + 0.5 * height, 0.0});
    }
    return project;
}

/// Rows of 12, 11, ..., 1 blocks, each on two.
inline Project pyramidProject() {
    Project project = blockProject();
    for (int row = 0; row < 12; ++row) {
        for (int k = 0; k < 12 - row; ++k) addBlock(project, {k + 0.5 * row, 0.25 + 0.5 * row, 0.0});
    }
    return project;
}

/// Four towers of two blocks with lintels across, storey on storey.
inline Project portalProject() {
    Project project = blockProject();
    const Id lintel = addAsset(project,
                               {.name = "lintel",
                                .material = project.materials[0].id,
                                .shape = Prism{{rectangle({-2.0, -0.125}, {2.0, 0.125}), {}}, 0.5},
                                .threshold = 5000.0},
                               {UniformScatter{.count = 6}});
    for (int portal = 0; portal < 3; ++portal) {
        for (int storey = 0; storey < 3; ++storey) {
            const double x = 6.0 * portal, y = 1.25 * storey;
            for (const double side : {-1.5, 1.5}) {
                for (int k = 0; k < 2; ++k) addBlock(project, {x + side, y + 0.25 + 0.5 * k, 0.0});
            }
            const std::string name = "lintel " + std::to_string(portal) + "." + std::to_string(storey);
            addInstance(project, lintel, name, {.position = {x, y + 1.125, 0.0}});
        }
    }
    return project;
}

/// Three half-circle arches of nine stones, of 2 m inner and 2.6 m outer radius, between fixed abutments.
inline Project archProject() {
    constexpr int kStones = 9;
    Project project = blockProject();
    const double half = std::numbers::pi / kStones / 2.0;
    const auto corner = [](double radius, double angle) { return Vec2(radius * cosine(angle), radius * sine(angle)); };
    const std::vector<Vec2> ring{corner(2.0, -half), corner(2.6, -half), corner(2.6, half), corner(2.0, half)};
    const Id stone = addAsset(
        project,
        {.name = "voussoir", .material = project.materials[0].id, .shape = Prism{{ring, {}}, 0.6}, .threshold = 9000.0},
        {UniformScatter{.count = 5}});
    for (int arch = 0; arch < 3; ++arch) {
        for (int k = 0; k < kStones; ++k) {
            const double angle = (2 * k + 1) * half;
            const std::string name = "voussoir " + std::to_string(arch) + "." + std::to_string(k);
            addInstance(project, stone, name,
                        {{7.0 * arch, 0.0, 0.0}, Quat{cosine(angle / 2.0), 0.0, 0.0, sine(angle / 2.0)}});
        }
    }
    return project;
}

/// Blocks above each other that break and fall into a heap: `columns` x 6 blocks of eight fragments.
inline Project heapProject(int columns) {
    Project project = blockProject();
    for (int column = 0; column < columns; ++column) {
        for (int height = 0; height < 6; ++height) {
            addBlock(project, {1.05 * (column % 4), 0.6 + 0.6 * height, 0.55 * (column / 4)});
        }
    }
    return project;
}

}  // namespace rubble::test
