#include "editor/document/FragmentHiding.h"

namespace rubble {

namespace {

void hide(Selection& selection, const Bake& bake, const FragmentSet& set) {
    selection.setHidden(choiceOf(completed(bake, set), bake));
}

}  // namespace

void hideChosen(Selection& selection, const Bake& bake) {
    FragmentSet hidden = fragmentsOf(selection.hidden(), bake);
    const FragmentSet chosen = fragmentsOf(selection.choice(), bake);
    for (std::size_t k = 0; k < hidden.size(); ++k) hidden[k] = hidden[k] || chosen[k];
    hide(selection, bake, hidden);
    selection.setSeeds({});
}

void showChosen(Selection& selection, const Bake& bake) {
    const FragmentSet chosen = withPieces(bake, fragmentsOf(selection.choice(), bake));
    FragmentSet hidden = smallestFragments(bake);
    const FragmentSet before = fragmentsOf(selection.hidden(), bake);
    for (std::size_t k = 0; k < hidden.size(); ++k) hidden[k] = hidden[k] && before[k] && !chosen[k];
    hide(selection, bake, hidden);
}

void isolateChosen(Selection& selection, const Bake& bake) {
    if (selection.choice().isEmpty()) return;
    hide(selection, bake, invertedFragments(bake, fragmentsOf(selection.choice(), bake)));
}

void showAllFragments(Selection& selection) { selection.setHidden({}); }

}  // namespace rubble
