#include "editor/canvas/MovedCells.h"

#include "core/fracture/PatternKind.h"
#include "core/fracture/Prism.h"

#include <algorithm>

namespace rubble {

namespace {

constexpr std::size_t kMostMoved = 64;  // more take longer than the picture

/// Compares two states of a pattern.
class Moves {
public:
    explicit Moves(const ShownPattern& before) : m_before(before) {}

    /// False where more changed than places of seeds.
    bool take(const Pattern& before, const Pattern& now) {
        return std::ranges::equal(before.layers, now.layers,
                                  [this](const auto& old, const auto& layer) { return takeLayer(old, layer); });
    }

    std::vector<MovedSeed> moved;

private:
    using Placed = std::vector<PlacedSeeds::Seed>;
    using Overrides = std::vector<SeedOverride>;

    bool takeLayer(const PatternLayer& old, const PatternLayer& now) {
        if (now.id != old.id || now.isOn != old.isOn || now.randomSeed != old.randomSeed) return false;
        if (!now.isOn) return true;
        // It moves scattered seeds when others move, cuts their cells, or makes other cells of them.
        const LayerRole role = kindOf(now.parameters).role;
        if (role != LayerRole::Scatters && role != LayerRole::Places) return false;
        const auto* placedOld = std::get_if<PlacedSeeds>(&old.parameters);
        const auto* placed = std::get_if<PlacedSeeds>(&now.parameters);
        const bool isAlike = placed && placedOld ? takePlaced(now.id, placedOld->seeds, placed->seeds)
                                                 : now.parameters == old.parameters;
        return isAlike && takeOverrides(now.id, old.overrides, now.overrides);
    }

    bool takePlaced(std::uint32_t layer, const Placed& before, const Placed& now) {
        return std::ranges::equal(before, now, [&](const PlacedSeeds::Seed& old, const PlacedSeeds::Seed& seed) {
            if (seed.index == old.index && seed.position != old.position) add({layer, seed.index}, seed.position);
            return seed.index == old.index;
        });
    }

    bool takeOverrides(std::uint32_t layer, const Overrides& before, const Overrides& now) {
        auto old = before.begin();
        for (const SeedOverride& change : now) {
            const bool isOld = old != before.end() && old->index == change.index;
            if (change.isDeleted != (isOld && old->isDeleted)) return false;
            const bool isMoved = !change.isDeleted && !(isOld && old->position == change.position);
            if (isMoved) add({layer, change.index}, change.position);
            if (isOld) ++old;
        }
        // Where a seed was thrown that is not held any more is not known here.
        return old == before.end();
    }

    void add(SeedId id, Vec2 position) {
        if (const std::uint32_t seed = m_before.find(id); seed != kNone) moved.push_back({seed, position});
    }

    const ShownPattern& m_before;
};

/// The part's own pattern, as if there were no other seeds.
std::shared_ptr<const BakedPattern> bakedOf(const ShownPattern& whole, const Asset& now, LocalCells cells) {
    auto baked = std::make_shared<BakedPattern>();
    baked->asset = std::make_shared<const Asset>(now);
    baked->inside = whole.baked().inside;
    baked->seeds.positions = std::move(cells.positions);
    for (const std::uint32_t seed : cells.seeds) baked->seeds.ids.push_back(whole.seeds().ids[seed]);
    baked->triangulation = std::move(cells.triangulation);
    baked->partition = std::move(cells.partition);
    return baked;
}

}  // namespace

std::optional<std::vector<MovedSeed>> movedSeeds(const ShownPattern& before, const Asset& now) {
    if (now.prism != before.baked().asset->prism) return std::nullopt;
    Moves moves(before);
    if (!moves.take(before.baked().asset->pattern, now.pattern)) return std::nullopt;
    return std::move(moves.moved);
}

bool MovedPart::replaces(std::uint32_t seed) const { return std::ranges::binary_search(replaced, seed); }

std::shared_ptr<const MovedPart> MovedCells::partOf(const Asset& now) {
    const std::optional<std::vector<MovedSeed>> moved = movedSeeds(*m_baked, now);
    if (!moved || moved->empty() || moved->size() > kMostMoved) return nullptr;
    if (!m_diagram) {
        const Result<Prism> prism = validated(now.prism);
        if (!prism) return nullptr;
        m_outline = prism->outline;
        m_diagram.emplace(m_baked->seeds().positions, m_baked->baked().triangulation);
    }
    Result<LocalCells> cells = m_diagram->cellsAround(m_outline, *moved);
    if (!cells) return nullptr;
    auto part = std::make_shared<MovedPart>();
    part->isShown.resize(cells->seeds.size());
    for (const std::uint32_t seed : cells->complete) {
        part->isShown[seed] = true;
        part->replaced.push_back(cells->seeds[seed]);
    }
    part->pattern = std::make_shared<const ShownPattern>(bakedOf(*m_baked, now, std::move(*cells)));
    findBoxes(*part, *moved);
    return part;
}

/// An area that changes hands was or is a moved seed's. But where another seed gets a piece, loses one or has several,
/// its pieces may be called otherwise or it be marked otherwise.
void MovedCells::findBoxes(MovedPart& part, std::span<const MovedSeed> moved) const {
    bool hasOtherNames = false;
    for (const std::uint32_t seed : part.replaced) {
        const std::uint32_t own = part.pattern->find(m_baked->seeds().ids[seed]);
        Box2 box = m_baked->boxOf(seed);
        include(box, part.pattern->boxOf(own));
        include(part.changed, box);
        if (std::ranges::find(moved, seed, &MovedSeed::seed) != moved.end()) {
            include(part.moved, box);
        } else {
            const std::size_t before = m_baked->piecesOf(seed).size(), now = part.pattern->piecesOf(own).size();
            hasOtherNames = hasOtherNames || before != now || now > 1;
        }
    }
    if (hasOtherNames) part.moved = part.changed;
}

}  // namespace rubble
