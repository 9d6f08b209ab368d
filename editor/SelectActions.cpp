#include "editor/SelectActions.h"

#include "editor/Action.h"
#include "editor/MainWindow.h"
#include "editor/Program.h"
#include "editor/SceneView.h"
#include "editor/SelectDialogs.h"
#include "editor/Views.h"
#include "editor/canvas/PatternCanvas.h"
#include "editor/document/CellChoice.h"
#include "editor/document/FragmentHiding.h"
#include "editor/document/FragmentSeeds.h"
#include "viewport/ViewportWidget.h"

#include <QKeyEvent>
#include <QMenu>

#include <algorithm>

namespace rubble {

namespace {

/// That which is seen: of the whole, or inside a fragment.
std::shared_ptr<const BakedPattern> patternOf(Workspace& workspace) {
    return workspace.bakes().findPattern(workspace.selection().asset(), workspace.selection().inside());
}

/// What is not in a set of all that lies inside a fragment.
FragmentSet invertedInside(const FragmentPath& inside, const Bake& bake, const FragmentSet& set) {
    FragmentSet others = invertedFragments(bake, set);
    const std::vector<std::optional<SeedId>> seeds = seedsOfFragments(bake, inside);
    for (std::size_t k = 0; k < others.size(); ++k) others[k] = others[k] && seeds[k];
    return others;
}

}  // namespace

SelectActions::SelectActions(MainWindow& window)
    : QObject(&window), m_window(window), m_menu(new QMenu(tr("Sele&ct"), &window)) {
    const auto add = addingTo(*m_menu, this);
    add({"select-all", tr("&All"), tr("Choose all seeds of the asset, and so all of its pieces"),
         QKeySequence("Ctrl+A")},
        &SelectActions::chooseAll);
    add({"select-none", tr("&None"), tr("Choose nothing"), QKeySequence("Ctrl+Shift+A")}, &SelectActions::chooseNone);
    add({"select-invert", tr("&Invert"), tr("Choose what is not chosen, and let go of what is"),
         QKeySequence("Ctrl+Shift+I")},
        &SelectActions::invert);
    m_menu->addSeparator();
    addKin();
    m_menu->addSeparator();
    addFigures();
    m_menu->addSeparator();
    addHiding();
    window.views().canvas().installEventFilter(this);
    window.views().scene().viewport().installEventFilter(this);
    Workspace& workspace = window.workspace();
    for (const auto signal : {&Selection::seedsChanged, &Selection::hiddenChanged}) {
        connect(&workspace.selection(), signal, this, &SelectActions::update);
    }
    connect(&workspace.selection(), &Selection::subjectChanged, this, &SelectActions::update);
    connect(&workspace.selection(), &Selection::assetChanged, this, &SelectActions::takeBake);
    connect(&workspace.bakes(), &Bakes::changed, this, &SelectActions::takeBake);
    takeBake();
}

void SelectActions::addKin() {
    const auto add = addingTo(*m_menu, this);
    m_forChosen = {add({"select-neighbours", tr("Nei&ghbours"), tr("Choose, too, what touches the chosen pieces"),
                        QKeySequence("Ctrl+G")},
                       &SelectActions::chooseNeighbours),
                   add({"select-siblings", tr("&Siblings"),
                        tr("Choose all pieces of what the chosen ones are pieces of"), QKeySequence("Ctrl+Shift+G")},
                       &SelectActions::chooseSiblings),
                   addInViews({"select-parents", tr("&Parents"), tr("Choose what the chosen pieces are pieces of"),
                               QKeySequence("[")},
                              &SelectActions::chooseParents),
                   addInViews({"select-children", tr("&Children"), tr("Choose what the chosen pieces are broken into"),
                               QKeySequence("]")},
                              &SelectActions::chooseChildren)};
    m_levels = m_menu->addMenu(tr("&Level"));
}

void SelectActions::addFigures() {
    const auto add = addingTo(*m_menu, this);
    m_forBake = {add({"select-volume", tr("By &Volume…"), tr("Choose the pieces with a volume in a range")},
                     &SelectActions::chooseVolumes),
                 add({"select-random", tr("At &Random…"), tr("Choose a share of all pieces at random")},
                     &SelectActions::chooseRandomly)};
}

void SelectActions::addHiding() {
    QAction* isolate = addInViews(
        {"isolate", tr("Hide &Other Pieces"),
         tr("Hide all but the chosen pieces in canvas and 3D view; nothing of it is saved"), QKeySequence("Shift+H")},
        &SelectActions::isolate);
    isolate->setShortcuts({QKeySequence("Shift+H"), QKeySequence("/")});
    m_forHiding = {
        addInViews({"hide", tr("&Hide Pieces"),
                    tr("Hide the chosen pieces in canvas and 3D view; nothing of it is saved"), QKeySequence("H")},
                   &SelectActions::hide),
        isolate};
    m_showAll = addInViews({"show", tr("Sho&w All Pieces"), tr("Show all hidden pieces again"), QKeySequence("Alt+H")},
                           &SelectActions::showAll);
}

/// An action whose key counts where canvas or 3D view have the focus.
QAction* SelectActions::addInViews(const ActionLook& look, Slot slot) {
    QAction* action = makeAction(this, look);
    connect(action, &QAction::triggered, this, slot);
    m_menu->addAction(action);
    m_window.views().keyInViews(*action);
    return action;
}

/// Alt+H would open the Help menu. In the 3D view, hidden instances are shown by it, too.
bool SelectActions::eventFilter(QObject* watched, QEvent* event) {
    const bool isOverride = event->type() == QEvent::ShortcutOverride;
    if (!isOverride && event->type() != QEvent::KeyPress) return QObject::eventFilter(watched, event);
    const QKeySequence key(static_cast<QKeyEvent*>(event)->keyCombination());
    if (key != m_showAll->shortcut() || m_window.workspace().play().isOn()) return false;
    event->accept();
    if (!isOverride) m_showAll->trigger();
    return watched == &m_window.views().canvas();
}

std::shared_ptr<const Bake> SelectActions::bake() const {
    const auto baked = m_window.workspace().bakes().find(m_window.workspace().selection().asset());
    return baked ? baked->bake : nullptr;
}

void SelectActions::chooseAll() {
    if (const auto pattern = patternOf(m_window.workspace()))
        m_window.workspace().selection().setSeeds(allCells(*pattern));
}

void SelectActions::chooseNone() { m_window.workspace().selection().setSeeds({}); }

/// By seeds, of which some may have no cell; by fragments where only some of a seed's are chosen.
void SelectActions::invert() {
    Selection& selection = m_window.workspace().selection();
    if (selection.choice().ids) {
        return change(
            [&](const Bake& now, const FragmentSet& set) { return invertedInside(selection.inside(), now, set); },
            tr("All pieces were chosen."));
    }
    if (const auto pattern = patternOf(m_window.workspace()))
        selection.setSeeds(otherCells(*pattern, selection.seeds()));
}

void SelectActions::chooseNeighbours() {
    Selection& selection = m_window.workspace().selection();
    if (selection.choice().ids) return change(withNeighbours, {});
    const auto pattern = patternOf(m_window.workspace());
    if (pattern) selection.setSeeds(withNeighbourCells(*pattern, selection.seeds()));
}

void SelectActions::chooseSiblings() { change(siblingsOf, tr("What is chosen has no pieces.")); }

void SelectActions::chooseParents() {
    change(parentsOf, tr("What is chosen are pieces of the whole: there is no level above."));
}

void SelectActions::chooseChildren() { change(childrenOf, tr("What is chosen is not broken again.")); }

void SelectActions::chooseVolumes() {
    const auto baked = bake();
    if (!baked) return;
    VolumeRangeDialog dialog(*baked, {m_window.program().preferences().unit}, &m_window);
    if (dialog.exec() != QDialog::Accepted) return;
    change([&](const Bake& now, const FragmentSet&) { return fragmentsOfVolume(now, dialog.least(), dialog.most()); },
           tr("No piece has such a volume."));
}

void SelectActions::chooseRandomly() {
    RandomShareDialog dialog(m_percent, m_randomSeed, &m_window);
    if (dialog.exec() != QDialog::Accepted) return;
    m_percent = dialog.percent();
    m_randomSeed = dialog.randomSeed();
    change([&](const Bake& now, const FragmentSet&) { return randomFragments(now, m_percent / 100.0, m_randomSeed); },
           tr("That share of the pieces is less than one."));
}

void SelectActions::hide() {
    if (const auto baked = bake()) hideChosen(m_window.workspace().selection(), *baked);
}

void SelectActions::isolate() {
    if (const auto baked = bake()) isolateChosen(m_window.workspace().selection(), *baked);
}

void SelectActions::showAll() { showAllFragments(m_window.workspace().selection()); }

void SelectActions::change(const Change& change, const QString& sentenceIfNone) {
    const auto baked = bake();
    if (!baked) return m_window.say(tr("The pieces are still being made."));
    Selection& selection = m_window.workspace().selection();
    const FragmentSet found = change(*baked, fragmentsOf(selection.choice(), *baked));
    if (std::ranges::find(found, true) == found.end()) return m_window.say(sentenceIfNone);
    selection.setChoice(choiceOf(found, *baked, selection.inside()));
}

void SelectActions::takeBake() {
    m_levels->clear();
    const auto baked = bake();
    for (QAction* action : m_forBake) action->setEnabled(baked != nullptr);
    m_levels->setEnabled(baked != nullptr);
    for (std::uint32_t level = 0; baked && level < levelCount(*baked); ++level) {
        const auto count = std::ranges::count(fragmentsOfLevel(*baked, level), true);
        QAction* action = m_levels->addAction(tr("Level &%1: %L2 pieces").arg(level).arg(count));
        action->setStatusTip(level == 0 ? tr("Choose the pieces of the whole")
                                        : tr("Choose the pieces of pieces of level %1").arg(level - 1));
        connect(action, &QAction::triggered, this, [this, level] {
            change([level](const Bake& now, const FragmentSet&) { return fragmentsOfLevel(now, level); },
                   tr("There is no such level any more."));
        });
    }
    update();
}

void SelectActions::update() {
    const Selection& selection = m_window.workspace().selection();
    const bool isAny = !selection.choice().isEmpty();
    for (QAction* action : m_forChosen) action->setEnabled(isAny);
    for (QAction* action : m_forHiding) action->setEnabled(isAny && selection.subject() != Part::Instance);
    m_showAll->setEnabled(!selection.hidden().isEmpty());
}

}  // namespace rubble
