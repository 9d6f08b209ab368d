#include "editor/panels/inspector/Inspector.h"

#include "editor/panels/inspector/AssetPage.h"
#include "editor/panels/inspector/InstancePage.h"
#include "editor/panels/inspector/MaterialPage.h"
#include "editor/panels/inspector/ScenePage.h"
#include "editor/widgets/Section.h"
#include "editor/widgets/TypedFields.h"

#include <QStackedWidget>
#include <QVBoxLayout>

namespace rubble {

Inspector::Inspector(Document& document, Selection& selection, const Bakes& bakes, const MortarWatch& joints,
                     QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_asset(new AssetPage(document, selection, bakes)),
      m_material(new MaterialPage(document, selection)),
      m_instance(new InstancePage(document, selection)),
      m_scene(new ScenePage(document, selection, joints)),
      m_pages(new QStackedWidget(this)) {
    for (QWidget* page : {static_cast<QWidget*>(m_asset), static_cast<QWidget*>(m_material),
                          static_cast<QWidget*>(m_instance), static_cast<QWidget*>(m_scene)}) {
        m_pages->addWidget(verticalScrollArea(page));
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_pages);
    setUnits({});
    connect(m_asset, &AssetPage::refused, this, &Inspector::refused);
    connect(m_material, &MaterialPage::refused, this, &Inspector::refused);
    connect(m_instance, &InstancePage::refused, this, &Inspector::refused);
    connect(m_scene, &ScenePage::refused, this, &Inspector::refused);
    connect(&document, &Document::changed, this, &Inspector::refresh);
    connect(&selection, &Selection::subjectChanged, this, &Inspector::showPage);
    connect(&selection, &Selection::assetChanged, this, &Inspector::showSubject);
    connect(&selection, &Selection::enteredFragmentChanged, this, &Inspector::showSubject);
    connect(&selection, &Selection::materialChanged, this, &Inspector::showSubject);
    connect(&selection, &Selection::instancesChanged, this, &Inspector::showSubject);
    showPage();
}

QStringList Inspector::collapsedSections() const {
    QStringList names;
    for (const Section* section : findChildren<Section*>()) {
        if (section->isCollapsed()) names.append(section->objectName());
    }
    return names;
}

void Inspector::setCollapsedSections(const QStringList& names) {
    for (Section* section : findChildren<Section*>()) section->setCollapsed(names.contains(section->objectName()));
}

QWidget& Inspector::page() { return *static_cast<QScrollArea*>(m_pages->currentWidget())->widget(); }

QWidget& Inspector::pageOf(Part subject) {
    switch (subject) {
        case Part::Asset: return *m_asset;
        case Part::Material: return *m_material;
        case Part::Instance: return *m_instance;
        default: return *m_scene;
    }
}

void Inspector::showPage() {
    for (auto* area : m_pages->findChildren<QScrollArea*>(Qt::FindDirectChildrenOnly)) {
        if (area->widget() == &pageOf(m_selection.subject())) m_pages->setCurrentWidget(area);
    }
    showSubject();
}

/// Shows what is selected now; texts that were typed for another subject are discarded.
void Inspector::showSubject() {
    discardTyping(*this);
    refresh();
}

/// Refreshes the visible page only; the others are refreshed when they are shown.
void Inspector::refresh() {
    const QWidget* shown = &page();
    if (shown == m_asset) m_asset->refresh();
    if (shown == m_material) m_material->refresh();
    if (shown == m_instance) m_instance->refresh();
    if (shown == m_scene) m_scene->refresh();
}

void Inspector::setMaterialActions(QAction* library, QAction* save) {
    m_material->setActions({library, save});
    m_asset->setLibraryAction(library);
}

void Inspector::setUnits(const Units& units) {
    m_asset->setUnits(units);
    m_material->setUnits(units);
    m_instance->setUnits(units);
    m_scene->setUnits(units);
    refresh();
}

}  // namespace rubble

#include "moc_Inspector.cpp"
