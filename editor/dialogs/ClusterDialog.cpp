#include "editor/dialogs/ClusterDialog.h"

#include "editor/widgets/ProjectRange.h"
#include "editor/widgets/TypedFields.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace rubble {

namespace {

constexpr int kMinClusterDialogWidth = 320;  // pixels, so that the title fits

}  // namespace

ClusterDialog::ClusterDialog(const ClusterTarget& target, std::uint32_t level, QWidget* parent)
    : QDialog(parent), m_measure(new QComboBox), m_value(new NumberField), m_level(new NumberField) {
    setWindowTitle(tr("Propose Clusters"));
    m_measure->addItem(tr("Number of clusters"));
    m_measure->addItem(tr("Fragments of each"));
    m_measure->setCurrentIndex(static_cast<int>(target.measure));
    m_value->setRange(FieldRange::whole(1.0, ClusterTarget::kMost));
    m_value->setValue(target.value);
    m_level->setRange(wholeFieldRange(ProjectNumber::BondClusterLevel));
    m_level->setValue(level);
    m_level->setHint(tr("Level 0 is the coarsest and breaks first; deeper clusters are made inside of coarser ones"));
    auto* form = new QFormLayout;
    form->addRow(tr("&By:"), m_measure);
    form->addRow(tr("&Value:"), m_value);
    form->addRow(tr("&Level:"), m_level);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton* propose = buttons->addButton(tr("Propose"), QDialogButtonBox::AcceptRole);
    propose->setFocusPolicy(Qt::TabFocus);  // a click leaves the focus in a field, so that its text can be refused
    connect(buttons, &QDialogButtonBox::accepted, this, &ClusterDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* rows = new QVBoxLayout(this);
    rows->addLayout(form);
    rows->addWidget(buttons);
    propose->setDefault(true);  // after the button was added to the dialog
    setMinimumWidth(kMinClusterDialogWidth);
    m_value->selectAll();
    m_value->setFocus();
}

ClusterTarget ClusterDialog::target() const {
    return {static_cast<ClusterTarget::Measure>(m_measure->currentIndex()),
            static_cast<std::uint32_t>(m_value->value())};
}

std::uint32_t ClusterDialog::level() const { return static_cast<std::uint32_t>(m_level->value()); }

void ClusterDialog::accept() {
    if (commitFields(*this)) QDialog::accept();
}

}  // namespace rubble

#include "moc_ClusterDialog.cpp"
