#pragma once

#include "core/asset/Bake.h"

#include <optional>

namespace rubble {

// What is broken lies in a tree: the whole, whose path is empty, its fragments, and theirs.

/// Whether a path is that of `place` or of something within it.
bool isWithin(const FragmentPath& path, const FragmentPath& place);
/// The path of the piece of `place` that a fragment within it is, or comes from: of "5.17/9.2" that is "5.17" within the whole.
FragmentPath pieceOf(const FragmentPath& place, const FragmentPath& path);

/// The number of the fragment with a path, kNone for the whole; nothing where the bake has none.
/// O(pieces of what it and those above it are pieces of).
std::optional<std::uint32_t> fragmentAt(const Bake& bake, const FragmentPath& path);

}  // namespace rubble
