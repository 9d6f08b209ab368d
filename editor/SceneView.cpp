#include "editor/SceneView.h"

#include "editor/Action.h"
#include "editor/ChoiceBox.h"
#include "editor/InstanceGizmo.h"
#include "editor/InstancePlacing.h"
#include "editor/PlayView.h"
#include "editor/SceneLegend.h"
#include "editor/TimelineBar.h"
#include "editor/ViewMeasure.h"
#include "editor/ViewportLook.h"
#include "editor/commands/InstanceEdits.h"
#include "viewport/ViewportWidget.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSlider>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kExplodedSteps = 200;    // of the slider
constexpr double kMostExploded = 2.0;  // factor at its end
constexpr QSize kBarIcon{18, 18};
constexpr int kLeastSlider = 40;         // pixels
constexpr double kAroundFragment = 1.5;  // of its size, that is shown on each side of it

}  // namespace

SceneView::SceneView(Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      m_workspace(workspace),
      m_viewport(new ViewportWidget),
      m_gizmo(new InstanceGizmo(workspace, *m_viewport)),
      m_placing(new InstancePlacing(workspace, *m_viewport, m_gizmo->overlay())),
      m_legend(new SceneLegend(m_viewport)),
      m_playView(new PlayView(workspace.play(), *m_viewport)),
      m_measure(new ViewMeasure(*m_viewport)),
      m_timeline(new TimelineBar(workspace.play())) {
    setFocusProxy(m_viewport);
    addViews();
    addSeparator();
    addToggles();
    addSeparator();
    addMeasure();
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(makeBar());
    rows->addWidget(m_viewport, 1);
    rows->addWidget(m_timeline);
    m_timeline->hide();
    connect(&workspace.play(), &PlayController::stateChanged, this, &SceneView::takePlayState);
    m_timer.setSingleShot(true);
    m_timer.setInterval(0);
    connect(&m_timer, &QTimer::timeout, this, &SceneView::update);
    connect(&workspace.document(), &Document::changed, this, &SceneView::invalidate);
    connect(&workspace.bakes(), &Bakes::changed, this, &SceneView::invalidate);
    for (const auto signal : {&Selection::seedsChanged, &Selection::hiddenChanged, &Selection::instancesChanged}) {
        connect(&workspace.selection(), signal, this, &SceneView::invalidate);
    }
    connect(&workspace.selection(), &Selection::assetChanged, this, &SceneView::invalidate);
    connect(m_viewport, &ViewportWidget::picked, this, &SceneView::pick);
    connect(m_viewport, &ViewportWidget::boxed, this, &SceneView::pickAll);
    takeTheme(*m_viewport);
    invalidate();
}

/// Of the scene as it is now, not as it was drawn last.
void SceneView::frameAll() {
    update();
    m_viewport->frameAll();
}

void SceneView::showWholeScene() { m_scope->setCurrentIndex(0); }

void SceneView::frameChosen() {
    showWholeScene();
    update();
    m_viewport->frameSelected();
}

void SceneView::frameFragments() {
    update();
    const Box3 chosen = boundsOf(m_viewport->scene(), kSelected);
    const Vec3 around = kAroundFragment * (chosen.max - chosen.min);
    if (!chosen.isEmpty()) m_viewport->frame({chosen.min - around, chosen.max + around});
}

void SceneView::setEditable(bool isEditable) {
    m_isEditable = isEditable;
    updateEditing();
}

void SceneView::updateEditing() {
    m_gizmo->setOn(isEditable());
    m_placing->setOn(isEditable());
}

void SceneView::takePreferences(const Preferences& preferences) { rubble::takePreferences(*m_viewport, preferences); }

void SceneView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) takeTheme(*m_viewport);
    QWidget::changeEvent(event);
}

