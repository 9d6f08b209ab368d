// rubble_pack.hpp - reads the packs that Rubble exports, as JSON and binary, and the events that it reports, and breaks
// the bonds of bonded assets. One header, C++17, the standard library only, no exceptions.
//
//     rubble_pack::Pack pack;
//     std::string fault;
//     if (!rubble_pack::load("wall/pack.json", pack, fault)) return fail(fault);
//     for (const rubble_pack::Body& fragment : pack.fragments) addBody(fragment.mass, fragment.hulls, fragment.offset);
//
// The fields are described in pack.md, events.md and state.md, beside this file. All indices in a pack that was read
// are in range and need no checks. Metres, kilograms, seconds; right-handed, y up.
//
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the authors of Rubble
//
// Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
// documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
// rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to
// permit persons to whom the Software is furnished to do so, subject to the following conditions:
//
// The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
// Software.
//
// THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
// WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
// COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
// OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <limits>
#include <locale>
#include <map>
#include <optional>
#include <queue>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace rubble_pack {

constexpr std::uint32_t kVersion = 2;         // of the newest packs that this header reads
constexpr std::uint32_t kNone = 0xffffffffu;  // no fragment

struct Vec3 {
    double x = 0.0, y = 0.0, z = 0.0;
};

/// A rotation, of length 1.
struct Quaternion {
    double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
};

struct Box {
    Vec3 min, max;  // m
};

/// The points p with dot(normal, p) <= offset are inside; the normal has length 1.
struct Plane {
    Vec3 normal;
    double offset = 0.0;  // m
};

/// An edge in the loop of a face: +1 from its first vertex to its second, -1 reversed.
struct SignedEdge {
    std::uint32_t edge = 0;
    int sign = 1;
};

/// A closed convex solid in its body's frame, for collisions: its faces are inside those of the body by the inset, so
/// that hulls of neighbours do not touch. Step k of a face runs from vertex faces[f][k] to the next of that loop and
/// along signedEdges[f][k]; the first two edges of a loop are never collinear.
struct Hull {
    std::vector<Vec3> vertices;                        // m
    std::vector<std::array<std::uint32_t, 2>> edges;   // each once
    std::vector<std::vector<std::uint32_t>> faces;     // vertices, counter-clockwise from outside
    std::vector<std::vector<SignedEdge>> signedEdges;  // a loop for each face
    std::vector<Plane> planes;                         // one for each face
    double inset = 0.0;                                // m
};

/// A neighbouring fragment of the same parent.
struct Neighbour {
    std::uint32_t fragment = 0;  // index in Pack::fragments
    double area = 0.0;           // m^2, of contact
    Vec3 centroid;               // m, of the contact, in the asset's frame. Zero in packs of version 1, as the normal
    Vec3 normal;                 // of length 1, towards the neighbour
};

/// An inertia as most engines take it: tensor = R diag(moments) R^T, with R of the rotation.
struct PrincipalInertia {
    Vec3 moments;         // kg m^2, descending
    Quaternion rotation;  // of the principal frame in the body's, w >= 0
};

/// The whole or a fragment. Its frame has the axes of the asset and its centre of mass as origin.
struct Body {
    std::string id;
    std::string name;                                // of its object in the meshes
    std::uint32_t parent = kNone;                    // the parent fragment; kNone: the whole
    std::uint32_t level = 0;                         // 0: the whole and its own fragments
    std::uint32_t firstChild = 0;                    // its fragments are consecutive
    std::uint32_t childCount = 0;                    // 0: it does not break
    Vec3 offset;                                     // of its frame in the asset's, m
    double volume = 0.0;                             // m^3
    double mass = 0.0;                               // kg
    Vec3 centreOfMass;                               // in its own frame, m
    std::array<std::array<double, 3>, 3> inertia{};  // kg m^2, about the centre of mass, by rows
    PrincipalInertia principal;                      // the same
    Box bounds;                                      // of its solid, in its own frame
    double radius = 0.0;                             // m, of its solid, from the centre of mass
    double thinnest = 0.0;                           // m, the smallest width of a hull; 0 in packs of version 1
    double threshold = 0.0;                          // N·s, that breaks it; 0: see Pack::thresholdOf()
    double gap = 0.0;                                // m between its fragments
    double lostMass = 0.0;                           // kg that the gap takes from them
    std::vector<Neighbour> neighbours;               // ascending
    std::vector<Hull> hulls;                         // at least one
};

struct Material {
    std::string name;
    double density = 0.0;  // kg/m^3
    double friction = 0.0;
    double restitution = 0.0;
    std::array<double, 3> outside{};  // sRGB
    std::array<double, 3> inside{};
    double opacity = 1.0;
    double tensileStrength = 0.0;    // Pa; 0: unknown
    double fractureToughness = 0.0;  // Pa m^(1/2); 0: unknown
    double youngsModulus = 0.0;      // Pa; 0: unknown
};

/// A material in the meshes.
struct Surface {
    std::string name;
    bool isInside = false;
    std::array<double, 3> colour{};  // sRGB
    double opacity = 1.0;
    double roughness = 0.9;
    std::string texture;  // a file beside pack.json; empty: none
};

/// Fragments that are removed after a while.
struct Debris {
    double lifetime = 0.0;           // s; 0: for good
    double fade = 0.0;               // s, at the end of it
    std::uint32_t maxFragments = 0;  // 0: any number
};

enum class MeshBodies { Whole, Fragments, Fragment };
enum class MeshPlace { Assembled, Centred };

/// A mesh file beside pack.json.
struct Mesh {
    std::string file;
    MeshBodies bodies = MeshBodies::Fragments;
    std::uint32_t fragment = kNone;  // for MeshBodies::Fragment
    MeshPlace place = MeshPlace::Assembled;
    std::uint32_t level = kNone;  // for MeshBodies::Fragments: of the fragments, all of which break; kNone: the leaves
};

/// How the load of a hit on a bond decreases with the distance from the point that was hit.
enum class Falloff { Constant, Linear, Smooth };

/// The common face of two fragments, or of a fragment and an anchor.
struct Bond {
    std::array<std::uint32_t, 2> fragments{kNone, kNone};       // ascending; the second kNone: an anchor
    double area = 0.0;                                          // m^2
    Vec3 centroid;                                              // m, in the asset's frame
    Vec3 normal;                                                // from the first to the second, or out of the first
    double capacity = std::numeric_limits<double>::infinity();  // N·s, that breaks it; infinite: it never breaks
    std::uint32_t clusterLevel = 0;                             // it holds until bonds of lower levels have broken
};

/// The bonds between the fragments of a body.
struct Fracture {
    std::uint32_t fragment = kNone;  // the body; kNone: the whole
    std::vector<Bond> bonds;         // ascending fragments
};

/// How a bonded asset breaks.
struct Bonding {
    double falloffRadius = 0.0;  // m, > 0: a hit loads the bonds within
    Falloff falloff = Falloff::Linear;
    double damageFrom = 1.0;              // of what a bond holds, in (0, 1]: a weaker load leaves no damage
    double span = 0.0;                    // m, sideways to an anchor; 0: any distance
    double collapseDelay = 0.0;           // s, after which what has lost its support comes off
    std::uint32_t minimumIsland = 1;      // fragments: smaller islands that come off fall apart
    std::string bake;                     // that damages name
    std::vector<Fracture> fractures;      // that of the whole, then ascending
    std::vector<std::uint32_t> anchored;  // fragments of the whole that are held in place, ascending
};

/// A fracture around the point of impact, which only Rubble computes; engines use the fragments of the pack.
struct CutAtImpact {
    std::uint32_t fragments = 0;
    double falloffRadius = 0.0;  // m
};

struct Pack {
    std::uint32_t version = 0;
    std::uint32_t asset = 0;
    std::string name;               // "wall~2"
    std::string base;               // "wall": the asset without its variant
    std::uint32_t variant = 0;      // 0: the asset itself
    std::string folder;             // "wall_2"
    std::string hash;               // equal for equal packs
    std::string physicsHash;        // equal where only meshes, surfaces and names differ; empty in version 1
    double threshold = 0.0;         // N·s; an impact at or above it breaks the body
    double inset = 0.0;             // m, of the hulls
    double leastSpeed = 0.5;        // m/s: a contact that approaches slower does not count
    double restitutionSpeed = 1.0;  // m/s: restitution counts above it
    bool breaksByMomentum = false;  // the damage rule: pack.md describes impact, the other
    std::optional<CutAtImpact> cutAtImpact;
    Material material;        // of all bodies
    Material insideMaterial;  // of cut faces
    std::vector<Surface> surfaces;
    std::optional<Debris> debris;
    std::vector<Mesh> meshes;
    Body whole;
    std::vector<Body> fragments;     // parents before their children
    std::optional<Bonding> bonding;  // none: it breaks whole

    /// The impact that breaks a body, N·s: its own threshold, or one that follows from its volume. `body`: an index in
    /// `fragments`, or kNone: the whole. Only of bodies that break.
    double thresholdOf(std::uint32_t body) const {
        if (body == kNone) return threshold;
        const Body& one = fragments[body];
        return one.threshold > 0.0 ? one.threshold : threshold * std::pow(one.volume / whole.volume, 2.0 / 3.0);
    }
    /// The impact J of a contact on one of its bodies, N·s, which breaks it or is that of a hit: (1 + e) times speed
    /// and mass; 0 where it is too slow to count. `speed`: m/s, of the approach before the contact is solved;
    /// `mass`: kg, the effective one of both bodies, as pack.md has it; `restitution`: of the other body.
    double impactOf(double speed, double mass, double restitution) const {
        if (!(speed > leastSpeed)) return 0.0;
        return (1.0 + (speed > restitutionSpeed ? std::max(material.restitution, restitution) : 0.0)) * speed * mass;
    }
    /// The body with an index in `fragments`; kNone: the whole.
    const Body& body(std::uint32_t index) const { return index == kNone ? whole : fragments[index]; }
    /// The fragments of a body; kNone: of the whole. Empty if it does not break.
    std::vector<std::uint32_t> fragmentsOf(std::uint32_t parent) const {
        const Body& one = body(parent);
        std::vector<std::uint32_t> children(one.childCount);
        for (std::uint32_t k = 0; k < one.childCount; ++k) children[k] = one.firstChild + k;
        return children;
    }
    /// Their former name.
    std::vector<std::uint32_t> piecesOf(std::uint32_t parent) const { return fragmentsOf(parent); }
    /// The mesh file that holds an object for a body, with an ending such as ".glb"; null if there is none.
    const Mesh* meshOf(std::uint32_t index, std::string_view ending) const {
        for (const Mesh& mesh : meshes) {
            if (mesh.file.size() < ending.size() || mesh.file.substr(mesh.file.size() - ending.size()) != ending)
                continue;
            const bool isWhole = mesh.bodies == MeshBodies::Whole, isOne = mesh.bodies == MeshBodies::Fragment;
            if (isWhole && index == kNone) return &mesh;
            if (isWhole || index == kNone) continue;
            const std::uint32_t level = fragments[index].childCount > 0 ? fragments[index].level : kNone;
            if (isOne ? mesh.fragment == index : mesh.level == level) return &mesh;
        }
        return nullptr;
    }
};

/// Parses a pack.json. On an error returns false, sets `fault` to a message and does not change the pack.
inline bool parse(std::string_view json, Pack& pack, std::string& fault);

/// Reads a file.
inline bool load(const std::string& path, Pack& pack, std::string& fault);

// What pack.bin holds: records of numbers as they are in the file. See pack-bin.md.

struct BinaryBody {
    double offset[3], mass, volume;
    double threshold;  // 0: it does not break
    double gap, lostMass;
    float moments[3], rotation[4];  // x, y, z, w
    float min[3], max[3], radius, thinnest;
    std::uint32_t parent;  // kNone: the whole
    std::uint32_t level, firstChild, childCount;
    std::uint32_t firstHull, hullCount;
    std::uint32_t id, name;  // see BinaryPack::text()
    std::uint32_t unused;
};
struct BinaryHull {
    std::uint32_t firstVertex, vertexCount;
    std::uint32_t firstLoop, faceCount;
    float inset;
};
struct BinaryVertex {
    float x, y, z;
};
struct BinaryContact {
    std::uint32_t first, second;  // fragments, ascending
    float area, centroid[3], normal[3];
    float capacity;  // of a bond; infinite: it never breaks; 0 where the asset breaks whole
    std::uint32_t clusterLevel;
};

/// An array in the bytes of a file.
template <class T>
class BinaryArray {
public:
    BinaryArray() = default;
    BinaryArray(const char* bytes, std::size_t count, std::size_t stride)
        : m_bytes(bytes), m_count(count), m_stride(stride) {}
    std::size_t size() const { return m_count; }
    /// By value: nothing is assumed of the alignment of the bytes.
    T operator[](std::size_t index) const {
        T element;
        std::memcpy(&element, m_bytes + index * m_stride, sizeof(T));
        return element;
    }
    /// The first element, where the bytes are aligned to 16 and the stride() is the size of a T.
    const char* data() const { return m_bytes; }
    std::size_t stride() const { return m_stride; }

private:
    const char* m_bytes = nullptr;
    std::size_t m_count = 0, m_stride = 0;
};

/// Views of the arrays of a pack.bin, valid as long as its bytes. All indices in them are in range.
///
///     rubble_pack::BinaryPack wall;
///     if (!rubble_pack::openBinary(bytes, wall, fault)) return fail(fault);
///     const rubble_pack::BinaryBody body = wall.fragment(0);
///     for (std::uint32_t k = 0; k < body.hullCount; ++k) addHull(wall.hulls[body.firstHull + k]);
struct BinaryPack {
    std::string_view header;  // JSON
    BinaryArray<BinaryBody> bodies;
    BinaryArray<BinaryHull> hulls;
    BinaryArray<BinaryVertex> vertices;
    BinaryArray<std::uint16_t> loops;
    BinaryArray<BinaryContact> contacts;
    std::string_view texts;

    std::uint32_t fragmentCount() const { return static_cast<std::uint32_t>(bodies.size() - 1); }
    BinaryBody whole() const { return bodies[0]; }
    BinaryBody fragment(std::uint32_t index) const { return bodies[index + 1]; }
    /// The text that starts at a place, such as BinaryBody::name.
    std::string_view text(std::uint32_t start) const { return texts.data() + start; }
};

/// Checks the bytes of a pack.bin and gives views of them: O(size), without a copy. On an error returns false, sets
/// `fault` to a message and does not change the pack. Only on little-endian machines.
inline bool openBinary(std::string_view bytes, BinaryPack& pack, std::string& fault);

/// Makes a pack of the bytes of a pack.bin, or of a file, with inertias from their principal moments. On an error
/// returns false, sets `fault` to a message and does not change the pack.
inline bool parseBinary(std::string_view bytes, Pack& pack, std::string& fault);
inline bool loadBinary(const std::string& path, Pack& pack, std::string& fault);

/// A pack of a scene.
struct ScenePack {
    std::string folder;       // beside scene.json
    std::string physicsHash;  // that of the pack which the scene was exported with
    std::uint32_t asset = 0, variant = 0;
};

/// An asset that stands in a scene. Its whole is at position + rotation * Pack::whole.offset.
struct SceneInstance {
    std::uint32_t id = 0;
    std::string name;
    std::uint32_t pack = 0;  // index in Scene::packs
    Vec3 position;           // m, of the asset's frame
    Quaternion rotation;     // of it
    double threshold = 0.0;  // N·s, of the whole, in place of the pack's
    bool isFixed = false;    // static until it breaks
    bool isUnbreakable = false;
    bool isAnchored = false;    // bonded: held by what is fixed and touches it
    double bondStrength = 1.0;  // a factor of the capacities of its bonds
    // Of an instance that breaks bonded: its bonds to what is fixed, with their capacities, in place of those of
    // Bonding::anchored; and whether its heaviest island stays though nothing holds it.
    std::vector<Bond> anchors;
    bool holdsHeaviest = false;
};

/// A face at which mortar joins fragments of two instances, or of one and something fixed.
struct SceneJoint {
    std::uint32_t mortar = 0;                              // id
    std::array<std::uint32_t, 2> instances{kNone, kNone};  // in Scene::instances; the second kNone: it is fixed
    std::array<std::uint32_t, 2> fragments{kNone, kNone};  // of their packs
    double area = 0.0;                                     // m^2
    Vec3 centroid;                                         // m, in the world
    Vec3 normal;                                           // from the first to the second
    double capacity = 0.0;                                 // N·s, that breaks it
};

enum class SceneShotKind { Throw, Hammer, Explosion };
enum class Projectile { Box, Ball, Plank, Asset };

/// What happens to a scene at a time.
struct SceneShot {
    std::uint32_t id = 0;
    std::string name;
    double time = 0.0;  // s
    SceneShotKind kind = SceneShotKind::Throw;
    Projectile projectile = Projectile::Box;  // of a throw, as the next five
    std::uint32_t asset = 0;                  // of Projectile::Asset: ScenePack::asset
    Vec3 size;                                // m; x is the diameter of a ball
    double mass = 0.0;                        // kg
    Vec3 from, to;                            // m; it starts at `from`
    double speed = 0.0;                       // m/s, towards `to`
    Vec3 at;                                  // m, of a hammer and an explosion
    Vec3 impulse;                             // N·s, of a hammer
    double impulsePerArea = 0.0;              // N·s/m^2, of an explosion
    double radius = 0.0;                      // m; of a hammer 0: follows from the impulse
};

/// The plane y = height.
struct SceneGround {
    double height = 0.0;  // m
    double friction = 0.0;
    double restitution = 0.0;
};

/// The packs of a project as they stand: see scene.md.
struct Scene {
    Vec3 gravity;  // m/s^2
    std::optional<SceneGround> ground;
    std::vector<ScenePack> packs;
    std::vector<SceneInstance> instances;
    std::vector<SceneJoint> joints;
    std::vector<SceneShot> shots;
};

/// Parse and read a scene.json. On an error return false, set `fault` to a message and do not change the scene.
inline bool parseScene(std::string_view json, Scene& scene, std::string& fault);
inline bool loadScene(const std::string& path, Scene& scene, std::string& fault);

