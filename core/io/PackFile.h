#pragma once

#include "core/asset/Bake.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/io/MeshPart.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// The version of the packs that are written and read.
inline constexpr std::uint32_t kPackVersion = 1;

/// The name of the description that every pack holds, beside its meshes.
inline constexpr const char* kPackName = "pack.json";

/// Which bodies of a pack a mesh file holds.
enum class PackMeshBodies {
    Whole,      // the whole alone
    Fragments,  // some or all fragments, none a piece of another, each as an object of its name
    Fragment,   // one fragment
};

/// A mesh file of a pack.
struct PackMeshFile {
    std::string name;  // "wall.obj", a file beside pack.json
    PackMeshBodies bodies = PackMeshBodies::Fragments;
    std::uint32_t fragment = kNone;  // index of the one that it holds
    PartPlace place = PartPlace::Assembled;
    bool operator==(const PackMeshFile&) const = default;
};

/// What a body is called in packs and in the meshes beside them, as one word: "wall" for the whole, "wall12" for the
/// fragment with index 12.
std::string bodyName(const Asset& asset, std::uint32_t fragment = kNone);

/// A hash of all that packJson() depends on: known without a bake, equal for equal packs.
ContentHash packHash(const Asset& asset, const AssetMaterials& material, std::span<const PackMeshFile> meshes);

/// A bake as the description of a pack: one line of JSON a body, with every number the shortest that reads back as the
/// same double. The same bytes at any number of threads. docs/formats/pack.md tells every field.
std::string packJson(const Bake& bake, const Asset& asset, const AssetMaterials& material,
                     std::span<const PackMeshFile> meshes, const TaskContext& task = {});

/// A convex hull of a body. Edge k of a face's loop, in both forms, runs from the face's vertex k to the next.
struct PackHull {
    Polytope polytope;
    std::vector<std::vector<SignedEdge>> signedEdges;  // one loop a face
};

/// The whole of an asset, or a fragment.
struct PackBody {
    std::string id;  // "3" for the whole of asset 3, "3/5.17.1" for a fragment
    std::string name;
    std::uint32_t parent = kNone;      // index of the fragment that it is a piece of; kNone: of the whole
    Vec3 offset{0.0, 0.0, 0.0};        // of its frame's origin in the asset's frame, m
    double volume = 0.0;               // m^3
    double mass = 0.0;                 // kg
    Vec3 centreOfMass{0.0, 0.0, 0.0};  // in its own frame, m
    Mat3 inertia{0.0};                 // kg m^2, about the centre of mass, in its own axes
    std::vector<Bond> neighbours;      // `fragment`: index in Pack::fragments; ascending
    std::vector<PackHull> hulls;       // in its own frame
};

/// What pack.json holds.
struct Pack {
    Id asset = 0;
    std::string name;
    double gap = 0.0;        // m between pieces
    std::string hash;        // packHash() as text
    double threshold = 0.0;  // N s
    Material material;       // its id is not stored
    std::vector<PackMeshFile> meshes;
    PackBody whole;
    std::vector<PackBody> fragments;
};

/// Reads what packJson() wrote, bit for bit.
///
/// Errors: BadInput where the text is not such JSON, naming the place ("fragments[3].hulls[0].planes[2]: ..."); Unsupported
/// where its version is newer; Limit where it is too large.
Result<Pack> readPack(std::string_view json);

/// Says in one sentence what is wrong with a pack first: ids or names that come twice, parents and neighbours that are not
/// there, neighbours that are not mutual, pieces whose volumes do not sum to their parent's, mass that is not density
/// times volume, inertia of no solid, hulls that fail verifyPolytope() or do not fill their body, signed edges that do not
/// run along their face or begin with two on one line, meshes of no fragment, a hash that is none.
std::optional<std::string> verifyPack(const Pack& pack);

}  // namespace rubble
