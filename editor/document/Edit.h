#pragma once

#include "core/asset/Project.h"

#include <QString>

#include <optional>
#include <variant>
#include <vector>

namespace rubble {

/// What a project's scene is besides its instances; edited as one value.
struct SceneSettings {
    Ground ground;
    Vec3 gravity{0.0, -9.81, 0.0};  // m/s^2
    Damage damage;
    Debris debris;
    bool operator==(const SceneSettings&) const = default;
};

/// The kinds of things a project holds.
enum class Part { Material, Asset, Instance, Shot, PlayTest, Scene };
enum class ChangeKind { Added, Removed, Altered };

/// What became of one thing.
struct Change {
    Part part = Part::Asset;
    Id id = 0;  // 0 for Part::Scene
    ChangeKind kind = ChangeKind::Altered;
    bool operator==(const Change&) const = default;
};
/// All that one edit changed; everything where another project came in its place.
struct Changes {
    std::vector<Change> list;
    bool isEverything = false;
    bool isStepTaken = false;  // by undo or redo: what is being dragged is not what is there any more

    bool touches(Part part) const;
    bool touches(Part part, Id id) const;
};

/// Another value for the thing with an id; none: it is not there.
template <class Value>
struct Swap {
    Id id = 0;
    std::optional<Value> value;
};
using AnySwap = std::variant<Swap<Material>, Swap<Asset>, Swap<Instance>, Swap<Shot>, Swap<PlayTest>, SceneSettings>;

/// A new state for parts of a project, as values. Carrying it out swaps them with what was there, so that carrying it out
/// again undoes it. It names each thing once.
struct Edit {
    QString text;                // what the user did: "Move seed"
    std::vector<AnySwap> swaps;  // of things with different ids
    std::optional<Id> nextId;    // where ids were taken
    quint64 stroke = 0;          // edits of one drag carry the same number and become one step; 0: a step of its own
    bool isEmpty() const { return swaps.empty(); }

    /// Takes a fresh id from the project, or the next one.
    Id takeId(const Project& project);
};

/// Exchanges the edit's values with the project's, and says what changed.
Changes swapInto(Project& project, Edit& edit);

/// Joins `later`, carried out after `earlier`, both already swapped, into `earlier`.
void join(Edit& earlier, Edit&& later);

/// True where carrying out the edit would change nothing.
bool isNoChange(const Project& project, const Edit& edit);

SceneSettings sceneSettings(const Project& project);

}  // namespace rubble