/// Units and axes of other engines. Unity: metres, left-handed, y up, with x reversed, as its importers of glTF do.
/// Unreal: centimetres, left-handed, z up, with y and z exchanged, as its importers do. Masses stay kilograms; an
/// inertia takes 10,000 times its moments in Unreal, and an impulse 100 times.
constexpr double kUnrealLength = 100.0, kUnrealImpulse = 100.0, kUnrealInertia = 10000.0;
inline Vec3 toUnity(const Vec3& position) { return {-position.x, position.y, position.z}; }
inline Quaternion toUnity(const Quaternion& q) { return {q.x, -q.y, -q.z, q.w}; }
inline Vec3 toUnreal(const Vec3& position) {
    return {kUnrealLength * position.x, kUnrealLength * position.z, kUnrealLength * position.y};
}
inline Quaternion toUnreal(const Quaternion& q) { return {-q.x, -q.z, -q.y, q.w}; }
/// The same of directions, normals for one, which have no unit; those of Unity are as positions.
inline Vec3 directionToUnreal(const Vec3& direction) { return {direction.x, direction.z, direction.y}; }
/// Angular velocities, rad/s: a mirror reverses them.
inline Vec3 angularToUnity(const Vec3& angular) { return {angular.x, -angular.y, -angular.z}; }
inline Vec3 angularToUnreal(const Vec3& angular) { return {-angular.x, -angular.z, -angular.y}; }

/// The damage of a bond: n/255 of what it held is gone.
using Damage = std::uint8_t;
constexpr Damage kBroken = 255;

/// The fragments of a fracture and their bonds. It never changes in play: damage is kept beside it, one byte a bond.
///
///     rubble_pack::Structure wall = rubble_pack::structureOf(pack, 0);
///     std::vector<rubble_pack::Damage> damage(wall.bonds.size());
///     rubble_pack::applyHit(wall, *pack.bonding, {{point}, impulse}, wall.fragments, damage);
///     for (const rubble_pack::Island& island : rubble_pack::islandsOf(wall, damage, wall.fragments)) ...
///
/// The results have the bits of Rubble's where the compiler does not contract products and sums: -ffp-contract=off.
struct Structure {
    std::vector<std::uint32_t> fragments;                   // ascending indices in Pack::fragments
    std::vector<Vec3> centres;                              // m: of mass, of each, in the asset's frame
    std::vector<Bond> bonds;                                // those of the fracture, then to anchors
    std::vector<std::array<std::uint32_t, 2>> ends;         // of each bond: numbers in `fragments`; kNone: an anchor
    std::vector<std::vector<std::uint32_t>> fragmentBonds;  // of each fragment, ascending

    /// The number of a fragment that is in it.
    std::uint32_t numberOf(std::uint32_t fragment) const {
        const auto found = std::lower_bound(fragments.begin(), fragments.end(), fragment);
        return static_cast<std::uint32_t>(found - fragments.begin());
    }
};

/// The structure of a fracture of a bonded pack: an index in Bonding::fractures. That of the whole
/// has a bond that never breaks to an anchor for each anchored fragment. `strength`: a factor of all capacities, as an
/// instance may have.
inline Structure structureOf(const Pack& pack, std::size_t fracture, double strength = 1.0);

/// Holds a fragment by something that it touches: a bond to an anchor. The damage of the structure grows by a byte.
inline void addAnchor(Structure& structure, const Bond& anchor);

/// A hit on a body.
struct Hit {
    std::vector<Vec3> points;  // m, in the asset's frame; one at least
    double impulse = 0.0;      // N·s
};

/// The effect of a hit: indices of bonds, ascending, each in one list at most.
struct HitOutcome {
    double taken = 0.0;                  // N·s, of the hit's, that it took to break and damage bonds
    std::vector<std::uint32_t> broken;   // bonds that broke
    std::vector<std::uint32_t> damaged;  // bonds with new damage that hold
};

/// The cluster level at which a body breaks: the lowest of the unbroken bonds between its fragments that can break;
/// kNone without such. `body`: its fragments, ascending.
inline std::uint32_t breakingLevel(const Structure& structure, const std::vector<Damage>& damage,
                                   const std::vector<std::uint32_t>& body);

/// Breaks and damages bonds of a body by a hit, as pack.md describes: those of its breakingLevel() only. `body`: its
/// fragments, ascending. Leaves the rest of the impulse, hit.impulse - taken, to the bodies.
inline HitOutcome applyHit(const Structure& structure, const Bonding& rule, const Hit& hit,
                           const std::vector<std::uint32_t>& body, std::vector<Damage>& damage);

/// Fragments that unbroken bonds connect.
struct Island {
    std::vector<std::uint32_t> fragments;  // ascending
    bool isAnchored = false;               // an unbroken bond leads from one to an anchor
};

/// The mass of several fragments together, as of an island that comes off: a body whose hulls are those of its
/// fragments, each moved by its offset less the centre.
struct IslandMass {
    double mass = 0.0;                               // kg
    Vec3 centre;                                     // m, of mass, in the asset's frame
    std::array<std::array<double, 3>, 3> inertia{};  // kg m^2, about the centre, by rows
};
inline IslandMass massOf(const Pack& pack, const std::vector<std::uint32_t>& fragments);

/// The islands of a body, by their first fragments.
inline std::vector<Island> islandsOf(const Structure& structure, const std::vector<Damage>& damage,
                                     const std::vector<std::uint32_t>& body);

/// The fragments of a body that have lost their support, ascending: those farther sideways from an anchor than `span`,
/// m, and than they are without any damage; see pack.md. Those of a cluster of its breakingLevel() only if all of them
/// have. `span` 0: any distance; `up` of length 1, in the asset's frame.
inline std::vector<std::uint32_t> unsupported(const Structure& structure, const std::vector<Damage>& damage,
                                              const std::vector<std::uint32_t>& body, double span, Vec3 up);

/// Breaks all bonds of some fragments that can break: so what has lost its support comes off, in single fragments,
/// which do not jam between what stands; or in clusters, where bonds of cluster levels above `level`, the
/// breakingLevel() of their body, hold. Returns the bonds that broke, ascending.
inline std::vector<std::uint32_t> breakOff(const Structure& structure, const std::vector<std::uint32_t>& fragments,
                                           std::vector<Damage>& damage, std::uint32_t level = kNone);

/// A bond of an instance of a scene.
struct SceneBond {
    std::uint32_t instance = 0;  // in Scene::instances
    std::uint32_t bond = 0;      // of its structure
};

/// The bonded instances of a scene, with what mortar joins: each half of a joint is a bond to an anchor in the
/// structure of its instance. A hit damages the structure of one instance; what it broke of a joint, breakMortar()
/// breaks in the other.
///
///     rubble_pack::SceneStructures all;
///     if (!rubble_pack::structuresOf(scene, packs, all, fault)) ...
///     std::vector<std::vector<rubble_pack::Damage>> damages = rubble_pack::intactDamages(all);
///     rubble_pack::applyHit(all.structures[k], *packs[scene.instances[k].pack].bonding, hit, body, damages[k]);
///     rubble_pack::breakMortar(all, damages);
///     for (const rubble_pack::Island& island : rubble_pack::islandsOf(all.structures[k], damages[k], body)) ...
struct SceneStructures {
    std::vector<Structure> structures;                   // of each instance; without fragments if it has no bonds
    std::vector<std::array<SceneBond, 2>> halves;        // of each joint of two instances
    std::vector<std::vector<std::uint32_t>> jointBonds;  // of each instance, ascending: its bonds that are halves
    std::vector<double> spans;                           // m, of each instance; 0: any
    std::vector<Vec3> ups;                               // of each: against gravity, in its asset's frame
    std::vector<std::vector<double>> masses;             // kg, by instance, of the fragments of its structure
    std::vector<bool> holdHeaviest;                      // SceneInstance::holdsHeaviest
};

/// Makes the structures of a scene. `packs`: those of Scene::packs, in that order. Where these are of another export,
/// or have no such fragments, returns false, sets `fault` to a message and does not change the structures.
inline bool structuresOf(const Scene& scene, const std::vector<Pack>& packs, SceneStructures& structures,
                         std::string& fault);

/// Damages of all structures in which nothing is broken.
inline std::vector<std::vector<Damage>> intactDamages(const SceneStructures& all);

/// Breaks the mortar that holds no longer: whose other half is broken, and that between islands of which none is
/// anchored any more, by itself or over mortar. Returns the halves that broke. To be called after every change of
/// damages, before islandsOf(): then what is anchored by the half of a joint is held.
inline std::vector<SceneBond> breakMortar(const SceneStructures& all, std::vector<std::vector<Damage>>& damages);

/// As unsupported() of one structure, over mortar, too: what stands on a fragment of another instance has all of its
/// span from there, what adjoins it what is left of the span. `held`: of each instance the fragments that are held,
/// ascending; of what mortar does not join, unsupported() of its structure gives the same.
inline std::vector<std::vector<std::uint32_t>> unsupported(const SceneStructures& all,
                                                           const std::vector<std::vector<Damage>>& damages,
                                                           const std::vector<std::vector<std::uint32_t>>& held);

/// The damages of all structures of an instance as bytes for networks and files, which Rubble reads, too: see state.md.
/// `damages`: of each fracture, in the order of Bonding::fractures; `bake`: Bonding::bake.
inline std::string damageBytes(const std::string& bake, const std::vector<std::vector<Damage>>& damages);

/// Reads damages of the same bake into `damages`, which must have the sizes of the structures. On an error returns
/// false, sets `fault` to a message and does not change the damages.
inline bool readDamage(std::string_view bytes, const std::string& bake, std::vector<std::vector<Damage>>& damages,
                       std::string& fault);

/// The kinds of events. Files of version 1 have the first six, in this order.
enum class EventKind { Impact, Bonds, Detached, Broken, Settled, Removed, Born, Damaged, Sliding, Rolling };
constexpr std::size_t kEventKinds = 10;

/// Why a body was removed; None: it was not.
enum class RemovalReason { None, Lifetime, Budget, LeftWorld, Input };

/// What broke further in a step, of an instance: see state.md. Counts within `broken` are those of the fractures of a
/// cut asset where `cut` is not empty.
struct EventDamage {
    std::vector<std::uint32_t> broken;                              // bonds or fractures, ascending
    std::vector<std::pair<std::uint32_t, std::uint32_t>> weakened;  // bonds that hold, and their damage, 1 to 254
    std::string cut;  // number of the cut at the point of impact; empty: none
};

/// Something that happened to a body in a step. Members that the kind does not have are 0 or empty.
struct Event {
    std::uint64_t step = 0;  // after which it holds
    EventKind kind = EventKind::Impact;
    std::uint32_t body = 0;       // its number
    std::uint32_t other = kNone;  // of the body that it touched, or came off; kNone: none
    std::uint32_t instance = 0;   // id; 0: the ground, or thrown. Version 2: of instances and damage only
    std::string fragment;         // version 1: its path in the asset; empty: the whole
    Vec3 point;                   // m, in the world
    Vec3 normal;                  // from `other` into `body`
    double impulse = 0.0;         // N·s, along the normal
    double speed = 0.0;           // m/s, of the approach; of what slides and rolls
    double energy = 0.0;          // J: that both bodies lost, or that the break took
    double area = 0.0;            // m^2, of the faces that opened
    double mass = 0.0;            // kg, of what came free or appeared; version 1: also of what came to rest or is gone
    std::uint32_t count = 0;      // of fragments that came free
    std::array<std::uint32_t, 2> materials{};  // ids, of both bodies; of the body and its inside. 0: none
    Box box;                                   // of what changed, in the world
    RemovalReason reason = RemovalReason::None;

    // Version 2:
    double restMass = 0.0;               // kg, of what is left of the body that it came off; 0: none, or fixed
    std::array<double, 2> masses{};      // kg, of both bodies of an impact; 0: fixed
    double load = 0.0;                   // N, of what slides and rolls
    Vec3 position;                       // m, of the frame of the body's asset in the world
    Quaternion rotation;                 // of that frame
    Vec3 velocity;                       // m/s, of the centre of mass
    Vec3 angularVelocity;                // rad/s, in world axes
    std::vector<std::string> fragments;  // paths: what appears, or was removed; none: the whole
    std::string name;                    // of an instance, or of what was thrown
    std::uint32_t asset = 0;             // id; 0: none
    std::uint32_t variant = 0;
    std::string projectile;  // "ball", "box" or "plank", of what is thrown and has no asset
    Vec3 size;               // m, of that
    bool isFixed = false;
    EventDamage damage;
};

/// Events of a kind that happened and are not reported one by one.
struct OmittedEvents {
    std::uint32_t count = 0;
    double energy = 0.0;  // J
};

/// The rest of a step.
struct EventSums {
    std::uint64_t step = 0;
    std::array<OmittedEvents, kEventKinds> omitted{};  // by kind
    double restEnergy = 0.0;                           // J, that contacts took without an impact
};

struct EventMaterial {
    std::uint32_t id = 0;
    std::string name;
};

struct EventAsset {
    std::uint32_t id = 0;
    std::uint32_t variant = 0;
    std::string name;
    std::string folder;  // of its pack
    std::uint32_t material = 0;
    std::vector<std::string> fragments;  // paths of all of them, if it breaks along bonds
};

struct EventLog {
    std::uint32_t version = 1;
    std::vector<Event> events;    // ascending step
    std::vector<EventSums> sums;  // ascending step

    // Version 2:
    std::uint64_t step = 0;  // after which it begins
    double dt = 0.0;         // s, of a step; 0 in version 1
    Vec3 gravity;            // m/s^2
    std::vector<EventMaterial> materials;
    std::vector<EventAsset> assets;
    std::vector<Event> bodies;  // that are there at the beginning, as if just born
};

/// A body as events of version 2 report it.
struct EventBody {
    std::string name;            // of its instance, or of what was thrown
    std::uint32_t instance = 0;  // id; 0: the ground, or thrown
    std::uint32_t asset = 0;     // id; 0: none
    std::uint32_t variant = 0;
    std::uint64_t born = 0;              // step after which it was there
    std::uint32_t from = kNone;          // body that it came off; kNone: none
    std::vector<std::string> fragments;  // paths, ascending as text; "": the whole
    bool isFixed = false;
    double mass = 0.0;  // kg; of what is fixed 0
};

/// Which bodies there are, and what is broken.
struct EventState {
    std::uint64_t step = 0;                        // after which it holds
    std::size_t next = 0;                          // event of the log that comes next
    std::map<std::uint32_t, EventBody> bodies;     // by number
    std::map<std::uint32_t, EventDamage> damages;  // by id of instance
};

/// The state before the first event of a log of version 2.
inline EventState startOf(const EventLog& log);

/// Brings a state to the end of a step, which must not be before it.
inline void playTo(const EventLog& log, std::uint64_t step, EventState& state);

/// The name of a material of a log; empty if there is none.
inline std::string materialName(const EventLog& log, std::uint32_t material);

/// Parses events as JSON lines, of version 1 or 2. On an error returns false, sets `fault` to a message and does not
/// change the log.
inline bool parseEvents(std::string_view lines, EventLog& log, std::string& fault);

/// Adds the lines that follow in a file to what was read of it, as they come over a network.
inline bool appendEvents(std::string_view lines, EventLog& log, std::string& fault);

/// Reads a file.
inline bool loadEvents(const std::string& path, EventLog& log, std::string& fault);

namespace detail {

enum class Kind { Null, Boolean, Number, Text, Array, Object };

/// JSON values in the order of their text, each container before what it holds: the first child of node i is i + 1, the
/// one behind a child is at its `end`.
struct Node {
    Kind kind = Kind::Null;
    double number = 0.0;
    std::uint32_t text = 0;   // index in Document::texts
    std::uint32_t key = 0;    // the same, of a member of an object
    std::uint32_t count = 0;  // of children
    std::uint32_t end = 0;
};
struct Document {
    std::vector<Node> nodes;
    std::vector<std::string> texts;
};

/// Takes JSON apart. After a fault everything fails.
class Parser {
public:
    explicit Parser(std::string_view text) : m_text(text) {}

    bool parse(Document& document) {
        if (!element(document, 0, 0)) return false;
        skipBlanks();
        return m_at == m_text.size() || fail("the end");
    }
    std::string fault() const {
        return "The text is not JSON at byte " + std::to_string(m_at) + ": expected " + m_expected + ".";
    }

private:
    static constexpr int kDeepest = 32;

    bool fail(const char* expected) {
        m_expected = expected;
        return false;
    }
    void skipBlanks() {
        while (isAt(m_at, " \t\r\n")) ++m_at;
    }
    bool isAt(std::size_t at, std::string_view letters) const {
        return at < m_text.size() && letters.find(m_text[at]) != std::string_view::npos;
    }
    bool take(char letter) {
        skipBlanks();
        if (m_at == m_text.size() || m_text[m_at] != letter) return false;
        ++m_at;
        return true;
    }

    bool element(Document& document, std::uint32_t key, int depth) {
        if (depth > kDeepest) return fail("fewer levels");
        skipBlanks();
        const std::size_t index = document.nodes.size();
        Node node;
        node.key = key;
        document.nodes.push_back(node);
        if (!content(document, node, depth)) return false;
        node.end = static_cast<std::uint32_t>(document.nodes.size());
        document.nodes[index] = node;
        return true;
    }
    bool content(Document& document, Node& node, int depth) {
        switch (m_at < m_text.size() ? m_text[m_at] : '\0') {
            case '{': node.kind = Kind::Object; return members(document, node, depth);
            case '[': node.kind = Kind::Array; return elements(document, node, depth);
            case '"': node.kind = Kind::Text; return text(document, node.text);
            case 'n': node.kind = Kind::Null; return word("null");
            case 't':
                node.kind = Kind::Boolean;
                node.number = 1.0;
                return word("true");
            case 'f': node.kind = Kind::Boolean; return word("false");
            default: node.kind = Kind::Number; return number(node.number);
        }
    }
    bool word(std::string_view letters) {
        if (m_text.substr(m_at, letters.size()) != letters) return fail("a value");
        m_at += letters.size();
        return true;
    }
    bool members(Document& document, Node& node, int depth) {
        ++m_at;
        if (take('}')) return true;
        do {
            std::uint32_t key = 0;
            skipBlanks();
            if (!isAt(m_at, "\"")) return fail("a key");
            if (!text(document, key)) return false;
            if (!take(':')) return fail("':'");
            if (!element(document, key, depth + 1)) return false;
            ++node.count;
        } while (take(','));
        return take('}') || fail("',' or '}'");
    }
    bool elements(Document& document, Node& node, int depth) {
        ++m_at;
        if (take(']')) return true;
        do {
            if (!element(document, 0, depth + 1)) return false;
            ++node.count;
        } while (take(','));
        return take(']') || fail("',' or ']'");
    }