/// Actions for what the viewport's own keys do, so that menu and search find them; the keys are in their texts.
void SceneView::addViews() {
    const auto add = [this](const ActionLook& look, const std::function<void()>& act) {
        QAction* action = makeAction(this, look);
        connect(action, &QAction::triggered, this, act);
        addAction(action);
    };
    add({"view-frame", tr("&Frame Selected	F"), tr("Bring what is chosen close; F in the 3D view")},
        [this] { m_viewport->frameSelected(); });
    add({"view-home", tr("Frame &All	Home"), tr("Show everything; Home in the 3D view")},
        [this] { m_viewport->frameAll(); });
    add({"view-front", tr("F&ront	1"), tr("Look from the front; 1 in the 3D view")},
        [this] { m_viewport->turnTo(StandardView::Front); });
    add({"view-right", tr("R&ight	3"), tr("Look from the right; 3 in the 3D view")},
        [this] { m_viewport->turnTo(StandardView::Right); });
    add({"view-top", tr("&Top	7"), tr("Look from above; 7 in the 3D view")},
        [this] { m_viewport->turnTo(StandardView::Top); });
    add({"view-iso", tr("I&sometric"), tr("Look from a corner")},
        [this] { m_viewport->turnTo(StandardView::Isometric); });
    add({"view-orthographic", tr("&Orthographic	5"),
         tr("Draw without perspective, or with it again; 5 in the 3D view")},
        [this] {
            const bool isParallel = m_viewport->camera().projection == Projection::Orthographic;
            m_viewport->setProjection(isParallel ? Projection::Perspective : Projection::Orthographic);
        });
}

void SceneView::addToggle(const ActionLook& look, bool isOn, const std::function<void(bool)>& take) {
    QAction* action = makeAction(this, look);
    action->setCheckable(true);
    action->setChecked(isOn);
    connect(action, &QAction::toggled, this, take);
    addAction(action);
}

void SceneView::addToggles() {
    const auto set = [this](auto RenderSettings::*setting, auto value) {
        RenderSettings settings = m_viewport->settings();
        settings.*setting = value;
        m_viewport->setSettings(settings);
    };
    addToggle({"view-wireframe", tr("&Wireframe"), tr("Draw edges only")}, false,
              [set](bool isOn) { set(&RenderSettings::shading, isOn ? Shading::Wireframe : Shading::Faces); });
    addToggle({"view-hulls", tr("&Hulls"), tr("Draw over it the convex hulls that physics will take")}, false,
              [this](bool isOn) {
                  m_options.hasHulls = isOn;
                  invalidate();
              });
    addToggle({"view-bonds", tr("&Bonds"), tr("Draw lines between pieces that touch, as wide as what they share")},
              false, [this](bool isOn) {
                  m_options.hasBonds = isOn;
                  invalidate();
              });
    addToggle({"view-grid", tr("Ground &Grid"), tr("Draw a grid on the ground")}, true,
              [set](bool isOn) { set(&RenderSettings::hasGrid, isOn); });
    addToggle({"view-shadows", tr("&Shadows"), tr("Draw shadows")}, true,
              [set](bool isOn) { set(&RenderSettings::hasShadows, isOn); });
}

void SceneView::addMeasure() {
    QAction* action = makeAction(
        this, {"view-measure", tr("&Measure"), tr("Measure between two points by two clicks"), QKeySequence("M")});
    m_measuring = action;
    action->setShortcutContext(Qt::WidgetShortcut);
    action->setCheckable(true);
    connect(action, &QAction::toggled, m_measure, &ViewMeasure::setOn);
    connect(m_measure, &ViewMeasure::onChanged, action, &QAction::setChecked);
    addAction(action);
    m_viewport->addAction(action);
}

void SceneView::addSeparator() {
    auto* separator = new QAction(this);
    separator->setSeparator(true);
    addAction(separator);
}

QWidget* SceneView::makeBar() {
    auto* bar = new QToolBar(tr("3D view"));
    bar->setIconSize(kBarIcon);
    m_scope = choiceBox({tr("Whole scene"), tr("Asset at hand")},
                        tr("Show every instance where it stands, or the asset at hand by itself"));
    m_scope->setObjectName("scope");
    m_scope->setAccessibleName(tr("What is shown"));
    connect(m_scope, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_isAssetOnly = index == 1;
        updateEditing();
        frameAll();
    });
    auto* colouring = choiceBox({tr("By material"), tr("By piece"), tr("By level"), tr("By volume"), tr("By mass"),
                                 tr("By aspect"), tr("By threshold")},
                                tr("What colours mean"));
    colouring->setObjectName("colouring");
    colouring->setAccessibleName(tr("Colouring"));
    connect(colouring, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_options.colouring = static_cast<SceneColouring>(index);
        invalidate();
    });
    m_notInPlay = {m_scope, colouring, makeExploded()};
    for (QWidget* control : m_notInPlay) bar->addWidget(control);
    bar->addWidget(makeViewMenu());
    bar->addAction(m_measuring);
    return bar;
}

