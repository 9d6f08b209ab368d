#include "editor/panels/inspector/OutlineEditor.h"

#include "editor/widgets/Buttons.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

namespace rubble {

namespace {

constexpr int kMinVisiblePoints = 3;
constexpr int kMaxVisiblePoints = 8;

}  // namespace

OutlineEditor::OutlineEditor(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_model(new OutlineModel(document, this)),
      m_rings(new QComboBox(this)),
      m_view(new NumberTable(
          *m_model, [this](NumberField& field, int) { field.setFormat(m_model->units().lengths()); }, this)) {
    m_view->setAccessibleName(tr("Outline Points"));
    m_view->setToolTip(tr("Edit a coordinate to move a point"));
    m_rings->setAccessibleName(tr("Ring"));
    m_rings->setToolTip(tr("Ring whose points are listed"));

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(buttonRow());
    layout->addWidget(m_view);
    connect(m_rings, &QComboBox::activated, this, [this](int row) {
        m_model->setRing(m_asset, static_cast<std::size_t>(row));
        m_removeHole->setEnabled(row > 0);
    });
    connect(m_model, &OutlineModel::modelReset, m_view,
            [this] { m_view->fitHeight(kMinVisiblePoints, kMaxVisiblePoints); });
    connect(m_model, &OutlineModel::refused, m_view, &NumberTable::showRefusal);
    connect(m_model, &OutlineModel::refused, this, &OutlineEditor::refused);
}

QWidget* OutlineEditor::buttonRow() {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_rings, 1);
    auto* addPoint = panelButton("add", tr("Add Point"), tr("Add a point after the current one"), row);
    auto* removePoint = panelButton("remove", tr("Delete Points"), tr("Delete the selected points"), row);
    auto* addHole = panelButton("hole-add", tr("Add Hole"), tr("Add a hole at the centre of the outline"), row);
    m_removeHole = panelButton("edit-delete", tr("Delete Hole"), tr("Delete this hole"), row);
    for (QToolButton* button : {addPoint, removePoint, addHole, m_removeHole}) layout->addWidget(button);
    connect(addPoint, &QToolButton::clicked, this, [this] {
        const int current = m_view->currentIndex().row();
        m_model->insertAfter(current >= 0 ? current : m_model->rowCount() - 1);
    });
    connect(removePoint, &QToolButton::clicked, this, [this] { m_model->removePoints(m_view->selectedRows()); });
    connect(addHole, &QToolButton::clicked, this, [this] {
        if (!m_model->addHole()) return;
        m_rings->setCurrentIndex(m_rings->count() - 1);
        emit m_rings->activated(m_rings->currentIndex());
    });
    connect(m_removeHole, &QToolButton::clicked, m_model, &OutlineModel::removeHole);
    return row;
}

void OutlineEditor::refresh(Id asset) {
    const Asset* shown = findAsset(m_document.project(), asset);
    if (shown && !shown->isPrism()) shown = nullptr;
    m_model->setRing(asset, asset == m_asset ? m_model->ring() : 0);
    m_asset = asset;
    const int rings = shown ? static_cast<int>(shown->prism().outline.holes.size()) + 1 : 1;
    if (m_rings->count() != rings) {
        m_rings->clear();
        m_rings->addItem(tr("Outline"));
        for (int hole = 1; hole < rings; ++hole) m_rings->addItem(tr("Hole %1").arg(hole));
    }
    m_rings->setCurrentIndex(static_cast<int>(m_model->ring()));
    m_removeHole->setEnabled(m_model->ring() > 0);
}

}  // namespace rubble

#include "moc_OutlineEditor.cpp"