    bool text(Document& document, std::uint32_t& index) {
        index = static_cast<std::uint32_t>(document.texts.size());
        return text(document.texts.emplace_back());
    }
    bool text(std::string& result) {
        for (++m_at; m_at < m_text.size(); ++m_at) {
            const char letter = m_text[m_at];
            if (letter == '"') {
                ++m_at;
                return true;
            }
            if (static_cast<unsigned char>(letter) < 0x20) break;
            if (letter != '\\') {
                result += letter;
            } else if (!escape(result)) {
                return fail("an escape");
            }
        }
        return fail("'\"'");
    }
    bool escape(std::string& result) {
        constexpr std::string_view kNames = "\"\\/bfnrt";
        constexpr std::string_view kLetters = "\"\\/\b\f\n\r\t";
        if (++m_at == m_text.size()) return false;
        const std::size_t name = kNames.find(m_text[m_at]);
        if (name != std::string_view::npos) {
            result += kLetters[name];
            return true;
        }
        std::uint32_t code = 0;
        if (m_text[m_at] != 'u' || !hex(code)) return false;
        if (code >= 0xd800 && code < 0xdc00) {
            std::uint32_t low = 0;
            if (m_text.substr(m_at + 1, 2) != "\\u") return false;
            m_at += 2;
            if (!hex(low) || low < 0xdc00 || low > 0xdfff) return false;
            code = 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00);
        } else if (code >= 0xdc00 && code <= 0xdfff) {
            return false;
        }
        appendUtf8(result, code);
        return true;
    }
    /// Four digits behind the place; leaves the place on the last.
    bool hex(std::uint32_t& code) {
        if (m_text.size() - m_at < 5) return false;
        const char* const first = m_text.data() + m_at + 1;
        const auto [end, error] = std::from_chars(first, first + 4, code, 16);
        m_at += 4;
        return error == std::errc() && end == first + 4;
    }
    static void appendUtf8(std::string& text, std::uint32_t code) {
        const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
        if (code < 0x80) return add(code);
        if (code < 0x800) {
            add(0xc0 | (code >> 6));
        } else if (code < 0x10000) {
            add(0xe0 | (code >> 12));
            add(0x80 | ((code >> 6) & 0x3f));
        } else {
            add(0xf0 | (code >> 18));
            add(0x80 | ((code >> 12) & 0x3f));
            add(0x80 | ((code >> 6) & 0x3f));
        }
        add(0x80 | (code & 0x3f));
    }

    std::size_t digitsFrom(std::size_t at) const {
        while (at < m_text.size() && m_text[at] >= '0' && m_text[at] <= '9') ++at;
        return at;
    }
    bool number(double& value) {
        const std::size_t start = m_at + (isAt(m_at, "-") ? 1 : 0);
        std::size_t end = digitsFrom(start);
        if (end == start || (m_text[start] == '0' && end > start + 1)) return fail("a value");
        if (isAt(end, ".")) {
            const std::size_t fraction = end + 1;
            end = digitsFrom(fraction);
            if (end == fraction) return fail("a number");
        }
        if (isAt(end, "eE")) {
            const std::size_t exponent = end + (isAt(end + 1, "+-") ? 2 : 1);
            end = digitsFrom(exponent);
            if (end == exponent) return fail("a number");
        }
        if (!toDouble(m_text.substr(m_at, end - m_at), value)) return fail("a number that a double can hold");
        m_at = end;
        return true;
    }
    /// The nearest double, whatever the locale; 0 for what is too small for one.
    static bool toDouble(std::string_view digits, double& value) {
#if defined(__cpp_lib_to_chars)
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error == std::errc()) return end == digits.data() + digits.size();
#else
        std::istringstream stream{std::string(digits)};
        stream.imbue(std::locale::classic());
        if (stream >> value) return std::isfinite(value);
#endif
        value = 0.0;
        return isBelowOne(digits);
    }

    /// Whether the magnitude of a number is below 1.
    static bool isBelowOne(std::string_view digits) {
        const std::size_t e = std::min(digits.find_first_of("eE"), digits.size());
        const std::size_t point = std::min(digits.find('.'), e);
        const std::size_t first = digits.find_first_of("123456789");
        if (first >= e) return true;
        std::int64_t exponent = 0;
        for (const char digit : digits.substr(e)) {
            if (digit >= '0' && digit <= '9')
                exponent = std::min(10 * exponent + (digit - '0'), std::int64_t{1000000000});
        }
        if (digits.find('-', e) != digits.npos) exponent = -exponent;
        return exponent + static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first) <= 0;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    const char* m_expected = "";
};

/// A value in a document, with the place where it stands.
struct Value {
    const Document* document = nullptr;
    std::uint32_t node = 0;
    const Value* parent = nullptr;  // null at the root
    const char* key = nullptr;      // in an object
    std::size_t number = 0;         // in an array

    const Node& operator*() const { return document->nodes[node]; }
    const Node* operator->() const { return &document->nodes[node]; }
    std::string place() const {
        if (!parent) return "";
        const std::string before = parent->place();
        if (!key) return before + "[" + std::to_string(number) + "]";
        return before.empty() ? key : before + "." + key;
    }
};

inline Vec3 plus(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 minus(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 times(const Vec3& a, double factor) { return {a.x * factor, a.y * factor, a.z * factor}; }
inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec3& a) { return std::sqrt(dot(a, a)); }

/// Adds edges, signed edges and planes, which follow from the faces. Returns false if a face has no area.
inline bool deriveTopology(Hull& hull) {
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> found;
    for (const std::vector<std::uint32_t>& face : hull.faces) {
        if (face.size() < 3) return false;
        Vec3 normal, middle;  // by Newell's method
        std::vector<SignedEdge>& loop = hull.signedEdges.emplace_back();
        for (std::size_t k = 0; k < face.size(); ++k) {
            const std::uint32_t from = face[k], to = face[(k + 1) % face.size()];
            const Vec3 a = minus(hull.vertices[from], hull.vertices[face[0]]);
            normal = plus(normal, cross(a, minus(hull.vertices[to], hull.vertices[face[0]])));
            middle = plus(middle, hull.vertices[from]);
            const std::array<std::uint32_t, 2> ends{std::min(from, to), std::max(from, to)};
            const auto [edge, isNew] = found.emplace(ends, static_cast<std::uint32_t>(hull.edges.size()));
            if (isNew) hull.edges.push_back(ends);
            loop.push_back({edge->second, from < to ? 1 : -1});
        }
        const double size = length(normal);
        if (!(size > 0.0)) return false;
        normal = times(normal, 1.0 / size);
        hull.planes.push_back({normal, dot(normal, middle) / static_cast<double>(face.size())});
    }
    return true;
}

/// The principal moments of a symmetric tensor by Jacobi's method, descending.
inline PrincipalInertia principalOf(std::array<std::array<double, 3>, 3> tensor) {
    std::array<std::array<double, 3>, 3> axes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};  // in columns
    const double rounding = 1e-15 * (std::abs(tensor[0][0]) + std::abs(tensor[1][1]) + std::abs(tensor[2][2]));
    const auto rotate = [&](std::size_t p, std::size_t q) {
        if (std::abs(tensor[p][q]) <= rounding) return;
        const double theta = (tensor[q][q] - tensor[p][p]) / (2.0 * tensor[p][q]);
        const double t = (theta < 0.0 ? -1.0 : 1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
        const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
        for (std::size_t k = 0; k < 3; ++k) {
            const double a = tensor[k][p], b = tensor[k][q];
            tensor[k][p] = c * a - s * b;
            tensor[k][q] = s * a + c * b;
            const double u = axes[k][p], v = axes[k][q];
            axes[k][p] = c * u - s * v;
            axes[k][q] = s * u + c * v;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const double a = tensor[p][k], b = tensor[q][k];
            tensor[p][k] = c * a - s * b;
            tensor[q][k] = s * a + c * b;
        }
    };
    for (int sweep = 0; sweep < 30; ++sweep) {
        rotate(0, 1);
        rotate(0, 2);
        rotate(1, 2);
    }
    std::array<std::size_t, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return tensor[a][a] > tensor[b][b]; });
    const auto axis = [&](std::size_t k) { return Vec3{axes[0][order[k]], axes[1][order[k]], axes[2][order[k]]}; };
    const Vec3 x = axis(0), y = axis(1), z = cross(x, y);
    // The quaternion of the matrix with columns x, y and z, by its largest component.
    const std::array<double, 4> squares{1.0 + x.x - y.y - z.z, 1.0 - x.x + y.y - z.z, 1.0 - x.x - y.y + z.z,
                                        1.0 + x.x + y.y + z.z};
    const auto largest = static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
    const double twice = std::sqrt(squares[largest]), rest = 0.5 / twice;
    Quaternion q;
    switch (largest) {
        case 0: q = {0.5 * twice, (x.y + y.x) * rest, (z.x + x.z) * rest, (y.z - z.y) * rest}; break;
        case 1: q = {(x.y + y.x) * rest, 0.5 * twice, (y.z + z.y) * rest, (z.x - x.z) * rest}; break;
        case 2: q = {(z.x + x.z) * rest, (y.z + z.y) * rest, 0.5 * twice, (x.y - y.x) * rest}; break;
        default: q = {(y.z - z.y) * rest, (z.x - x.z) * rest, (x.y - y.x) * rest, 0.5 * twice};
    }
    if (q.w < 0.0) q = {-q.x, -q.y, -q.z, -q.w};
    return {{tensor[order[0]][order[0]], tensor[order[1]][order[1]], tensor[order[2]][order[2]]}, q};
}

/// Adds what follows from a body of version 1.
inline void deriveVersion2(Body& body) {
    body.principal = principalOf(body.inertia);
    constexpr double kFar = std::numeric_limits<double>::max();
    body.bounds = {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
    for (const Hull& hull : body.hulls) {
        for (const Vec3& v : hull.vertices) {
            Vec3 &low = body.bounds.min, &high = body.bounds.max;
            low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
            high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
            body.radius = std::max(body.radius, length(v));
        }
    }
}

/// Whether the children of each body are the fragments whose parent it is, in that order: `bodyOf` gives the fragments,
/// of which there are `count`, and of kNone the whole. So there are no cycles either.
template <class BodyOf>
bool hasConsecutiveChildren(std::uint32_t count, BodyOf bodyOf) {
    std::vector<std::uint32_t> found(count);  // of the children of each fragment
    std::uint32_t foundOfWhole = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t parent = bodyOf(k).parent;
        std::uint32_t& before = parent == kNone ? foundOfWhole : found[parent];
        if (bodyOf(parent).firstChild + before++ != k) return false;
    }
    for (std::uint32_t k = 0; k < count; ++k)
        if (found[k] != bodyOf(k).childCount) return false;
    return foundOfWhole == bodyOf(kNone).childCount;
}

/// Adds what version 1 does not say: levels, children, principal inertia and bounds.
inline void deriveVersion2(Pack& pack) {
    deriveVersion2(pack.whole);
    for (std::uint32_t k = 0; k < pack.fragments.size(); ++k) {
        Body& fragment = pack.fragments[k];
        deriveVersion2(fragment);
        Body& parent = fragment.parent == kNone ? pack.whole : pack.fragments[fragment.parent];
        fragment.level = fragment.parent == kNone ? 0 : parent.level + 1;
        if (parent.childCount == 0) parent.firstChild = k;
        ++parent.childCount;
    }
}

/// Adds centroids and normals to the contacts of the larger of two fragments, which are written at the smaller.
inline void mirrorContacts(Pack& pack) {
    for (std::uint32_t k = 0; k < pack.fragments.size(); ++k) {
        for (const Neighbour& contact : pack.fragments[k].neighbours) {
            if (contact.fragment <= k) continue;
            std::vector<Neighbour>& theirs = pack.fragments[contact.fragment].neighbours;
            const auto before = [](const Neighbour& one, std::uint32_t fragment) { return one.fragment < fragment; };
            const auto back = std::lower_bound(theirs.begin(), theirs.end(), k, before);
            if (back == theirs.end() || back->fragment != k) continue;
            back->centroid = contact.centroid;
            back->normal = times(contact.normal, -1.0);
        }
    }
}

/// Reads values, and keeps the first fault with its place. After it everything reads as nothing.
class Reader {
public:
    std::string fault;

    void refuse(const Value& value, const std::string& reason) {
        const std::string place = value.place();
        if (fault.empty()) fault = (place.empty() ? "The document" : place) + ": " + reason + ".";
    }
    bool is(const Value& value, Kind kind, const char* expected) {
        if (fault.empty() && value->kind != kind) refuse(value, std::string("expected ") + expected);
        return fault.empty();
    }
    /// A member of an object; none if it is missing.
    static std::optional<Value> find(const Value& object, const char* key) {
        const std::vector<Node>& nodes = object.document->nodes;
        for (std::uint32_t child = object.node + 1; child < object->end; child = nodes[child].end) {
            if (object.document->texts[nodes[child].key] == key) return Value{object.document, child, &object, key, 0};
        }
        return std::nullopt;
    }
    /// What `read` makes of a member of an object.
    template <class Read>
    auto at(const Value& object, const char* key, Read read) {
        if (is(object, Kind::Object, "an object")) {
            if (const std::optional<Value> value = find(object, key)) return read(*value);
            refuse(object, std::string("the key \"") + key + "\" is missing");
        }
        return decltype(read(object)){};
    }
    /// The same; of a missing one `absent`.
    template <class Read>
    auto at(const Value& object, const char* key, Read read, decltype(read(object)) absent) {
        const std::optional<Value> value = is(object, Kind::Object, "an object") ? find(object, key) : std::nullopt;
        return value ? read(*value) : absent;
    }
    double number(const Value& value) { return is(value, Kind::Number, "a number") ? value->number : 0.0; }
    double positive(const Value& value) {
        const double read = number(value);
        if (fault.empty() && !(read > 0.0)) refuse(value, "expected a number above 0");
        return read;
    }
    /// A whole number below `end`.
    std::uint32_t index(const Value& value, std::size_t end) {
        const double read = number(value);
        if (fault.empty() && read >= 0.0 && read < static_cast<double>(end) && read == std::floor(read))
            return static_cast<std::uint32_t>(read);
        refuse(value, "expected a whole number below " + std::to_string(end));
        return 0;
    }
    /// The same, or null.
    std::uint32_t link(const Value& value, std::size_t end) {
        return value->kind == Kind::Null ? kNone : index(value, end);
    }
    std::string text(const Value& value) {
        return is(value, Kind::Text, "a text") ? value.document->texts[value->text] : std::string();
    }
    /// Which of the words it is.
    template <class Words>
    std::size_t oneOf(const Value& value, const Words& words) {
        const std::string read = text(value);
        const auto found = std::find(std::begin(words), std::end(words), read);
        if (found == std::end(words)) refuse(value, "\"" + read + "\" is not known to this reader");
        return found == std::end(words) ? 0 : static_cast<std::size_t>(found - std::begin(words));
    }
    std::size_t oneOf(const Value& value, std::initializer_list<std::string_view> words) {
        return oneOf<std::initializer_list<std::string_view>>(value, words);
    }
    /// Calls `visit` with every element of an array.
    template <class Visit>
    void forEach(const Value& value, Visit visit) {
        if (!is(value, Kind::Array, "an array")) return;
        std::size_t number = 0;
        for (std::uint32_t child = value.node + 1; child < value->end && fault.empty();) {
            visit(Value{value.document, child, &value, nullptr, number++});
            child = value.document->nodes[child].end;
        }
    }
    /// An array, each element by `read`. Reserves little: the elements may be short texts in place of large objects.
    template <class Read>
    auto list(const Value& value, Read read) {
        std::vector<decltype(read(value))> elements;
        elements.reserve(std::min(value->count, 256u));
        forEach(value, [&](const Value& element) { elements.push_back(read(element)); });
        return elements;
    }
    template <std::size_t Count>
    std::array<double, Count> numbers(const Value& value) {
        std::array<double, Count> read{};
        if (is(value, Kind::Array, "an array") && value->count != Count)
            refuse(value, "expected " + std::to_string(Count) + " numbers");
        forEach(value, [&](const Value& element) { read[element.number] = number(element); });
        return read;
    }
    Vec3 vector(const Value& value) {
        const std::array<double, 3> read = numbers<3>(value);
        return {read[0], read[1], read[2]};
    }
    std::string textAt(const Value& object, const char* key) {
        return at(object, key, [&](const Value& value) { return text(value); });
    }
    /// A number that may be missing, at least 0.
    double optionalAt(const Value& object, const char* key) {
        const double read = at(
            object, key, [&](const Value& value) { return number(value); }, 0.0);
        if (!(read >= 0.0)) refuse(object, std::string("the key \"") + key + "\" is below 0");
        return read;
    }
    double numberAt(const Value& object, const char* key) {
        return at(object, key, [&](const Value& value) { return number(value); });
    }
    double positiveAt(const Value& object, const char* key) {
        return at(object, key, [&](const Value& value) { return positive(value); });
    }
    Vec3 vectorAt(const Value& object, const char* key) {
        return at(object, key, [&](const Value& value) { return vector(value); });
    }
    std::size_t oneOfAt(const Value& object, const char* key, std::initializer_list<std::string_view> words) {
        return at(object, key, [&](const Value& value) { return oneOf(value, words); });
    }
    std::uint32_t linkAt(const Value& object, const char* key, std::size_t end) {
        return at(object, key, [&](const Value& value) { return link(value, end); });
    }
    template <class Read>
    auto listAt(const Value& object, const char* key, Read read) {
        return at(object, key, [&](const Value& value) { return list(value, read); });
    }