/// All that the view can be told, by name, in little room.
QWidget* SceneView::makeViewMenu() {
    auto* button = new QToolButton;
    auto* menu = new QMenu(button);
    menu->setToolTipsVisible(true);
    menu->addActions(actions());
    button->setObjectName("view-menu");
    button->setText(tr("View"));
    button->setToolTip(tr("Standard views, and what is drawn: wireframe, hulls, bonds, grid, shadows"));
    button->setStatusTip(button->toolTip());
    button->setPopupMode(QToolButton::InstantPopup);
    button->setMenu(menu);
    return button;
}

QWidget* SceneView::makeExploded() {
    auto* box = new QWidget;
    auto* label = new QLabel(tr("E&xploded:"));
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setRange(0, kExplodedSteps);
    slider->setMinimumWidth(kLeastSlider);
    slider->setToolTip(tr("Move pieces apart"));
    slider->setAccessibleName(tr("Exploded"));
    slider->setObjectName("exploded");
    label->setBuddy(slider);
    connect(slider, &QSlider::valueChanged, this, [this](int value) {
        m_options.exploded = kMostExploded * value / kExplodedSteps;
        invalidate();
    });
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(4, 0, 2, 0);
    row->addWidget(label);
    row->addWidget(slider, 1);
    return box;
}

/// While it is played the scene is not the document's.
void SceneView::takePlayState() {
    const bool isOn = m_workspace.play().isOn();
    m_timeline->setVisible(isOn);
    m_measure->setOn(false);
    for (QWidget* control : m_notInPlay) control->setEnabled(!isOn);
    setEditable(!isOn);
    invalidate();
}

void SceneView::update() {
    m_timer.stop();
    if (m_workspace.play().frame()) return m_legend->setContent({});
    m_options.asset = m_isAssetOnly ? m_workspace.selection().asset() : 0;
    m_options.marks = marks();
    m_viewport->setScene(std::make_shared<const RenderScene>(
        m_builder.sceneOf(m_workspace.project(), m_workspace.bakes().assetBakes(), m_options)));
    m_legend->setContent({m_options.colouring, m_viewport->scene().colourRange, m_viewport->scene().largestBond});
}

SceneMarks SceneView::marks() const {
    const Selection& selection = m_workspace.selection();
    SceneMarks marks;
    addMarks(selection.choice(), marks.selected);
    addMarks(selection.hidden(), marks.hidden);
    for (const Instance& instance : m_workspace.project().instances) {
        const bool isChosen = selection.choice().isEmpty() && selection.instances().contains(instance.id);
        if (isChosen) marks.selected.push_back({instance.asset, instance.id, kNone});
        if (instance.isHidden) marks.hidden.push_back({instance.asset, instance.id, kNone});
    }
    return marks;
}

/// Marks for fragments of the asset at hand and their pieces, in all its instances that break as the asset itself does.
void SceneView::addMarks(const FragmentChoice& choice, std::vector<PickId>& picks) const {
    const Id asset = m_workspace.selection().asset();
    const std::shared_ptr<const Bake> bake = bakeAtHand();
    if (choice.isEmpty() || !bake) return;
    std::vector<Id> instances;
    bool areAll = true;
    for (const Instance& instance : m_workspace.project().instances) {
        if (instance.asset != asset) continue;
        instance.variant == 0 ? instances.push_back(instance.id) : void(areAll = false);
    }
    if (areAll || m_isAssetOnly) instances = {0};
    const FragmentSet marked = withPieces(*bake, fragmentsOf(choice, *bake));
    for (std::uint32_t fragment = 0; fragment < marked.size(); ++fragment) {
        if (!marked[fragment]) continue;
        for (const Id instance : instances) picks.push_back({asset, instance, fragment});
    }
}

std::shared_ptr<const Bake> SceneView::bakeAtHand() const {
    const auto baked = m_workspace.bakes().find(m_workspace.selection().asset());
    return baked ? baked->bake : nullptr;
}

void SceneView::chooseNothing() {
    m_workspace.selection().setSeeds({});
    m_workspace.selection().setInstances(m_workspace.project(), {});
}

void SceneView::chooseInstance(Id instance, bool isMore) {
    Selection& selection = m_workspace.selection();
    std::set<Id> instances;
    if (isMore) instances = selection.instances();
    if (!instances.insert(instance).second) instances.erase(instance);
    selection.setSeeds({});
    selection.setInstances(m_workspace.project(), std::move(instances));
}

