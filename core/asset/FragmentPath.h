#pragma once

#include "core/fracture/Pattern.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// A fragment's id below that of its asset, "5.17" or "5.17.1/9.2": the names of the pieces from the whole down to it. It stays
/// when an asset is copied but for the layers, whose ids are then others.
using FragmentPath = std::string;

/// The path in a fragment's id: what follows the asset's.
FragmentPath pathOfId(std::string_view fragmentId);
/// The path of what a fragment is a piece of; empty for the whole.
FragmentPath parentOf(const FragmentPath& path);
/// How deep a fragment lies: 0 where it is a piece of the whole.
std::uint32_t levelOf(const FragmentPath& path);

/// The name of a piece, see pieceName().
struct PieceName {
    SeedId seed;  // or the first cell of a cut layer, where there are no seeds
    std::uint32_t partOfCell = kNone;
    std::vector<SeedId> cells;  // the others
    bool operator==(const PieceName&) const = default;
};
/// The last name in a path; nothing where it is none.
std::optional<PieceName> pieceNameOf(const FragmentPath& path);
/// Whether it reads as a path: names of pieces, one or more with strokes between.
bool isPath(const FragmentPath& path);

/// The path with other ids of layers; those that are not in the map stay.
FragmentPath withLayers(const FragmentPath& path, const std::map<std::uint32_t, std::uint32_t>& layers);

}  // namespace rubble
