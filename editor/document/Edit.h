#pragma once

#include "core/asset/project/Project.h"

#include <QString>

#include <optional>
#include <variant>
#include <vector>

namespace rubble {

/// The settings of a project's scene, without its instances; edited as one value.
struct SceneSettings {
    Ground ground;
    Vec3 gravity{0.0, -9.81, 0.0};  // m/s²
    Damage damage;
    Debris debris;
    EventSettings events;
    bool operator==(const SceneSettings&) const = default;
};

/// The kinds of elements of a project.
enum class Part { Material, Asset, Instance, Shot, PlayTest, Mortar, Scene };
enum class ChangeKind { Added, Removed, Modified };

/// A change of one element.
struct Change {
    Part part = Part::Asset;
    Id id = 0;  // 0 for Part::Scene
    ChangeKind kind = ChangeKind::Modified;
    bool operator==(const Change&) const = default;
};
/// The changes of one edit.
struct Changes {
    std::vector<Change> list;
    bool isEverything = false;  // the project was replaced
    bool isUndoOrRedo = false;  // a drag in progress must end: its state is outdated

    bool touches(Part part) const;
    bool touches(Part part, Id id) const;
};

/// A new value for the element with an id; none removes the element.
template <class Value>
struct Replacement {
    Id id = 0;
    std::optional<Value> value;
};
using AnyReplacement = std::variant<Replacement<Material>, Replacement<Asset>, Replacement<Instance>, Replacement<Shot>,
                                    Replacement<PlayTest>, Replacement<Mortar>, SceneSettings>;

/// New values for some elements of a project. Applying it exchanges them with the project's, so that applying it again
/// undoes it. It contains each element at most once.
struct Edit {
    QString text;                              // of the undo step: "Move Seed"
    std::vector<AnyReplacement> replacements;  // of different elements
    std::optional<Id> nextId;                  // if ids were allocated
    Id lastReused = 0;     // the last id allocated when the project's nextId could not advance any more
    quint64 mergeKey = 0;  // edits with the same key, those of one drag, become one undo step; 0: no merging
    bool isEmpty() const { return replacements.empty(); }

    /// Returns a fresh id: the project's next one, or the one after the last allocated here; the lowest unused one if
    /// that is the greatest id.
    Id allocateId(const Project& project);
};

/// Exchanges the edit's values with the project's and returns the changes.
Changes applyEdit(Project& project, Edit& edit);

/// Takes back applyEdit(), right after it; needs no memory.
void revertEdit(Project& project, Edit& edit);

/// Merges `later` into `earlier`. Both are applied already, in this order.
void merge(Edit& earlier, Edit&& later);

/// Whether applying the edit would change nothing.
bool isNoChange(const Project& project, const Edit& edit);

SceneSettings sceneSettings(const Project& project);

}  // namespace rubble