void SceneView::chooseAt(QPoint point) {
    const Project& project = m_workspace.project();
    const auto hit = sceneHit(project, assetHulls(project), m_viewport->rayAt(point));
    if (!hit || hit->instance == 0 || findInstance(project, hit->instance)->isLocked) return;
    if (!m_workspace.selection().instances().contains(hit->instance)) chooseInstance(hit->instance, false);
}

bool SceneView::choosePieceAt(QPoint point) {
    const std::optional<PickId> id = m_viewport->pickAt(point);
    if (!m_isAssetOnly && !isOfChosenPieces(id)) return false;
    const std::shared_ptr<const Bake> bake = bakeAtHand();
    if (!id || !bake || id->fragment >= bake->fragmentCount()) return m_isAssetOnly;
    if (!fragmentsOf(m_workspace.selection().choice(), *bake)[id->fragment]) pick(id, {});
    return true;
}

/// Whether it lies in the instance of which pieces are chosen, not the instance itself.
bool SceneView::isOfChosenPieces(const std::optional<PickId>& id) const {
    const Selection& selection = m_workspace.selection();
    const Instance* instance = id ? findInstance(m_workspace.project(), id->instance) : nullptr;
    return instance && !instance->isLocked && instance->variant == 0 && instance->asset == selection.asset() &&
           selection.instances() == std::set<Id>{instance->id} && !selection.choice().isEmpty();
}

/// A click chooses the instance; in one that is chosen alone already, the seed of the fragment. With Ctrl or Shift one more.
/// Fragments of variants have no seeds in the pattern that the canvas shows, and locked instances are as good as not there.
void SceneView::pick(const std::optional<PickId>& id, Qt::KeyboardModifiers modifiers) {
    Selection& selection = m_workspace.selection();
    const bool isMore = modifiers.testAnyFlags(Qt::ControlModifier | Qt::ShiftModifier);
    const Instance* instance = id ? findInstance(m_workspace.project(), id->instance) : nullptr;
    if (!id || (instance && instance->isLocked)) {
        if (!isMore) chooseNothing();
        return;
    }
    if (instance && (instance->variant != 0 || selection.instances() != std::set<Id>{instance->id})) {
        return chooseInstance(instance->id, isMore);
    }
    selection.setAsset(id->asset);
    const std::shared_ptr<const Bake> bake = bakeAtHand();
    if (!bake || id->fragment >= bake->fragmentCount()) return selection.setSeeds({});
    FragmentSet chosen(bake->fragmentCount(), false);
    if (isMore) chosen = fragmentsOf(selection.choice(), *bake);
    chosen[id->fragment] = !chosen[id->fragment];
    selection.setChoice(choiceOf(chosen, *bake, selection.inside()));
}

/// Chooses the instances in a box, or the fragments where it is drawn in the asset by itself.
void SceneView::pickAll(const std::vector<PickId>& ids, Qt::KeyboardModifiers modifiers) {
    Selection& selection = m_workspace.selection();
    const bool isMore = modifiers.testAnyFlags(Qt::ControlModifier | Qt::ShiftModifier);
    if (m_isAssetOnly) return pickFragments(ids, isMore);
    std::set<Id> instances;
    if (isMore) instances = selection.instances();
    if (!isMore) chooseNothing();
    for (const PickId& id : ids) {
        const Instance* instance = findInstance(m_workspace.project(), id.instance);
        if (instance && !instance->isLocked) instances.insert(instance->id);
    }
    if (instances.empty()) return;
    selection.setSeeds({});
    selection.setInstances(m_workspace.project(), std::move(instances));
}

void SceneView::pickFragments(const std::vector<PickId>& ids, bool isMore) {
    Selection& selection = m_workspace.selection();
    const std::shared_ptr<const Bake> bake = bakeAtHand();
    if (!bake) return;
    FragmentSet chosen(bake->fragmentCount(), false);
    if (isMore) chosen = fragmentsOf(selection.choice(), *bake);
    for (const PickId& id : ids) {
        if (id.fragment < chosen.size()) chosen[id.fragment] = true;
    }
    selection.setChoice(choiceOf(chosen, *bake, selection.inside()));
}

}  // namespace rubble
