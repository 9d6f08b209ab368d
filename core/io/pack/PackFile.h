#pragma once

#include "core/asset/bake/Bake.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/io/exchange/MeshPart.h"
#include "core/io/pack/PackBonding.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// The version of packs that is written and read.
inline constexpr std::uint32_t kPackVersion = 1;

/// The file of a pack that describes its bodies and lists its meshes.
inline constexpr const char* kPackName = "pack.json";

/// The bodies in a mesh file of a pack.
enum class PackMeshBodies {
    Whole,      // the whole alone
    Fragments,  // some or all fragments, none nested in another, each an object with its name
    Fragment,   // one fragment
};

/// A mesh file of a pack.
struct PackMeshFile {
    std::string name;  // "wall-fragments.obj", a file beside pack.json
    PackMeshBodies bodies = PackMeshBodies::Fragments;
    std::uint32_t fragment = kNone;  // index of the one fragment
    PartPlacement place = PartPlacement::Assembled;
    bool operator==(const PackMeshFile&) const = default;
};

/// Returns the name of a fragment in pack and meshes: that of the asset and the fragment's path, as in the table of
/// fragments, with '-' for '/' and '_' for '+': "wall-3.2-4.1". The whole has the meshName() of the asset.
std::string fragmentBodyName(const Asset& asset, std::string_view fragmentId);

/// Returns a hash of all inputs of packJson(), without baking. Equal packs have equal hashes.
ContentHash packHash(const Asset& asset, const AssetMaterials& material, std::span<const PackMeshFile> meshes);

/// Returns pack.json for a bake: one body per line, every number the shortest that reads back as the same double. The
/// bytes do not depend on the number of threads. All fields are described in docs/formats/pack.md.
std::string packJson(const Bake& bake, const Asset& asset, const AssetMaterials& material,
                     std::span<const PackMeshFile> meshes, const TaskContext& task = {});

/// A convex hull of a body. Edge k of a face's loop runs from the face's vertex k to the next.
struct PackHull {
    Polytope polytope;
    std::vector<std::vector<SignedEdge>> signedEdges;  // one loop a face
};

/// The whole of an asset, or a fragment.
struct PackBody {
    std::string id;  // "3" for the whole of asset 3, "3/5.17.1" for a fragment
    std::string name;
    std::uint32_t parent = kNone;             // index of the parent fragment; kNone: the whole
    Vec3 offset{0.0, 0.0, 0.0};               // of its frame's origin in the asset's frame, m
    double volume = 0.0;                      // m³
    double mass = 0.0;                        // kg
    Vec3 centreOfMass{0.0, 0.0, 0.0};         // in its own frame, m
    Mat3 inertia{0.0};                        // kg·m², about the centre of mass, in its own axes
    std::vector<FragmentContact> neighbours;  // `fragment`: index in Pack::fragments; ascending
    std::optional<double> threshold;          // N·s, that is set for it; none: follows from its volume
    double gap = 0.0;                         // m between its fragments; 0: none
    double lostMass = 0.0;                    // kg that the gap takes from them
    std::vector<PackHull> hulls;              // in its own frame
};

/// The contents of pack.json.
struct Pack {
    Id asset = 0;
    std::string name;
    double gap = 0.0;        // m between fragments, the widest of all bodies
    std::string hash;        // packHash() in hexadecimal
    std::string checksum;    // of the text, see verifyPackText(); empty: written by an earlier version
    double threshold = 0.0;  // N·s
    Material material;       // its id is not in the file
    std::vector<PackMeshFile> meshes;
    PackBody whole;
    std::vector<PackBody> fragments;
    std::optional<PackBonding> bonding;  // none: it breaks whole
};

/// Reads what packJson() wrote, bit for bit.
///
/// Errors: BadInput if the text is not JSON of this form, with the path ("fragments[3].hulls[0].planes[2]: ...");
/// Unsupported if its version is newer; Limit if it is too large.
Result<Pack> readPack(std::string_view json);

/// Returns the first error in a pack, if there is one: repeated ids or names, missing parents and neighbours,
/// neighbours that are not mutual, children whose masses do not sum to their parent's or have another centre of mass,
/// contacts that the hulls do not have (verifyPackContacts()), bonds that are not of neighbours (verifyPackBonding()),
/// mass that is not density times volume, an impossible inertia, hulls that fail verifyPolytope() or do not fill their
/// body, signed edges that do not follow their face or start with two collinear ones, meshes of missing fragments, a
/// malformed or zero hash.
std::optional<std::string> verifyPack(const Pack& pack);

/// Returns that the text of a pack was changed after it was written, if its checksum says so. The checksum is the hash
/// of the text with 32 zeros in its place.
std::optional<std::string> verifyPackText(std::string_view json, const Pack& pack);
/// Returns the text of a pack with the right checksum. It must have one.
std::string withChecksum(std::string json);

}  // namespace rubble
