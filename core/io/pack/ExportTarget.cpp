#include "core/io/pack/ExportTarget.h"

namespace rubble {
namespace {

constexpr std::string_view kFiles = R"(
| File | Holds |
|---|---|
| `scene.json` | where the instances stand, what holds them, ground, gravity, and throws; not in every export |
| `<asset>/pack.json` | for each asset masses, inertia, collision hulls, thresholds, materials, and bonds |
| `<asset>/pack.bin` | the same, for mapping into memory; not in every export |
| `<asset>/<asset>-intact.*` | the mesh of the asset before it breaks |
| `<asset>/<asset>-fragments.*` | its fragments, an object each, called as in `pack.json`; in USD `<asset>.usda` |
| `export.json`, `manifest.json` | what was exported, so that the next export replaces no file that you edited |

Metres, kilograms, seconds; right-handed, y up. Rotations are quaternions x, y, z, w.

The whole of an instance stands at position + rotation · offset of the whole. When an impact reaches its threshold,
remove it and add its fragments (those from `firstChild` on) at position + rotation · their offsets, with the velocity
of that point of the whole. The impact is J = (1 + e) · v · m with the velocities before the solver. Never add bodies
of two levels at once.

Where the `pack.json` of an asset has `bonding`, its `threshold` does not count: an impact breaks the bonds around its
point, and only what is no longer connected to an anchor comes off, as bodies of one fragment or several, and after
`collapseDelay` what is too far from one. `anchors` and `joints` in `scene.json` say what holds each instance.
`applyHit()`, `breakMortar()`, `islandsOf()` and `unsupported()` of `rubble_pack.hpp` do this in C++; `pack.md` and
`scene.md` of Rubble's documentation say how in any language.

Fragments keep still when they take the place of the whole, since their collision hulls are inset by 0.1 mm. Where the
engine adds a margin around shapes, set it below that.
)";

constexpr std::string_view kUnrealSteps =
    "1. *Tools ▸ Execute Python Script…* runs `import_into_unreal.py`, which imports the GLB files, makes a\n"
    "   Geometry Collection of the fragments of each asset, and places the instances of `scene.json`. It needs the\n"
    "   plugins *Python Editor Script Plugin* and *Geometry Collection*, and a level that is open.\n"
    "2. Or import the GLB files by hand (Interchange), without combining static meshes. The meshes called\n"
    "   `UCX_<fragment>_00` are the collision hulls, which Unreal attaches by their names.\n"
    "3. Unreal exchanges y and z and has centimetres: a position (x, y, z) becomes 100 · (x, z, y), a rotation\n"
    "   (x, y, z, w) becomes (−x, −z, −y, w); an impulse in N·s is 100 kg·cm/s, a moment of inertia in\n"
    "   kg·m² is 10,000 kg·cm². `rubble_pack.hpp` has these conversions, and needs no exceptions and no RTTI.\n"
    "\nThe script and the names follow the documentation of Unreal Engine 5. Neither was tested in it.\n";

std::string_view titleOf(ExportTarget target) {
    constexpr std::array<std::string_view, 7> kTitles{"any engine", "Unity", "Unreal Engine", "Godot", "Blender",
                                                      "the web",    "USD"};
    return kTitles[static_cast<std::size_t>(target)];
}

std::string_view stepsFor(ExportTarget target) {
    switch (target) {
        case ExportTarget::Neutral:
            return "In C++ read the packs with `rubble_pack.hpp`, a single header that is installed with Rubble, in "
                   "other\n"
                   "languages as JSON.\n";
        case ExportTarget::Unity:
            return "1. Copy this folder into `Assets`; import the GLB files with glTFast or UnityGLTF.\n"
                   "2. These importers reverse x: a position (x, y, z) becomes (−x, y, z), a rotation (x, y, z, w)\n"
                   "   becomes (x, −y, −z, w).\n"
                   "3. Give each body a `Rigidbody` with `mass`, `centerOfMass` 0, `inertiaTensor` = "
                   "`principal.moments`\n"
                   "   and `inertiaTensorRotation` = `principal.rotation`, and for each hull a convex `MeshCollider`.\n"
                   "4. Set the default contact offset to 0.0001 or less.\n"
                   "\nNot tested in Unity itself.\n";
        case ExportTarget::Unreal: return kUnrealSteps;
        case ExportTarget::Godot:
            return "1. Copy this folder into the project; Godot imports the GLB files.\n"
                   "2. Read `pack.json` and `scene.json` with `JSON.parse_string()`; give each body a `RigidBody3D` "
                   "with\n"
                   "   `mass`, and for each hull a `CollisionShape3D` with a `ConvexPolygonShape3D` of its vertices.\n"
                   "3. Set the margin of these shapes to 0.00002.\n"
                   "\nPacks are tested in Godot 3.2.\n";
        case ExportTarget::Blender:
            return "1. Import the GLB files: *File ▸ Import ▸ glTF 2.0*. Blender turns y up into z up.\n"
                   "2. For rigid bodies, set *Shape* to *Convex Hull*, *Mass* from `pack.json`, and *Collision Margin* "
                   "to\n"
                   "   0.00002 m.\n"
                   "\nMeshes are tested in Blender 3.4.\n";
        case ExportTarget::Web:
            return "1. Load the GLB files with `GLTFLoader` of three.js or the loader of Babylon.js.\n"
                   "2. Read `pack.json` with `fetch()`, and make bodies in Rapier, Jolt, PhysX, Havok or cannon-es; "
                   "the\n"
                   "   example `rapier_example.mjs` that is installed with Rubble has 80 lines, and needs "
                   "`npm install\n"
                   "   @dimforge/rapier3d-compat`. `rapier_scene_example.mjs`, with `bonds.mjs` and "
                   "`bonded_play.mjs`,\n"
                   "   stands the whole scene and breaks the bonds of bonded assets.\n"
                   "\nTested in three.js, Babylon.js, Rapier, Jolt, PhysX, Havok, MuJoCo and cannon-es.\n";
        case ExportTarget::Usd:
            return "1. Reference `<asset>/<asset>.usda`, the fragments, or `<asset>/<asset>-intact.usda`, the whole, "
                   "which\n"
                   "   have rigid bodies, masses and colliders of UsdPhysics.\n"
                   "2. Bonded assets have fixed joints with break forces between their fragments: the impulse that\n"
                   "   breaks a bond over a step of 1/60 s.\n"
                   "\nMeshes are tested in three.js; physics is not tested in Omniverse or Houdini.\n";
    }
    return {};
}

constexpr const char* kRigidBodies =
    "\nThe GLB files hold rigid bodies with masses and colliders: `KHR_physics_rigid_bodies`, and `OMI_physics_body`, "
    "which\n"
    "Godot 4.3 and later read. Programs that read neither take the meshes.\n";
constexpr const char* kCompact =
    "\nThe GLB files are compact: each has one skinned mesh, whose joints are the fragments, and no physics. They need "
    "a\n"
    "reader of `EXT_meshopt_compression`: in three.js, call `setMeshoptDecoder(MeshoptDecoder)` of the loader. "
    "Programs\n"
    "without one refuse the files; for these, export plain GLB files.\n";

}  // namespace

PackOptions optionsFor(ExportTarget target) {
    PackOptions options;
    if (target == ExportTarget::Neutral) return options;
    options.meshes.obj = false;
    const bool isNative = target == ExportTarget::Unity || target == ExportTarget::Unreal;
    options.files = isNative ? PackFiles::Both : PackFiles::Json;
    options.topology = PackTopology::Loops;
    options.meshes.glb = target != ExportTarget::Usd;
    options.meshes.usd = target == ExportTarget::Usd;
    const bool readsPhysics = target == ExportTarget::Godot || target == ExportTarget::Web;
    options.meshes.glbKind = readsPhysics                     ? GlbKind::Physics
                             : target == ExportTarget::Unreal ? GlbKind::Named
                                                              : GlbKind::Plain;
    return options;
}

std::string readmeFor(ExportTarget target, GlbKind glbKind) {
    std::string text = "# Destructible assets for ";
    text += titleOf(target);
    text += "\n\nExported by Rubble.\n\n";
    text += stepsFor(target);
    if (glbKind == GlbKind::Physics) text += kRigidBodies;
    if (glbKind == GlbKind::Compact) text += kCompact;
    text += kFiles;
    return text;
}

}  // namespace rubble
