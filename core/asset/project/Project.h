#pragma once

#include "core/asset/project/Bonding.h"
#include "core/asset/project/Finish.h"
#include "core/asset/project/FragmentPath.h"
#include "core/asset/project/Shaping.h"
#include "core/asset/project/Texture.h"
#include "core/fracture/pattern/Pattern.h"
#include "core/fracture/pieces/Prism.h"
#include "core/geometry/mesh/ClosedMesh.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rubble {

/// Project-wide id, allocated from Project::nextId; 0: none.
using Id = std::uint32_t;

/// sRGB, each in [0, 1].
struct Colour {
    double red = 0.8;
    double green = 0.8;
    double blue = 0.8;
    bool operator==(const Colour&) const = default;
};

/// A physical material with its colours.
struct Material {
    Id id = 0;
    std::string name;
    double density = 1000.0;                  // kg/m³, > 0
    double friction = 0.6;                    // Coulomb coefficient, >= 0
    double restitution = 0.0;                 // in [0, 1]
    std::optional<double> tensileStrength;    // Pa, > 0; none: unknown
    std::optional<double> fractureToughness;  // Pa·√m, > 0; none: unknown
    std::optional<double> youngsModulus;      // Pa, > 0; none: unknown
    Colour outside;
    Colour inside;
    double opacity = 1.0;  // of its surfaces in pictures and mesh files: glass 0.3
    Finish finish = Finish::Plain;
    bool operator==(const Material&) const = default;
};

/// The settings by which the fragments of one level, or a single fragment, are fractured further.
struct Level {
    Pattern pattern;
    double minimumVolume = 0.0;       // m³; smaller fragments are not fractured
    std::optional<double> threshold;  // N·s, > 0, of each fragment that it fractures; none: follows from its volume
    double bondStrength = 1.0;        // >= 0: multiplies the strength of the bonds between its fragments
    bool operator==(const Level&) const = default;
};

/// The settings by which a single fragment is fractured, overriding its level.
struct FragmentLevel {
    FragmentPath fragment;
    std::optional<Level> level;  // none: it is not fractured
    bool operator==(const FragmentLevel&) const = default;
};

/// The threshold of a single fragment, instead of that of its level.
struct FragmentThreshold {
    FragmentPath fragment;
    double threshold = 0.0;  // N·s, > 0
    bool operator==(const FragmentThreshold&) const = default;
};

/// Fracture around the point of impact when the asset breaks, instead of into the fragments of its pattern.
/// Source: "Creating Realistic Real-Time Destruction Using the Vienna Physics Engine" (bachelor thesis), 3.3.
struct CutAtImpact {
    static constexpr std::uint32_t kMinFragments = 2;
    static constexpr std::uint32_t kMaxFragments = 1000;  // it is computed within one step
    std::uint32_t fragments = 30;                         // from kMinFragments to kMaxFragments
    // m, > 0: half of the seeds lie within it, denser towards the impact, or as near as they have room: their fragments
    // are no thinner than some tenth of the depth.
    double falloffRadius = 0.3;
    bool operator==(const CutAtImpact&) const = default;
};

/// The required outcome of the event of a strength requirement.
enum class RequirementOutcome {
    Survives,
    Breaks,
    HoleAtMost,  // it loses no more than a hole of a width
};

/// A fall from a height onto level ground, in the asset's own orientation.
struct DropRequirement {
    double height = 1.0;  // m, > 0
    bool operator==(const DropRequirement&) const = default;
};
/// A head-on hit on the centre of its front by a body.
struct HitRequirement {
    double mass = 5.0;    // kg, > 0
    double speed = 10.0;  // m/s, > 0
    bool operator==(const HitRequirement&) const = default;
};
/// An impact of known impulse, such as one of a simulation.
struct ImpulseRequirement {
    double impulse = 10.0;  // N·s, > 0, on the whole asset
    bool operator==(const ImpulseRequirement&) const = default;
};
/// An event that an asset must survive, must break in, or may lose a part in. Requirements bound its threshold, or the
/// impulse per area of its bonds.
struct StrengthRequirement {
    RequirementOutcome outcome = RequirementOutcome::Survives;
    std::variant<DropRequirement, HitRequirement, ImpulseRequirement> event;
    double hole = 0.5;  // m, > 0: the width for HoleAtMost, as holeWidth()
    bool operator==(const StrengthRequirement&) const = default;
};

