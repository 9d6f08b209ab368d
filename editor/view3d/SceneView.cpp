#include "editor/view3d/SceneView.h"

#include "core/asset/placement/InstancePlacement.h"
#include "core/base/OutOfMemory.h"
#include "editor/view3d/ExplodeSlider.h"
#include "editor/view3d/LightMenu.h"
#include "editor/view3d/PlayView.h"
#include "editor/view3d/SceneLegend.h"
#include "editor/view3d/ScenePicker.h"
#include "editor/view3d/TimelinePanel.h"
#include "editor/view3d/tools/ActionKeys.h"
#include "editor/view3d/tools/BondPaintTool.h"
#include "editor/view3d/tools/PlacementTool.h"
#include "editor/view3d/tools/SurfaceMeasureTool.h"
#include "editor/view3d/tools/TransformTool.h"
#include "editor/widgets/AccessibleRole.h"
#include "editor/widgets/Action.h"
#include "editor/widgets/ComboBox.h"
#include "editor/workspace/SkyFile.h"
#include "editor/workspace/ViewportStyle.h"
#include "viewport/scene/JointLines.h"
#include "viewport/widget/ViewportWidget.h"

#include <QComboBox>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <array>

namespace rubble {

namespace {

constexpr QSize kBarIcon{18, 18};
enum Scope { kWholeScene, kActiveAsset };  // the items of the box

struct ColouringItem {
    SceneColouring colouring;
    const char* text;
};
constexpr std::array kColourings{
    ColouringItem{SceneColouring::Material, QT_TRANSLATE_NOOP("rubble::SceneView", "Material")},
    ColouringItem{SceneColouring::Fragment, QT_TRANSLATE_NOOP("rubble::SceneView", "Fragment")},
    ColouringItem{SceneColouring::Level, QT_TRANSLATE_NOOP("rubble::SceneView", "Level")},
    ColouringItem{SceneColouring::Volume, QT_TRANSLATE_NOOP("rubble::SceneView", "Volume")},
    ColouringItem{SceneColouring::Mass, QT_TRANSLATE_NOOP("rubble::SceneView", "Mass")},
    ColouringItem{SceneColouring::Aspect, QT_TRANSLATE_NOOP("rubble::SceneView", "Aspect")},
    ColouringItem{SceneColouring::Threshold, QT_TRANSLATE_NOOP("rubble::SceneView", "Threshold")},
    ColouringItem{SceneColouring::BondStrength, QT_TRANSLATE_NOOP("rubble::SceneView", "Strength")},
    ColouringItem{SceneColouring::Cluster, QT_TRANSLATE_NOOP("rubble::SceneView", "Cluster")}};
constexpr double kInstanceMargin = 0.25;  // of its size, on each side
constexpr double kFragmentMargin = 1.5;   // of its size, on each side

}  // namespace

SceneView::SceneView(Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      m_workspace(workspace),
      m_viewport(new ViewportWidget),
      m_transformTool(new TransformTool(workspace, *m_viewport)),
      m_placementTool(new PlacementTool(workspace, *m_viewport)),
      m_legend(new SceneLegend(m_viewport)),
      m_playView(new PlayView(workspace.play(), *m_viewport)),
      m_measureTool(new SurfaceMeasureTool(*m_viewport)),
      m_bondPaintTool(new BondPaintTool(workspace, *m_viewport)),
      m_lightMenu(new LightMenu(this)),
      m_skyFile(new SkyFile(this)),
      m_precedingKeys(new ActionKeys(m_viewport)),
      m_picker(new ScenePicker(workspace, *m_viewport)),
      m_timeline(new TimelinePanel(workspace.play())) {
    setFocusProxy(m_viewport);
    setAccessibleRole(*m_viewport, QAccessible::Canvas);
    m_viewport->setTools(
        {m_measureTool, &m_playView->tool(), m_placementTool, m_bondPaintTool, m_transformTool, m_precedingKeys});
    m_viewport->setOverlayItems(
        {m_transformTool, m_placementTool, m_legend, &m_playView->hud(), m_measureTool, m_bondPaintTool});
    addViews();
    addSeparator();
    addToggles();
    addAction(m_lightMenu->menuAction());
    connect(m_lightMenu, &LightMenu::lightSelected, this, &SceneView::lightSelected);
    connect(m_lightMenu, &LightMenu::fileRequested, this, &SceneView::skyFileRequested);
    connect(m_skyFile, &SkyFile::lightChanged, this, &SceneView::updateSky);
    connect(m_skyFile, &SkyFile::failed, this, &SceneView::failed);
    addSeparator();
    addMeasure();
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    QWidget* bar = makeBar();
    rows->addWidget(bar);
    connect(m_viewport, &ViewportWidget::presentingChanged, bar, &QWidget::setHidden);
    connect(m_viewport, &ViewportWidget::presentingChanged, this, &SceneView::updateTimeline);
    connect(m_viewport, &ViewportWidget::overlaysChanged, &workspace.play(), &PlayController::setOverlaysShown);
    rows->addWidget(m_viewport, 1);
    rows->addWidget(m_timeline);
    m_timeline->hide();
    connect(&workspace.play(), &PlayController::stateChanged, this, &SceneView::updatePlayState);
    m_timer.setSingleShot(true);
    m_timer.setInterval(0);
    connect(&m_timer, &QTimer::timeout, this, &SceneView::refreshScene);
    connect(&workspace.document(), &Document::changed, this, &SceneView::invalidate);
    connect(&workspace.bakes(), &Bakes::changed, this, &SceneView::invalidate);
    for (const auto signal : {&Selection::seedsChanged, &Selection::hiddenChanged, &Selection::instancesChanged}) {
        connect(&workspace.selection(), signal, this, &SceneView::invalidate);
    }
    connect(&workspace.selection(), &Selection::assetChanged, this, &SceneView::invalidate);
    connect(&workspace.selection(), &Selection::mortarChanged, this, &SceneView::invalidate);
    connect(&workspace.selection(), &Selection::subjectChanged, this, &SceneView::invalidate);
    connect(&workspace.mortars(), &MortarWatch::changed, this, &SceneView::invalidate);
    followPalette(*m_viewport);
    invalidate();
}

/// Updates the scene first: it may not have been drawn yet.
void SceneView::frameAll() {
    refreshScene();
    m_viewport->frameAll();
}

void SceneView::showWholeScene() { m_scope->setCurrentIndex(kWholeScene); }

void SceneView::frameSelected() {
    showWholeScene();
    refreshScene();
    m_viewport->frameSelected();
}

void SceneView::frameInstances(std::span<const Id> instances) {
    refreshScene();
    const Box3 added = boundsOf(m_workspace.project(), instances);
    if (added.isEmpty()) return frameAll();
    const Vec3 around = kInstanceMargin * (added.max - added.min);
    m_viewport->frame({added.min - around, added.max + around});
}

void SceneView::frameFragments() {
    refreshScene();
    const Box3 selected = boundsOf(m_viewport->scene(), kSelected);
    if (selected.isEmpty()) return;
    const Vec3 around = kFragmentMargin * (selected.max - selected.min);
    const Box3 all = boundsOf(m_viewport->scene());  // there is no context beyond
    m_viewport->frame({glm::max(selected.min - around, all.min), glm::min(selected.max + around, all.max)});
}

void SceneView::setEditable(bool isEditable) {
    m_isEditable = isEditable;
    updateEditing();
}

void SceneView::updateEditing() {
    m_transformTool->setOn(isEditable());
    m_placementTool->setOn(isEditable());
}

void SceneView::applyPreferences(const Preferences& preferences) {
    rubble::applyPreferences(*m_viewport, preferences);
    m_lightMenu->setLight(preferences.sky, preferences.skyFile, preferences.exposure, preferences.recentSkyFiles);
    m_skyFile->setPath(preferences.skyFile);
    const Units units{preferences.unit};
    m_transformTool->setUnits(units);
    m_placementTool->setUnits(units);
    m_measureTool->setUnits(units);
    m_legend->setUnits(units);
    m_playView->tool().setUnits(units);
    m_playView->setStatisticsShown(preferences.hasStatistics);
}

void SceneView::updateSky() {
    RenderSettings settings = m_viewport->settings();
    settings.skyFile = m_skyFile->light();
    m_viewport->setSettings(settings);
}

void SceneView::setPrecedingActions(const QList<QAction*>& actions) { m_precedingKeys->setActions(actions); }

/// Actions for the viewport's own keys, so that menus and the search list them. The keys are part of their texts, not
/// shortcuts.
void SceneView::addViews() {
    const auto add = [this](const ActionDefinition& definition, const std::function<void()>& act) {
        QAction* action = makeAction(this, definition);
        connect(action, &QAction::triggered, this, act);
        addAction(action);
    };
    add({"view-frame", tr("&Frame Selected\tF"), tr("Frame the selection; F in the 3D view")},
        [this] { m_viewport->frameSelected(); });
    add({"view-home", tr("Frame &All\tHome"), tr("Frame everything; Home in the 3D view")},
        [this] { m_viewport->frameAll(); });
    add({"view-front", tr("F&ront\t1"), tr("Look from the front; 1 in the 3D view")},
        [this] { m_viewport->alignTo(StandardView::Front); });
    add({"view-right", tr("R&ight\t3"), tr("Look from the right; 3 in the 3D view")},
        [this] { m_viewport->alignTo(StandardView::Right); });
    add({"view-top", tr("&Top\t7"), tr("Look from above; 7 in the 3D view")},
        [this] { m_viewport->alignTo(StandardView::Top); });
    add({"view-iso", tr("Isom&etric"), tr("Look from the front, right and top")},
        [this] { m_viewport->alignTo(StandardView::Isometric); });
    add({"view-orthographic", tr("&Orthographic\t5"), tr("Toggle perspective; 5 in the 3D view")}, [this] {
        const bool isParallel = m_viewport->camera().projection == Projection::Orthographic;
        m_viewport->setProjection(isParallel ? Projection::Perspective : Projection::Orthographic);
    });
}

void SceneView::addToggle(const ActionDefinition& definition, bool isOn, const std::function<void(bool)>& apply) {
    QAction* action = makeAction(this, definition);
    action->setCheckable(true);
    action->setChecked(isOn);
    connect(action, &QAction::toggled, this, apply);
    addAction(action);
}

void SceneView::addToggles() {
    const auto set = [this](auto RenderSettings::*setting, auto value) {
        RenderSettings settings = m_viewport->settings();
        settings.*setting = value;
        m_viewport->setSettings(settings);
    };
    addToggle({"view-wireframe", tr("&Wireframe"), tr("Show edges only")}, false,
              [set](bool isOn) { set(&RenderSettings::shading, isOn ? Shading::Wireframe : Shading::Faces); });
    addToggle({"view-hulls", tr("&Hulls"), tr("Show the convex hulls used for collision")}, false, [this](bool isOn) {
        m_options.hasHulls = isOn;
        invalidate();
    });
    addToggle({"view-bonds", tr("&Bonds"), tr("Show the bonds between fragments, wider for larger contact areas")},
              false, [this](bool isOn) {
                  m_options.hasBonds = isOn;
                  invalidate();
              });
    addToggle({"view-grid", tr("Ground &Grid"), tr("Show a grid on the ground")}, true,
              [set](bool isOn) { set(&RenderSettings::hasGrid, isOn); });
    addToggle({"view-shadows", tr("&Shadows"), tr("Show shadows")}, true,
              [set](bool isOn) { set(&RenderSettings::hasShadows, isOn); });
    addToggle({"view-overlays", tr("O&verlays"),
               tr("Show what is drawn over the scene: texts, handles, outlines, axes"), QKeySequence("Alt+Shift+Z")},
              true, [this](bool isOn) { m_viewport->setOverlaysOn(isOn); });
}

void SceneView::addMeasure() {
    QAction* action = makeAction(
        this, {"view-measure", tr("&Measure"), tr("Measure the distance between two points"), QKeySequence("M")});
    m_measureAction = action;
    action->setShortcutContext(Qt::WidgetShortcut);
    action->setCheckable(true);
    connect(action, &QAction::toggled, m_measureTool, &SurfaceMeasureTool::setOn);
    connect(m_measureTool, &SurfaceMeasureTool::onChanged, action, &QAction::setChecked);
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
    bar->addWidget(makeViewMenu());
    bar->addAction(m_measureAction);
    m_scope = comboBox({tr("Scene"), tr("Asset")}, tr("Show all instances, or the active asset by itself"));
    m_scope->setObjectName("scope");
    m_scope->setAccessibleName(tr("Scope"));
    connect(m_scope, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_isAssetOnly = index == kActiveAsset;
        m_picker->setAssetOnly(m_isAssetOnly);
        updateEditing();
        frameAll();
    });
    QStringList colourings;
    for (const ColouringItem& item : kColourings) colourings << tr(item.text);
    auto* colouring = comboBox(colourings, tr("Colour the fragments by this property"));
    colouring->setObjectName("colouring");
    colouring->setAccessibleName(tr("Colouring"));
    connect(colouring, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_options.colouring = kColourings[static_cast<std::size_t>(index)].colouring;
        invalidate();
    });
    auto* explode = new ExplodeSlider;
    connect(explode, &ExplodeSlider::factorChanged, this, [this](double factor) {
        m_options.explodeFactor = factor;
        invalidate();
    });
    m_editControls = {m_scope, colouring, explode};
    for (QWidget* control : m_editControls) bar->addWidget(control);
    return bar;
}

