#pragma once

#include "core/asset/AssetBakes.h"
#include "core/asset/Breeding.h"
#include "core/play/Session.h"

#include <functional>

namespace rubble {

/// What the variants of a sheet are measured by.
enum class SheetMeasure {
    Number,         // as they were made
    Pieces,         // how many smallest fragments
    SmallestPiece,  // m^3
    Aspect,         // of the longest smallest fragment: see aspectOf()
    BreakImpact,    // N s: what first broke an instance of the asset under the shot
    DebrisHeight,   // m above the ground: how high its highest piece lies at the step
};
inline constexpr int kSheetMeasures = 6;

/// "smallestPiece", as it stands on command lines and in files.
const char* nameOf(SheetMeasure measure);

/// The shots under which all variants are looked at, and when.
struct SheetStage {
    std::vector<Id> shots;           // of the project
    std::uint64_t step = 0;          // so many steps after the start
    double stepLength = 1.0 / 60.0;  // s
    bool operator==(const SheetStage&) const = default;
};

/// The figures of one variant; those of play only where there is a stage, and something to be told.
struct SheetFigures {
    std::uint32_t pieces = 0;
    double smallestPiece = 0.0;          // m^3
    double aspect = 1.0;                 // of the longest
    bool isPlayed = false;               // there is a stage
    std::optional<double> breakImpact;   // N s; none: no instance of it broke
    std::optional<double> debrisHeight;  // m; none: no instance of it broke, or nothing of it is left

    std::optional<double> value(SheetMeasure measure, std::uint32_t number) const;
    bool operator==(const SheetFigures&) const = default;
};

/// One variant of an asset on a contact sheet.
struct SheetEntry {
    std::uint32_t number = 0;  // its place among the variants
    Asset asset;
    std::shared_ptr<const Bake> bake;  // null where it cannot be broken
    SheetFigures figures;
    std::shared_ptr<const Session> moment;  // where there is a stage: as it is at its step, to be drawn and let go of
    std::optional<std::string> fault;       // a sentence on what kept it from being baked or played
};

/// What a sheet is made of. Variants take the place of the asset in all of its instances, whichever variant those ask for.
struct SheetOrder {
    Project project;
    AssetBakes bakes;  // of other assets of the project, as far as they are there; what is missing is baked
    Id asset = 0;
    std::vector<Asset> variants;      // of that asset, with its id
    std::optional<SheetStage> stage;  // none: pieces at rest
};

/// The project with a variant in the place of its asset, and in all of its instances.
Project projectWith(const Project& project, const Asset& variant);

/// Bakes and measures the variants, several at a time on task.threads, and hands each over as it is there: from any thread, but
/// one at a time, in any order. One that cannot be baked or played is handed over with its fault, so that the others are there
/// all the same. The same bits on any number of threads.
///
/// Errors: NotFound where the project has no such asset or shot, or a stage but no instance of the asset; those of bakesOf()
/// and playScene() for what is no variant; Cancelled.
Status makeContactSheet(const SheetOrder& order, const std::function<void(SheetEntry)>& take,
                        const TaskContext& task = {});

/// The entries by a measure, ascending, as indices in `entries`; those without a value last, equal ones in their order.
std::vector<std::uint32_t> sortedBy(SheetMeasure measure, std::span<const SheetEntry> entries);

}  // namespace rubble
