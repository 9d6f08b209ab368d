#include "editor/ArrayDialogs.h"

#include "core/asset/PrismHulls.h"
#include "core/geometry/TriangleMesh.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <QtMath>

namespace rubble {

namespace {

constexpr int kMostCopies = 1000;  // along one axis
constexpr double kFarthest = 1e4;  // m
constexpr int kLeastWidth = 340;   // pixels: room for the title
constexpr int kUsualRing = 6;

}  // namespace

ArrayDialog::ArrayDialog(const QString& title, QWidget* parent)
    : QDialog(parent), m_form(new QFormLayout), m_variants(new QCheckBox(tr("Each copy breaks in a way of its &own"))) {
    setWindowTitle(title);
    m_variants->setToolTip(tr("Gives each copy a variant of its asset: same shape, other random seeds"));
    m_variants->setChecked(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton* copy = buttons->addButton(tr("Copy"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(m_form);
    layout->addWidget(m_variants);
    layout->addWidget(buttons);
    copy->setDefault(true);  // a button knows its dialog only now
    setMinimumWidth(kLeastWidth);
}

bool ArrayDialog::haveVariants() const { return m_variants->isChecked(); }

QSpinBox* ArrayDialog::addCount(const QString& label, int usual) {
    auto* box = new QSpinBox;
    box->setRange(1, kMostCopies);
    box->setValue(usual);
    m_form->addRow(label, box);
    return box;
}

QDoubleSpinBox* ArrayDialog::addNumber(const QString& label, const QString& unit, double usual) {
    auto* box = new QDoubleSpinBox;
    box->setRange(-kFarthest, kFarthest);
    box->setDecimals(3);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setSuffix(unit);
    box->setValue(usual);
    m_form->addRow(label, box);
    return box;
}

GridArrayDialog::GridArrayDialog(Vec3 steps, QWidget* parent) : ArrayDialog(tr("Array in Rows"), parent) {
    const QStringList axes{tr("x"), tr("y"), tr("z")};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const QString& name = axes[static_cast<int>(axis)];
        m_counts[axis] = addCount(tr("Count along %1:").arg(name), axis == 0 ? 3 : 1);
        m_steps[axis] = addNumber(tr("Step along %1:").arg(name), tr(" m"), steps[static_cast<int>(axis)]);
    }
    m_counts[0]->selectAll();
    m_counts[0]->setFocus();
}

GridArray GridArrayDialog::array() const {
    GridArray array;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        array.counts[axis] = m_counts[axis]->value();
        array.steps[static_cast<int>(axis)] = m_steps[axis]->value();
    }
    return array;
}

RingArrayDialog::RingArrayDialog(QWidget* parent) : ArrayDialog(tr("Array in a Ring"), parent) {
    m_count = addCount(tr("&Count:"), kUsualRing);
    m_x = addNumber(tr("Axis at &x:"), tr(" m"), 0.0);
    m_z = addNumber(tr("Axis at &z:"), tr(" m"), 0.0);
    m_degrees = addNumber(tr("&Turn each by:"), QStringLiteral("°"), 360.0 / kUsualRing);
    connect(m_count, &QSpinBox::valueChanged, this, [this](int count) { m_degrees->setValue(360.0 / count); });
    m_count->selectAll();
    m_count->setFocus();
}

RingArray RingArrayDialog::array() const {
    return {m_count->value(), {m_x->value(), m_z->value()}, qDegreesToRadians(m_degrees->value())};
}

Vec3 sizeOf(const Project& project, std::span<const Id> instances) {
    const AssetHulls hulls = assetHulls(project);
    Box3 box;
    for (const Id id : instances) {
        const Instance& instance = *findInstance(project, id);
        const auto own = hulls.find(instance.asset);
        if (own == hulls.end()) continue;
        for (const Polytope& hull : own->second) {
            for (const Vec3& vertex : hull.vertices) {
                box.include(instance.pose.position + instance.pose.orientation * vertex);
            }
        }
    }
    return box.isEmpty() ? Vec3(1.0) : box.max - box.min;
}

}  // namespace rubble
