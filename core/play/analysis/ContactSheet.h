#pragma once

#include "core/asset/bake/AssetBakes.h"
#include "core/asset/bake/VariantGeneration.h"
#include "core/play/events/EventHistory.h"
#include "core/play/session/SavedSession.h"

#include <functional>

namespace rubble {

/// A measure by which the variants of a sheet can be compared and sorted.
enum class SheetMeasure {
    Number,            // in order of generation
    Fragments,         // number of leaf fragments
    SmallestFragment,  // m³
    Aspect,            // of the most elongated leaf fragment: see aspectRatio()
    BreakImpact,       // N·s: the impact that first broke an instance of the asset
    DebrisHeight,      // m above the ground: the top of its highest fragment at the step
};
inline constexpr int kSheetMeasures = 6;

/// The name of a measure in files, such as "smallestPiece".
const char* nameOf(SheetMeasure measure);

/// The shots that all variants are played with, and the step at which they are compared.
struct SheetStage {
    std::vector<Id> shots;                      // of the project
    std::uint64_t step = 0;                     // number of steps played
    double stepLength = 1.0 / 60.0;             // s; with a state its own
    std::shared_ptr<const SavedSession> state;  // that they start from, in which the asset is intact; null: the scene
    bool operator==(const SheetStage&) const = default;
};

/// The measures of one variant; those of play only with a stage.
struct SheetFigures {
    std::uint32_t fragments = 0;
    double smallestFragment = 0.0;       // m³
    double aspect = 1.0;                 // of the most elongated leaf
    bool isPlayed = false;               // the request has a stage
    std::optional<double> breakImpact;   // N·s; none: no instance of it broke
    std::optional<double> debrisHeight;  // m; none: no instance of it broke, or no fragment is left

    std::optional<double> value(SheetMeasure measure, std::uint32_t number) const;
    bool operator==(const SheetFigures&) const = default;
};

/// One variant of an asset on a contact sheet.
struct SheetEntry {
    std::uint32_t number = 0;  // its index among the variants
    Asset asset;
    std::shared_ptr<const Bake> bake;  // null if it cannot be fractured
    SheetFigures figures;
    std::shared_ptr<const Session> session;  // with a stage: at its step; release it after drawing
    EventHistory history;                    // what it reported until then
    std::optional<std::string> fault;        // why it could not be baked or played, as a sentence
};

/// The input of a contact sheet. Each variant replaces the asset in all of its instances.
struct SheetRequest {
    Project project;
    AssetBakes bakes;  // of other assets of the project; missing ones are computed
    Id asset = 0;
    std::vector<Asset> variants;      // of that asset, with its id
    std::optional<SheetStage> stage;  // none: variants at rest
};

/// The project with a variant in place of its asset, used by all instances.
Project projectWith(const Project& project, const Asset& variant);

/// Bakes and measures the variants on task.threads and passes each to `take` when it is done: from any thread, but one
/// at a time, in any order. A variant that cannot be baked or played is passed with its fault. The same bits on any
/// number of threads.
///
/// Errors: NotFound for a missing asset or shot, or a stage without an instance of the asset; those of bakesOf() and
/// playScene() for the rest of the project; Cancelled.
Status makeContactSheet(const SheetRequest& request, const std::function<void(SheetEntry)>& take,
                        const TaskContext& task = {});

/// Indices into `entries`, stably sorted by a measure, ascending; entries without a value last.
std::vector<std::uint32_t> sortedBy(SheetMeasure measure, std::span<const SheetEntry> entries);

}  // namespace rubble
