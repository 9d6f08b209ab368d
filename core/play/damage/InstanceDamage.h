#pragma once

#include "core/play/scene/PlayAsset.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// What the bits of a damage stand for. Written to files: values never change.
enum class DamageKind : std::uint8_t {
    Fractures = 1,  // of an instance that breaks whole: a bit per fracture
    Bonds = 2,      // of a bonded one: a bit per bond, and a byte per damaged bond that holds
};

/// The point at which a whole was fractured, and the number that makes the cut reproducible: see cutAtImpact().
struct ImpactCut {
    Vec2 point{0.0, 0.0};  // m, in the xy plane of the asset
    std::uint64_t number = 0;
    double height = 0.0;  // m, along z: of a mesh; 0 for a prism

    Vec3 place() const { return {point, height}; }
    /// Whether the height is 0, which files leave out.
    bool isInPlane() const { return key().back() == 0; }
    /// Compares the bits, so that equal cuts have equal fragments.
    bool operator==(const ImpactCut& other) const { return key() == other.key(); }
    bool operator<(const ImpactCut& other) const { return key() < other.key(); }

private:
    std::array<std::uint64_t, 4> key() const;
};

/// Which fractures or bonds of an instance have broken: a value, without bodies and poses.
struct InstanceDamage {
    DamageKind kind = DamageKind::Fractures;
    ContentHash bake;              // damageHash() of its asset
    std::optional<ImpactCut> cut;  // if the whole was fractured at a point of impact
    // By index in PlayAsset::fractures, of the cut asset if there is a cut; or in BondLayout.
    std::vector<bool> broken;
    std::map<std::uint32_t, std::uint8_t> partial;  // by index in BondLayout: n/255 of a bond that holds, 1 to 254
    bool operator==(const InstanceDamage&) const = default;
    bool isIntact() const;
};

/// The damage of the instances of a project, by id.
using SessionDamage = std::map<Id, InstanceDamage>;

/// What a damage must have been done to: a hash of everything that the fragments follow from.
ContentHash damageHash(const Asset& asset, const Bake& bake);

/// The damage of an instance that has not broken.
InstanceDamage intactDamage(const Asset& asset, const PlayAsset& ready);

/// The damage of an instance that both were done to: a fracture or bond is broken if it is in one of them, and of the
/// damages of a bond that holds the larger counts. Commutative,
/// associative and idempotent, so that damages may arrive in any order and any number of times. Of two different cuts
/// one prevails, the one with the larger number, then the larger point, with its fractures; a cut prevails over none.
///
/// Errors: BadInput if they are of different bakes, with both hashes; of different kinds; or of different sizes with
/// the same cut.
Result<InstanceDamage> mergedDamage(const InstanceDamage& one, const InstanceDamage& other);

/// What is broken or more damaged in `now` than in `before`: merged with `before` it gives `now`, where `now` was
/// merged from it.
///
/// Errors: as above.
Result<InstanceDamage> damageSince(const InstanceDamage& now, const InstanceDamage& before);

/// Why a damage cannot be of an asset, as a sentence: of another bake, with both hashes; of another number of
/// fractures; or with a fragment that broke before its parent. `ready` is the asset, or what its cut gives.
std::optional<std::string> damageFault(const InstanceDamage& damage, ContentHash bake, const PlayAsset& ready);

/// The fragments that break in each fracture of an asset; kNone: the whole.
std::vector<std::uint32_t> brokenFragments(const PlayAsset& ready);
/// The index of the fracture that a fragment comes from; kNone if it is the only fragment of the whole. O(log n).
std::uint32_t fractureContaining(const PlayAsset& ready, std::uint32_t fragment);

}  // namespace rubble
