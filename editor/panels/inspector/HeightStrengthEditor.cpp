#include "editor/panels/inspector/HeightStrengthEditor.h"

#include "editor/panels/inspector/NumberDelegate.h"
#include "editor/widgets/Buttons.h"
#include "editor/widgets/ProjectRange.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kMaxVisibleStrengths = 6;
constexpr int kStrengthPadding = 8;  // pixels

}  // namespace

HeightStrengthEditor::HeightStrengthEditor(Document& document, QWidget* parent)
    : QWidget(parent), m_model(new HeightStrengthModel(document, this)), m_view(new QTableView(this)) {
    m_view->setModel(m_model);
    const auto prepare = [this](NumberField& field, int column) {
        const bool isHeight = column == HeightStrengthModel::Height;
        if (isHeight) field.setFormat(m_model->units().lengths());
        field.setRange(fieldRange(isHeight ? ProjectNumber::BondStrengthHeight : ProjectNumber::BondStrength));
    };
    m_view->setItemDelegate(new NumberDelegate(prepare, m_view));
    m_view->setAccessibleName(tr("Strength by Height"));
    m_view->setToolTip(tr("Multiply the strength of bonds at a height above the lowest point of the outline"));
    m_view->setTabKeyNavigation(false);
    m_view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                            QAbstractItemView::AnyKeyPressed);
    m_view->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_view->horizontalHeader()->setHighlightSections(false);
    m_view->verticalHeader()->hide();
    m_view->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_view->verticalHeader()->setDefaultSectionSize(m_view->fontMetrics().height() + kStrengthPadding);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(buttonRow());
    layout->addWidget(m_view);
    connect(m_model, &HeightStrengthModel::modelReset, this, &HeightStrengthEditor::fitHeight);
    connect(m_model, &HeightStrengthModel::refused, this, [this](const QString& sentence) {
        const QRect place = m_view->visualRect(m_view->currentIndex());
        QToolTip::showText(m_view->viewport()->mapToGlobal(place.bottomLeft()), sentence, m_view);
        emit refused(sentence);
    });
    fitHeight();
}

QWidget* HeightStrengthEditor::buttonRow() {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto* title = new QLabel(tr("Strength by height"));
    title->setToolTip(m_view->toolTip());
    auto* add = panelButton("add", tr("Add Height"), tr("Add a strength above the current one"), row);
    m_remove = panelButton("remove", tr("Delete Heights"), tr("Delete the selected strengths"), row);
    layout->addWidget(title, 1);
    for (QToolButton* button : {add, m_remove}) layout->addWidget(button);
    connect(add, &QToolButton::clicked, this, [this] {
        const int current = m_view->currentIndex().row();
        const int added = m_model->insertAfter(current >= 0 ? current : m_model->rowCount() - 1);
        m_model->refresh();
        if (added >= 0) m_view->setCurrentIndex(m_model->index(added, HeightStrengthModel::Factor));
    });
    connect(m_remove, &QToolButton::clicked, this, [this] {
        std::vector<int> rows;
        for (const QModelIndex& index : m_view->selectionModel()->selectedIndexes()) rows.push_back(index.row());
        m_model->removeStrengths(std::move(rows));
    });
    return row;
}

/// Fits the height to the rows, up to kMaxVisibleStrengths.
void HeightStrengthEditor::fitHeight() {
    const int rows = std::min(m_model->rowCount(), kMaxVisibleStrengths);
    const int rowHeight = m_view->verticalHeader()->defaultSectionSize();
    m_view->setFixedHeight(rows * rowHeight + m_view->horizontalHeader()->sizeHint().height() +
                           2 * m_view->frameWidth());
    m_view->setVisible(rows > 0);
    m_remove->setEnabled(rows > 0);
}

void HeightStrengthEditor::refresh(Id asset) { m_model->setAsset(asset); }

}  // namespace rubble

#include "moc_HeightStrengthEditor.cpp"
