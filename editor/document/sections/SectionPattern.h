#pragma once

#include "core/fracture/planes/SolidSection.h"
#include "editor/document/Bakes.h"

#include <memory>

namespace rubble {

/// The section of a fracture of a mesh as a pattern in the plane, with which the canvas shows and edits it: a piece for
/// each polygon of a fragment, the seeds whose cells are cut, and the asset with the largest outline of the section as
/// its prism. `asset`: the state that was baked, whose levels fracture `parent`; `section`: in the frame of what was
/// cut.
std::shared_ptr<const BakedPattern> sectionPattern(const Asset& asset, const Bake& bake, const BakedFracture& fracture,
                                                   const SolidSection& section);

}  // namespace rubble
