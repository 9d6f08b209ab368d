#include "editor/dialogs/import/MeshSeedsDialog.h"

#include "editor/dialogs/import/MeshReading.h"
#include "editor/dialogs/import/OutlinePreview.h"
#include "editor/widgets/ComboBox.h"
#include "editor/widgets/ScreenFit.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace rubble {

namespace {

constexpr QSize kMeshSeedsSize{420, 480};

}  // namespace

MeshSeedsDialog::MeshSeedsDialog(const QString& fileName, SourceScene mesh, Polygon outline, QWidget* parent)
    : QDialog(parent),
      m_mesh(std::move(mesh)),
      m_outline(std::move(outline)),
      m_unit(createUnitBox()),
      m_along(
          comboBox({tr("X"), tr("Y"), tr("Z")}, tr("Select the axis of the file along which vertices are projected"))),
      m_fit(new QCheckBox(tr("&Fit to outline"))),
      m_preview(new OutlinePreview),
      m_summary(new QLabel) {
    setWindowTitle(tr("Add Seeds from %1").arg(fileName));
    m_along->setCurrentIndex(static_cast<int>(FileAxis::Z));
    m_fit->setToolTip(tr("Scale and move the mesh to fill the outline"));
    m_summary->setWordWrap(true);
    m_summary->setTextFormat(Qt::PlainText);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_add = buttons->addButton(tr("Add Layer"), QDialogButtonBox::AcceptRole);
    auto* form = new QFormLayout;
    form->addRow(tr("&Unit:"), m_unit);
    form->addRow(tr("&Project along:"), m_along);
    form->addRow(QString(), m_fit);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_preview, 1);
    layout->addWidget(m_summary);
    layout->addWidget(buttons);
    m_add->setDefault(true);  // after the button was added to the dialog
    resizeWithinScreen(*this, kMeshSeedsSize);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    for (QComboBox* box : {m_unit, m_along}) {
        connect(box, &QComboBox::currentIndexChanged, this, &MeshSeedsDialog::updateSeeds);
    }
    connect(m_fit, &QCheckBox::toggled, this, &MeshSeedsDialog::updateSeeds);
    updateSeeds();
}

void MeshSeedsDialog::updateSeeds() {
    m_unit->setEnabled(!m_fit->isChecked());
    Result<VertexSeeds> found = seedsAtVertices(m_mesh,
                                                {.along = static_cast<FileAxis>(m_along->currentIndex()),
                                                 .metresPerUnit = metresPerUnit(*m_unit),
                                                 .isFitted = m_fit->isChecked()},
                                                m_outline);
    m_add->setEnabled(found.hasValue());
    const QString note = QString::fromStdString(found ? found->omissionText() : found.error().message);
    m_found = found ? std::move(*found) : VertexSeeds{};
    std::vector<Vec2> positions;
    for (const PlacedSeeds::Seed& seed : m_found.seeds.seeds) positions.push_back(seed.position);
    m_preview->setOutline(m_outline, std::move(positions));
    const int count = static_cast<int>(m_found.seeds.seeds.size());
    m_summary->setText(m_add->isEnabled() ? tr("%Ln seed(s).", nullptr, count) + ' ' + note : note);
}

}  // namespace rubble

#include "moc_MeshSeedsDialog.cpp"
