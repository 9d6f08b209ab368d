#pragma once

#include "core/io/pack/PackFile.h"

#include <optional>
#include <string>

namespace rubble {

/// Returns the first error in the places of a pack's fragments and in their neighbours, if there is one: a fragment
/// that extends beyond its parent, two siblings that touch but are not neighbours, a contact area that differs from
/// that of the faces that meet, fragments nearer to each other than the gap of their parent, or none as far apart as
/// it. Beside a gap, contact areas are bounded: from below by the faces that are opposite each other, from above by the
/// pieces that half of the gap was taken from. Fragments of meshes, whose hulls are around them, are not compared.
/// Precondition: ids, parents and hulls are valid. Nearly O(n log n) for n
/// fragments of one size.
std::optional<std::string> verifyPackContacts(const Pack& pack);

}  // namespace rubble
