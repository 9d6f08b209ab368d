#include "editor/canvas/tools/CanvasTool.h"

#include "editor/canvas/painting/GridPainting.h"
#include "editor/commands/AssetPatterns.h"
#include "editor/document/EnteredFragment.h"
#include "editor/document/ShownText.h"

#include <QScopedValueRollback>

#include <utility>

namespace rubble {

namespace {

constexpr double kNudge = 1.0;        // pixels
constexpr double kLargeNudge = 10.0;  // with Shift

std::optional<Vec2> directionOf(int key) {
    switch (key) {
        case Qt::Key_Left: return Vec2(-1.0, 0.0);
        case Qt::Key_Right: return Vec2(1.0, 0.0);
        case Qt::Key_Up: return Vec2(0.0, 1.0);
        case Qt::Key_Down: return Vec2(0.0, -1.0);
        default: return std::nullopt;
    }
}

}  // namespace

Pattern& CanvasState::patternIn(Asset& copy) const { return ownPattern(copy, selection.enteredFragment()); }

void CanvasState::refreshFragment() {
    const Asset* asset = this->asset();
    const FragmentPath& entered = selection.enteredFragment();
    fragment = nullptr;
    fragmentOffset = Vec2(0.0);
    if (isMesh()) {
        if (const auto section = bakes.findPattern(asset->id, entered)) fragment = section->asset;
    } else if (asset && !entered.empty()) {
        if (std::optional<FragmentSolid> solid = fragmentSolid(bakes, asset->id, entered)) {
            fragmentOffset = solid->offset;
            fragment = std::make_shared<const Asset>(fragmentAsAsset(*asset, entered, std::move(solid->prism)));
        }
    }
}

const Asset* CanvasState::assetInItsPlane() const {
    if (!isMesh()) return displayedAsset();
    const bool isAlongZ = pattern && pattern->baked().section && pattern->baked().section->normal().z > 0.5;
    return isAlongZ ? displayedAsset() : nullptr;
}

void CanvasState::moveSeed(Pattern& changed, SeedId seed, Vec2 position) const {
    const std::optional<SectionPlane> section = pattern ? pattern->baked().section : std::nullopt;
    if (!section) return rubble::moveSeed(changed, seed, position);
    const std::uint32_t number = pattern->find(seed);
    const double height = number == kNone ? 0.0 : pattern->seeds().heights[number];
    rubble::moveSeed(changed, seed, section->movedUp(height).inSpace(position));
}

void CanvasState::placeSeed(PatternLayer& layer, Vec2 position) const {
    const std::optional<SectionPlane> section = pattern ? pattern->baked().section : std::nullopt;
    if (section)
        rubble::placeSeed(layer, section->inSpace(position));
    else
        rubble::placeSeed(layer, position);
}

bool CanvasState::push(Edit edit) const {
    const QScopedValueRollback pushing(isPushing, true);
    return document.push(std::move(edit));
}

std::optional<FragmentPath> CanvasState::fracturedFragmentAt(Vec2 point) const {
    const std::uint32_t piece = pattern ? pattern->pieceAt(point) : kNone;
    const auto baked = bakes.find(selection.asset());
    if (piece == kNone || !asset() || !baked || !baked->bake) return std::nullopt;
    FragmentPath path = pattern->fragmentPath(piece);
    if (nearestFractured(*asset(), baked->bake.get(), path) != path) return std::nullopt;
    return path;
}

QString CanvasState::placeholder() const {
    if (!asset()) {  // without any asset, the window shows the first steps
        return document.project().assets.empty()
                   ? QString()
                   : CanvasTool::tr("No asset selected. Select one in the project tree, or add one.");
    }
    if (isMesh()) {
        const auto baked = bakes.find(selection.asset());
        return baked && baked->fault ? QString::fromStdString(baked->fault->message) : QString();
    }
    const auto shown = bakes.findPattern(selection.asset(), selection.enteredFragment());
    return shown && shown->fault ? QString::fromStdString(shown->fault->message) : QString();
}

void addFragmentNavigation(QMenu& menu, const CanvasState& state, Vec2 point) {
    const std::optional<FragmentPath> fractured = state.fracturedFragmentAt(point);
    if (!fractured && !state.isInFragment()) return;
    Selection& selection = state.selection;
    menu.addSeparator();
    if (fractured) {
        menu.addAction(CanvasTool::tr("&Enter Fragment %1").arg(nameText(*fractured)), &selection,
                       [&selection, fractured] { enterFragment(selection, *fractured); });
    }
    if (state.isInFragment()) {
        menu.addAction(CanvasTool::tr("E&xit Fragment"), &selection,
                       [&selection] { exitToFragment(selection, parentOf(selection.enteredFragment())); });
    }
}

std::optional<Vec2> nudgeStep(const QKeyEvent& event, const CanvasState& state) {
    const std::optional<Vec2> direction = directionOf(event.key());
    if (!direction) return std::nullopt;
    const bool isLarge = event.modifiers().testFlag(Qt::ShiftModifier);
    if (state.isSnapping && !isLarge) return *direction * gridStep(state.view, state.units);
    return *direction * ((isLarge ? kLargeNudge : kNudge) / state.view.scale);
}

quint64 CanvasTool::nudgeMergeKey(bool isRepeated) {
    if (!isRepeated || m_nudgeMergeKey == 0) m_nudgeMergeKey = m_state.document.newMergeKey();
    return m_nudgeMergeKey;
}

}  // namespace rubble

#include "moc_CanvasTool.cpp"
