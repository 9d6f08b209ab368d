#pragma once

#include <cstddef>

namespace rubble::bench {

// Each case prepares an input of n items and returns the milliseconds of the measured operation, the best of a few
// runs.

/// Waking n sleeping bodies one by one, and the collide() that follows.
double wakeCase(std::size_t n);

/// The bake of a prism on a regular n-gon, to compare with wholeMeshCase().
double polygonBakeCase(std::size_t n);

/// The mesh of the whole of a regular n-gon.
double wholeMeshCase(std::size_t n);

/// Finding the problems of a bake with n diagnostics on its second level.
double problemsCase(std::size_t n);

/// A session step that removes n pieces of debris.
double debrisCase(std::size_t n);

/// The impulses of a blast before a pane of 1 m² in n touching fragments.
double blastCase(std::size_t n);

/// The Voronoi cells of two seeds in a regular polygon of n corners, two of which lie on the bisector.
double weldingCase(std::size_t n);

/// The Voronoi cells of two seeds in a comb of n teeth: one cell has n pieces.
double splitCellCase(std::size_t n);

}  // namespace rubble::bench
