#include "editor/panels/inspector/HeightStrengthEditor.h"

#include "editor/widgets/Buttons.h"
#include "editor/widgets/ProjectRange.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace rubble {

namespace {

constexpr int kMaxVisibleStrengths = 6;

}  // namespace

HeightStrengthEditor::HeightStrengthEditor(Document& document, QWidget* parent)
    : QWidget(parent), m_model(new HeightStrengthModel(document, this)) {
    const auto prepare = [this](NumberField& field, int column) {
        const bool isHeight = column == HeightStrengthModel::Height;
        if (isHeight) field.setFormat(m_model->units().lengths());
        field.setRange(fieldRange(isHeight ? ProjectNumber::BondStrengthHeight : ProjectNumber::BondStrength));
    };
    m_view = new NumberTable(*m_model, prepare, this);
    m_view->setAccessibleName(tr("Strength by Height"));
    m_view->setToolTip(tr("Multiply the strength of bonds at a height above the lowest point of the outline"));
    m_view->verticalHeader()->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(buttonRow());
    layout->addWidget(m_view);
    connect(m_model, &HeightStrengthModel::modelReset, this, &HeightStrengthEditor::fitHeight);
    connect(m_model, &HeightStrengthModel::refused, m_view, &NumberTable::showRefusal);
    connect(m_model, &HeightStrengthModel::refused, this, &HeightStrengthEditor::refused);
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
    connect(m_remove, &QToolButton::clicked, this, [this] { m_model->removeStrengths(m_view->selectedRows()); });
    return row;
}

/// Without a row, the table is hidden.
void HeightStrengthEditor::fitHeight() {
    const bool hasRows = m_model->rowCount() > 0;
    m_view->fitHeight(0, kMaxVisibleStrengths);
    m_view->setVisible(hasRows);
    m_remove->setEnabled(hasRows);
}

void HeightStrengthEditor::refresh(Id asset) { m_model->setAsset(asset); }

}  // namespace rubble

#include "moc_HeightStrengthEditor.cpp"