    /// What `read` makes of each element of an array that may be missing.
    template <class Read>
    auto optionalListAt(const Value& object, const char* key, Read read) {
        return at(
            object, key, [&](const Value& value) { return list(value, read); }, std::vector<decltype(read(object))>{});
    }
    Hull hull(const Value& value) {
        Hull read;
        int derived = 0;
        if (is(value, Kind::Object, "an object")) {
            for (const char* key : {"edges", "signedEdges", "planes"}) derived += find(value, key).has_value();
            if (derived != 0 && derived != 3) refuse(value, "expected edges, signed edges and planes, or none of them");
        }
        read.inset = optionalAt(value, "inset");
        read.vertices = listAt(value, "vertices", [&](const Value& v) { return vector(v); });
        const auto vertex = [&](const Value& v) { return index(v, read.vertices.size()); };
        read.edges = optionalListAt(value, "edges", [&](const Value& v) {
            std::array<std::uint32_t, 2> ends{};
            if (is(v, Kind::Array, "an array") && v->count != 2) refuse(v, "expected 2 vertices");
            forEach(v, [&](const Value& end) { ends[end.number] = vertex(end); });
            return ends;
        });
        read.faces = listAt(value, "faces", [&](const Value& v) { return list(v, vertex); });
        const auto signedEdge = [&](const Value& v) {
            const std::array<double, 2> pair = numbers<2>(v);
            if (!(pair[0] >= 0.0 && pair[0] < static_cast<double>(read.edges.size()) && pair[0] == std::floor(pair[0])))
                refuse(v, "expected an edge that is there");
            if (pair[1] != 1.0 && pair[1] != -1.0) refuse(v, "expected an edge, then 1 or -1");
            return fault.empty() ? SignedEdge{static_cast<std::uint32_t>(pair[0]), pair[1] > 0.0 ? 1 : -1}
                                 : SignedEdge{};
        };
        read.signedEdges = optionalListAt(value, "signedEdges", [&](const Value& v) { return list(v, signedEdge); });
        read.planes = optionalListAt(value, "planes", [&](const Value& v) {
            const std::array<double, 4> plane = numbers<4>(v);
            return Plane{{plane[0], plane[1], plane[2]}, plane[3]};
        });
        if (fault.empty() && derived == 0 && !deriveTopology(read)) refuse(value, "a face has no area");
        bool agree = read.faces.size() == read.planes.size() && read.faces.size() == read.signedEdges.size();
        for (std::size_t f = 0; agree && f < read.faces.size(); ++f) {
            agree = read.faces[f].size() >= 3 && read.faces[f].size() == read.signedEdges[f].size();
        }
        if (!agree) refuse(value, "faces, signed edges and planes do not agree");
        return read;
    }
    Neighbour neighbour(const Value& value, std::size_t count) {
        Neighbour read;
        read.fragment = at(value, "fragment", [&](const Value& v) { return index(v, count); });
        read.area = positiveAt(value, "area");
        const auto optionalVector = [&](const char* key) {
            return at(
                value, key, [&](const Value& v) { return vector(v); }, Vec3{});
        };
        read.centroid = optionalVector("centroid");
        read.normal = optionalVector("normal");
        return read;
    }
    PrincipalInertia principal(const Value& value) {
        PrincipalInertia read;
        read.moments = vectorAt(value, "moments");
        const auto rotation = at(value, "rotation", [&](const Value& v) { return numbers<4>(v); });
        read.rotation = {rotation[0], rotation[1], rotation[2], rotation[3]};
        return read;
    }
    /// What version 2 added to a body, of `count` fragments.
    void addVersion2(const Value& value, std::size_t count, Body& body) {
        body.level = countAt(value, "level");
        body.childCount = countAt(value, "childCount");
        body.firstChild = at(
            value, "firstChild", [&](const Value& v) { return index(v, count); }, 0u);
        if (fault.empty() && std::size_t{body.firstChild} + body.childCount > count)
            refuse(value, "expected children that are there");
        body.principal = at(value, "principal", [&](const Value& v) { return principal(v); });
        at(value, "bounds", [&](const Value& v) {
            body.bounds = {vectorAt(v, "min"), vectorAt(v, "max")};
            body.radius = positiveAt(v, "radius");
            body.thinnest = positiveAt(v, "thinnest");
            return 0;
        });
    }
    /// A body that is a fragment of one of the `before` first fragments, of `count`.
    Body body(const Value& value, std::size_t before, std::size_t count) {
        Body read;
        read.id = textAt(value, "id");
        read.name = textAt(value, "name");
        read.parent = linkAt(value, "parent", before);
        read.offset = vectorAt(value, "offset");
        read.volume = positiveAt(value, "volume");
        read.mass = positiveAt(value, "mass");
        read.centreOfMass = vectorAt(value, "centreOfMass");
        at(value, "inertia", [&](const Value& v) {
            if (is(v, Kind::Array, "an array") && v->count != 3) refuse(v, "expected 3 rows");
            forEach(v, [&](const Value& row) { read.inertia[row.number] = numbers<3>(row); });
            return 0;
        });
        read.threshold = optionalAt(value, "threshold");
        read.gap = optionalAt(value, "gap");
        read.lostMass = optionalAt(value, "lostMass");
        read.neighbours = listAt(value, "neighbours", [&](const Value& v) { return neighbour(v, count); });
        read.hulls = listAt(value, "hulls", [&](const Value& v) { return hull(v); });
        if (read.hulls.empty()) refuse(value, "expected at least one hull");
        if (m_version >= 2) addVersion2(value, count, read);
        return read;
    }
    Material material(const Value& value) {
        Material read;
        read.name = textAt(value, "name");
        read.density = positiveAt(value, "density");
        read.friction = numberAt(value, "friction");
        read.restitution = numberAt(value, "restitution");
        read.outside = at(value, "outside", [&](const Value& v) { return numbers<3>(v); });
        read.inside = at(value, "inside", [&](const Value& v) { return numbers<3>(v); });
        read.opacity = at(
            value, "opacity", [&](const Value& v) { return number(v); }, 1.0);
        read.tensileStrength = optionalAt(value, "tensileStrength");
        read.fractureToughness = optionalAt(value, "fractureToughness");
        read.youngsModulus = optionalAt(value, "youngsModulus");
        return read;
    }
    Surface surface(const Value& value) {
        Surface read;
        read.name = textAt(value, "name");
        read.isInside = oneOfAt(value, "side", {"outside", "inside"}) == 1;
        read.colour = at(value, "colour", [&](const Value& v) { return numbers<3>(v); });
        read.opacity = numberAt(value, "opacity");
        read.roughness = numberAt(value, "roughness");
        read.texture = at(
            value, "texture", [&](const Value& v) { return text(v); }, std::string());
        return read;
    }
    Mesh mesh(const Value& value, std::size_t count) {
        Mesh read;
        read.file = textAt(value, "file");
        read.bodies = static_cast<MeshBodies>(oneOfAt(value, "bodies", {"whole", "fragments", "fragment"}));
        read.fragment = linkAt(value, "fragment", count);
        read.place = static_cast<MeshPlace>(oneOfAt(value, "place", {"assembled", "centred"}));
        read.level = at(
            value, "level", [&](const Value& v) { return link(v, count); }, kNone);
        return read;
    }
    Bond bond(const Value& value, const std::vector<Body>& fragments, std::uint32_t parent) {
        Bond read;
        at(value, "fragments", [&](const Value& v) {
            if (is(v, Kind::Array, "an array") && v->count != 2) refuse(v, "expected 2 fragments");
            forEach(v, [&](const Value& end) {
                const std::uint32_t fragment = read.fragments[end.number] = index(end, fragments.size());
                if (fault.empty() && fragments[fragment].parent != parent)
                    refuse(end, "expected a fragment of the body");
            });
            if (fault.empty() && read.fragments[0] >= read.fragments[1]) refuse(v, "expected ascending fragments");
            return 0;
        });
        read.area = positiveAt(value, "area");
        read.centroid = vectorAt(value, "centroid");
        read.normal = vectorAt(value, "normal");
        read.capacity = capacityAt(value);
        read.clusterLevel = at(
            value, "clusterLevel", [&](const Value& v) { return index(v, kNone); }, 0);
        return read;
    }
    Fracture fracture(const Value& value, const std::vector<Body>& fragments) {
        Fracture read;
        read.fragment = linkAt(value, "fragment", fragments.size());
        read.bonds = listAt(value, "bonds", [&](const Value& v) { return bond(v, fragments, read.fragment); });
        return read;
    }
    Bonding bonding(const Value& value, const std::vector<Body>& fragments) {
        Bonding read;
        read.falloffRadius = positiveAt(value, "falloffRadius");
        read.falloff = static_cast<Falloff>(oneOfAt(value, "falloff", {"constant", "linear", "smooth"}));
        read.damageFrom = positiveAt(value, "damageFrom");
        if (read.damageFrom > 1.0) refuse(value, "the key \"damageFrom\" is above 1");
        read.span = numberAt(value, "span");
        read.collapseDelay = numberAt(value, "collapseDelay");
        read.minimumIsland = countAt(value, "minimumIsland");
        read.bake = at(value, "bake", [&](const Value& v) {
            const std::string digits = text(v);
            if (digits.size() != 32 || digits.find_first_not_of("0123456789abcdef") != digits.npos)
                refuse(v, "expected 32 hexadecimal digits");
            return digits;
        });
        read.fractures = listAt(value, "fractures", [&](const Value& v) { return fracture(v, fragments); });
        read.anchored = listAt(value, "anchored", [&](const Value& v) {
            const std::uint32_t fragment = index(v, fragments.size());
            if (fault.empty() && fragments[fragment].parent != kNone) refuse(v, "expected a fragment of the whole");
            return fragment;
        });
        return read;
    }
    /// Refuses what is no pack, or none that this header can read.
    void checkFormat(const Value& root) {
        oneOfAt(root, "format", {"rubble-pack"});
        at(root, "version", [&](const Value& version) {
            const double read = number(version);
            if (read != 1.0 && read != kVersion)
                refuse(version, "this header reads versions up to " + std::to_string(kVersion));
            m_version = fault.empty() ? static_cast<std::uint32_t>(read) : 0;
            return 0;
        });
        at(root, "units", [&](const Value& units) {
            oneOfAt(units, "length", {"m"});
            oneOfAt(units, "mass", {"kg"});
            return oneOfAt(units, "time", {"s"});
        });
        at(root, "axes", [&](const Value& axes) {
            oneOfAt(axes, "handedness", {"right"});
            oneOfAt(axes, "up", {"y"});
            return oneOfAt(axes, "front", {"counter-clockwise"});
        });
    }
    /// What version 2 says of the asset, beside its bodies.
    void addVersion2(const Value& root, Pack& pack) {
        at(root, "asset", [&](const Value& asset) {
            pack.base = textAt(asset, "base");
            pack.variant = countAt(asset, "variant");
            pack.folder = textAt(asset, "folder");
            return 0;
        });
        pack.physicsHash = textAt(root, "physicsHash");
        at(root, "break", [&](const Value& value) {
            oneOfAt(value, "as", {"whole", "bonded"});
            pack.breaksByMomentum = oneOfAt(value, "rule", {"impact", "momentum"}) == 1;
            oneOfAt(value, "velocity", {"beforeSolver"});
            pack.leastSpeed = numberAt(value, "leastSpeed");
            pack.restitutionSpeed = numberAt(value, "restitutionSpeed");
            if (const std::optional<Value> cut = fault.empty() ? find(value, "cutAtImpact") : std::nullopt)
                pack.cutAtImpact = CutAtImpact{countAt(*cut, "fragments"), positiveAt(*cut, "falloffRadius")};
            return 0;
        });
        at(root, "combine", [&](const Value& value) {
            oneOfAt(value, "friction", {"geometricMean"});
            return oneOfAt(value, "restitution", {"maximum"});
        });
        at(root, "collision", [&](const Value& value) { return pack.inset = numberAt(value, "inset"); });
        const auto materials = listAt(root, "materials", [&](const Value& value) { return material(value); });
        const auto materialAt = [&](const char* key) {
            const auto which = at(root, key, [&](const Value& value) { return index(value, materials.size()); });
            return fault.empty() ? materials[which] : Material{};
        };
        pack.material = materialAt("material");
        pack.insideMaterial = materialAt("insideMaterial");
        pack.surfaces = listAt(root, "surfaces", [&](const Value& value) { return surface(value); });
        if (const std::optional<Value> debris = fault.empty() ? find(root, "debris") : std::nullopt)
            pack.debris = Debris{
                optionalAt(*debris, "lifetime"), numberAt(*debris, "fade"),
                at(
                    *debris, "maxFragments", [&](const Value& value) { return index(value, std::size_t{kNone}); }, 0u)};
    }
    /// The members before the bodies, of `count` fragments.
    Pack header(const Value& root, std::size_t count) {
        Pack read;
        checkFormat(root);
        read.version = m_version;
        at(root, "asset", [&](const Value& asset) {
            read.name = textAt(asset, "name");
            return read.asset = at(asset, "id", [&](const Value& id) { return index(id, std::size_t{kNone}); });
        });
        read.hash = textAt(root, "hash");
        read.threshold = positiveAt(root, "threshold");
        if (fault.empty() && m_version < 2) {
            read.material = at(root, "material", [&](const Value& value) { return material(value); });
            read.insideMaterial = read.material;
            read.base = read.name;
        }
        if (fault.empty() && m_version >= 2) addVersion2(root, read);
        read.meshes = listAt(root, "meshes", [&](const Value& value) { return mesh(value, count); });
        return read;
    }
    Pack pack(const Value& root) {
        checkFormat(root);
        std::size_t count = 0;
        at(root, "fragments", [&](const Value& value) {
            if (is(value, Kind::Array, "an array")) count = value->count;
            return 0;
        });
        Pack read = header(root, count);
        read.whole = at(root, "whole", [&](const Value& value) { return body(value, 0, count); });
        read.fragments = at(root, "fragments", [&](const Value& value) {
            return list(value, [&](const Value& element) { return body(element, element.number, count); });
        });
        if (fault.empty() && m_version < 2) deriveVersion2(read);
        const auto bodyOf = [&](std::uint32_t index) -> const Body& { return read.body(index); };
        if (fault.empty() && !hasConsecutiveChildren(static_cast<std::uint32_t>(count), bodyOf))
            refuse(root, "the fragments of a body are not consecutive");
        if (const std::optional<Value> bonds = fault.empty() ? find(root, "bonding") : std::nullopt)
            read.bonding = bonding(*bonds, read.fragments);
        if (fault.empty()) mirrorContacts(read);
        return read;
    }

    bool boolean(const Value& value) {
        is(value, Kind::Boolean, "true or false");
        return fault.empty() && value->number > 0.0;
    }
    bool booleanAt(const Value& object, const char* key) {
        return at(object, key, [&](const Value& value) { return boolean(value); });
    }
    ScenePack scenePack(const Value& value) {
        ScenePack read;
        read.folder = textAt(value, "folder");
        read.physicsHash = textAt(value, "physicsHash");
        read.asset = countAt(value, "asset");
        read.variant = countAt(value, "variant");
        return read;
    }
    SceneInstance instance(const Value& value, const std::vector<ScenePack>& packs) {
        SceneInstance read;
        read.id = countAt(value, "id");
        read.name = textAt(value, "name");
        read.pack = at(value, "pack", [&](const Value& v) {
            const std::string folder = text(v);
            for (std::size_t k = 0; k < packs.size(); ++k) {
                if (packs[k].folder == folder) return static_cast<std::uint32_t>(k);
            }
            refuse(v, "\"" + folder + "\" is no pack of the scene");
            return 0u;
        });
        read.position = vectorAt(value, "position");
        const auto rotation = at(value, "rotation", [&](const Value& v) { return numbers<4>(v); });
        read.rotation = {rotation[0], rotation[1], rotation[2], rotation[3]};
        read.threshold = positiveAt(value, "threshold");
        read.isFixed = booleanAt(value, "fixed");
        read.isUnbreakable = booleanAt(value, "unbreakable");
        read.isAnchored = booleanAt(value, "anchored");
        read.bondStrength = numberAt(value, "bondStrength");
        if (fault.empty() && find(value, "holdsHeaviest")) read.holdsHeaviest = booleanAt(value, "holdsHeaviest");
        if (fault.empty() && find(value, "anchors"))
            read.anchors = listAt(value, "anchors", [&](const Value& v) { return anchor(v); });
        return read;
    }
    double capacityAt(const Value& value) {
        return at(value, "capacity", [&](const Value& v) {
            if (v->kind == Kind::Null) return std::numeric_limits<double>::infinity();
            if (fault.empty() && number(v) < 0.0) refuse(v, "expected a number of at least 0");
            return number(v);
        });
    }
    Bond anchor(const Value& value) {
        Bond read;
        read.fragments[0] = countAt(value, "fragment");
        read.area = positiveAt(value, "area");
        read.centroid = vectorAt(value, "centroid");
        read.normal = vectorAt(value, "normal");
        read.capacity = capacityAt(value);
        return read;
    }
    SceneJoint joint(const Value& value, const std::vector<SceneInstance>& instances) {
        SceneJoint read;
        read.mortar = countAt(value, "mortar");
        std::size_t count = 0;
        at(value, "instances", [&](const Value& v) {
            if (is(v, Kind::Array, "an array") && (v->count < 1 || v->count > 2))
                refuse(v, "expected 1 or 2 instances");
            count = v->count;
            forEach(v, [&](const Value& end) {
                const double id = number(end);
                const auto found = std::find_if(instances.begin(), instances.end(),
                                                [&](const SceneInstance& one) { return one.id == id; });
                if (found == instances.end()) return refuse(end, "there is no such instance");
                read.instances[end.number] = static_cast<std::uint32_t>(found - instances.begin());
            });
            return 0;
        });
        at(value, "fragments", [&](const Value& v) {
            if (is(v, Kind::Array, "an array") && v->count != count) refuse(v, "expected one for each instance");
            forEach(v, [&](const Value& end) { read.fragments[end.number] = index(end, kNone); });
            return 0;
        });
        read.area = positiveAt(value, "area");
        read.centroid = vectorAt(value, "centroid");
        read.normal = vectorAt(value, "normal");
        read.capacity = capacityAt(value);
        return read;
    }
    SceneShot shot(const Value& value) {
        SceneShot read;
        read.id = countAt(value, "id");
        read.name = textAt(value, "name");
        read.time = numberAt(value, "time");
        read.kind = static_cast<SceneShotKind>(oneOfAt(value, "kind", {"throw", "hammer", "explosion"}));
        at(value, "action", [&](const Value& action) {
            if (read.kind == SceneShotKind::Throw) {
                read.projectile =
                    static_cast<Projectile>(oneOfAt(action, "projectile", {"box", "ball", "plank", "asset"}));
                read.asset = countAt(action, "asset");
                read.size = vectorAt(action, "size");
                read.mass = numberAt(action, "mass");
                read.from = vectorAt(action, "from");
                read.to = vectorAt(action, "to");
                read.speed = numberAt(action, "speed");
                return 0;
            }
            read.at = vectorAt(action, "at");
            if (read.kind == SceneShotKind::Hammer) read.impulse = vectorAt(action, "impulse");
            if (read.kind == SceneShotKind::Explosion) read.impulsePerArea = numberAt(action, "impulse");
            read.radius = optionalAt(action, "radius");
            return 0;
        });
        return read;
    }
    Scene scene(const Value& root) {
        Scene read;
        oneOfAt(root, "format", {"rubble-scene"});
        at(root, "version", [&](const Value& version) {
            if (number(version) != 1.0) refuse(version, "this header reads version 1");
            return 0;
        });
        read.gravity = vectorAt(root, "gravity");
        if (const std::optional<Value> ground = fault.empty() ? find(root, "ground") : std::nullopt) {
            read.ground = SceneGround{numberAt(*ground, "height"), numberAt(*ground, "friction"),
                                      numberAt(*ground, "restitution")};
        }
        read.packs = listAt(root, "packs", [&](const Value& value) { return scenePack(value); });
        read.instances = listAt(root, "instances", [&](const Value& value) { return instance(value, read.packs); });
        if (fault.empty() && find(root, "joints"))
            read.joints = listAt(root, "joints", [&](const Value& value) { return joint(value, read.instances); });
        read.shots = listAt(root, "shots", [&](const Value& value) { return shot(value); });
        return read;
    }

