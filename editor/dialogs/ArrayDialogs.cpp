#include "editor/dialogs/ArrayDialogs.h"

#include "core/asset/placement/InstancePlacement.h"
#include "editor/widgets/NumberField.h"
#include "editor/widgets/TypedFields.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <QtMath>

namespace rubble {

namespace {

constexpr int kMaxCopies = 1000;           // along one axis
constexpr double kMaxDistance = 1e4;       // m
constexpr int kMinArrayDialogWidth = 340;  // pixels, so that the title fits
constexpr int kDefaultRingCount = 6;

}  // namespace

ArrayDialog::ArrayDialog(const QString& title, QWidget* parent)
    : QDialog(parent), m_form(new QFormLayout), m_variants(new QCheckBox(tr("Separate &variant for each copy"))) {
    setWindowTitle(title);
    m_variants->setToolTip(tr("Give each copy the same shape with its own fracture pattern"));
    m_variants->setChecked(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton* copy = buttons->addButton(tr("Copy"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(m_form);
    layout->addWidget(m_variants);
    layout->addWidget(buttons);
    copy->setFocusPolicy(Qt::TabFocus);  // a click leaves the focus in a field, so that its text can be refused
    copy->setDefault(true);              // after the button was added to the dialog
    setMinimumWidth(kMinArrayDialogWidth);
}

bool ArrayDialog::haveVariants() const { return m_variants->isChecked(); }

NumberField* ArrayDialog::addCount(const QString& label, int value) {
    auto* field = new NumberField;
    field->setRange(FieldRange::whole(1, kMaxCopies));
    field->setValue(value);
    m_form->addRow(label, field);
    return field;
}

NumberField* ArrayDialog::addNumber(const QString& label, const NumberFormat& format, double value) {
    auto* field = new NumberField;
    field->setRange({.min = -kMaxDistance, .max = kMaxDistance});
    field->setFormat(format);
    field->setValue(value);
    m_form->addRow(label, field);
    return field;
}

void ArrayDialog::accept() {
    if (commitFields(*this)) QDialog::accept();
}

GridArrayDialog::GridArrayDialog(Vec3 steps, const Units& units, QWidget* parent)
    : ArrayDialog(tr("Grid Array"), parent) {
    const QStringList axes{tr("x"), tr("y"), tr("z")};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const QString& name = axes[static_cast<int>(axis)];
        m_counts[axis] = addCount(tr("Count along %1:").arg(name), axis == 0 ? 3 : 1);
        m_steps[axis] = addNumber(tr("Spacing along %1:").arg(name), units.lengths(), steps[static_cast<int>(axis)]);
    }
    m_counts[0]->selectAll();
    m_counts[0]->setFocus();
}

GridArray GridArrayDialog::array() const {
    GridArray array;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        array.counts[axis] = static_cast<int>(m_counts[axis]->value());
        array.steps[static_cast<int>(axis)] = m_steps[axis]->value();
    }
    return array;
}

RingArrayDialog::RingArrayDialog(const Units& units, QWidget* parent) : ArrayDialog(tr("Radial Array"), parent) {
    m_count = addCount(tr("&Count:"), kDefaultRingCount);
    m_x = addNumber(tr("Axis at &x:"), units.lengths(), 0.0);
    m_z = addNumber(tr("Axis at &z:"), units.lengths(), 0.0);
    m_degrees = addNumber(tr("&Angle between copies:"), Units::angles(), 360.0 / kDefaultRingCount);
    connect(m_count, &NumberField::edited, this, [this](double count) { m_degrees->setValue(360.0 / count); });
    m_count->selectAll();
    m_count->setFocus();
}

RingArray RingArrayDialog::array() const {
    return {static_cast<int>(m_count->value()), {m_x->value(), m_z->value()}, qDegreesToRadians(m_degrees->value())};
}

Vec3 sizeOf(const Project& project, std::span<const Id> instances) {
    const Box3 box = boundsOf(project, instances);
    return box.isEmpty() ? Vec3(1.0) : box.max - box.min;
}

}  // namespace rubble

#include "moc_ArrayDialogs.cpp"
