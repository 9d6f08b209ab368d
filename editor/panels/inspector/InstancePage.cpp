#include "editor/panels/inspector/InstancePage.h"

#include "core/asset/strength/Threshold.h"
#include "editor/commands/Renaming.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/EulerAngles.h"
#include "editor/widgets/ProjectRange.h"
#include "editor/widgets/SliderField.h"

#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <cmath>

namespace rubble {

namespace {

double assetThreshold(const Project& project, const Instance& instance) {
    const Asset* asset = findAsset(project, instance.asset);
    return asset ? thresholdOf(project, *asset) : 0.0;
}

}  // namespace

InstancePage::InstancePage(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_form(
          document, [this] { return selected(); }, pushOf<Instance>(document)),
      m_instance(new Section("instance", tr("Instance"), this)),
      m_strength(new Section("strength", tr("Strength"), this)) {
    auto* transform = new Section("transform", tr("Transform"), this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    for (Section* section : {m_instance, transform, m_strength}) layout->addWidget(section);
    layout->addStretch();
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    m_form.setFault([this](const Instance& instance) {
        const bool isOne = m_selection.instances().size() == 1;
        return isOne
                   ? nameFault(m_document.project(), Part::Instance, instance.id, QString::fromStdString(instance.name))
                   : QString();
    });
    buildInstance(*m_instance);
    buildTransform(*transform);
    buildStrength(*m_strength);
    buildBonds(*m_strength);
}

std::vector<Instance> InstancePage::selected() const {
    std::vector<Instance> instances;
    for (const Instance& instance : m_document.project().instances) {
        if (m_selection.instances().contains(instance.id)) instances.push_back(instance);
    }
    return instances;
}

void InstancePage::buildInstance(Section& section) {
    m_name = section.addRow(tr("Name"), new QLineEdit, tr("Name of the instance"));
    m_form.bind(
        m_name, tr("Rename"), [](const Instance& instance) { return QString::fromStdString(instance.name); },
        [](Instance& instance, const QString& entered) { instance.name = entered.trimmed().toStdString(); });
    m_asset = section.addRow(tr("Asset"), new QComboBox, tr("Asset of the instance"));
    m_form.bind(m_asset, tr("Set Asset"), &Instance::asset);
    auto* variant =
        section.addRow(tr("Variant"), new NumberField,
                       tr("Fracture variant: 0 for the asset's own pattern, other numbers for other random seeds"));
    variant->setRange(wholeFieldRange(ProjectNumber::InstanceVariant));
    m_form.bind(
        variant, tr("Set Variant"), [](const Instance& instance) { return static_cast<double>(instance.variant); },
        [](Instance& instance, double entered) {
            instance.variant = static_cast<std::uint32_t>(std::lround(entered));
        });
    m_editAsset = new QPushButton(tr("Edit Asset"));
    m_editAsset->setToolTip(tr("Show the asset's shape and pattern"));
    m_editAsset->setAutoDefault(false);
    section.addWide(m_editAsset);
    addCheckBox(section, tr("Hidden"), tr("Hide in the 3D view; the instance still takes part in simulations"),
                tr("Hide or Show Instances"), &Instance::isHidden);
    addCheckBox(section, tr("Locked"), tr("Prevent selecting and moving in the 3D view"),
                tr("Lock or Unlock Instances"), &Instance::isLocked);
    connect(m_editAsset, &QPushButton::clicked, this, [this] { m_selection.setAsset(m_selection.asset()); });
}

void InstancePage::buildTransform(Section& section) {
    const QStringList axes{tr("x"), tr("y"), tr("z")};
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = section.addRow(tr("Position %1").arg(axes[axis]), new NumberField,
                                     tr("Position of the asset's origin; y points up"));
        field->setRange(fieldRange(ProjectNumber::InstancePosition));
        m_form.bind(
            field, tr("Move"), [axis](const Instance& instance) { return instance.pose.position[axis]; },
            [axis](Instance& instance, double entered) { instance.pose.position[axis] = entered; });
        m_position[static_cast<std::size_t>(axis)] = field;
    }
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = section.addRow(tr("Rotation %1").arg(axes[axis]), new NumberField,
                                     tr("Rotation about the world axes, first x, then y, then z"));
        field->setFormat(Units::angles());
        field->setRange({.min = -36'000.0, .max = 36'000.0, .step = 1.0});
        m_form.bind(
            field, tr("Rotate"), [this, axis](const Instance& instance) { return degreesOf(instance)[axis]; },
            [this, axis](Instance& instance, double entered) { rotate(instance, axis, entered); });
    }
}

void InstancePage::buildStrength(Section& section) {
    m_hasThreshold = new QCheckBox(tr("Override Threshold"));
    m_hasThreshold->setToolTip(tr("Override the asset's threshold"));
    section.addWide(m_hasThreshold);
    m_form.bind(
        m_hasThreshold, tr("Override Threshold"),
        [](const Instance& instance) { return instance.threshold.has_value(); },
        [this](Instance& instance, bool isOn) {
            if (!isOn)
                instance.threshold.reset();
            else if (!instance.threshold)
                instance.threshold = assetThreshold(m_document.project(), instance);
        });
    m_threshold = section.addRow(tr("Threshold"), thresholdField(), tr("Impulse at which the instance breaks"));
    m_form.bind(
        m_threshold, tr("Set Threshold"),
        [this](const Instance& instance) {
            return instance.threshold.value_or(assetThreshold(m_document.project(), instance));
        },
        [](Instance& instance, double entered) { instance.threshold = entered; });
    addCheckBox(section, tr("Fixed"), tr("Hold in place until it breaks"), tr("Fix or Release Instances"),
                &Instance::isFixed);
    addCheckBox(section, tr("Unbreakable"), tr("Prevent breaking, whatever hits it; it may still move"),
                tr("Make Unbreakable or Breakable"), &Instance::isUnbreakable);
}

/// What is only shown for instances of assets that break as bonded.
void InstancePage::buildBonds(Section& section) {
    m_anchored = addCheckBox(section, tr("Anchored Where It Touches"),
                             tr("Hold fragments in place that touch the ground or a fixed instance at the start"),
                             tr("Anchor or Release Instances"), &Instance::isAnchored);
    m_bondStrength =
        section.addRow(tr("Bond strength"),
                       new SliderField(fieldRange(ProjectNumber::BondStrength), 0.1, 10.0, SliderScale::Logarithmic),
                       tr("Multiply the strength of the bonds of the instance"));
    m_form.bind(m_bondStrength, tr("Set Bond Strength"), &Instance::bondStrength);
}

QCheckBox* InstancePage::addCheckBox(Section& section, const QString& label, const QString& hint, const QString& step,
                                     bool Instance::*member) {
    auto* box = new QCheckBox(label);
    box->setToolTip(hint);
    section.addWide(box);
    m_form.bind(box, step, member);
    return box;
}

bool InstancePage::isBonded(const Instance& instance) const {
    const Asset* asset = findAsset(m_document.project(), instance.asset);
    return asset && asset->breakAs == BreakAs::Bonded;
}

Vec3 InstancePage::degreesOf(const Instance& instance) const {
    return instance.pose.orientation == m_typedOrientation ? m_typedDegrees : eulerDegrees(instance.pose.orientation);
}

void InstancePage::rotate(Instance& instance, int axis, double degrees) {
    Vec3 angles = degreesOf(instance);
    angles[axis] = degrees;
    instance.pose.orientation = orientationOf(angles);
    m_typedOrientation = instance.pose.orientation;
    m_typedDegrees = angles;
}

void InstancePage::setUnits(const Units& units) {
    for (NumberField* field : m_position) field->setFormat(units.lengths());
}

void InstancePage::refresh() {
    std::vector<ComboItem> assets;
    for (const Asset& asset : m_document.project().assets) assets.push_back({asset.id, nameText(asset.name), {}});
    setItems(*m_asset, assets);
    m_form.refresh();
    const std::vector<Instance> instances = selected();
    const bool isOne = instances.size() == 1;
    m_instance->setTitle(isOne ? tr("Instance") : tr("%1 Instances").arg(locale().toString(instances.size())));
    m_instance->setRowVisible(m_name, isOne);
    m_editAsset->setEnabled(m_asset->currentIndex() >= 0);
    m_threshold->setEnabled(std::ranges::all_of(instances, [](const Instance& i) { return i.threshold.has_value(); }));
    const auto bonded = std::ranges::count_if(instances, [this](const Instance& i) { return isBonded(i); });
    const bool doBreakWhole = bonded < std::ssize(instances);
    m_hasThreshold->setVisible(doBreakWhole);
    m_strength->setRowVisible(m_threshold, doBreakWhole);
    m_anchored->setVisible(bonded > 0);
    m_strength->setRowVisible(m_bondStrength, bonded > 0);
}

}  // namespace rubble

#include "moc_InstancePage.cpp"
