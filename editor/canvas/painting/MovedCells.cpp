#include "editor/canvas/painting/MovedCells.h"

#include "core/fracture/pattern/PatternKind.h"
#include "core/fracture/pieces/Prism.h"

#include <algorithm>

namespace rubble {

namespace {

constexpr std::size_t kMaxMovedSeeds = 64;  // more take longer than a frame

/// Collects the seeds that were moved between two states of a pattern.
class PatternComparison {
public:
    explicit PatternComparison(const DrawablePattern& before) : m_before(before) {}

    /// False if more than seed positions changed.
    bool compare(const Pattern& before, const Pattern& now) {
        return std::ranges::equal(before.layers, now.layers,
                                  [this](const auto& old, const auto& layer) { return compareLayer(old, layer); });
    }

    std::vector<MovedSeed> moved;

private:
    using Placed = std::vector<PlacedSeeds::Seed>;
    using Overrides = std::vector<SeedOverride>;

    bool compareLayer(const PatternLayer& old, const PatternLayer& now) {
        if (now.id != old.id || now.isOn != old.isOn || now.randomSeed != old.randomSeed) return false;
        if (!now.isOn) return true;
        // Other roles change cells beyond those of the moved seeds.
        const LayerRole role = kindOf(now.parameters).role;
        if (role != LayerRole::Scatters && role != LayerRole::Places) return false;
        const auto* oldPlaced = std::get_if<PlacedSeeds>(&old.parameters);
        const auto* placed = std::get_if<PlacedSeeds>(&now.parameters);
        const bool isSame = placed && oldPlaced ? comparePlaced(now.id, oldPlaced->seeds, placed->seeds)
                                                : now.parameters == old.parameters;
        return isSame && compareOverrides(now.id, old.overrides, now.overrides);
    }

    bool comparePlaced(std::uint32_t layer, const Placed& before, const Placed& now) {
        return std::ranges::equal(before, now, [&](const PlacedSeeds::Seed& old, const PlacedSeeds::Seed& seed) {
            if (seed.index == old.index && seed.position != old.position) add({layer, seed.index}, seed.position);
            return seed.index == old.index;
        });
    }

    bool compareOverrides(std::uint32_t layer, const Overrides& before, const Overrides& now) {
        auto old = before.begin();
        for (const SeedOverride& change : now) {
            const bool isOld = old != before.end() && old->index == change.index;
            if (change.isDeleted != (isOld && old->isDeleted)) return false;
            const bool isMoved = !change.isDeleted && !(isOld && old->position == change.position);
            if (isMoved) add({layer, change.index}, change.position);
            if (isOld) ++old;
        }
        // The scattered position of a seed whose override was removed is not known here.
        return old == before.end();
    }

    void add(SeedId id, Vec2 position) {
        if (const std::uint32_t seed = m_before.find(id); seed != kNone) moved.push_back({seed, position});
    }

    const DrawablePattern& m_before;
};

/// The pattern of the part alone.
std::shared_ptr<const BakedPattern> bakedOf(const DrawablePattern& whole, const Asset& now, LocalCells cells) {
    auto baked = std::make_shared<BakedPattern>();
    baked->asset = std::make_shared<const Asset>(now);
    baked->parent = whole.baked().parent;
    baked->seeds.positions = std::move(cells.positions);
    for (const std::uint32_t seed : cells.seeds) baked->seeds.ids.push_back(whole.seeds().ids[seed]);
    baked->triangulation = std::move(cells.triangulation);
    baked->partition = std::move(cells.partition);
    return baked;
}

}  // namespace

std::optional<std::vector<MovedSeed>> movedSeeds(const DrawablePattern& before, const Asset& now) {
    if (before.baked().section || !isSameShape(now, *before.baked().asset)) return std::nullopt;
    PatternComparison comparison(before);
    if (!comparison.compare(before.baked().asset->pattern, now.pattern)) return std::nullopt;
    return std::move(comparison.moved);
}

bool MovedPart::replaces(std::uint32_t seed) const { return std::ranges::binary_search(replaced, seed); }

std::shared_ptr<const MovedPart> MovedCells::movedPart(const Asset& now) {
    const std::optional<std::vector<MovedSeed>> moved = movedSeeds(*m_baked, now);
    if (!moved || moved->empty() || moved->size() > kMaxMovedSeeds) return nullptr;
    if (!m_diagram) {
        const Result<Prism> prism = validated(now.prism());
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
    part->pattern = std::make_shared<const DrawablePattern>(bakedOf(*m_baked, now, std::move(*cells)));
    findBoxes(*part, *moved);
    return part;
}

/// Any area that changes its cell belongs to a moved seed before or after. But if the number of pieces of another seed
/// changes, or it has several, its pieces may change their names.
void MovedCells::findBoxes(MovedPart& part, std::span<const MovedSeed> moved) const {
    bool mayBeRenamed = false;
    for (const std::uint32_t seed : part.replaced) {
        const std::uint32_t own = part.pattern->find(m_baked->seeds().ids[seed]);
        Box2 box = m_baked->boxOf(seed);
        include(box, part.pattern->boxOf(own));
        include(part.changed, box);
        if (std::ranges::find(moved, seed, &MovedSeed::seed) != moved.end()) {
            include(part.moved, box);
        } else {
            const std::size_t before = m_baked->piecesOf(seed).size(), now = part.pattern->piecesOf(own).size();
            mayBeRenamed = mayBeRenamed || before != now || now > 1;
        }
    }
    if (mayBeRenamed) part.moved = part.changed;
}

}  // namespace rubble