    static constexpr std::array<std::string_view, kEventKinds> kKinds{
        "impact", "bonds", "detached", "broken", "settled", "removed", "born", "damaged", "sliding", "rolling"};
    static constexpr double kMaxCount = 9007199254740992.0;  // the whole numbers below are doubles

    std::uint64_t step(const Value& value) {
        return at(value, "step", [&](const Value& v) {
            const double read = number(v);
            if (fault.empty() && !(read >= 0.0 && read < kMaxCount && read == std::floor(read)))
                refuse(v, "expected a step");
            return fault.empty() ? static_cast<std::uint64_t>(read) : 0;
        });
    }
    std::uint32_t countAt(const Value& value, const char* key) {
        return at(value, key, [&](const Value& v) { return index(v, std::size_t{kNone}); });
    }
    Box box(const Value& value) {
        const std::vector<Vec3> corners = list(value, [&](const Value& v) { return vector(v); });
        if (fault.empty() && corners.size() != 2) refuse(value, "expected 2 corners");
        return fault.empty() ? Box{corners[0], corners[1]} : Box{};
    }
    /// A member that may be missing.
    double numberOr0(const Value& value, const char* key) {
        return at(
            value, key, [&](const Value& v) { return number(v); }, 0.0);
    }
    Vec3 vectorOr0(const Value& value, const char* key) {
        return at(
            value, key, [&](const Value& v) { return vector(v); }, Vec3{});
    }
    std::uint32_t wholeOr(const Value& value, const char* key, std::uint32_t absent) {
        return at(
            value, key, [&](const Value& v) { return index(v, std::size_t{kNone}); }, absent);
    }
    std::string textOrNone(const Value& value, const char* key) {
        return at(
            value, key, [&](const Value& v) { return text(v); }, std::string());
    }
    std::vector<std::string> paths(const Value& value) {
        return optionalListAt(value, "fragments", [&](const Value& v) { return text(v); });
    }
    std::array<std::uint32_t, 2> materialPair(const Value& value) {
        const std::vector<std::uint32_t> pair =
            list(value, [&](const Value& v) { return index(v, std::size_t{kNone}); });
        if (fault.empty() && pair.size() != 2) refuse(value, "expected 2 materials");
        return fault.empty() ? std::array<std::uint32_t, 2>{pair[0], pair[1]} : std::array<std::uint32_t, 2>{};
    }
    /// What the kinds of both versions have.
    Event event(const Value& value) {
        Event read;
        read.step = step(value);
        read.kind = at(value, "kind", [&](const Value& v) { return static_cast<EventKind>(oneOf(v, kKinds)); });
        if (fault.empty() && m_eventsVersion < 2 && read.kind > EventKind::Removed)
            refuse(value, "the kind is of version 2, which begins with a line for the whole file");
        read.other = wholeOr(value, "other", kNone);
        read.point = vectorOr0(value, "point");
        read.normal = vectorOr0(value, "normal");
        read.impulse = numberOr0(value, "impulse");
        read.speed = numberOr0(value, "speed");
        read.energy = numberOr0(value, "energy");
        read.area = numberOr0(value, "area");
        read.mass = numberOr0(value, "mass");
        read.count = wholeOr(value, "count", 0);
        read.reason = at(
            value, "reason",
            [&](const Value& v) {
                return static_cast<RemovalReason>(1 + oneOf(v, {"lifetime", "budget", "leftWorld", "input"}));
            },
            RemovalReason::None);
        if (m_eventsVersion < 2) {
            addVersion1(value, read);
        } else {
            addVersion2(value, read);
        }
        return read;
    }
    void addVersion1(const Value& value, Event& read) {
        read.body = countAt(value, "body");
        read.instance = countAt(value, "instance");
        read.fragment = textAt(value, "fragment");
        read.point = vectorAt(value, "point");
        read.materials = at(value, "materials", [&](const Value& v) { return materialPair(v); });
        read.box = at(value, "box", [&](const Value& v) { return box(v); });
    }
    void addVersion2(const Value& value, Event& read) {
        const bool isOfBody = read.kind != EventKind::Damaged;
        if (isOfBody) read.body = countAt(value, "body");
        read.instance = isOfBody ? wholeOr(value, "instance", 0) : countAt(value, "instance");
        read.materials = at(
            value, "materials", [&](const Value& v) { return materialPair(v); }, std::array<std::uint32_t, 2>{});
        read.box = at(
            value, "box", [&](const Value& v) { return box(v); }, Box{});
        read.masses = at(
            value, "masses", [&](const Value& v) { return numbers<2>(v); }, std::array<double, 2>{});
        read.restMass = numberOr0(value, "restMass");
        read.load = numberOr0(value, "load");
        read.position = vectorOr0(value, "position");
        const std::array<double, 4> turned = at(
            value, "rotation", [&](const Value& v) { return numbers<4>(v); },
            std::array<double, 4>{0.0, 0.0, 0.0, 1.0});
        read.rotation = {turned[0], turned[1], turned[2], turned[3]};
        read.velocity = vectorOr0(value, "velocity");
        read.angularVelocity = vectorOr0(value, "angularVelocity");
        read.fragments = paths(value);
        read.name = textOrNone(value, "name");
        read.asset = wholeOr(value, "asset", 0);
        read.variant = wholeOr(value, "variant", 0);
        read.projectile = textOrNone(value, "projectile");
        read.size = vectorOr0(value, "size");
        read.isFixed = at(
            value, "fixed", [&](const Value& v) { return boolean(v); }, false);
        if (!isOfBody) read.damage = eventDamage(value);
    }
    EventDamage eventDamage(const Value& value) {
        EventDamage read;
        const auto whole = [&](const Value& v) { return index(v, std::size_t{kNone}); };
        read.broken = listAt(value, "broken", whole);
        read.weakened = listAt(value, "weakened", [&](const Value& v) {
            const std::vector<std::uint32_t> pair = list(v, whole);
            if (fault.empty() && (pair.size() != 2 || pair[1] < 1 || pair[1] > 254))
                refuse(v, "expected a bond and its damage, 1 to 254");
            return fault.empty() ? std::pair(pair[0], pair[1]) : std::pair(0u, 0u);
        });
        if (fault.empty() && find(value, "cut"))
            read.cut = at(value, "cut", [&](const Value& v) { return textAt(v, "number"); });
        return read;
    }
    /// The first line of version 2.
    void addEventHeader(const Value& value, EventLog& log) {
        oneOfAt(value, "format", {"rubble-events"});
        at(value, "version", [&](const Value& version) {
            if (number(version) != 2.0) refuse(version, "this header reads version 2");
            return 0;
        });
        m_eventsVersion = log.version = 2;
        log.step = step(value);
        log.dt = positiveAt(value, "dt");
        log.gravity = vectorAt(value, "gravity");
        log.materials = listAt(value, "materials", [&](const Value& v) {
            return EventMaterial{countAt(v, "material"), textAt(v, "name")};
        });
        log.assets = listAt(value, "assets", [&](const Value& v) {
            return EventAsset{countAt(v, "asset"), countAt(v, "variant"),  textAt(v, "name"),
                              textAt(v, "folder"), countAt(v, "material"), paths(v)};
        });
        log.bodies = listAt(value, "bodies", [&](const Value& v) {
            Event read;
            read.kind = EventKind::Born;
            read.step = log.step;
            read.mass = numberOr0(v, "mass");
            addVersion2(v, read);
            return read;
        });
    }
    EventSums sums(const Value& value) {
        EventSums read;
        read.step = step(value);
        read.restEnergy = numberAt(value, "restEnergy");
        at(value, "omitted", [&](const Value& omitted) {
            std::size_t kind = 0;
            for (const std::string_view name : kKinds) {
                read.omitted[kind++] = at(
                    omitted, name.data(),
                    [&](const Value& v) {
                        return OmittedEvents{countAt(v, "count"), numberAt(v, "energy")};
                    },
                    OmittedEvents{});
            }
            return 0;
        });
        return read;
    }
    /// Adds a line of events to a log.
    void addLine(const Value& value, EventLog& log, bool isFirst) {
        m_eventsVersion = log.version;
        if (isFirst && is(value, Kind::Object, "an object") && find(value, "format")) {
            addEventHeader(value, log);
        } else if (textAt(value, "kind") == "sums") {
            log.sums.push_back(sums(value));
        } else {
            log.events.push_back(event(value));
        }
    }

private:
    std::uint32_t m_version = 0;
    std::uint32_t m_eventsVersion = 1;
};

/// Appends a bond to a structure.
inline void link(Structure& structure, const Bond& bond) {
    const auto index = static_cast<std::uint32_t>(structure.bonds.size());
    std::array<std::uint32_t, 2> ends{kNone, kNone};
    for (std::size_t k = 0; k < 2; ++k) {
        if (bond.fragments[k] == kNone) continue;
        ends[k] = structure.numberOf(bond.fragments[k]);
        structure.fragmentBonds[ends[k]].push_back(index);
    }
    structure.bonds.push_back(bond);
    structure.ends.push_back(ends);
}

/// The number of the fragment at the other end of a bond; kNone: an anchor.
inline std::uint32_t otherEnd(const Structure& structure, std::uint32_t bond, std::uint32_t number) {
    const std::array<std::uint32_t, 2>& ends = structure.ends[bond];
    return ends[0] == number ? ends[1] : ends[0];
}

/// Whether a bond holds nothing: without capacity it never did.
inline bool isBroken(const Structure& structure, const std::vector<Damage>& damage, std::size_t bond) {
    return damage[bond] == kBroken || !(structure.bonds[bond].capacity > 0.0);
}

inline bool isAnchored(const Structure& structure, const std::vector<Damage>& damage, std::uint32_t number) {
    const std::vector<std::uint32_t>& bonds = structure.fragmentBonds[number];
    return std::any_of(bonds.begin(), bonds.end(), [&](std::uint32_t bond) {
        return structure.ends[bond][1] == kNone && !isBroken(structure, damage, bond);
    });
}

/// The length sideways of a step from a fragment over one of its bonds, m.
inline double sidewaysStep(const Structure& structure, std::uint32_t bond, std::uint32_t from, const Vec3& up) {
    constexpr double kStandsOn = 0.5;                // cosine of 60 degrees
    constexpr double kCorbel = 0.57735026918962576;  // tangent of 30 degrees
    const double along = dot(structure.bonds[bond].normal, up);
    const double upwards = structure.ends[bond][0] == from ? along : -along;
    const Vec3 apart = minus(structure.centres[otherEnd(structure, bond, from)], structure.centres[from]);
    const double height = dot(apart, up);
    const double sideways = length(minus(apart, {height * up.x, height * up.y, height * up.z}));
    return upwards >= kStandsOn ? std::max(0.0, sideways - kCorbel * height) : sideways;
}

/// The distance of each fragment of a body from the nearest anchor, m, by number: up to its limit, else infinite. Those
/// that are not of the body stay below 0.
/// Source: Dijkstra 1959, by (distance, number).
inline std::vector<double> anchorDistances(const Structure& structure, const std::vector<Damage>& damage,
                                           const std::vector<std::uint32_t>& body, const std::vector<double>& limits,
                                           const Vec3& up) {
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    std::vector<double> distances(structure.fragments.size(), -1.0);
    const auto reach = [&](std::uint32_t number, double distance) {
        if (!(distance < distances[number])) return;
        distances[number] = distance;
        queue.push({distance, number});
    };
    for (const std::uint32_t fragment : body)
        distances[structure.numberOf(fragment)] = std::numeric_limits<double>::infinity();
    for (const std::uint32_t fragment : body) {
        const std::uint32_t number = structure.numberOf(fragment);
        if (isAnchored(structure, damage, number)) reach(number, 0.0);
    }
    while (!queue.empty()) {
        const auto [distance, number] = queue.top();
        queue.pop();
        if (distance > distances[number]) continue;
        for (const std::uint32_t bond : structure.fragmentBonds[number]) {
            const std::uint32_t next = otherEnd(structure, bond, number);
            if (next == kNone || isBroken(structure, damage, bond)) continue;
            const double reached = distance + sidewaysStep(structure, bond, number, up);
            if (reached <= limits[next]) reach(next, reached);
        }
    }
    return distances;
}

/// A vector of the world in the axes of a frame with this rotation.
inline Vec3 inAxes(const Quaternion& rotation, const Vec3& v) {
    const Vec3 axis{-rotation.x, -rotation.y, -rotation.z}, across = cross(axis, v);
    return plus(v, times(plus(times(across, rotation.w), cross(axis, across)), 2.0));
}

inline Quaternion normalized(const Quaternion& q) {
    const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    return {q.x / length, q.y / length, q.z / length, q.w / length};
}

/// The half of a joint in the frame of one of its instances.
inline Bond halfOf(const SceneJoint& joint, std::size_t side, const SceneInstance& instance) {
    const Quaternion rotation = normalized(instance.rotation);
    Bond half;
    half.fragments = {joint.fragments[side], kNone};
    half.area = joint.area;
    half.centroid = inAxes(rotation, minus(joint.centroid, instance.position));
    half.normal = inAxes(rotation, side == 0 ? joint.normal : times(joint.normal, -1.0));
    half.capacity = joint.capacity;
    return half;
}

/// The islands of all structures as units that mortar joins.
class MortarUnits {
public:
    MortarUnits(const SceneStructures& all, const std::vector<std::vector<Damage>>& damages) {
        for (std::size_t k = 0; k < all.structures.size(); ++k) add(all, k, damages[k]);
    }
    std::uint32_t rootOf(const SceneStructures& all, const SceneBond& half) {
        return rootOf(m_units[half.instance][all.structures[half.instance].ends[half.bond][0]]);
    }
    void join(std::uint32_t a, std::uint32_t b) {
        m_isAnchored[std::min(a, b)] = m_isAnchored[a] || m_isAnchored[b];
        m_parents[std::max(a, b)] = std::min(a, b);
    }
    bool isAnchored(std::uint32_t root) const { return m_isAnchored[root]; }

private:
    std::uint32_t rootOf(std::uint32_t unit) {
        while (m_parents[unit] != unit) unit = m_parents[unit] = m_parents[m_parents[unit]];
        return unit;
    }
    /// Adds the islands of a structure, which its own anchors hold, and not the halves of joints.
    void add(const SceneStructures& all, std::size_t k, std::vector<Damage> damage) {
        const Structure& structure = all.structures[k];
        for (const std::uint32_t half : all.jointBonds[k]) damage[half] = kBroken;
        m_units.emplace_back(structure.fragments.size());
        std::uint32_t heaviest = kNone;
        double most = -1.0;
        for (const Island& island : islandsOf(structure, damage, structure.fragments)) {
            const auto unit = static_cast<std::uint32_t>(m_parents.size());
            m_parents.push_back(unit);
            m_isAnchored.push_back(island.isAnchored);
            double mass = 0.0;
            for (const std::uint32_t fragment : island.fragments) {
                const std::uint32_t number = structure.numberOf(fragment);
                m_units[k][number] = unit;
                mass += all.masses[k][number];
            }
            if (mass > most) most = mass, heaviest = unit;
        }
        if (all.holdHeaviest[k] && heaviest != kNone) m_isAnchored[heaviest] = true;
    }

    std::vector<std::vector<std::uint32_t>> m_units;  // by instance and number
    std::vector<std::uint32_t> m_parents;
    std::vector<bool> m_isAnchored;  // of roots
};

