#pragma once

#include "editor/canvas/tools/CanvasTool.h"

#include <vector>

namespace rubble {

/// Whether the fragment of a piece of the shown pattern is selected.
bool isPieceSelected(const CanvasState& state, std::uint32_t piece);

/// The pieces of the shown pattern whose fragments are selected, ascending. O(pieces).
std::vector<std::uint32_t> selectedPieces(const CanvasState& state);

/// Selects the fragments of some pieces of the shown pattern and nothing else, or adds them to the selection.
void selectPieces(const CanvasState& state, const std::vector<std::uint32_t>& pieces, bool isAdding = false);

/// Selects the fragment of a piece if it was not selected, or deselects it; others keep their state.
void togglePiece(const CanvasState& state, std::uint32_t piece);

}  // namespace rubble
