#pragma once

#include "core/asset/import/AssetImport.h"
#include "core/asset/import/SurfaceFit.h"

#include <map>
#include <memory>

namespace rubble {

/// An object of a mesh file, or a part of one, in metres and y up.
struct ImportPart {
    std::string name;
    bool hasUvs = false;
    TriangleMesh mesh;                      // welded
    std::vector<SourceTriangle> triangles;  // the triangles of the file, one per triangle of the mesh
    double tolerance = 0.0;                 // m
    double rounding = 0.0;                  // m: the most by which the file's numbers displace a point; 0: unknown
    std::vector<Pose> copies;               // motions in the world to where else it stands
    std::vector<std::string> notes;
    TriangleMesh unwelded;         // of a whole object: its mesh before welding, which a closed mesh is made of
    std::optional<Error> noPrism;  // why it is not tried as a prism: it has a cavity
};

/// The triangles of an object in the world: in metres, y up.
TriangleMesh meshInWorld(const SourceObject& object, double metresPerUnit, UpAxis up);

/// Welds an object and splits it into its connected parts, unless it is to be, or may be and has a cavity, a closed
/// mesh as a whole.
///
/// Errors: BadInput with the place of a mesh that lies too far from the origin; those of welded(); of prisms,
/// Degenerate if a part is the wall of a cavity; Limit above 1000 parts.
Result<std::vector<ImportPart>> partsToImport(const SourceObject& object, double metresPerUnit, UpAxis up,
                                              ImportShape as);

/// Whether all points of a part lie in one plane. Such a part is never imported.
bool isFlat(const ImportPart& part);

/// A prism with the surface of the mesh it was fitted to, or a closed mesh.
struct ImportedSolid {
    std::optional<PrismFit> prism;  // this or the following
    std::optional<SolidFit> closed;
    bool usesFallback = false;
    double tolerance = 0.0;  // m: that of the part, or more where its points are rounded
    FittedSurface surface;   // of a prism
    std::optional<Texture> texture;
    std::uint32_t material = 0;  // of the scene: the one with the largest area
    std::vector<std::string> notes;
    /// Of the asset's frame, in the world.
    Pose pose() const { return closed ? Pose{closed->position, {1.0, 0.0, 0.0, 0.0}} : prism->pose; }
    /// Of the asset.
    std::variant<Prism, std::shared_ptr<const ClosedMesh>> shape() const;
};

/// What became of a part.
struct PartOutcome {
    Result<ImportedSolid> solid;
    std::optional<MeshProblem> problem;  // if it was rejected as a closed mesh
};

/// Images of a scene that textures share, by their index.
using TextureImages = std::map<std::uint32_t, std::shared_ptr<const EncodedImage>>;

/// Fits a prism to a part, or uses its fallback, or the part as a closed mesh. A part that is a prism but for the
/// rounding of its file is imported as the prism between its caps, with a note.
///
/// Errors: those of orientedSolid() and fitPrism(), or of fallbackPrism(); Degenerate if the file's rounding is too
/// coarse for the size of the part, or with the fault that judgeMesh() finds and, if it is closed, why it is not a
/// prism; Cancelled.
PartOutcome importedSolid(const ImportPart& part, const SourceScene& scene, const ImportOptions& options,
                          TextureImages& images, const TaskContext& context);

}  // namespace rubble
