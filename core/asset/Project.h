#pragma once

#include "core/asset/FragmentPath.h"
#include "core/asset/Shaping.h"
#include "core/asset/Surface.h"
#include "core/fracture/Pattern.h"
#include "core/fracture/Prism.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rubble {

/// Project-wide integer id; 0 names nothing. All come from Project::nextId.
using Id = std::uint32_t;

/// sRGB, each in [0, 1].
struct Colour {
    double red = 0.8;
    double green = 0.8;
    double blue = 0.8;
    bool operator==(const Colour&) const = default;
};

/// What a body is made of.
struct Material {
    Id id = 0;
    std::string name;
    double density = 1000.0;                  // kg/m^3, > 0
    double friction = 0.6;                    // Coulomb's coefficient, >= 0
    double restitution = 0.0;                 // in [0, 1]
    std::optional<double> tensileStrength;    // Pa, > 0; none: not told
    std::optional<double> fractureToughness;  // Pa·√m, > 0; none: not told
    Colour outside;
    Colour inside;
    bool operator==(const Material&) const = default;
};

/// How the fragments of one level, or a single one, are broken again.
struct Level {
    Pattern pattern;
    double minimumVolume = 0.0;  // m^3; smaller fragments stay whole
    bool operator==(const Level&) const = default;
};

/// How one fragment is broken, whatever its level says.
struct FragmentLevel {
    FragmentPath fragment;
    std::optional<Level> level;  // none: it stays whole
    bool operator==(const FragmentLevel&) const = default;
};

/// Being cut anew where it is hit when it breaks, instead of into the pieces of its pattern (thesis 3.3).
struct CutAtImpact {
    static constexpr std::uint32_t kFewestPieces = 2;
    static constexpr std::uint32_t kMostPieces = 1000;  // it is cut within a step
    std::uint32_t pieces = 30;                          // from kFewestPieces to kMostPieces
    double reach = 0.3;  // m, > 0: seeds grow denser towards the point of impact; half of them lie within it
    bool operator==(const CutAtImpact&) const = default;
};

enum class IntentOutcome { Survives, Breaks };

/// Falling from a height onto level ground, as the asset stands.
struct DropIntent {
    double height = 1.0;  // m, > 0
    bool operator==(const DropIntent&) const = default;
};
/// Being hit in the middle of its front by a body, head on.
struct HitIntent {
    double mass = 5.0;    // kg, > 0
    double speed = 10.0;  // m/s, > 0
    bool operator==(const HitIntent&) const = default;
};
/// What an artist wants an asset to take, or not to take: the threshold is derived from such sentences.
struct Intent {
    IntentOutcome outcome = IntentOutcome::Survives;
    std::variant<DropIntent, HitIntent> event;
    bool operator==(const Intent&) const = default;
};

/// A solid with its recipe for breaking.
struct Asset {
    Id id = 0;
    std::string name;
    Id material = 0;
    Prism prism;
    Pattern pattern;
    Shaping shaping;                         // of the pieces of all levels
    std::vector<Level> levels;               // below the first: levels[0] breaks the pattern's fragments
    std::vector<FragmentLevel> leaves;       // fragments that are broken in their own way: ascending path
    std::vector<FragmentEdit> edits;         // fragments merged and split by hand, in the order that it was done
    double threshold = 100.0;                // N·s, > 0, as typed; what is in force: see thresholdOf()
    std::optional<double> contactTime;       // s, > 0: the threshold follows from the material's strength; none: typed
    double insideUvScale = 1.0;              // UV units a metre on the inside faces
    Id insideMaterial = 0;                   // whose inside the cuts lay open; 0: the asset's own material
    std::optional<CutAtImpact> cutAtImpact;  // none: it breaks into the pieces of its pattern
    std::vector<Intent> intents;             // in the order they were written
    std::shared_ptr<const Surface> surface;  // of the mesh it was imported from; null where there was none
    bool operator==(const Asset& other) const;
};