/// A solid with its recipe for fracture.
struct Asset {
    Id id = 0;
    std::string name;
    Id material = 0;
    std::variant<Prism, std::shared_ptr<const ClosedMesh>> shape;  // a mesh is never null
    Pattern pattern;
    Shaping shaping;                                    // of all levels
    std::vector<Level> levels;                          // levels[0] fractures the pattern's fragments
    std::vector<FragmentLevel> fragmentLevels;          // settings of single fragments; ascending path
    std::vector<FragmentThreshold> fragmentThresholds;  // of single fragments; ascending path
    std::vector<FragmentEdit> edits;                    // merges and splits by hand, in the order of editing
    double threshold = 100.0;                           // N·s, > 0, as entered; thresholdOf() gives the effective one
    std::optional<double> contactTime;                  // s, > 0: derive the threshold from the material's strength
    double insideUvScale = 1.0;                         // UV units per metre on inside faces
    Id insideMaterial = 0;                              // of inside faces; 0: the asset's own material
    std::optional<CutAtImpact> cutAtImpact;             // none: it breaks into the fragments of its pattern
    BreakAs breakAs = BreakAs::Whole;                   // what is cut at the point of impact breaks whole
    Bonding bonding;                                    // of what breaks as bonded
    std::vector<StrengthRequirement> requirements;      // in the order of editing
    std::shared_ptr<const Surface> surface;             // of the imported mesh; null if not imported
    std::optional<Texture> texture;                     // of the outside; none: the material's colour alone
    bool operator==(const Asset& other) const;

    /// Null if it is a prism.
    const ClosedMesh* mesh() const;
    bool isPrism() const { return std::holds_alternative<Prism>(shape); }
    /// Of a prism only.
    const Prism& prism() const;
    Prism& prism();
};

/// Whether two assets are equal prisms, or meshes of the same content.
bool isSameShape(const Asset& first, const Asset& second);

/// An asset placed in the scene.
struct Instance {
    Id id = 0;
    std::string name;
    Id asset = 0;
    Pose pose;                        // world from the prism's frame
    std::optional<double> threshold;  // N·s, overrides the asset's
    bool isFixed = false;             // static, as the ground, until it breaks
    bool isUnbreakable = false;       // never breaks, whatever the impact; may be fixed as well
    bool isAnchored = false;          // bonded: held by what it touches at the start, if that is fixed
    double bondStrength = 1.0;        // >= 0: multiplies the strength of its bonds
    std::uint32_t variant = 0;        // of the fracture: see variantOf()
    bool isHidden = false;            // in the editor only; it takes part in play
    bool isLocked = false;            // neither selected nor moved in the 3D view
    bool operator==(const Instance&) const = default;
};

struct Ground {
    bool isOn = true;
    double height = 0.0;  // m
    double friction = 0.6;
    double restitution = 0.0;
    bool operator==(const Ground&) const = default;
};

enum class DamageRule { Impact, Momentum };

/// The settings for computing damage to bodies.
struct Damage {
    DamageRule rule = DamageRule::Impact;
    bool isThesis = false;            // preset: one threshold, rule Momentum, 100 kg fragments, no break impulse
    double thesisThreshold = 1000.0;  // N·s
    bool operator==(const Damage&) const = default;
};

/// The settings for removing debris: fragments, also those of thrown assets. Projectiles, thrown assets that are whole,
/// and instances are not debris.
struct Debris {
    std::optional<double> lifetime;             // s, > 0: after which it has faded out; none: unlimited
    double fade = 1.0;                          // s, >= 0: duration of fading out, at the end of its life
    std::optional<std::uint32_t> maxFragments;  // >= 1; beyond it: sleeping first, then smallest, then oldest
    bool operator==(const Debris&) const = default;
};

/// The settings of the events of play.
struct EventSettings {
    double leastEnergy = 1.0;       // J: weaker impacts are only counted and summed
    std::uint32_t maxRecords = 16;  // a step, >= 1; at least one for each kind that happened
    bool operator==(const EventSettings&) const = default;
};

enum class ProjectileKind { Box, Ball, Plank, Asset };

