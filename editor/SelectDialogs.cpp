#include "editor/SelectDialogs.h"

#include "core/asset/FragmentSets.h"
#include "editor/panels/NumberField.h"
#include "editor/panels/RandomSeedField.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

constexpr int kLeastWidth = 320;  // pixels: room for the title

/// The volumes of the smallest and the largest of those pieces that are not broken again, m^3.
std::pair<double, double> volumeRange(const Bake& bake) {
    const FragmentSet smallest = smallestFragments(bake);
    std::pair<double, double> range{1e308, 0.0};
    for (std::uint32_t k = 0; k < smallest.size(); ++k) {
        if (!smallest[k]) continue;
        const double volume = bake.fragment(k).solid.volume();
        range = {std::min(range.first, volume), std::max(range.second, volume)};
    }
    return range;
}

/// Buttons to choose with, or not, below what is asked.
void addButtons(QDialog& dialog, QVBoxLayout& rows) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton* choose = buttons->addButton(QDialog::tr("Select"), QDialogButtonBox::AcceptRole);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    rows.addWidget(buttons);
    choose->setDefault(true);
    dialog.setMinimumWidth(kLeastWidth);
}

}  // namespace

VolumeRangeDialog::VolumeRangeDialog(const Bake& bake, const Units& units, QWidget* parent)
    : QDialog(parent),
      m_bake(bake),
      m_least(addField(volumeRange(bake).first, units)),
      m_most(addField(volumeRange(bake).second, units)),
      m_count(new QLabel) {
    setWindowTitle(tr("Select by Volume"));
    auto* form = new QFormLayout;
    form->addRow(tr("At &least:"), m_least);
    form->addRow(tr("At &most:"), m_most);
    form->addRow(QString(), m_count);
    auto* rows = new QVBoxLayout(this);
    rows->addLayout(form);
    addButtons(*this, *rows);
    count();
}

NumberField* VolumeRangeDialog::addField(double value, const Units& units) {
    auto* field = new NumberField;
    field->setFormat(units.volumes());
    field->setRange(FieldRange::zeroOrAbove());
    field->setValue(value);
    connect(field, &NumberField::edited, this, &VolumeRangeDialog::count);
    return field;
}

double VolumeRangeDialog::least() const { return m_least->value(); }
double VolumeRangeDialog::most() const { return m_most->value(); }

void VolumeRangeDialog::count() {
    const auto found = std::ranges::count(fragmentsOfVolume(m_bake, least(), most()), true);
    m_count->setText(tr("%L1 of %L2 pieces").arg(found).arg(std::ranges::count(smallestFragments(m_bake), true)));
}

RandomShareDialog::RandomShareDialog(int percent, quint64 randomSeed, QWidget* parent)
    : QDialog(parent), m_percent(new QSpinBox), m_seed(new RandomSeedField) {
    setWindowTitle(tr("Select at Random"));
    m_percent->setRange(0, 100);
    m_percent->setSuffix(tr(" %"));
    m_percent->setValue(percent);
    m_seed->setValue(randomSeed);
    auto* form = new QFormLayout;
    form->addRow(tr("&Share of the pieces:"), m_percent);
    form->addRow(tr("&Random seed:"), m_seed);
    auto* rows = new QVBoxLayout(this);
    rows->addLayout(form);
    addButtons(*this, *rows);
    m_percent->selectAll();
    m_percent->setFocus();
}

int RandomShareDialog::percent() const { return m_percent->value(); }
quint64 RandomShareDialog::randomSeed() const { return m_seed->value(); }

}  // namespace rubble
