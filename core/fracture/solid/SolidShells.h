#pragma once

#include "core/base/Index.h"
#include "core/fracture/solid/SolidFaces.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// A closed surface of a cell in a solid: sides of faces that meet at edges.
struct SolidShell {
    std::uint32_t cell = 0;
    double volume = 0.0;               // steps³; negative around a cavity
    double area = 0.0;                 // steps²
    std::uint32_t smallest = kNone;    // point, by x, then y, then z
    std::uint32_t owner = kNone;       // the shell whose fragment it belongs to: itself, or another; kNone: left out
    std::vector<std::uint32_t> sides;  // 2 * face, + 1 if from behind
};

/// The shells of a cut solid. Those that own themselves are each the outside of a fragment.
struct SolidShells {
    std::vector<SolidShell> shells;
    std::vector<std::uint32_t> ofSide;  // the shell of each side; kNone outside

    /// The shell whose fragment a shell belongs to; kNone if it is left out.
    std::uint32_t ownerOf(std::uint32_t shell) const {
        while (shell != kNone && shells[shell].owner != shell) shell = shells[shell].owner;
        return shell;
    }
};

/// Joins the sides of faces to shells. A cavity belongs to the shell of its cell that is around it; one that is there
/// because of rounding to the lattice, thinner than kTieDistance, to the neighbour with the largest common face.
///
/// Errors: Cancelled.
Result<SolidShells> solidShells(const SolidFaces& faces, std::span<const Vec3> points, const TaskContext& task = {});

}  // namespace rubble