/// How far fragments of all structures are from what supports them, as fractions of the span of their instance; of
/// those that are not held, below 0.
/// Source: Dijkstra 1959, by (fraction, instance, number).
class SupportFractions {
public:
    SupportFractions(const SceneStructures& all, const std::vector<std::vector<Damage>>& damages,
                     const std::vector<std::vector<std::uint32_t>>& held,
                     const std::vector<std::vector<double>>& limits)
        : m_all(all), m_damages(damages), m_limits(limits) {
        m_other.resize(all.structures.size());
        for (const auto& joint : all.halves) {
            m_other[joint[0].instance][joint[0].bond] = joint[1];
            m_other[joint[1].instance][joint[1].bond] = joint[0];
        }
        for (std::size_t k = 0; k < all.structures.size(); ++k) {
            m_fractions.emplace_back(all.structures[k].fragments.size(), -1.0);
            for (const std::uint32_t fragment : held[k])
                m_fractions[k][all.structures[k].numberOf(fragment)] = std::numeric_limits<double>::infinity();
        }
        for (std::uint32_t k = 0; k < all.structures.size(); ++k) addSources(k);
        while (!m_queue.empty()) {
            const auto [fraction, instance, number] = m_queue.top();
            m_queue.pop();
            if (fraction > m_fractions[instance][number]) continue;
            for (const std::uint32_t bond : all.structures[instance].fragmentBonds[number])
                follow(instance, number, bond, fraction);
        }
    }
    std::vector<std::vector<double>> fractions() && { return std::move(m_fractions); }

private:
    bool isBroken(std::uint32_t instance, std::uint32_t bond) const {
        return detail::isBroken(m_all.structures[instance], m_damages[instance], bond);
    }
    bool hasSpan(std::uint32_t instance) const { return m_all.spans[instance] > 0.0 && !m_all.holdHeaviest[instance]; }

    void addSources(std::uint32_t k) {
        const Structure& structure = m_all.structures[k];
        for (std::uint32_t number = 0; number < structure.fragments.size() && !hasSpan(k); ++number)
            reach(k, number, 0.0);
        for (std::uint32_t bond = 0; bond < structure.bonds.size(); ++bond) {
            const bool isAnchor = structure.ends[bond][1] == kNone && m_other[k].find(bond) == m_other[k].end();
            if (isAnchor && !isBroken(k, bond)) reach(k, structure.ends[bond][0], 0.0);
        }
    }
    void follow(std::uint32_t k, std::uint32_t number, std::uint32_t bond, double fraction) {
        if (isBroken(k, bond)) return;
        const std::uint32_t next = otherEnd(m_all.structures[k], bond, number);
        if (next != kNone) {
            const double step = hasSpan(k) ? sidewaysStep(m_all.structures[k], bond, number, m_all.ups[k]) : 0.0;
            reach(k, next, fraction + perMetre(k) * step);
        } else if (const auto other = m_other[k].find(bond); other != m_other[k].end()) {
            if (!isBroken(other->second.instance, other->second.bond)) cross({k, bond}, other->second, fraction);
        }
    }
    /// Goes on over mortar.
    void cross(const SceneBond& half, const SceneBond& other, double fraction) {
        constexpr double kStandsOn = 0.5;  // cosine of 60 degrees
        const Structure &from = m_all.structures[half.instance], &to = m_all.structures[other.instance];
        const double upwards = dot(from.bonds[half.bond].normal, m_all.ups[half.instance]);
        const std::uint32_t number = to.ends[other.bond][0];
        if (upwards <= -kStandsOn) return;  // it would hang
        if (upwards >= kStandsOn) return reach(other.instance, number, 0.0);
        const double step = sideways(half) + sideways(other);
        reach(other.instance, number, fraction + perMetre(other.instance) * step);
    }
    /// How far a half is from the centre of mass of its fragment sideways, m.
    double sideways(const SceneBond& half) const {
        const Structure& structure = m_all.structures[half.instance];
        const Vec3& up = m_all.ups[half.instance];
        const Vec3 apart = minus(structure.bonds[half.bond].centroid, structure.centres[structure.ends[half.bond][0]]);
        return length(minus(apart, times(up, dot(apart, up))));
    }
    double perMetre(std::uint32_t k) const { return hasSpan(k) ? 1.0 / m_all.spans[k] : 0.0; }
    void reach(std::uint32_t k, std::uint32_t number, double fraction) {
        double& known = m_fractions[k][number];
        if (!(fraction < known) || (!m_limits.empty() && !(fraction <= m_limits[k][number]))) return;
        known = fraction;
        m_queue.push({fraction, k, number});
    }

    using Entry = std::tuple<double, std::uint32_t, std::uint32_t>;

    const SceneStructures& m_all;
    const std::vector<std::vector<Damage>>& m_damages;
    const std::vector<std::vector<double>>& m_limits;
    std::vector<std::map<std::uint32_t, SceneBond>> m_other;  // by instance and bond: the other half
    std::vector<std::vector<double>> m_fractions;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
};

inline double loadFraction(const Bonding& rule, double distance) {
    const double x = distance / rule.falloffRadius;
    if (x > 1.0) return 0.0;
    switch (rule.falloff) {
        case Falloff::Constant: return 1.0;
        case Falloff::Linear: return 1.0 - x;
        case Falloff::Smooth: return 1.0 - x * x * (3.0 - 2.0 * x);
    }
    return 0.0;
}

inline double utilization(double load, double capacity) {
    if (capacity > 0.0) return load / capacity;
    return load > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

inline Damage damageAfter(Damage damage, double utilization, double damageFrom) {
    if (utilization >= 1.0) return kBroken;
    if (utilization < damageFrom) return damage;
    const double increase = (utilization - damageFrom) / (1.0 - damageFrom);
    return static_cast<Damage>(std::min(int{kBroken}, damage + static_cast<int>(increase * kBroken)));
}

/// A bond under a hit.
struct LoadedBond {
    std::uint32_t bond = 0;
    double fraction = 0.0;     // of the impulse
    double utilization = 0.0;  // at the full impulse
    double distance = 0.0;     // m
};

/// The flags of fragments, by number.
inline std::vector<bool> flagsOf(const Structure& structure, const std::vector<std::uint32_t>& fragments) {
    std::vector<bool> flags(structure.fragments.size());
    for (const std::uint32_t fragment : fragments) flags[structure.numberOf(fragment)] = true;
    return flags;
}

/// Adds to some fragments of a body the rest of their clusters: what bonds of levels above `level` connect with them.
inline void addClusters(const Structure& structure, const std::vector<Damage>& damage, const std::vector<bool>& isIn,
                        std::uint32_t level, std::vector<bool>& isFound) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t number = 0; number < isFound.size(); ++number) {
        if (isFound[number]) found.push_back(number);
    }
    while (!found.empty()) {
        const std::uint32_t number = found.back();
        found.pop_back();
        for (const std::uint32_t bond : structure.fragmentBonds[number]) {
            const std::uint32_t other = otherEnd(structure, bond, number);
            if (other == kNone || !isIn[other] || isFound[other]) continue;
            if (isBroken(structure, damage, bond) || structure.bonds[bond].clusterLevel <= level) continue;
            isFound[other] = true;
            found.push_back(other);
        }
    }
}

/// A body that is hit at points.
class StruckBody {
public:
    StruckBody(const Structure& structure, const std::vector<std::uint32_t>& body, const std::vector<Vec3>& points,
               const std::vector<Damage>& damage)
        : m_structure(structure),
          m_points(points),
          m_level(breakingLevel(structure, damage, body)),
          m_isIn(flagsOf(structure, body)),
          m_isStruck(m_isIn.size()) {
        for (const Vec3& point : points) strike(point);
        addClusters(structure, damage, m_isIn, m_level, m_isStruck);
    }

    /// The bonds that the hit loads enough to damage them, in the order in which they take of it.
    std::vector<LoadedBond> loadedBonds(const Bonding& rule, double impulse, const std::vector<Damage>& damage) const {
        std::vector<LoadedBond> loaded;
        for (std::uint32_t bond = 0; bond < m_structure.bonds.size(); ++bond) {
            const auto [first, second] = m_structure.ends[bond];
            if (isBroken(m_structure, damage, bond) || !m_isIn[first]) continue;
            if (second != kNone && !m_isIn[second]) continue;
            if (m_structure.bonds[bond].clusterLevel > m_level) continue;
            const double distance = distanceOf(m_structure.bonds[bond].centroid);
            const bool isStruck = m_isStruck[first] || (second != kNone && m_isStruck[second]);
            const double fraction = isStruck ? 1.0 : loadFraction(rule, distance);
            const double used = utilization(impulse * fraction, m_structure.bonds[bond].capacity);
            if (fraction > 0.0 && used >= rule.damageFrom) loaded.push_back({bond, fraction, used, distance});
        }
        std::sort(loaded.begin(), loaded.end(), [](const LoadedBond& a, const LoadedBond& b) {
            return std::tie(b.utilization, a.distance, a.bond) < std::tie(a.utilization, b.distance, b.bond);
        });
        return loaded;
    }

private:
    /// Marks the fragment of the body whose centre is nearest to a point.
    void strike(const Vec3& point) {
        std::size_t nearest = m_isIn.size();
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t number = 0; number < m_isIn.size(); ++number) {
            const Vec3 arm = minus(m_structure.centres[number], point);
            const double square = dot(arm, arm);
            if (!m_isIn[number] || !(square < least)) continue;
            least = square;
            nearest = number;
        }
        if (nearest < m_isIn.size()) m_isStruck[nearest] = true;
    }
    double distanceOf(const Vec3& centroid) const {
        double least = std::numeric_limits<double>::infinity();
        for (const Vec3& point : m_points) least = std::min(least, length(minus(centroid, point)));
        return least;
    }

    const Structure& m_structure;
    const std::vector<Vec3>& m_points;
    std::uint32_t m_level;         // of clusters
    std::vector<bool> m_isIn;      // by number
    std::vector<bool> m_isStruck;  // by number
};

/// The little-endian number of `size` bytes from `at`.
inline std::uint64_t numberOf(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t k = size; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
    return value;
}

inline void addNumber(std::string& bytes, std::uint64_t value, int size) {
    for (int k = 0; k < size; ++k) bytes.push_back(static_cast<char>(value >> (8 * k) & 0xff));
}

/// The lower half of XXH3 (128 bits, seed 0) of more than 16 bytes.
/// Source: the specification of XXH3 in the documentation of xxHash; the secret is its default one.
class Xxh3 {
public:
    static std::uint64_t lowOf(std::string_view bytes) {
        if (bytes.size() > 240) return ofMany(bytes);
        return bytes.size() > 128 ? ofSome(bytes) : ofFew(bytes);
    }

private:
    static constexpr std::uint64_t k32_1 = 0x9e3779b1u, k32_2 = 0x85ebca77u, k32_3 = 0xc2b2ae3du;
    static constexpr std::uint64_t k64_1 = 0x9e3779b185ebca87u, k64_2 = 0xc2b2ae3d27d4eb4fu;
    static constexpr std::uint64_t k64_3 = 0x165667b19e3779f9u, k64_4 = 0x85ebca77c2b2ae63u;
    static constexpr std::uint64_t k64_5 = 0x27d4eb2f165667c5u;
    static constexpr std::size_t kSecretBytes = 192, kStripe = 64, kStripes = 16;  // of a block

    /// Eight bytes of the secret from any of them.
    static std::uint64_t secret(std::size_t at) {
        static constexpr std::array<std::uint64_t, kSecretBytes / 8> kWords{
            0xbe4ba423396cfeb8u, 0x1cad21f72c81017cu, 0xdb979083e96dd4deu, 0x1f67b3b7a4a44072u, 0x78e5c0cc4ee679cbu,
            0x2172ffcc7dd05a82u, 0x8e2443f7744608b8u, 0x4c263a81e69035e0u, 0xcb00c391bb52283cu, 0xa32e531b8b65d088u,
            0x4ef90da297486471u, 0xd8acdea946ef1938u, 0x3f349ce33f76faa8u, 0x1d4f0bc7c7bbdcf9u, 0x3159b4cd4be0518au,
            0x647378d9c97e9fc8u, 0xc3ebd33483acc5eau, 0xeb6313faffa081c5u, 0x49daf0b751dd0d17u, 0x9e68d429265516d3u,
            0xfca1477d58be162bu, 0xce31d07ad1b8f88fu, 0x280416958f3acb45u, 0x7e404bbbcafbd7afu};
        const std::size_t word = at / 8, shift = 8 * (at % 8);
        return shift == 0 ? kWords[word] : kWords[word] >> shift | kWords[word + 1] << (64 - shift);
    }
    static std::uint64_t read(std::string_view bytes, std::size_t at) { return numberOf(bytes, at, 8); }
    /// Both halves of the product, combined.
    static std::uint64_t folded(std::uint64_t a, std::uint64_t b) {
        const std::uint64_t a0 = a & 0xffffffffu, a1 = a >> 32, b0 = b & 0xffffffffu, b1 = b >> 32;
        const std::uint64_t middle = a1 * b0 + (a0 * b0 >> 32);
        const std::uint64_t carried = (middle & 0xffffffffu) + a0 * b1;
        return (a * b) ^ (a1 * b1 + (middle >> 32) + (carried >> 32));
    }
    static std::uint64_t avalanche(std::uint64_t h) {
        h = (h ^ (h >> 37)) * 0x165667919e3779f9u;
        return h ^ (h >> 32);
    }

    struct Sums {
        std::uint64_t low = 0, high = 0;

        void mix(std::string_view bytes, std::size_t first, std::size_t second, std::size_t key) {
            low += folded(read(bytes, first) ^ secret(key), read(bytes, first + 8) ^ secret(key + 8));
            low ^= read(bytes, second) + read(bytes, second + 8);
            high += folded(read(bytes, second) ^ secret(key + 16), read(bytes, second + 8) ^ secret(key + 24));
            high ^= read(bytes, first) + read(bytes, first + 8);
        }
    };

    static std::uint64_t ofFew(std::string_view bytes) {
        Sums sums{bytes.size() * k64_1, 0};
        for (std::size_t k = (bytes.size() - 1) / 32 + 1; k-- > 0;)
            sums.mix(bytes, 16 * k, bytes.size() - 16 * (k + 1), 32 * k);
        return avalanche(sums.low + sums.high);
    }
    static std::uint64_t ofSome(std::string_view bytes) {
        Sums sums{bytes.size() * k64_1, 0};
        for (std::size_t k = 0; k < 4; ++k) sums.mix(bytes, 32 * k, 32 * k + 16, 32 * k);
        sums = {avalanche(sums.low), avalanche(sums.high)};
        for (std::size_t k = 4; 32 * (k + 1) <= bytes.size(); ++k)
            sums.mix(bytes, 32 * k, 32 * k + 16, 3 + 32 * (k - 4));
        sums.mix(bytes, bytes.size() - 16, bytes.size() - 32, 103);
        return avalanche(sums.low + sums.high);
    }
    static void accumulate(std::array<std::uint64_t, 8>& sums, std::string_view bytes, std::size_t at,
                           std::size_t key) {
        for (std::size_t lane = 0; lane < 8; ++lane) {
            const std::uint64_t value = read(bytes, at + 8 * lane), keyed = value ^ secret(key + 8 * lane);
            sums[lane ^ 1] += value;
            sums[lane] += (keyed & 0xffffffffu) * (keyed >> 32);
        }
    }
    static std::uint64_t ofMany(std::string_view bytes) {
        std::array<std::uint64_t, 8> sums{k32_3, k64_1, k64_2, k64_3, k64_4, k32_2, k64_5, k32_1};
        const std::size_t stripes = (bytes.size() - 1) / kStripe;
        for (std::size_t stripe = 0; stripe < stripes; ++stripe) {
            accumulate(sums, bytes, kStripe * stripe, 8 * (stripe % kStripes));
            if (stripe % kStripes != kStripes - 1) continue;
            for (std::size_t lane = 0; lane < 8; ++lane)
                sums[lane] = (sums[lane] ^ (sums[lane] >> 47) ^ secret(kSecretBytes - kStripe + 8 * lane)) * k32_1;
        }
        accumulate(sums, bytes, bytes.size() - kStripe, kSecretBytes - kStripe - 7);
        std::uint64_t merged = bytes.size() * k64_1;
        for (std::size_t k = 0; k < 8; k += 2)
            merged += folded(sums[k] ^ secret(11 + 8 * k), sums[k + 1] ^ secret(19 + 8 * k));
        return avalanche(merged);
    }
};

inline std::uint64_t checksum(std::string_view bytes) { return Xxh3::lowOf(bytes); }

/// What every damage of bonds of a bake begins with.
inline std::string damageHeader(const std::string& bake) {
    std::string bytes = "RDMG";
    bytes += {1, 2, 0};  // version, kind, no cut
    for (const std::size_t first : {std::size_t{0}, std::size_t{16}}) {
        std::uint64_t half = 0;
        if (bake.size() == 32) std::from_chars(bake.data() + first, bake.data() + first + 16, half, 16);
        addNumber(bytes, half, 8);
    }
    return bytes;
}

/// Reads a damage of as many bonds as `all` has; returns what is wrong with it, or null.
inline const char* readDamages(std::string_view bytes, const std::string& bake, std::vector<Damage>& all) {
    const std::string header = damageHeader(bake);
    const std::size_t bits = header.size() + 4, partial = bits + (all.size() + 7) / 8;
    if (bytes.size() < bits + 12) return "The damage is too short.";
    if (bytes.substr(0, 4) != header.substr(0, 4)) return "The text is not a damage.";
    if (checksum(bytes.substr(0, bytes.size() - 8)) != numberOf(bytes, bytes.size() - 8, 8))
        return "The damage was changed on its way: its checksum does not fit.";
    if (bytes.substr(0, 7) != header.substr(0, 7)) return "The damage is not of bonds, or of another version.";
    if (bytes.substr(0, header.size()) != header) return "The damage is of another bake.";
    if (numberOf(bytes, header.size(), 4) != all.size()) return "The damage is of another number of bonds.";
    if (bytes.size() < partial + 12) return "The damage is too short.";
    const std::uint64_t count = numberOf(bytes, partial, 4);
    if (bytes.size() != partial + 4 + 4 * count + 8) return "The damage has another size than its bonds take.";
    for (std::size_t k = 0; k < 8 * (partial - bits); ++k) {
        const bool isBroken = (numberOf(bytes, bits + k / 8, 1) >> (k % 8) & 1) != 0;
        if (isBroken && k >= all.size()) return "The damage has bits beyond its last bond.";
        if (isBroken) all[k] = kBroken;
    }
    std::size_t next = 0;  // the least bond that may follow
    for (std::size_t at = partial + 4; at < partial + 4 + 4 * count; at += 4) {
        const std::size_t bond = numberOf(bytes, at, 3);
        const auto one = static_cast<Damage>(numberOf(bytes, at + 3, 1));
        if (bond < next || bond >= all.size() || all[bond] == kBroken || one == 0 || one == kBroken)
            return "A damaged bond is broken, out of order or does not exist.";
        all[bond] = one;
        next = bond + 1;
    }
    return nullptr;
}

