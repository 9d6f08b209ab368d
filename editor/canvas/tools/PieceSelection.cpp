#include "editor/canvas/tools/PieceSelection.h"

#include "core/asset/bake/FragmentLookup.h"
#include "editor/document/CellSelection.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

namespace rubble {

namespace {

std::shared_ptr<const Bake> bakeOf(const CanvasState& state) {
    const auto baked = state.bakes.find(state.selection.asset());
    return baked ? baked->bake : nullptr;
}

/// The numbers of the pieces' fragments in a bake; nothing if it is older than the pattern and lacks some.
std::optional<std::vector<std::uint32_t>> numbersIn(const Bake& bake, const CanvasState& state,
                                                    const std::vector<std::uint32_t>& pieces) {
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t piece : pieces) {
        const std::optional<std::uint32_t> number = fragmentAt(bake, state.pattern->fragmentPath(piece));
        if (!number || *number == kNone) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

/// The selection of pieces by their names alone, without a bake.
FragmentSelection selectionByName(const CanvasState& state, const std::vector<std::uint32_t>& pieces) {
    FragmentSelection selection{.parent = state.pattern->baked().parent};
    std::map<SeedId, int> missing;  // pieces of each cell that are not selected
    for (std::uint32_t piece = 0; piece < state.pattern->partition().pieceCount(); ++piece) {
        ++missing[state.pattern->cellOf(piece)];
    }
    FragmentSelection::Ids ids;
    for (const std::uint32_t piece : pieces) {
        selection.seeds.insert(state.pattern->cellOf(piece));
        ids.insert(state.pattern->fragmentId(piece));
        --missing[state.pattern->cellOf(piece)];
    }
    const bool areWhole = std::ranges::all_of(selection.seeds, [&](SeedId cell) { return missing[cell] == 0; });
    if (!areWhole) selection.ids = std::move(ids);
    return selection;
}

}  // namespace

bool isPieceSelected(const CanvasState& state, std::uint32_t piece) {
    const FragmentSelection& selection = state.selection.fragments();
    const SeedId cell = state.pattern->cellOf(piece);
    const FragmentPath& parent = state.pattern->baked().parent;
    if (!selection.ids) return selection.contains(parent, cell, {});
    return state.selection.seeds().contains(cell) && selection.contains(parent, cell, state.pattern->fragmentId(piece));
}

std::vector<std::uint32_t> selectedPieces(const CanvasState& state) {
    std::vector<std::uint32_t> pieces;
    if (!state.pattern) return pieces;
    const std::vector<bool> isSelected = selectedPieces(state.pattern->baked(), state.selection.fragments());
    for (std::uint32_t piece = 0; piece < isSelected.size(); ++piece) {
        if (isSelected[piece]) pieces.push_back(piece);
    }
    return pieces;
}

void selectPieces(const CanvasState& state, const std::vector<std::uint32_t>& pieces, bool isAdding) {
    if (!state.pattern) return state.selection.setFragments({});
    const std::shared_ptr<const Bake> bake = bakeOf(state);
    if (const auto numbers = bake ? numbersIn(*bake, state, pieces) : std::nullopt) {
        FragmentSet set(bake->fragmentCount(), false);
        if (isAdding) set = fragmentsOf(state.selection.fragments(), *bake);
        for (const std::uint32_t number : *numbers) set[number] = true;
        return state.selection.setFragments(selectionOf(set, *bake, state.pattern->baked().parent));
    }
    std::vector<std::uint32_t> all = isAdding ? selectedPieces(state) : std::vector<std::uint32_t>{};
    std::vector<bool> isIn(state.pattern->partition().pieceCount(), false);
    for (const std::uint32_t piece : all) isIn[piece] = true;
    for (const std::uint32_t piece : pieces) {
        if (!isIn[piece]) all.push_back(piece);
        isIn[piece] = true;
    }
    state.selection.setFragments(selectionByName(state, all));
}

void togglePiece(const CanvasState& state, std::uint32_t piece) {
    if (!isPieceSelected(state, piece)) return selectPieces(state, {piece}, true);
    const std::shared_ptr<const Bake> bake = bakeOf(state);
    if (const auto number = bake ? numbersIn(*bake, state, {piece}) : std::nullopt) {
        FragmentSet set = fragmentsOf(state.selection.fragments(), *bake);
        FragmentSet deselected(set.size(), false);
        deselected[number->front()] = true;
        deselected = withDescendants(*bake, deselected);
        for (std::size_t k = 0; k < set.size(); ++k) set[k] = set[k] && !deselected[k];
        return state.selection.setFragments(selectionOf(set, *bake, state.pattern->baked().parent));
    }
    std::vector<std::uint32_t> rest = selectedPieces(state);
    std::erase(rest, piece);
    state.selection.setFragments(selectionByName(state, rest));
}

}  // namespace rubble
