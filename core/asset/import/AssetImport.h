#pragma once

#include "core/asset/import/SolidFit.h"
#include "core/asset/project/Project.h"
#include "core/base/TaskContext.h"
#include "core/geometry/mesh/SourceScene.h"
#include "core/geometry/mesh/UpAxis.h"
#include "core/geometry/prism/PrismFit.h"

#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// What objects of a mesh file become.
enum class ImportShape {
    Auto,   // each unconnected part a prism if it is one, or its fallback if that is wanted, else a closed mesh; an
            // object with a cavity a closed mesh as a whole
    Prism,  // each unconnected part a prism, or its fallback
    Solid,  // each object a closed mesh, with all its parts and cavities
};

/// The options for importing a mesh file.
struct ImportOptions {
    std::optional<double> metresPerUnit;    // overrides the unit of the file; without either: metres
    UpAxis up = UpAxis::Y;                  // of the file; the world's is y
    ImportShape as = ImportShape::Auto;     // prisms or closed meshes
    PrismAxis axis = PrismAxis::Thinnest;   // of the prism, in the world
    std::optional<PrismFallback> fallback;  // for objects that are not prisms
    std::string asset;                      // the asset to reimport or to create; empty: one per object
    bool mergesEqual = false;               // objects that are equal but for their poses become one asset
    bool isFixed = false;                   // the new instances
    bool isUnbreakable = false;             // the new instances
    bool findsFallbacks = false;            // of rejected objects; takes about as long as importing them
};

/// An asset created or replaced by an import.
struct ImportedAsset {
    Id asset = 0;
    bool isReplaced = false;        // an existing asset got a new shape, surface and texture and kept everything else
    bool usesFallback = false;      // the object is not a prism
    std::size_t merged = 0;         // equal objects that are further instances of it
    std::optional<PrismFit> prism;  // this or the following
    std::optional<SolidFit> solid;
    double tolerance = 0.0;          // m, of a prism; 0: a mesh is imported as it is
    std::vector<std::string> notes;  // sentences: what was merged, flipped, omitted, renamed or replaced
};

/// A fallback that was tried and imports a rejected object.
struct WorkingFallback {
    PrismFallback fallback = PrismFallback::Silhouette;
    PrismAxis axis = PrismAxis::Thinnest;  // the requested one if it works
    double volume = 0.0;                   // m³
    /// Whether both set the same options.
    bool operator==(const WorkingFallback& other) const { return fallback == other.fallback && axis == other.axis; }
};

/// An object, or a part of one, that is not imported.
struct RejectedObject {
    Error error;                             // names the object
    std::vector<WorkingFallback> fallbacks;  // at most one of each kind; empty unless they were to be found
    std::optional<double> volume;            // m³; unknown if the mesh is no solid, or no fallbacks were to be found
    std::optional<MeshProblem> problem;      // if it cannot be cut as a closed mesh

    /// Whether a fallback changes the volume by more than a hundredth, and so the shape; unknown: no.
    bool isReshapedBy(const WorkingFallback& working) const;
};

struct ImportOutcome {
    Project project;
    double metresPerUnit = 1.0;
    std::vector<ImportedAsset> assets;     // in the file's order
    std::vector<RejectedObject> rejected;  // in the file's order
};

/// Adds the objects of a mesh file to a project as assets, with an instance of each at the mesh's position. Unconnected
/// parts of an object become separate assets, unless it is to be a closed mesh. Assets are named after their objects,
/// or the file; taken names are numbered. Materials are found by name, or added with the file's name and colour. Of
/// several images of an asset the one with the largest area becomes its texture. A reimported asset keeps its id,
/// material, pattern, levels and threshold, and its instances keep their poses. A rejected object does not block the
/// others.
///
/// Objects, or parts of them, are rejected with the errors of welded(), orientedSolid(), fitPrism() and
/// fallbackPrism(), or with the fault that judgeMesh() finds.
/// Errors: NotFound if none of several objects has the name of the requested asset; Degenerate if that object has
/// several parts; BadInput if the unit is not greater than zero; Cancelled.
Result<ImportOutcome> importedInto(Project project, const SourceScene& scene, const std::string& fileName,
                                   const ImportOptions& options, const TaskContext& context);

}  // namespace rubble