/// Finds the sections of a pack.bin and checks that all indices in them are in range.
class BinaryOpener {
public:
    explicit BinaryOpener(std::string_view bytes) : m_bytes(bytes) {}

    /// What is wrong with the bytes, or null.
    const char* open(BinaryPack& pack) {
        constexpr std::size_t kHead = 24, kEntry = 24, kChecksum = 8;
        if (m_bytes.size() < kHead + kChecksum) return "It is too short.";
        if (m_bytes.substr(0, 8) != "RUBBLEPK") return "It is not a pack.bin.";
        if (numberOf(m_bytes, 8, 4) != 1) return "It has a version that this header does not read.";
        if (numberOf(m_bytes, 16, 8) != m_bytes.size()) return "It has another size than it should.";
        const std::string_view content = m_bytes.substr(0, m_bytes.size() - kChecksum);
        if (checksum(content) != numberOf(m_bytes, content.size(), kChecksum))
            return "It was changed: its checksum does not fit.";
        const std::uint64_t count = numberOf(m_bytes, 12, 4);
        if (count > (content.size() - kHead) / kEntry) return "Its table of sections does not fit.";
        for (std::uint64_t k = 0; k < count; ++k) {
            Section section;
            const std::size_t at = kHead + kEntry * static_cast<std::size_t>(k);
            const std::uint64_t kind = numberOf(m_bytes, at, 4);
            section.elementSize = numberOf(m_bytes, at + 4, 4);
            section.offset = numberOf(m_bytes, at + 8, 8);
            section.count = numberOf(m_bytes, at + 16, 8);
            if (section.elementSize == 0 || section.offset > content.size()) return "A section does not fit.";
            if (section.count > (content.size() - section.offset) / section.elementSize)
                return "A section does not fit.";
            if (kind >= 1 && kind <= m_sections.size()) m_sections[static_cast<std::size_t>(kind) - 1] = section;
        }
        const bool isThere = text(1, pack.header) && array(2, pack.bodies) && array(3, pack.hulls) &&
                             array(4, pack.vertices) && array(5, pack.loops) && array(6, pack.contacts) &&
                             text(7, pack.texts);
        if (!isThere) return "A section is missing.";
        return indexFault(pack);
    }

private:
    struct Section {
        std::uint64_t elementSize = 0, offset = 0, count = 0;
    };

    bool text(std::size_t kind, std::string_view& view) const {
        const Section& section = m_sections[kind - 1];
        if (section.elementSize != 1) return false;
        view = m_bytes.substr(static_cast<std::size_t>(section.offset), static_cast<std::size_t>(section.count));
        return true;
    }
    template <class T>
    bool array(std::size_t kind, BinaryArray<T>& view) const {
        const Section& section = m_sections[kind - 1];
        if (section.elementSize < sizeof(T)) return false;
        view = BinaryArray<T>(m_bytes.data() + section.offset, static_cast<std::size_t>(section.count),
                              static_cast<std::size_t>(section.elementSize));
        return true;
    }
    /// Whether an array has enough elements for all that take of it, so that none is shared: then what is made of a
    /// file is not much larger than the file.
    template <class Array>
    static bool take(std::uint64_t count, std::uint64_t& taken, const Array& array) {
        taken += count;
        return taken <= array.size();
    }
    static const char* indexFault(const BinaryPack& pack) {
        if (pack.bodies.size() == 0) return "It has no bodies.";
        if (pack.texts.empty() || pack.texts.back() != '\0') return "Its texts do not end.";
        const std::uint64_t count = pack.bodies.size() - 1;
        std::uint64_t hulls = 0, letters = 0;
        for (std::size_t k = 0; k < pack.bodies.size(); ++k) {
            const BinaryBody body = pack.bodies[k];
            if (body.parent != kNone && (k == 0 || body.parent >= k - 1))
                return "A parent does not precede its children.";
            if (std::uint64_t{body.firstChild} + body.childCount > count) return "The children of a body do not exist.";
            if (std::uint64_t{body.firstHull} + body.hullCount > pack.hulls.size() || body.hullCount == 0)
                return "The hulls of a body do not exist.";
            if (!take(body.hullCount, hulls, pack.hulls)) return "Two bodies have the same hull.";
            if (body.id >= pack.texts.size() || body.name >= pack.texts.size()) return "A text does not exist.";
            for (const std::uint32_t start : {body.id, body.name})
                if (!take(pack.text(start).size() + 1, letters, pack.texts)) return "Two bodies have the same text.";
            if (!(body.mass > 0.0 && body.volume > 0.0)) return "A body has no mass or no volume.";
        }
        const auto bodyOf = [&](std::uint32_t k) { return k == kNone ? pack.whole() : pack.fragment(k); };
        if (!hasConsecutiveChildren(pack.fragmentCount(), bodyOf))
            return "The fragments of a body are not consecutive.";
        if (const char* fault = hullFault(pack)) return fault;
        for (std::size_t k = 0; k < pack.contacts.size(); ++k) {
            const BinaryContact contact = pack.contacts[k];
            if (contact.first >= contact.second || contact.second >= count ||
                pack.fragment(contact.first).parent != pack.fragment(contact.second).parent)
                return "The fragments of a contact are wrong.";
        }
        return nullptr;
    }
    static const char* hullFault(const BinaryPack& pack) {
        std::uint64_t vertices = 0, numbers = 0;
        for (std::size_t k = 0; k < pack.hulls.size(); ++k) {
            const BinaryHull hull = pack.hulls[k];
            if (std::uint64_t{hull.firstVertex} + hull.vertexCount > pack.vertices.size())
                return "The vertices of a hull do not exist.";
            if (!take(hull.vertexCount, vertices, pack.vertices)) return "Two hulls have the same vertex.";
            std::uint64_t at = hull.firstLoop;
            for (std::uint32_t face = 0; face < hull.faceCount; ++face) {
                const std::uint64_t corners = at < pack.loops.size() ? pack.loops[static_cast<std::size_t>(at)] : 0;
                if (corners < 3 || at + corners >= pack.loops.size()) return "The faces of a hull do not exist.";
                if (!take(corners + 1, numbers, pack.loops)) return "Two hulls have the same face.";
                if (!hasCorners(pack, hull, at, corners)) return "A vertex of a face does not exist.";
                at += corners + 1;
            }
        }
        return nullptr;
    }
    static bool hasCorners(const BinaryPack& pack, const BinaryHull& hull, std::uint64_t at, std::uint64_t corners) {
        for (std::uint64_t k = 1; k <= corners; ++k) {
            if (pack.loops[static_cast<std::size_t>(at + k)] >= hull.vertexCount) return false;
        }
        return true;
    }

    std::string_view m_bytes;
    std::array<Section, 7> m_sections{};
};

inline Vec3 vectorOf(const float (&v)[3]) { return {double{v[0]}, double{v[1]}, double{v[2]}}; }

/// The tensor of principal moments.
inline std::array<std::array<double, 3>, 3> tensorOf(const PrincipalInertia& inertia) {
    const Quaternion& q = inertia.rotation;
    const std::array<Vec3, 3> axes{
        Vec3{1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.w * q.z), 2.0 * (q.x * q.z - q.w * q.y)},
        Vec3{2.0 * (q.x * q.y - q.w * q.z), 1.0 - 2.0 * (q.x * q.x + q.z * q.z), 2.0 * (q.y * q.z + q.w * q.x)},
        Vec3{2.0 * (q.x * q.z + q.w * q.y), 2.0 * (q.y * q.z - q.w * q.x), 1.0 - 2.0 * (q.x * q.x + q.y * q.y)}};
    const std::array<double, 3> moments{inertia.moments.x, inertia.moments.y, inertia.moments.z};
    std::array<std::array<double, 3>, 3> tensor{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::array<double, 3> v{axes[axis].x, axes[axis].y, axes[axis].z};
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column)
                tensor[row][column] += moments[axis] * v[row] * v[column];
    }
    return tensor;
}

/// Makes a body of a record; returns false if a face has no area.
inline bool bodyOf(const BinaryPack& source, const BinaryBody& record, Body& body) {
    body.id = source.text(record.id);
    body.name = source.text(record.name);
    body.parent = record.parent;
    body.level = record.level;
    body.firstChild = record.firstChild;
    body.childCount = record.childCount;
    body.offset = {record.offset[0], record.offset[1], record.offset[2]};
    body.volume = record.volume;
    body.mass = record.mass;
    const float(&q)[4] = record.rotation;
    body.principal = {vectorOf(record.moments), {double{q[0]}, double{q[1]}, double{q[2]}, double{q[3]}}};
    body.inertia = tensorOf(body.principal);
    body.bounds = {vectorOf(record.min), vectorOf(record.max)};
    body.radius = double{record.radius};
    body.thinnest = double{record.thinnest};
    body.threshold = record.threshold;
    body.gap = record.gap;
    body.lostMass = record.lostMass;
    body.hulls.resize(record.hullCount);
    for (std::uint32_t h = 0; h < record.hullCount; ++h) {
        const BinaryHull hull = source.hulls[record.firstHull + h];
        Hull& made = body.hulls[h];
        made.inset = double{hull.inset};
        for (std::uint32_t k = 0; k < hull.vertexCount; ++k) {
            const BinaryVertex v = source.vertices[hull.firstVertex + k];
            made.vertices.push_back({double{v.x}, double{v.y}, double{v.z}});
        }
        std::size_t at = hull.firstLoop;
        for (std::uint32_t face = 0; face < hull.faceCount; ++face) {
            std::vector<std::uint32_t>& loop = made.faces.emplace_back(source.loops[at++]);
            for (std::uint32_t& vertex : loop) vertex = source.loops[at++];
        }
        if (!deriveTopology(made)) return false;
    }
    return true;
}

/// Adds contacts, and the bonds of a bonded pack.
inline void addContacts(const BinaryPack& source, Pack& pack) {
    std::map<std::uint32_t, std::size_t> fractures;  // by body
    const auto addFracture = [&](std::uint32_t index, const Body& body) {
        if (!pack.bonding || body.childCount < 2) return;
        fractures[index] = pack.bonding->fractures.size();
        pack.bonding->fractures.push_back({index, {}});
    };
    addFracture(kNone, pack.whole);
    for (std::uint32_t k = 0; k < pack.fragments.size(); ++k) addFracture(k, pack.fragments[k]);
    for (std::size_t k = 0; k < source.contacts.size(); ++k) {
        const BinaryContact contact = source.contacts[k];
        const Vec3 centroid = vectorOf(contact.centroid), normal = vectorOf(contact.normal);
        const auto area = double{contact.area};
        pack.fragments[contact.first].neighbours.push_back({contact.second, area, centroid, normal});
        pack.fragments[contact.second].neighbours.push_back({contact.first, area, centroid, times(normal, -1.0)});
        const auto fracture = fractures.find(pack.fragments[contact.first].parent);
        if (fracture == fractures.end()) continue;
        Bond bond;
        bond.fragments = {contact.first, contact.second};
        bond.area = area;
        bond.centroid = centroid;
        bond.normal = normal;
        bond.capacity = double{contact.capacity};
        bond.clusterLevel = contact.clusterLevel;
        pack.bonding->fractures[fracture->second].bonds.push_back(bond);
    }
    for (Body& fragment : pack.fragments) {
        std::sort(fragment.neighbours.begin(), fragment.neighbours.end(),
                  [](const Neighbour& a, const Neighbour& b) { return a.fragment < b.fragment; });
    }
}

/// The bytes of a file; none if it cannot be read.
inline std::optional<std::string> bytesOf(const std::string& path, std::string& fault) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    if (file && (file.peek() == std::ifstream::traits_type::eof() || bytes << file.rdbuf())) return bytes.str();
    fault = "Cannot read \"" + path + "\".";
    return std::nullopt;
}

/// Reads a JSON text: `read` makes a result of its root. After a fault the result is as it was.
template <class T, class Read>
bool readJson(std::string_view json, T& result, std::string& fault, Read read) {
    Parser parser(json);
    Document document;
    if (!parser.parse(document)) {
        fault = parser.fault();
        return false;
    }
    Reader reader;
    T made = read(reader, Value{&document, 0, nullptr, nullptr, 0});
    if (!reader.fault.empty()) {
        fault = reader.fault;
        return false;
    }
    result = std::move(made);
    return true;
}

/// Reads a file by one of the functions that parse its bytes.
template <class T>
bool loadBy(bool (*parse)(std::string_view, T&, std::string&), const std::string& path, T& result, std::string& fault) {
    const std::optional<std::string> bytes = bytesOf(path, fault);
    if (!bytes) return false;
    if (parse(*bytes, result, fault)) return true;
    fault = "\"" + path + "\": " + fault;
    return false;
}

}  // namespace detail

namespace detail {

/// The structure of a fracture without anchors.
inline Structure fractureOf(const Pack& pack, std::size_t fracture, double strength) {
    const Fracture& source = pack.bonding->fractures[fracture];
    Structure structure;
    structure.fragments = pack.fragmentsOf(source.fragment);
    for (const std::uint32_t fragment : structure.fragments)
        structure.centres.push_back(pack.fragments[fragment].offset);
    structure.fragmentBonds.resize(structure.fragments.size());
    for (Bond bond : source.bonds) {
        if (std::isfinite(bond.capacity)) bond.capacity *= strength;
        link(structure, bond);
    }
    return structure;
}

}  // namespace detail

inline Structure structureOf(const Pack& pack, std::size_t fracture, double strength) {
    Structure structure = detail::fractureOf(pack, fracture, strength);
    if (pack.bonding->fractures[fracture].fragment != kNone) return structure;
    for (const std::uint32_t fragment : pack.bonding->anchored) {
        Bond anchor;
        anchor.fragments = {fragment, kNone};
        anchor.centroid = pack.fragments[fragment].offset;
        anchor.normal = {0.0, 0.0, 1.0};
        detail::link(structure, anchor);
    }
    return structure;
}

inline void addAnchor(Structure& structure, const Bond& anchor) { detail::link(structure, anchor); }

inline std::uint32_t breakingLevel(const Structure& structure, const std::vector<Damage>& damage,
                                   const std::vector<std::uint32_t>& body) {
    const std::vector<bool> isIn = detail::flagsOf(structure, body);
    std::uint32_t level = kNone;
    for (std::size_t bond = 0; bond < structure.bonds.size(); ++bond) {
        const auto [first, second] = structure.ends[bond];
        if (second == kNone || !isIn[first] || !isIn[second] || detail::isBroken(structure, damage, bond)) continue;
        if (std::isfinite(structure.bonds[bond].capacity)) level = std::min(level, structure.bonds[bond].clusterLevel);
    }
    return level;
}

inline HitOutcome applyHit(const Structure& structure, const Bonding& rule, const Hit& hit,
                           const std::vector<std::uint32_t>& body, std::vector<Damage>& damage) {
    const detail::StruckBody struck(structure, body, hit.points, damage);
    HitOutcome outcome;
    double left = hit.impulse;
    for (const detail::LoadedBond& loaded : struck.loadedBonds(rule, hit.impulse, damage)) {
        const double capacity = structure.bonds[loaded.bond].capacity;
        const Damage before = damage[loaded.bond];
        const Damage after =
            detail::damageAfter(before, detail::utilization(left * loaded.fraction, capacity), rule.damageFrom);
        if (after == before) continue;
        damage[loaded.bond] = after;
        (after == kBroken ? outcome.broken : outcome.damaged).push_back(loaded.bond);
        left = std::max(0.0, left - capacity * (after - before) / kBroken);
    }
    outcome.taken = hit.impulse - left;
    std::sort(outcome.broken.begin(), outcome.broken.end());
    std::sort(outcome.damaged.begin(), outcome.damaged.end());
    return outcome;
}

inline std::vector<Island> islandsOf(const Structure& structure, const std::vector<Damage>& damage,
                                     const std::vector<std::uint32_t>& body) {
    // Union-find: each number has a smaller one of its island as its parent, the smallest itself.
    std::vector<std::uint32_t> parents(structure.fragments.size(), kNone), islandOf(parents.size(), kNone);
    const auto rootOf = [&](std::uint32_t number) {
        while (parents[number] != number) number = parents[number] = parents[parents[number]];
        return number;
    };
    for (const std::uint32_t fragment : body) {
        const std::uint32_t number = structure.numberOf(fragment);
        parents[number] = number;
        for (const std::uint32_t bond : structure.fragmentBonds[number]) {
            const std::uint32_t other = detail::otherEnd(structure, bond, number);
            if (other >= number || parents[other] == kNone || detail::isBroken(structure, damage, bond)) continue;
            const std::uint32_t one = rootOf(number), two = rootOf(other);
            parents[std::max(one, two)] = std::min(one, two);
        }
    }
    std::vector<Island> islands;
    for (const std::uint32_t fragment : body) {
        const std::uint32_t number = structure.numberOf(fragment);
        std::uint32_t& island = islandOf[rootOf(number)];
        if (island == kNone) {
            island = static_cast<std::uint32_t>(islands.size());
            islands.emplace_back();
        }
        islands[island].fragments.push_back(fragment);
        if (detail::isAnchored(structure, damage, number)) islands[island].isAnchored = true;
    }
    return islands;
}

inline std::vector<std::uint32_t> unsupported(const Structure& structure, const std::vector<Damage>& damage,
                                              const std::vector<std::uint32_t>& body, double span, Vec3 up) {
    const std::vector<double> unlimited(structure.fragments.size(), std::numeric_limits<double>::infinity());
    const std::vector<Damage> none(structure.bonds.size());
    std::vector<double> limits = detail::anchorDistances(structure, none, structure.fragments, unlimited, up);
    for (double& limit : limits) limit = std::max(limit, span > 0.0 ? span : std::numeric_limits<double>::max());
    const std::vector<double> distances = detail::anchorDistances(structure, damage, body, limits, up);
    std::vector<bool> isHeld(distances.size());
    for (std::size_t number = 0; number < distances.size(); ++number)
        isHeld[number] = distances[number] >= 0.0 && distances[number] <= limits[number];
    detail::addClusters(structure, damage, detail::flagsOf(structure, body), breakingLevel(structure, damage, body),
                        isHeld);
    std::vector<std::uint32_t> found;
    for (const std::uint32_t fragment : body) {
        if (!isHeld[structure.numberOf(fragment)]) found.push_back(fragment);
    }
    return found;
}

