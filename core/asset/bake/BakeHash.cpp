#include "core/asset/bake/BakeHash.h"

#include "core/fracture/pattern/PatternKind.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

namespace rubble {
namespace {

/// Raised when bake() changes its result for an asset, so that earlier exports count as out of date.
constexpr std::uint64_t kBakeVersion = 1;

void add(Hasher& hasher, Vec2 point) {
    hasher.add(point.x);
    hasher.add(point.y);
}

void add(Hasher& hasher, const Ring& ring) {
    hasher.add(std::uint64_t{ring.size()});
    for (const Vec2 corner : ring) add(hasher, corner);
}

void add(Hasher& hasher, const Polygon& outline) {
    add(hasher, outline.outer);
    hasher.add(std::uint64_t{outline.holes.size()});
    for (const Ring& hole : outline.holes) add(hasher, hole);
}

void add(Hasher& hasher, const Prism& prism) {
    add(hasher, prism.outline);
    hasher.add(prism.depth);
}

/// A mesh starts with a word that the number of an outline's corners cannot be.
void add(Hasher& hasher, const ClosedMesh& mesh) {
    hasher.add(std::uint64_t{1} << 63);
    hasher.add(mesh.hash.high);
    hasher.add(mesh.hash.low);
}

/// A plain number is hashed alone, as before there were other counts; others start with a word that no number can be.
void add(Hasher& hasher, const SeedCount& count) {
    if (count.by == CountBy::Number) return hasher.add(static_cast<std::uint64_t>(count.amount));
    hasher.add((std::uint64_t{1} << 63) + static_cast<std::uint64_t>(count.by));
    hasher.add(count.amount);
}

void add(Hasher& hasher, const LayerParameter& parameter, const LayerParameters& of) {
    const ParameterValue value = parameter.read(of);
    switch (parameter.type) {
        case ParameterType::Whole:
        case ParameterType::Option: return hasher.add(static_cast<std::uint64_t>(std::get<double>(value)));
        case ParameterType::Real: return hasher.add(std::get<double>(value));
        case ParameterType::Point: return add(hasher, std::get<Vec2>(value));
        case ParameterType::Count: return add(hasher, std::get<SeedCount>(value));
    }
}

// The data of a kind besides its parameters.
template <class Parameters>
void addHeld(Hasher&, const Parameters&) {}
void addHeld(Hasher& hasher, const PlacedSeeds& placed) {
    hasher.add(std::uint64_t{placed.seeds.size()});
    // In blocks, since a call costs more than hashing one seed.
    std::array<std::uint64_t, 3 * 256> words;
    std::size_t count = 0;
    for (const PlacedSeeds::Seed& seed : placed.seeds) {
        words[count++] = seed.index;
        words[count++] = std::bit_cast<std::uint64_t>(seed.position.x);
        words[count++] = std::bit_cast<std::uint64_t>(seed.position.y);
        if (count < words.size() && &seed != &placed.seeds.back()) continue;
        hasher.add(std::as_bytes(std::span(words).first(count)));
        count = 0;
    }
    const auto isRaised = [](const PlacedSeeds::Seed& seed) { return seed.height != 0.0; };
    if (std::ranges::none_of(placed.seeds, isRaised)) return;
    hasher.add(std::string_view("heights"));
    for (const PlacedSeeds::Seed& seed : placed.seeds) hasher.add(seed.height);
}

void addHeld(Hasher& hasher, const CrackLines& layer) {
    hasher.add(std::uint64_t{layer.lines.size()});
    for (const CrackLines::CrackLine& line : layer.lines) {
        hasher.add(std::uint64_t{line.index});
        add(hasher, line.points);
    }
}

void addHeld(Hasher& hasher, const DensityImage& layer) {
    if (!layer.image) return hasher.add(std::uint64_t{0});
    const GreyImage& image = *layer.image;
    for (const std::uint32_t number : {image.width, image.height, image.bits}) hasher.add(std::uint64_t{number});
    for (const std::vector<std::uint16_t>* values : {&image.grey, &image.opacity}) {
        hasher.add(std::uint64_t{values->size()});
        hasher.add(std::as_bytes(std::span(*values)));
    }
}

void add(Hasher& hasher, const PatternLayer& layer) {
    hasher.add(std::uint64_t{layer.id});
    hasher.add(layer.randomSeed);
    hasher.add(std::uint64_t{layer.parameters.index()});
    for (const LayerParameter& parameter : kindOf(layer.parameters).parameters) {
        if (!isWritten(parameter, layer.parameters)) continue;
        if (parameter.isSpatial) hasher.add(parameter.name);
        add(hasher, parameter, layer.parameters);
    }
    std::visit([&](const auto& parameters) { addHeld(hasher, parameters); }, layer.parameters);
    hasher.add(std::uint64_t{layer.overrides.size()});
    for (const SeedOverride& change : layer.overrides) {
        hasher.add(std::uint64_t{change.index});
        hasher.add(std::uint64_t{change.isDeleted});
        add(hasher, change.isDeleted ? Vec2{0.0, 0.0} : change.position);
        if (!change.isDeleted && change.height != 0.0) add(hasher, Vec2{1.0, change.height});
    }
    if (layer.scatteredIn) add(hasher, *layer.scatteredIn);
}

/// Disabled layers have no effect and are not hashed.
void add(Hasher& hasher, const Pattern& pattern) {
    hasher.add(static_cast<std::uint64_t>(std::ranges::count(pattern.layers, true, &PatternLayer::isOn)));
    for (const PatternLayer& layer : pattern.layers) {
        if (layer.isOn) add(hasher, layer);
    }
}

void add(Hasher& hasher, const FragmentPath& path) {
    hasher.add(std::uint64_t{path.size()});
    hasher.add(std::string_view(path));
}

void add(Hasher& hasher, const Level& level) {
    hasher.add(level.minimumVolume);
    add(hasher, level.pattern);
}

void add(Hasher& hasher, const FragmentEdit& edit) {
    hasher.add(std::uint64_t{edit.index()});
    if (const auto* split = std::get_if<FragmentSplit>(&edit)) {
        add(hasher, split->fragment);
        add(hasher, split->line.point);
        return add(hasher, split->line.direction);
    }
    const auto& merge = std::get<FragmentMerge>(edit);
    add(hasher, merge.into);
    hasher.add(std::uint64_t{merge.merged.size()});
    for (const FragmentPath& path : merge.merged) add(hasher, path);
}

/// Adds nothing for default shaping, so that hashes stay as they were before shaping existed. Roughness affects meshes
/// only.
void addShaping(Hasher& hasher, const Asset& asset) {
    const SmallPieces& small = asset.shaping.smallPieces;
    const bool isDefault = small.rule == SmallPieceRule::Keep && asset.shaping.gap == 0.0 &&
                           asset.fragmentLevels.empty() && asset.edits.empty();
    if (isDefault) return;
    hasher.add(static_cast<std::uint64_t>(small.rule));
    if (small.rule != SmallPieceRule::Keep) {
        hasher.add(static_cast<std::uint64_t>(small.measure));
        hasher.add(small.limit);
    }
    hasher.add(asset.shaping.gap);
    hasher.add(std::uint64_t{asset.fragmentLevels.size()});
    for (const FragmentLevel& leaf : asset.fragmentLevels) {
        add(hasher, leaf.fragment);
        hasher.add(std::uint64_t{leaf.level.has_value()});
        if (leaf.level) add(hasher, *leaf.level);
    }
    hasher.add(std::uint64_t{asset.edits.size()});
    for (const FragmentEdit& edit : asset.edits) add(hasher, edit);
}

}  // namespace

ContentHash bakeInputHash(const Asset& asset) {
    Hasher hasher;
    hasher.add(kBakeVersion);
    hasher.add(std::uint64_t{asset.id});
    if (const ClosedMesh* mesh = asset.mesh()) {
        add(hasher, *mesh);
    } else {
        add(hasher, asset.prism());
    }
    add(hasher, asset.pattern);
    hasher.add(std::uint64_t{asset.levels.size()});
    for (const Level& level : asset.levels) add(hasher, level);
    addShaping(hasher, asset);
    return hasher.digest();
}

}  // namespace rubble
