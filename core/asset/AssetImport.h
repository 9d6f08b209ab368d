#pragma once

#include "core/asset/Project.h"
#include "core/base/TaskContext.h"
#include "core/geometry/PrismFinder.h"
#include "core/geometry/SourceScene.h"

#include <optional>
#include <string>
#include <vector>

namespace rubble {

enum class UpAxis { Y, Z };

/// How a mesh file is taken.
struct ImportOptions {
    std::optional<double> metresPerUnit;     // instead of what the file says, or metres
    UpAxis up = UpAxis::Y;                   // the file's; the world's is y
    AxisChoice axis = AxisChoice::Thinnest;  // the world's
    std::optional<PrismFallback> fallback;   // for objects that are no prism
    std::string asset;                       // the asset to import again, or to make; empty: one for each object
};

/// What became of an object.
struct ImportedAsset {
    Id asset = 0;
    bool isReplaced = false;  // an asset that was there took a new prism and surface and kept all else
    bool isStandIn = false;   // its fallback was taken
    FoundPrism prism;
    double tolerance = 0.0;          // m
    std::vector<std::string> notes;  // one sentence each: what was merged, turned, left out, numbered or put in place
};

struct ImportOutcome {
    Project project;
    double metresPerUnit = 1.0;
    std::vector<ImportedAsset> assets;  // in the file's order
    std::vector<Error> refused;         // each names its object; in the file's order
};

/// The project with the objects of a mesh file as assets, and an instance of each where the mesh stands. Parts
/// of an object that are not joined become assets of their own. Assets are named after their objects, or the file;
/// names that are taken are numbered. Materials are found by name, or added with the file's name and colour.
/// An asset that is imported again keeps its id, material, pattern, levels and threshold, and its instances stay where
/// they are. Objects that are refused keep no others from being imported; where all are, the project stays as it was.
///
/// Refused are, with the faults of welded(), solidOf() and findPrism() or standInPrism(), objects or parts of them.
/// Errors: NotFound where an asset is asked for that no object of several is named after; Degenerate where it would be
/// of several parts; BadInput where the unit is not greater than zero; Cancelled.
Result<ImportOutcome> importedInto(Project project, const SourceScene& scene, const std::string& fileName,
                                   const ImportOptions& options, const TaskContext& context);

}  // namespace rubble
