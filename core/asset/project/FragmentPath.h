#pragma once

#include "core/fracture/pattern/Pattern.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// A fragment's id without that of its asset: the names of the pieces from the whole down to it, "5.17" or
/// "5.17.1/9.2". The whole has the empty path. A path survives copying the asset, except that the copied layers get new
/// ids: see withLayers().
using FragmentPath = std::string;

/// The path in a fragment's id "asset/path".
FragmentPath pathOfId(std::string_view fragmentId);
/// The path of the parent; empty for the whole and for fragments of level 0.
FragmentPath parentOf(const FragmentPath& path);
/// The fragment's level; 0: a fragment of the whole.
std::uint32_t levelOf(const FragmentPath& path);
/// True if `path` is `ancestor` or one of its descendants.
bool isWithin(const FragmentPath& path, const FragmentPath& ancestor);
/// The child of `ancestor` that is `path` or an ancestor of it: "5.17" for the path "5.17/9.2" and the whole.
FragmentPath childOnPath(const FragmentPath& ancestor, const FragmentPath& path);

/// The parts of a piece's name, see pieceName().
struct PieceName {
    SeedId seed;  // or the first cell of a cut layer, where there are no seeds
    std::uint32_t partOfCell = kNone;
    std::vector<SeedId> cells;  // further cells of a merged piece
    bool operator==(const PieceName&) const = default;
};
/// The last name of a path; nothing if it cannot be parsed.
std::optional<PieceName> pieceNameOf(const FragmentPath& path);
/// True if the text is one or more piece names separated by slashes.
bool isFragmentPath(const FragmentPath& path);

/// The path with layer ids replaced according to the map; ids that are not in the map stay.
FragmentPath withLayers(const FragmentPath& path, const std::map<std::uint32_t, std::uint32_t>& layers);

}  // namespace rubble
