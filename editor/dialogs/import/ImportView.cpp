#include "editor/dialogs/import/ImportView.h"

#include "editor/workspace/ViewportStyle.h"
#include "viewport/scene/ProblemCamera.h"
#include "viewport/widget/ViewportWidget.h"

#include <QLabel>
#include <QVBoxLayout>

namespace rubble {
namespace {

constexpr std::size_t kMaxShadowedTriangles = 200'000;  // shadows draw each triangle dozens of times

}  // namespace

ImportView::ImportView(const Preferences& preferences, QWidget* parent)
    : QWidget(parent), m_viewport(new ViewportWidget), m_legend(new QLabel) {
    applyPreferences(*m_viewport, preferences);
    followPalette(*m_viewport);
    m_viewport->setMinimumSize(360, 260);
    m_legend->setWordWrap(true);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(m_viewport, 1);
    rows->addWidget(m_legend);
}

void ImportView::setModel(SourceModel model) {
    m_model = std::move(model);
    RenderSettings settings = m_viewport->settings();
    settings.hasShadows = m_model.geometry->indices.size() / 3 <= kMaxShadowedTriangles;
    m_viewport->setSettings(settings);
    m_problems.clear();
    setAsset(nullptr);
    m_viewport->frameAll();
}

void ImportView::setProblems(std::vector<MeshProblem> problems) { m_problems = std::move(problems); }

void ImportView::setAsset(const ImportedAsset* imported) {
    ImportOverlay overlay{.problems = m_problems};
    if (imported != nullptr && imported->prism) overlay.prism = &*imported->prism;
    if (imported != nullptr && imported->solid) overlay.solid = &*imported->solid;
    m_viewport->setScene(std::make_shared<const RenderScene>(importScene(m_model, overlay)));
    QString legend = tr("Grey: mesh.");
    if (overlay.prism != nullptr) legend += ' ' + tr("Blue-green: prism of the selected row. Orange: its axis.");
    if (overlay.solid != nullptr) legend += ' ' + tr("Blue-green: box around the selected mesh.");
    if (imported == nullptr && m_problems.empty()) legend += ' ' + tr("No prism fits it.");
    if (!m_problems.empty()) legend += ' ' + tr("Red: where it cannot be cut.");
    m_legend->setText(legend);
}

void ImportView::frameProblem(std::size_t index) {
    const MeshProblem& problem = m_problems[index];
    m_viewport->frameFrom(facing(problem, m_model, m_viewport->camera()), surroundingsOf(problem, m_model));
}

}  // namespace rubble

#include "moc_ImportView.cpp"