/// An asset placed in the scene.
struct Instance {
    Id id = 0;
    std::string name;
    Id asset = 0;
    Pose pose;                        // world from the prism's frame
    std::optional<double> threshold;  // N·s, instead of the asset's
    bool isFixed = false;             // held in place, as if part of the ground
    std::uint32_t variant = 0;        // in which way it breaks: see variantOf()
    bool isHidden = false;            // left out of the editor's view of the scene; it plays all the same
    bool isLocked = false;            // in the editor's view it is neither chosen nor moved
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

/// How bodies take damage.
struct Damage {
    DamageRule rule = DamageRule::Impact;
    bool isThesis = false;            // the preset: one threshold for all, momentum, 100 kg a piece, no payment
    double thesisThreshold = 1000.0;  // N·s
    bool operator==(const Damage&) const = default;
};

/// When pieces that lie about are taken away.
struct Debris {
    std::optional<double> lifetime;           // s, > 0: from birth until a piece has faded; none: for ever
    double fade = 1.0;                        // s, >= 0: the end of its life, in which it fades away
    std::optional<std::uint32_t> mostPieces;  // >= 1: beyond it pieces go: asleep first, then the smallest, the oldest
    bool operator==(const Debris&) const = default;
};

enum class ProjectileKind { Box, Ball, Plank, Asset };

/// Something thrown.
struct Throw {
    ProjectileKind kind = ProjectileKind::Box;
    Id asset = 0;               // for ProjectileKind::Asset
    Vec3 size{0.5, 0.5, 0.5};   // m; a ball takes x as its diameter
    double mass = 10.0;         // kg
    Vec3 from{0.0, 1.0, 10.0};  // m
    Vec3 to{0.0, 1.0, 0.0};     // m; it flies straight at it
    double speed = 10.0;        // m/s
    bool operator==(const Throw&) const = default;
};
/// A blow with a given impulse at a point.
struct Hammer {
    Vec3 at{0.0, 0.0, 0.0};       // m
    Vec3 impulse{0.0, 0.0, 0.0};  // N·s
    bool operator==(const Hammer&) const = default;
};
/// An impulse away from a point, falling off to zero at a radius.
struct Explosion {
    Vec3 at{0.0, 0.0, 0.0};   // m
    double impulse = 1000.0;  // N·s per m^2 of facing area at the centre
    double radius = 2.0;      // m
    bool operator==(const Explosion&) const = default;
};
using ShotAction = std::variant<Throw, Hammer, Explosion>;

/// What happens to the scene in a play-test, and when.
struct Shot {
    Id id = 0;
    std::string name;
    double time = 0.0;  // s after the start
    ShotAction action;
    bool operator==(const Shot&) const = default;
};

enum class ExpectationKind {
    StandsUntouched,    // nothing moves more than 1 cm for `value` seconds
    Breaks,             // `instance` breaks
    DoesNotBreak,       // `instance` does not break
    BreaksIntoAtLeast,  // `instance` breaks into at least `value` pieces
    NothingAbove,       // nothing above the height of `value` metres at the end
    NothingFaster,      // nothing faster than `value` m/s at the end
};
struct Expectation {
    ExpectationKind kind = ExpectationKind::Breaks;
    Id instance = 0;  // 0: any
    double value = 0.0;
    bool operator==(const Expectation&) const = default;
};
/// A shot with what it is expected to do.
struct PlayTest {
    Id id = 0;
    std::string name;
    std::vector<Id> shots;
    double duration = 5.0;  // s
    std::vector<Expectation> expectations;
    bool operator==(const PlayTest&) const = default;
};

/// Everything an artist edits and saves.
struct Project {
    Id nextId = 1;
    std::vector<Material> materials;  // this and the following: ascending id
    std::vector<Asset> assets;
    std::vector<Instance> instances;
    Ground ground;
    Vec3 gravity{0.0, -9.81, 0.0};  // m/s^2
    Damage damage;
    Debris debris;
    std::vector<Shot> shots;
    std::vector<PlayTest> playTests;
    bool operator==(const Project&) const = default;
};

/// What an asset is made of: its own material, and the one whose inside its cuts lay open. Borrows them for a call.
struct AssetMaterials {
    AssetMaterials(const Material& both) : own(both), inside(both) {}
    AssetMaterials(const Material& itsOwn, const Material& itsInside) : own(itsOwn), inside(itsInside) {}
    const Material& own;
    const Material& inside;
};
/// Those of an asset whose materials are there.
AssetMaterials materialsOf(const Project& project, const Asset& asset);

/// The element with an id, or null.
const Material* findMaterial(const Project& project, Id id);
const Asset* findAsset(const Project& project, Id id);
/// The asset with a name, or null.
const Asset* findAsset(const Project& project, const std::string& name);

/// Says in one sentence what keeps a project from being used: ids that are not unique, not ascending or not below
/// nextId, names that are empty or taken, references to nothing, numbers out of range, prisms that cannot be fractured.
std::optional<std::string> verifyProject(const Project& project);

}  // namespace rubble
