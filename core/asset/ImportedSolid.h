#pragma once

#include "core/asset/AssetImport.h"
#include "core/asset/SurfaceFit.h"

namespace rubble {

/// An object of a mesh file, or a part of one, in metres and y up.
struct ImportPart {
    std::string name;
    bool hasUvs = false;
    TriangleMesh mesh;                      // welded
    std::vector<SourceTriangle> triangles;  // what each triangle of the mesh was in the file
    double tolerance = 0.0;                 // m
    std::vector<std::string> notes;
};

/// The triangles of an object where they stand in the world: in metres, y up.
TriangleMesh meshInWorld(const SourceObject& object, double metresPerUnit, UpAxis up);

/// Welds an object and takes it apart where it is of several parts that are not joined.
///
/// Errors: those of welded(); Degenerate where a part is the wall of a cavity; Limit above 1000 parts.
Result<std::vector<ImportPart>> partsToImport(const SourceObject& object, double metresPerUnit, UpAxis up);

/// A prism with the look of the mesh that it was found in.
struct ImportedSolid {
    FoundPrism found;
    bool isStandIn = false;
    FittedSurface look;
    std::uint32_t material = 0;  // of the scene, the one with the most area
    std::vector<std::string> notes;
};

/// Errors: those of solidOf() and findPrism(), or of standInPrism().
Result<ImportedSolid> importedSolid(const ImportPart& part, const SourceScene& scene, const ImportOptions& options);

}  // namespace rubble