/// Throws a projectile.
struct Throw {
    ProjectileKind kind = ProjectileKind::Box;
    Id asset = 0;               // for ProjectileKind::Asset
    Vec3 size{0.5, 0.5, 0.5};   // m; x is the diameter of a ball
    double mass = 10.0;         // kg
    Vec3 from{0.0, 1.0, 10.0};  // m
    Vec3 to{0.0, 1.0, 0.0};     // m; gives the initial direction
    double speed = 10.0;        // m/s
    bool operator==(const Throw&) const = default;
};
/// Strikes a body's surface with the head of a hammer, which makes nothing faster than itself: see HammerPatch.h.
struct Hammer {
    Vec3 at{0.0, 0.0, 0.0};        // m
    Vec3 impulse{0.0, 0.0, 0.0};   // N·s
    std::optional<double> radius;  // m, of the patch that it strikes; none: follows from the impulse
    bool operator==(const Hammer&) const = default;
};
/// Pushes bodies away from a point: the surfaces that face it and are visible from it, with an impulse per area that
/// falls linearly from `impulse` at the point to 0 at `radius`. See World::blast().
struct Blast {
    Vec3 at{0.0, 0.0, 0.0};   // m
    double impulse = 1000.0;  // N·s/m²
    double radius = 2.0;      // m
    bool operator==(const Blast&) const = default;
};
using ShotAction = std::variant<Throw, Hammer, Blast>;

/// An action on the scene at a given time of a play-test.
struct Shot {
    Id id = 0;
    std::string name;
    double time = 0.0;  // s after the start
    ShotAction action;
    bool operator==(const Shot&) const = default;
};

enum class ExpectationKind {
    StandsUntouched,    // nothing moves more than 1 cm within `value` seconds
    Breaks,             // `instance` breaks
    DoesNotBreak,       // `instance` does not break
    BreaksIntoAtLeast,  // `instance` breaks into at least `value` fragments
    NothingAbove,       // nothing above the height of `value` metres at the end
    NothingFaster,      // nothing faster than `value` m/s at the end
    StaysUp,            // at most the fraction `value` of the mass of `instance` came down at the end
    HoleAtMost,         // no hole in the bonded `instance` is wider than `value` metres at the end
};
inline constexpr std::size_t kExpectationKinds = 8;
struct Expectation {
    ExpectationKind kind = ExpectationKind::Breaks;
    Id instance = 0;  // 0: any
    double value = 0.0;
    bool operator==(const Expectation&) const = default;
};
/// An instance, or some of its fragments.
struct InstancePart {
    Id instance = 0;
    std::vector<FragmentPath> fragments;  // ascending, of a bonded instance; none: all of it
    bool operator==(const InstancePart&) const = default;
};
/// Shots, and the expected behaviour of the scene when they are fired.
struct PlayTest {
    Id id = 0;
    std::string name;
    std::string state;  // name of the state beside the project that it starts from; empty: from the scene
    std::vector<InstancePart> removed;  // at the start; ascending instance
    std::vector<Id> shots;
    double duration = 5.0;  // s
    std::vector<Expectation> expectations;
    bool operator==(const PlayTest&) const = default;
};

/// Everything that is edited and saved.
struct Project {
    /// Tells the project from others whose files have the same name; 32 hexadecimal digits. Empty: it has none yet.
    std::string identity;
    Id nextId = 1;
    std::vector<Material> materials;  // this and the following: ascending id
    std::vector<Asset> assets;
    std::vector<Instance> instances;
    Ground ground;
    Vec3 gravity{0.0, -9.81, 0.0};  // m/s²
    Damage damage;
    Debris debris;
    EventSettings events;
    std::vector<Shot> shots;
    std::vector<PlayTest> playTests;
    std::vector<Mortar> mortars;
    bool operator==(const Project&) const = default;
};

/// An asset's material, and the material of its inside faces. Borrowed for a call.
struct AssetMaterials {
    AssetMaterials(const Material& both) : own(both), inside(both) {}
    AssetMaterials(const Material& outer, const Material& inner) : own(outer), inside(inner) {}
    const Material& own;
    const Material& inside;
};
/// Both must exist in the project.
AssetMaterials materialsOf(const Project& project, const Asset& asset);

/// The element with an id; null if there is none.
const Material* findMaterial(const Project& project, Id id);
const Asset* findAsset(const Project& project, Id id);
const Instance* findInstance(const Project& project, Id id);
const Mortar* findMortar(const Project& project, Id id);
/// The asset with a name; null if there is none.
const Asset* findAsset(const Project& project, const std::string& name);

}  // namespace rubble
