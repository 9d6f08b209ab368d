#include "editor/document/FragmentVisibility.h"

namespace rubble {

namespace {

void hide(Selection& selection, const Bake& bake, const FragmentSet& set) {
    selection.setHidden(selectionOf(completed(bake, set), bake));
}

}  // namespace

void hideSelected(Selection& selection, const Bake& bake) {
    FragmentSet hidden = fragmentsOf(selection.hidden(), bake);
    const FragmentSet selected = fragmentsOf(selection.fragments(), bake);
    for (std::size_t k = 0; k < hidden.size(); ++k) hidden[k] = hidden[k] || selected[k];
    hide(selection, bake, hidden);
    selection.setSeeds({});
}

void showSelected(Selection& selection, const Bake& bake) {
    const FragmentSet selected = withDescendants(bake, fragmentsOf(selection.fragments(), bake));
    FragmentSet hidden = leafFragments(bake);
    const FragmentSet before = fragmentsOf(selection.hidden(), bake);
    for (std::size_t k = 0; k < hidden.size(); ++k) hidden[k] = hidden[k] && before[k] && !selected[k];
    hide(selection, bake, hidden);
}

void isolateSelected(Selection& selection, const Bake& bake) {
    if (selection.fragments().isEmpty()) return;
    hide(selection, bake, invertedFragments(bake, fragmentsOf(selection.fragments(), bake)));
}

void showAllFragments(Selection& selection) { selection.setHidden({}); }

}  // namespace rubble
