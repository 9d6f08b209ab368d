#include "tests/attack/EngineUse.h"

#include "core/base/Hash.h"
#include "tests/attack/Mutator.h"

#include <algorithm>
#include <cmath>

namespace rubble::attack {
namespace {

using Fault = std::optional<std::string>;
using Damages = std::vector<std::vector<rubble_pack::Damage>>;

constexpr int kHits = 3;

/// A point at a fragment or anywhere near it, or far away.
rubble_pack::Vec3 randomPoint(const rubble_pack::Structure& structure, Random& random) {
    const double apart = std::pow(10.0, random.between(-9.0, 3.0));
    const rubble_pack::Vec3 by{apart * random.unit(), apart * random.unit(), apart * random.unit()};
    return rubble_pack::detail::plus(structure.centres[random.below(structure.centres.size())], by);
}

/// Hits a structure that has fragments, and lets fall off what has lost its support.
Fault hitFault(const rubble_pack::Pack& pack, const rubble_pack::Structure& structure,
               std::vector<rubble_pack::Damage>& damage, Random& random) {
    rubble_pack::Hit hit{{}, std::pow(10.0, random.between(-6.0, 9.0))};
    for (std::uint64_t count = 1 + random.below(3); count > 0; --count)
        hit.points.push_back(randomPoint(structure, random));
    const rubble_pack::HitOutcome outcome =
        rubble_pack::applyHit(structure, *pack.bonding, hit, structure.fragments, damage);
    if (!(outcome.taken >= 0.0 && outcome.taken <= hit.impulse)) return "A hit takes more than its impulse.";
    const auto isDamaged = [&](std::uint32_t bond) { return damage.at(bond) > 0; };
    if (!std::ranges::all_of(outcome.broken, isDamaged) || !std::ranges::all_of(outcome.damaged, isDamaged))
        return "A hit damages a bond that it leaves undamaged.";
    const std::uint32_t level = rubble_pack::breakingLevel(structure, damage, structure.fragments);
    const std::vector<std::uint32_t> falling =
        rubble_pack::unsupported(structure, damage, structure.fragments, pack.bonding->span, {0.0, 1.0, 0.0});
    rubble_pack::breakOff(structure, falling, damage, level);
    std::size_t count = 0;
    for (const rubble_pack::Island& island : rubble_pack::islandsOf(structure, damage, structure.fragments)) {
        count += island.fragments.size();
        if (!(rubble_pack::massOf(pack, island.fragments).mass > 0.0)) return "An island has no mass.";
    }
    if (count != structure.fragments.size()) return "The islands do not have each fragment once.";
    return std::nullopt;
}

/// Passes damages on as bytes, unchanged and changed; most changed ones get a checksum that fits.
Fault damageFault(const std::string& bake, const Damages& damages, Random& random) {
    constexpr std::size_t kChecksum = 8;
    std::string bytes = rubble_pack::damageBytes(bake, damages), fault;
    Damages read = damages;
    for (std::vector<rubble_pack::Damage>& one : read) std::ranges::fill(one, rubble_pack::Damage{0});
    if (!rubble_pack::readDamage(bytes, bake, read, fault)) return "The header refuses its own damages: " + fault;
    if (read != damages) return "The header reads other damages than it wrote.";
    if (random.below(8) == 0) {
        bytes = mutatedBytes(bytes, random);
    } else {
        bytes = mutatedBytes(bytes.substr(0, bytes.size() - kChecksum), random);
        rubble_pack::detail::addNumber(bytes, contentHash(bytes).low, kChecksum);
    }
    if (!rubble_pack::readDamage(bytes, bake, read, fault) && fault.empty())
        return "The header refuses damages without a word.";
    return std::nullopt;
}

/// What is anchored after mortar has broken that holds nothing.
std::vector<std::vector<std::uint32_t>> heldFragments(const rubble_pack::SceneStructures& all, Damages& damages) {
    while (!rubble_pack::breakMortar(all, damages).empty()) {
    }
    std::vector<std::vector<std::uint32_t>> held(all.structures.size());
    for (std::size_t k = 0; k < held.size(); ++k) {
        for (const rubble_pack::Island& island :
             rubble_pack::islandsOf(all.structures[k], damages[k], all.structures[k].fragments))
            if (island.isAnchored) held[k].insert(held[k].end(), island.fragments.begin(), island.fragments.end());
        std::ranges::sort(held[k]);
    }
    return held;
}

}  // namespace

Fault packUseFault(const rubble_pack::Pack& pack, Random& random) {
    for (std::uint32_t body = 0; body <= pack.fragments.size(); ++body) {
        const std::uint32_t index = body < pack.fragments.size() ? body : rubble_pack::kNone;
        for (const std::uint32_t child : pack.fragmentsOf(index))
            if (pack.body(child).parent != index) return "A fragment has another parent than the body that it is of.";
        static_cast<void>(pack.thresholdOf(index));
        static_cast<void>(pack.meshOf(index, ".glb"));
    }
    if (!pack.bonding) return std::nullopt;
    Damages damages;
    for (std::size_t k = 0; k < pack.bonding->fractures.size(); ++k) {
        rubble_pack::Structure structure =
            rubble_pack::structureOf(pack, k, random.below(2) == 0 ? 1.0 : random.between(0.0, 4.0));
        if (!structure.bonds.empty() && random.below(2) == 0) {
            rubble_pack::Bond anchor = structure.bonds[random.below(structure.bonds.size())];
            anchor.fragments[1] = rubble_pack::kNone;
            rubble_pack::addAnchor(structure, anchor);
        }
        damages.emplace_back(structure.bonds.size());
        for (int hits = structure.fragments.empty() ? 0 : kHits; hits > 0; --hits)
            if (Fault fault = hitFault(pack, structure, damages.back(), random)) return fault;
    }
    return damageFault(pack.bonding->bake, damages, random);
}

Fault sceneUseFault(const rubble_pack::Scene& scene, const std::vector<rubble_pack::Pack>& packs, Random& random,
                    bool& isUsed) {
    rubble_pack::SceneStructures all;
    std::string refusal;
    isUsed = rubble_pack::structuresOf(scene, packs, all, refusal);
    if (!isUsed && (refusal.empty() || refusal.back() != '.')) return "The header refuses packs without a sentence.";
    Damages damages = rubble_pack::intactDamages(all);
    for (int hits = all.structures.empty() ? 0 : kHits; hits > 0; --hits) {
        const std::size_t k = random.below(all.structures.size());
        const rubble_pack::Pack& pack = packs[scene.instances[k].pack];
        if (all.structures[k].fragments.empty()) continue;
        if (Fault fault = hitFault(pack, all.structures[k], damages[k], random)) return fault;
        const auto held = heldFragments(all, damages), falling = rubble_pack::unsupported(all, damages, held);
        for (std::size_t one = 0; one < held.size(); ++one) {
            const std::uint32_t level = rubble_pack::breakingLevel(all.structures[one], damages[one], held[one]);
            rubble_pack::breakOff(all.structures[one], falling[one], damages[one], level);
        }
        if (Fault fault = damageFault(pack.bonding->bake, {damages[k]}, random)) return fault;
    }
    return std::nullopt;
}

Fault eventsUseFault(const rubble_pack::EventLog& log, Random& random) {
    rubble_pack::EventState state = rubble_pack::startOf(log);
    const std::uint64_t end = log.events.empty() ? state.step : std::max(state.step, log.events.back().step);
    for (int parts = 4; parts > 0; --parts)
        rubble_pack::playTo(log, state.step + random.below(end - state.step + 1), state);
    rubble_pack::playTo(log, end, state);
    if (state.step != end) return "The events are not played to their end.";
    for (const rubble_pack::Event& event : log.events)
        for (const std::uint32_t material : event.materials)
            static_cast<void>(rubble_pack::materialName(log, material));
    return std::nullopt;
}

}  // namespace rubble::attack
