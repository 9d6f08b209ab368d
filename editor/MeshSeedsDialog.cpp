#include "editor/MeshSeedsDialog.h"

#include "editor/ChoiceBox.h"
#include "editor/MeshReading.h"
#include "editor/OutlinePreview.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace rubble {

MeshSeedsDialog::MeshSeedsDialog(const QString& fileName, SourceScene mesh, Polygon outline, QWidget* parent)
    : QDialog(parent),
      m_mesh(std::move(mesh)),
      m_outline(std::move(outline)),
      m_unit(unitBox()),
      m_along(choiceBox({tr("X"), tr("Y"), tr("Z")}, tr("Along which axis of the file its points are seen"))),
      m_fit(new QCheckBox(tr("&Fit into the outline"))),
      m_preview(new OutlinePreview),
      m_told(new QLabel) {
    setWindowTitle(tr("Seeds from %1").arg(fileName));
    m_along->setCurrentIndex(static_cast<int>(FileAxis::Z));
    m_fit->setToolTip(tr("Scales the mesh evenly and moves it until it fills the outline"));
    m_told->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_add = buttons->addButton(tr("Add Layer"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* form = new QFormLayout;
    form->addRow(tr("&Unit:"), m_unit);
    form->addRow(tr("&Seen along:"), m_along);
    form->addRow(QString(), m_fit);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_preview, 1);
    layout->addWidget(m_told);
    layout->addWidget(buttons);
    m_add->setDefault(true);  // a button knows its dialog only now
    resize(420, 480);
    for (QComboBox* box : {m_unit, m_along}) {
        connect(box, &QComboBox::currentIndexChanged, this, &MeshSeedsDialog::update);
    }
    connect(m_fit, &QCheckBox::toggled, this, &MeshSeedsDialog::update);
    update();
}

void MeshSeedsDialog::update() {
    m_unit->setEnabled(!m_fit->isChecked());
    Result<VertexSeeds> found = seedsAtVertices(m_mesh,
                                                {.along = static_cast<FileAxis>(m_along->currentIndex()),
                                                 .metresPerUnit = metresOf(*m_unit),
                                                 .isFitted = m_fit->isChecked()},
                                                m_outline);
    m_add->setEnabled(found.hasValue());
    m_found = found ? std::move(*found) : VertexSeeds{};
    std::vector<Vec2> places;
    for (const PlacedSeeds::Seed& seed : m_found.seeds.seeds) places.push_back(seed.position);
    m_preview->setOutline(m_outline, std::move(places));
    const std::string told = found ? m_found.report() : found.error().message;
    const QString count = tr("%n seed(s).", nullptr, static_cast<int>(m_found.seeds.seeds.size()));
    m_told->setText(found ? count + ' ' + QString::fromStdString(told) : QString::fromStdString(told));
}

}  // namespace rubble