/// A menu button with all actions of the view.
QWidget* SceneView::makeViewMenu() {
    auto* button = new QToolButton;
    auto* menu = new QMenu(button);
    menu->setToolTipsVisible(true);
    menu->addActions(actions());
    button->setObjectName("view-menu");
    button->setText(tr("View"));
    button->setToolTip(tr("Standard views and display options"));
    button->setStatusTip(button->toolTip());
    button->setPopupMode(QToolButton::InstantPopup);
    button->setMenu(menu);
    return button;
}

/// In play the session is shown instead of the document.
void SceneView::updatePlayState() {
    const bool isOn = m_workspace.play().isInPlay();
    updateTimeline();
    m_measureTool->setOn(false);
    for (QWidget* control : m_editControls) control->setEnabled(!isOn);
    setEditable(!isOn);
    invalidate();
}

/// Presenting shows the scene alone.
void SceneView::updateTimeline() {
    m_timeline->setVisible(m_workspace.play().isInPlay() && !m_viewport->isPresenting());
}

/// The joints of the mortar that the inspector shows.
std::span<const MortarJoint> SceneView::shownJoints() const {
    const Selection& selection = m_workspace.selection();
    if (m_isAssetOnly || selection.subject() != Part::Scene) return {};
    const JoinedMortar* joined = m_workspace.mortars().find(selection.mortar());
    return joined ? std::span<const MortarJoint>(joined->joints) : std::span<const MortarJoint>();
}

void SceneView::refreshScene() {
    m_timer.stop();
    if (m_workspace.play().frame()) return m_legend->setContent({});
    m_options.asset = m_isAssetOnly ? m_workspace.selection().asset() : 0;
    m_options.marks = m_picker->marks();
    const Status shown = orOutOfMemory("drawing the fragments", [this]() -> Status {
        const auto scene = std::make_shared<RenderScene>(
            m_builder.sceneOf(m_workspace.project(), m_workspace.bakes().assetBakes(), m_options));
        addJointLines(*scene, shownJoints());
        m_viewport->setScene(scene);
        return success();
    });
    if (!shown) {
        m_viewport->setScene(std::make_shared<const RenderScene>());
        m_builder = {};  // what it keeps of the assets
        emit failed(QString::fromStdString(shown.error().message));
    }
    m_legend->setContent({m_options.colouring, m_viewport->scene().colourRange, m_viewport->scene().largestBondArea});
}

}  // namespace rubble

#include "moc_SceneView.cpp"
