#include "editor/dialogs/SelectDialogs.h"

#include "core/asset/bake/FragmentSets.h"
#include "editor/widgets/NumberField.h"
#include "editor/widgets/RandomSeedField.h"
#include "editor/widgets/TypedFields.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

constexpr int kMinSelectDialogWidth = 320;  // pixels, so that the title fits

/// Returns the smallest and the largest volume of the leaf fragments, m³.
std::pair<double, double> volumeRange(const Bake& bake) {
    const FragmentSet leaves = leafFragments(bake);
    std::pair<double, double> range{1e308, 0.0};
    for (std::uint32_t k = 0; k < leaves.size(); ++k) {
        if (!leaves[k]) continue;
        const double volume = bake.fragment(k).solid.volume();
        range = {std::min(range.first, volume), std::max(range.second, volume)};
    }
    return range;
}

/// Adds Select and Cancel buttons below the fields.
void addButtons(QDialog& dialog, QVBoxLayout& rows) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton* select = buttons->addButton(QDialog::tr("Select"), QDialogButtonBox::AcceptRole);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    rows.addWidget(buttons);
    select->setFocusPolicy(Qt::TabFocus);  // a click leaves the focus in a field, so that its text can be refused
    select->setDefault(true);
    dialog.setMinimumWidth(kMinSelectDialogWidth);
}

}  // namespace

VolumeRangeDialog::VolumeRangeDialog(const Bake& bake, const Units& units, QWidget* parent)
    : QDialog(parent),
      m_bake(bake),
      m_min(addField(volumeRange(bake).first, units)),
      m_max(addField(volumeRange(bake).second, units)),
      m_count(new QLabel) {
    setWindowTitle(tr("Select by Volume"));
    auto* form = new QFormLayout;
    form->addRow(tr("Mi&nimum:"), m_min);
    form->addRow(tr("Ma&ximum:"), m_max);
    form->addRow(QString(), m_count);
    auto* rows = new QVBoxLayout(this);
    rows->addLayout(form);
    addButtons(*this, *rows);
    updateCount();
}

NumberField* VolumeRangeDialog::addField(double value, const Units& units) {
    auto* field = new NumberField;
    field->setFormat(units.volumes());
    field->setRange(FieldRange::zeroOrAbove());
    field->setValue(value);
    connect(field, &NumberField::edited, this, &VolumeRangeDialog::updateCount);
    return field;
}

void VolumeRangeDialog::accept() {
    if (commitFields(*this)) QDialog::accept();
}

double VolumeRangeDialog::min() const { return m_min->value(); }
double VolumeRangeDialog::max() const { return m_max->value(); }

void VolumeRangeDialog::updateCount() {
    const auto found = std::ranges::count(fragmentsOfVolume(m_bake, min(), max()), true);
    const auto all = static_cast<int>(std::ranges::count(leafFragments(m_bake), true));
    m_count->setText(tr("%L1 of %Ln fragment(s)", nullptr, all).arg(found));
}

RandomFractionDialog::RandomFractionDialog(int percent, quint64 randomSeed, QWidget* parent)
    : QDialog(parent), m_percent(new NumberField), m_seed(new RandomSeedField) {
    setWindowTitle(tr("Select Randomly"));
    m_percent->setRange(FieldRange::whole(0, 100));
    m_percent->setFormat({QStringLiteral("%")});
    m_percent->setValue(percent);
    m_seed->setValue(randomSeed);
    auto* form = new QFormLayout;
    form->addRow(tr("&Fraction of the fragments:"), m_percent);
    form->addRow(tr("&Random seed:"), m_seed);
    auto* rows = new QVBoxLayout(this);
    rows->addLayout(form);
    addButtons(*this, *rows);
    m_percent->selectAll();
    m_percent->setFocus();
}

void RandomFractionDialog::accept() {
    if (commitFields(*this)) QDialog::accept();
}

int RandomFractionDialog::percent() const { return static_cast<int>(m_percent->value()); }
quint64 RandomFractionDialog::randomSeed() const { return m_seed->value(); }

}  // namespace rubble

#include "moc_SelectDialogs.cpp"