inline std::vector<std::uint32_t> breakOff(const Structure& structure, const std::vector<std::uint32_t>& fragments,
                                           std::vector<Damage>& damage, std::uint32_t level) {
    const std::vector<bool> isOff = detail::flagsOf(structure, fragments);
    std::vector<std::uint32_t> broken;
    for (std::uint32_t bond = 0; bond < structure.bonds.size(); ++bond) {
        const auto [first, second] = structure.ends[bond];
        if (!isOff[first] && (second == kNone || !isOff[second])) continue;
        if (detail::isBroken(structure, damage, bond) || !std::isfinite(structure.bonds[bond].capacity)) continue;
        if (structure.bonds[bond].clusterLevel > level) continue;
        damage[bond] = kBroken;
        broken.push_back(bond);
    }
    return broken;
}

inline IslandMass massOf(const Pack& pack, const std::vector<std::uint32_t>& fragments) {
    IslandMass all;
    const auto centreOf = [&](std::uint32_t fragment) {
        const Body& body = pack.fragments[fragment];
        return detail::plus(body.offset, body.centreOfMass);
    };
    for (const std::uint32_t fragment : fragments) {
        all.mass += pack.fragments[fragment].mass;
        all.centre = detail::plus(all.centre, detail::times(centreOf(fragment), pack.fragments[fragment].mass));
    }
    if (all.mass > 0.0) all.centre = detail::times(all.centre, 1.0 / all.mass);
    for (const std::uint32_t fragment : fragments) {
        const Body& body = pack.fragments[fragment];
        const Vec3 arm = detail::minus(centreOf(fragment), all.centre);
        const std::array<double, 3> a{arm.x, arm.y, arm.z};
        const double square = detail::dot(arm, arm);
        for (std::size_t row = 0; row < 3; ++row) {  // the parallel-axis theorem
            for (std::size_t column = 0; column < 3; ++column) {
                const double own = row == column ? square : 0.0;
                all.inertia[row][column] += body.inertia[row][column] + body.mass * (own - a[row] * a[column]);
            }
        }
    }
    return all;
}

namespace detail {

/// Why packs are not those of a scene; empty if they are.
inline std::string faultOfPacks(const Scene& scene, const std::vector<Pack>& packs) {
    if (packs.size() != scene.packs.size()) return "There must be a pack for each of the scene.";
    for (std::size_t k = 0; k < packs.size(); ++k) {
        if (packs[k].physicsHash != scene.packs[k].physicsHash)
            return "The pack \"" + scene.packs[k].folder + "\" is of another export than the scene.";
    }
    return {};
}

/// Adds a bond to an anchor; returns false if the structure has no such fragment.
inline bool addHalf(Structure& structure, const Bond& bond) {
    if (!std::binary_search(structure.fragments.begin(), structure.fragments.end(), bond.fragments[0])) return false;
    link(structure, bond);
    return true;
}

}  // namespace detail

inline bool structuresOf(const Scene& scene, const std::vector<Pack>& packs, SceneStructures& structures,
                         std::string& fault) {
    fault = detail::faultOfPacks(scene, packs);
    if (!fault.empty()) return false;
    SceneStructures all;
    for (const SceneInstance& instance : scene.instances) {
        const Pack& pack = packs[instance.pack];
        const bool hasBonds = pack.bonding && !pack.bonding->fractures.empty() && !instance.isUnbreakable &&
                              pack.bonding->fractures[0].fragment == kNone;
        Structure structure;
        if (hasBonds) structure = detail::fractureOf(pack, 0, instance.bondStrength);
        for (const Bond& anchor : instance.anchors) {
            if (detail::addHalf(structure, anchor)) continue;
            fault = "An anchor of \"" + instance.name + "\" holds a fragment that its pack has not.";
            return false;
        }
        std::vector<double>& masses = all.masses.emplace_back();
        for (const std::uint32_t fragment : structure.fragments) masses.push_back(pack.fragments[fragment].mass);
        all.structures.push_back(std::move(structure));
        all.spans.push_back(hasBonds ? pack.bonding->span : 0.0);
        const double gravity = detail::length(scene.gravity);
        const Vec3 up = gravity > 0.0 ? detail::times(scene.gravity, -1.0 / gravity) : Vec3{0.0, 0.0, 0.0};
        all.ups.push_back(detail::inAxes(detail::normalized(instance.rotation), up));
        all.holdHeaviest.push_back(instance.holdsHeaviest);
    }
    all.jointBonds.resize(scene.instances.size());
    for (const SceneJoint& joint : scene.joints) {
        std::array<SceneBond, 2> halves;
        for (std::size_t side = 0; side < 2 && joint.instances[side] != kNone; ++side) {
            const std::uint32_t k = joint.instances[side];
            halves[side] = {k, static_cast<std::uint32_t>(all.structures[k].bonds.size())};
            if (detail::addHalf(all.structures[k], detail::halfOf(joint, side, scene.instances[k]))) continue;
            fault = "A joint of \"" + scene.instances[k].name + "\" joins a fragment that its pack has not.";
            return false;
        }
        if (joint.instances[1] == kNone) continue;
        for (const SceneBond& half : halves) all.jointBonds[half.instance].push_back(half.bond);
        all.halves.push_back(halves);
    }
    structures = std::move(all);
    return true;
}

inline std::vector<std::vector<Damage>> intactDamages(const SceneStructures& all) {
    std::vector<std::vector<Damage>> damages;
    for (const Structure& structure : all.structures) damages.emplace_back(structure.bonds.size());
    return damages;
}

inline std::vector<SceneBond> breakMortar(const SceneStructures& all, std::vector<std::vector<Damage>>& damages) {
    const auto isBroken = [&](const SceneBond& half) {
        return detail::isBroken(all.structures[half.instance], damages[half.instance], half.bond);
    };
    detail::MortarUnits units(all, damages);
    for (const std::array<SceneBond, 2>& joint : all.halves) {
        if (!isBroken(joint[0]) && !isBroken(joint[1]))
            units.join(units.rootOf(all, joint[0]), units.rootOf(all, joint[1]));
    }
    std::vector<SceneBond> broken;
    for (const std::array<SceneBond, 2>& joint : all.halves) {
        const bool isHalf = isBroken(joint[0]) || isBroken(joint[1]);
        for (const SceneBond& half : joint) {
            if (!isBroken(half) && (isHalf || !units.isAnchored(units.rootOf(all, half)))) broken.push_back(half);
        }
    }
    for (const SceneBond& half : broken) damages[half.instance][half.bond] = kBroken;
    return broken;
}

inline std::vector<std::vector<std::uint32_t>> unsupported(const SceneStructures& all,
                                                           const std::vector<std::vector<Damage>>& damages,
                                                           const std::vector<std::vector<std::uint32_t>>& held) {
    std::vector<std::vector<std::uint32_t>> everything;
    for (const Structure& structure : all.structures) everything.push_back(structure.fragments);
    std::vector<std::vector<double>> limits =
        detail::SupportFractions(all, intactDamages(all), everything, {}).fractions();
    for (std::vector<double>& own : limits)
        for (double& limit : own) limit = std::max(limit, 1.0);
    const std::vector<std::vector<double>> fractions = detail::SupportFractions(all, damages, held, limits).fractions();
    std::vector<std::vector<std::uint32_t>> found(all.structures.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
        if (!(all.spans[k] > 0.0) || all.holdHeaviest[k]) continue;
        const Structure& structure = all.structures[k];
        std::vector<bool> isHeld(structure.fragments.size());
        for (std::size_t number = 0; number < isHeld.size(); ++number)
            isHeld[number] = fractions[k][number] >= 0.0 && fractions[k][number] <= limits[k][number];
        detail::addClusters(structure, damages[k], detail::flagsOf(structure, held[k]),
                            breakingLevel(structure, damages[k], held[k]), isHeld);
        for (const std::uint32_t fragment : held[k])
            if (!isHeld[structure.numberOf(fragment)]) found[k].push_back(fragment);
    }
    return found;
}

inline std::string damageBytes(const std::string& bake, const std::vector<std::vector<Damage>>& damages) {
    std::vector<Damage> all;
    for (const std::vector<Damage>& one : damages) all.insert(all.end(), one.begin(), one.end());
    std::string bytes = detail::damageHeader(bake);
    detail::addNumber(bytes, all.size(), 4);
    std::string partial;
    std::uint64_t partialCount = 0;
    for (std::size_t first = 0; first < all.size(); first += 8) {
        std::uint64_t octet = 0;
        for (std::size_t k = first; k < std::min(first + 8, all.size()); ++k) {
            if (all[k] == kBroken) octet |= std::uint64_t{1} << (k - first);
            if (all[k] == kBroken || all[k] == 0) continue;
            detail::addNumber(partial, std::uint64_t{all[k]} << 24 | k, 4);
            ++partialCount;
        }
        detail::addNumber(bytes, octet, 1);
    }
    detail::addNumber(bytes, partialCount, 4);
    bytes += partial;
    detail::addNumber(bytes, detail::checksum(bytes), 8);
    return bytes;
}

inline bool readDamage(std::string_view bytes, const std::string& bake, std::vector<std::vector<Damage>>& damages,
                       std::string& fault) {
    std::vector<Damage> all;
    for (const std::vector<Damage>& one : damages) all.resize(all.size() + one.size());
    if (const char* error = detail::readDamages(bytes, bake, all)) {
        fault = error;
        return false;
    }
    auto next = all.begin();
    for (std::vector<Damage>& one : damages) {
        const auto end = next + static_cast<std::ptrdiff_t>(one.size());
        one.assign(next, end);
        next = end;
    }
    return true;
}

inline bool parse(std::string_view json, Pack& pack, std::string& fault) {
    return detail::readJson(json, pack, fault,
                            [](detail::Reader& reader, const detail::Value& root) { return reader.pack(root); });
}

inline bool openBinary(std::string_view bytes, BinaryPack& pack, std::string& fault) {
    BinaryPack opened;
    if (const char* error = detail::BinaryOpener(bytes).open(opened)) {
        fault = error;
        return false;
    }
    pack = opened;
    return true;
}

inline bool parseBinary(std::string_view bytes, Pack& pack, std::string& fault) {
    BinaryPack source;
    if (!openBinary(bytes, source, fault)) return false;
    return detail::readJson(source.header, pack, fault, [&](detail::Reader& reader, const detail::Value& root) {
        Pack read = reader.header(root, source.fragmentCount());
        read.fragments.resize(source.fragmentCount());
        bool hasArea = detail::bodyOf(source, source.whole(), read.whole);
        for (std::uint32_t k = 0; k < source.fragmentCount(); ++k)
            hasArea = detail::bodyOf(source, source.fragment(k), read.fragments[k]) && hasArea;
        if (!hasArea) reader.refuse(root, "a face of a hull has no area");
        if (!reader.fault.empty()) return read;
        if (const std::optional<detail::Value> bonds = detail::Reader::find(root, "bonding"))
            read.bonding = reader.bonding(*bonds, read.fragments);
        if (reader.fault.empty()) detail::addContacts(source, read);
        return read;
    });
}

inline bool loadBinary(const std::string& path, Pack& pack, std::string& fault) {
    return detail::loadBy(parseBinary, path, pack, fault);
}

inline bool load(const std::string& path, Pack& pack, std::string& fault) {
    return detail::loadBy(parse, path, pack, fault);
}

inline bool parseScene(std::string_view json, Scene& scene, std::string& fault) {
    return detail::readJson(json, scene, fault,
                            [](detail::Reader& reader, const detail::Value& root) { return reader.scene(root); });
}

inline bool loadScene(const std::string& path, Scene& scene, std::string& fault) {
    return detail::loadBy(parseScene, path, scene, fault);
}

inline bool parseEvents(std::string_view lines, EventLog& log, std::string& fault) {
    EventLog read;
    if (!appendEvents(lines, read, fault)) return false;
    log = std::move(read);
    return true;
}

inline bool appendEvents(std::string_view lines, EventLog& log, std::string& fault) {
    EventLog read;  // the new lines only
    const bool isBegun = log.version > 1 || !log.events.empty() || !log.sums.empty();
    read.version = log.version;
    for (std::size_t start = 0, number = 1; start < lines.size(); ++number) {
        const std::size_t end = std::min(lines.find('\n', start), lines.size());
        detail::Parser parser(lines.substr(start, end - start));
        detail::Document document;
        detail::Reader reader;
        if (parser.parse(document)) {
            reader.addLine(detail::Value{&document, 0, nullptr, nullptr, 0}, read, number == 1 && !isBegun);
        } else {
            reader.fault = parser.fault();
        }
        if (!reader.fault.empty()) {
            fault = "Line " + std::to_string(number) + ": " + reader.fault;
            return false;
        }
        start = end + 1;
    }
    if (!isBegun) {
        log = std::move(read);
        return true;
    }
    log.events.insert(log.events.end(), read.events.begin(), read.events.end());
    log.sums.insert(log.sums.end(), read.sums.begin(), read.sums.end());
    return true;
}

inline bool loadEvents(const std::string& path, EventLog& log, std::string& fault) {
    return detail::loadBy(parseEvents, path, log, fault);
}

namespace detail {

/// The path of the fragment that one is part of; empty for the whole.
inline std::string_view parentOf(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    return slash == path.npos ? std::string_view() : path.substr(0, slash);
}

/// Takes a fragment out of a body; what it is part of falls apart into its fragments.
inline void takeFragment(const EventLog& log, EventBody& body, const std::string& path) {
    std::vector<std::string>& own = body.fragments;
    const auto placeOf = [&](std::string_view one) { return std::lower_bound(own.begin(), own.end(), one); };
    const auto has = [&](std::string_view one) { return std::binary_search(own.begin(), own.end(), one); };
    std::string_view whole = path;
    while (!has(whole)) {
        if (whole.empty()) return;
        whole = parentOf(whole);
    }
    const auto isIt = [&](const EventAsset& one) { return one.id == body.asset && one.variant == body.variant; };
    const auto asset = std::find_if(log.assets.begin(), log.assets.end(), isIt);
    while (!has(path) && asset != log.assets.end()) {
        own.erase(placeOf(whole));
        std::string_view next = path;
        while (parentOf(next) != whole) next = parentOf(next);
        for (const std::string& one : asset->fragments)
            if (!one.empty() && parentOf(one) == whole) own.push_back(one);
        std::sort(own.begin(), own.end());
        if (!has(next)) return;
        whole = next;
    }
    if (has(path)) own.erase(placeOf(path));
}

inline EventBody bodyOf(const Event& event) {
    EventBody body{event.name,  event.instance,  event.asset,   event.variant, event.step,
                   event.other, event.fragments, event.isFixed, event.mass};
    if (body.fragments.empty()) body.fragments.emplace_back();
    std::sort(body.fragments.begin(), body.fragments.end());
    return body;
}

/// What is left of a body moves if the event has its mass.
inline void setRest(EventBody& body, const Event& event) {
    body.mass = event.restMass;
    body.isFixed = !(event.restMass > 0.0);
}

/// Adds a body that appeared, or what came free of its anchors.
inline void addBirth(const EventLog& log, const Event& event, EventState& state) {
    EventBody body = bodyOf(event);
    if (const auto known = state.bodies.find(event.body); known != state.bodies.end()) {
        known->second.fragments = body.fragments;
        known->second.isFixed = body.isFixed;
        known->second.mass = body.mass;
        return;
    }
    if (const auto whole = state.bodies.find(event.other); whole != state.bodies.end()) {
        EventBody& other = whole->second;
        body.name = other.name, body.instance = other.instance, body.asset = other.asset, body.variant = other.variant;
        if (event.kind == EventKind::Detached) {
            for (const std::string& path : body.fragments) takeFragment(log, other, path);
            setRest(other, event);
        }
    }
    state.bodies[event.body] = std::move(body);
}

inline void addRemoval(const EventLog& log, const Event& event, EventState& state) {
    if (event.fragments.empty()) {
        state.bodies.erase(event.body);
    } else if (const auto body = state.bodies.find(event.body); body != state.bodies.end()) {
        for (const std::string& path : event.fragments) takeFragment(log, body->second, path);
        setRest(body->second, event);
        if (body->second.fragments.empty()) state.bodies.erase(body);
    }
}

/// Adds what broke further to a damage.
inline void addDamage(const EventDamage& added, EventDamage& damage) {
    if (!added.cut.empty()) damage = {{}, {}, added.cut};
    damage.broken.insert(damage.broken.end(), added.broken.begin(), added.broken.end());
    std::sort(damage.broken.begin(), damage.broken.end());
    using Weakened = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
    Weakened all = std::move(damage.weakened), left;
    all.insert(all.end(), added.weakened.begin(), added.weakened.end());
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool isLatest = k + 1 == all.size() || all[k + 1].first != all[k].first;
        if (isLatest && !std::binary_search(damage.broken.begin(), damage.broken.end(), all[k].first))
            left.push_back(all[k]);
    }
    damage.weakened = std::move(left);
}

}  // namespace detail

inline EventState startOf(const EventLog& log) {
    EventState state;
    state.step = log.step;
    for (const Event& body : log.bodies) detail::addBirth(log, body, state);
    return state;
}

inline void playTo(const EventLog& log, std::uint64_t step, EventState& state) {
    for (; state.next < log.events.size() && log.events[state.next].step <= step; ++state.next) {
        const Event& event = log.events[state.next];
        switch (event.kind) {
            case EventKind::Born:
            case EventKind::Detached: detail::addBirth(log, event, state); break;
            case EventKind::Broken: state.bodies.erase(event.body); break;
            case EventKind::Removed: detail::addRemoval(log, event, state); break;
            case EventKind::Damaged: detail::addDamage(event.damage, state.damages[event.instance]); break;
            default: break;
        }
    }
    state.step = step;
}

inline std::string materialName(const EventLog& log, std::uint32_t material) {
    for (const EventMaterial& one : log.materials)
        if (one.id == material) return one.name;
    return {};
}

}  // namespace rubble_pack
