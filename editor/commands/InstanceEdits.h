#pragma once

#include "editor/commands/ProjectEdits.h"

#include <array>

namespace rubble {

/// The edits of a scene's instances. Those that are named are there; ids of others are asked for nowhere.

/// Copies along the world's axes.
struct GridArray {
    std::array<int, 3> counts{2, 1, 1};  // along x, y and z, with the instance itself; >= 1
    Vec3 steps{1.0, 1.0, 1.0};           // m, from one to the next
};
/// Copies around a vertical axis, turned with it.
struct RingArray {
    int count = 6;          // with the instance itself; >= 1
    Vec2 middle{0.0, 0.0};  // x and z of the axis, m
    double turn = 1.0;      // rad, from one to the next
};

/// Copies of each of the instances. Those of a ring stand where turning takes them; nothing looks whether there is room.
Edit gridOf(const Project& project, std::span<const Id> instances, const GridArray& array);
Edit ringOf(const Project& project, std::span<const Id> instances, const RingArray& array);

/// Adds an instance of an asset at a place.
Addition placeInstance(const Project& project, Id asset, const Pose& pose);

/// Each of the instances, from the lowest to the highest, falls straight down until it rests on what is below it, or is
/// lifted out of what it stands in: see fallOf().
Edit dropInstances(const Project& project, std::span<const Id> instances);

/// Gives instances variants of their assets that no other instance has, ascending: no two of them break alike then.
Edit spreadVariants(const Project& project, std::span<const Id> instances);

Edit hideInstances(const Project& project, std::span<const Id> instances);
/// Hides all but these.
Edit isolateInstances(const Project& project, std::span<const Id> instances);
Edit showAllInstances(const Project& project);
Edit lockInstances(const Project& project, std::span<const Id> instances);
Edit unlockAllInstances(const Project& project);

/// Instances with other poses, one each. `stroke`: see Edit::stroke.
Edit movedInstances(const QString& text, const Project& project, std::span<const Id> instances,
                    std::span<const Pose> poses, quint64 stroke);

/// The instance with an id, or null.
const Instance* findInstance(const Project& project, Id id);

}  // namespace rubble
