#include "editor/dialogs/import/ImportView.h"

#include "editor/workspace/ViewportStyle.h"
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
    setPrism(nullptr);
    m_viewport->frameAll();
}

void ImportView::setPrism(const PrismFit* prism) {
    m_viewport->setScene(std::make_shared<const RenderScene>(importScene(m_model, prism)));
    m_legend->setText(prism != nullptr
                          ? tr("Grey: mesh. Blue-green: prism of the selected row. Orange: axis of the prism.")
                          : tr("Grey: mesh. No prism fits it."));
}

}  // namespace rubble

#include "moc_ImportView.cpp"
