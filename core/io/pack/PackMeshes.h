#pragma once

#include "core/base/TaskContext.h"
#include "core/io/exchange/ObjFile.h"
#include "core/io/exchange/PackBuilder.h"
#include "core/io/output/ExportFolder.h"

#include <string>
#include <vector>

namespace rubble {

/// The distribution of fragments among mesh files.
enum class FileSplit {
    Single,       // the leaf fragments in one file, the broken fragments of each level in another
    PerFragment,  // one file per fragment
};

/// The faces of an OBJ file. GLB files always have triangles.
enum class FaceShape { Polygons, Triangles };

enum class GlbKind {
    Plain,
    Physics,  // with rigid bodies, and the hulls of the pack as colliders
    Compact,  // small and drawn at once, see compactGlbFile()
    Named,    // with the hulls as meshes whose names Unreal Engine reads
};

/// The mesh files that an export writes.
struct MeshOptions {
    bool obj = true;
    bool glb = true;
    bool usd = false;   // the whole, and the fragments that do not break
    bool mjcf = false;  // these fragments
    FileSplit split = FileSplit::Single;
    PartPlacement place = PartPlacement::Assembled;
    FaceShape faces = FaceShape::Polygons;
    ObjFrame objFrame;
    GlbKind glbKind = GlbKind::Plain;
    bool operator==(const MeshOptions&) const = default;
};

/// The memory that the meshes of a fragment take while they are exported, bytes. Measured with 20,000 fragments.
double meshBytesPerFragment(const MeshOptions& options);

/// The mesh files of a pack.
struct PackMeshes {
    std::vector<PackMeshFile> list;  // for pack.json
    std::vector<ExportFile> files;   // MTL, the texture's image, USD and MJCF included
};

/// The names of the files in the folder of a pack, as far as they are known before the asset is fractured.
struct PackFileNames {
    std::vector<std::string> names;
    bool areAll = true;  // false: there may be mesh files of single fragments, or of fragments of a level that break
};

/// Returns the names of the files of packMeshes(), in their order as far as they are known.
PackFileNames meshFileNames(const Asset& asset, const PackNames& names, const MeshOptions& options);

/// Returns the meshes of an asset, the whole first. The files are described in docs/formats/obj-glb.md, those of USD
/// and MuJoCo, which are not in the list, in docs/formats/usd-mjcf.md.
///
/// Errors: those of glbFile(); Cancelled.
Result<PackMeshes> packMeshes(const PackBuilder& builder, const MeshOptions& options, const TaskContext& task = {});

}  // namespace rubble
