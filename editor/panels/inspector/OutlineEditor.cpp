#include "editor/panels/inspector/OutlineEditor.h"

#include "editor/panels/inspector/NumberDelegate.h"
#include "editor/widgets/Buttons.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableView>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kMaxVisibleRows = 8;
constexpr int kRowPadding = 8;  // pixels

}  // namespace

OutlineEditor::OutlineEditor(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_model(new OutlineModel(document, this)),
      m_rings(new QComboBox(this)),
      m_view(new QTableView(this)) {
    m_view->setModel(m_model);
    m_view->setItemDelegate(
        new NumberDelegate([this](NumberField& field, int) { field.setFormat(m_model->units().lengths()); }, m_view));
    m_view->setAccessibleName(tr("Outline Points"));
    m_view->setToolTip(tr("Edit a coordinate to move a point"));
    m_view->setTabKeyNavigation(false);
    m_view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                            QAbstractItemView::AnyKeyPressed);
    m_view->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_view->horizontalHeader()->setHighlightSections(false);
    m_view->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_view->verticalHeader()->setDefaultSectionSize(m_view->fontMetrics().height() + kRowPadding);
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
    connect(m_model, &OutlineModel::modelReset, this, &OutlineEditor::fitHeight);
    connect(m_model, &OutlineModel::refused, this, [this](const QString& sentence) {
        const QRect place = m_view->visualRect(m_view->currentIndex());
        QToolTip::showText(m_view->viewport()->mapToGlobal(place.bottomLeft()), sentence, m_view);
        emit refused(sentence);
    });
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
    connect(removePoint, &QToolButton::clicked, this, [this] {
        std::vector<int> rows;
        for (const QModelIndex& index : m_view->selectionModel()->selectedIndexes()) rows.push_back(index.row());
        std::ranges::sort(rows);
        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
        m_model->removePoints(std::move(rows));
    });
    connect(addHole, &QToolButton::clicked, this, [this] {
        if (!m_model->addHole()) return;
        m_rings->setCurrentIndex(m_rings->count() - 1);
        emit m_rings->activated(m_rings->currentIndex());
    });
    connect(m_removeHole, &QToolButton::clicked, m_model, &OutlineModel::removeHole);
    return row;
}

/// Fits the height to the rows, up to kMaxVisibleRows.
void OutlineEditor::fitHeight() {
    const int rows = std::clamp(m_model->rowCount(), 3, kMaxVisibleRows);
    const int rowHeight = m_view->verticalHeader()->defaultSectionSize();
    m_view->setFixedHeight(rows * rowHeight + m_view->horizontalHeader()->sizeHint().height() +
                           2 * m_view->frameWidth());
}

void OutlineEditor::refresh(Id asset) {
    const Asset* shown = findAsset(m_document.project(), asset);
    m_model->setRing(asset, asset == m_asset ? m_model->ring() : 0);
    m_asset = asset;
    const int rings = shown ? static_cast<int>(shown->prism.outline.holes.size()) + 1 : 1;
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
