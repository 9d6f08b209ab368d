#include "editor/actions/PlayContextMenu.h"

#include "editor/commands/ProjectEdits.h"
#include "editor/document/ShownText.h"
#include "editor/play/PlayController.h"
#include "editor/view3d/SceneView.h"
#include "editor/views/Views.h"
#include "editor/workspace/Workspace.h"
#include "viewport/widget/ViewportWidget.h"

#include <algorithm>

namespace rubble {

PlayContextMenu::PlayContextMenu(Views& views, QAction* whatWouldFall)
    : QObject(&views.window()), m_views(views), m_whatWouldFall(whatWouldFall), m_menu(new QMenu(&views.window())) {
    m_menu->setObjectName("play-body");
    m_menu->setToolTipsVisible(true);
    connect(&views.scene().viewport(), &QWidget::customContextMenuRequested, this, &PlayContextMenu::open);
}

void PlayContextMenu::open(const QPoint& point) {
    ViewportWidget& viewport = m_views.scene().viewport();
    if (!m_views.workspace().play().isInPlay() || viewport.isPresenting()) return;
    const std::optional<PickId> pick = viewport.pickAt(point);
    const Instance* instance = pick ? findInstance(m_views.workspace().project(), pick->instance) : nullptr;
    if (instance == nullptr) return m_views.showStatus(tr("Right-click an instance, or what came off one."));
    fill(*pick, point);
    m_menu->popup(viewport.mapToGlobal(point));
}

void PlayContextMenu::fill(const PickId& pick, const QPoint& point) {
    m_menu->clear();
    PlayController& play = m_views.workspace().play();
    const Project& project = m_views.workspace().project();
    const Instance& instance = *findInstance(project, pick.instance);
    const Asset* asset = findAsset(project, instance.asset);
    const Ray ray = m_views.scene().viewport().rayAt(point);
    m_menu->addSection(menuText(nameText(instance.name)));
    const auto addRemoval = [&](const QString& text, const QString& tip, RemovalExtent removal) {
        QAction* action = m_menu->addAction(text, this, [&play, ray, removal] { play.removeAlong(removal, ray); });
        action->setToolTip(tip);
    };
    addRemoval(tr("&Remove"), tr("Take it away, without any force; the next run has it again"), RemovalExtent::Body);
    if (asset != nullptr && asset->breakAs == BreakAs::Bonded)
        addRemoval(tr("Remove &Fragment"), tr("Take the fragment away, and see what it held"), RemovalExtent::Fragment);
    m_menu->addAction(m_whatWouldFall);
    m_menu->addAction(tr("Fra&me"), this, [this, pick] { frame(pick); });
    QAction* unbreakable = m_menu->addAction(tr("&Never Breaks"));
    unbreakable->setCheckable(true);
    unbreakable->setChecked(instance.isUnbreakable);
    unbreakable->setToolTip(tr("Keep this instance from breaking, whatever hits it"));
    connect(unbreakable, &QAction::triggered, this, [this, id = instance.id](bool isOn) { setUnbreakable(id, isOn); });
}

/// Frames the body that is picked, where it is by now.
void PlayContextMenu::frame(const PickId& pick) {
    const std::optional<PlayFrame>& shown = m_views.workspace().play().frame();
    if (!shown || !shown->scene) return;
    const std::vector<PickId>& picks = shown->scene->picks;
    const auto found = std::ranges::find(picks, pick);
    if (found == picks.end()) return;
    const Box3 box = boundsOfBody(*shown->scene, static_cast<std::uint32_t>(found - picks.begin()));
    if (box.min.x <= box.max.x) m_views.scene().viewport().frame(box);
}

void PlayContextMenu::setUnbreakable(Id instance, bool isUnbreakable) {
    const Instance* found = findInstance(m_views.workspace().project(), instance);
    if (found == nullptr) return;
    Instance changed = *found;
    changed.isUnbreakable = isUnbreakable;
    m_views.workspace().document().push(modify(tr("Set Never Breaks"), std::move(changed)));
}

}  // namespace rubble

#include "moc_PlayContextMenu.cpp"
