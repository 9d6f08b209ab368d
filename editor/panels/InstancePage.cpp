#include "editor/panels/InstancePage.h"

#include "core/asset/Threshold.h"
#include "editor/commands/Renaming.h"
#include "editor/panels/EulerAngles.h"
#include "editor/panels/ThresholdField.h"

#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <cmath>

namespace rubble {

namespace {

constexpr double kMostVariant = 9999.0;  // enough for any scene

QString textOf(const std::string& text) { return QString::fromStdString(text); }

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
          document, [this] { return chosen(); }, pushOf<Instance>(document)),
      m_instance(new Section("instance", tr("Instance"), this)) {
    auto* place = new Section("place", tr("Place"), this);
    auto* strength = new Section("strength", tr("Strength"), this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    for (Section* section : {m_instance, place, strength}) layout->addWidget(section);
    layout->addStretch();
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    m_form.setFault([this](const Instance& instance) {
        const bool isOne = m_selection.instances().size() == 1;
        return isOne ? nameFault(m_document.project(), Part::Instance, instance.id, textOf(instance.name)) : QString();
    });
    buildInstance(*m_instance);
    buildPlace(*place);
    buildStrength(*strength);
}

std::vector<Instance> InstancePage::chosen() const {
    std::vector<Instance> instances;
    for (const Instance& instance : m_document.project().instances) {
        if (m_selection.instances().contains(instance.id)) instances.push_back(instance);
    }
    return instances;
}

void InstancePage::buildInstance(Section& section) {
    m_name = section.addRow(tr("Name"), new QLineEdit, tr("What the instance is called"));
    m_form.bind(
        m_name, tr("Rename"), [](const Instance& instance) { return textOf(instance.name); },
        [](Instance& instance, const QString& entered) { instance.name = entered.trimmed().toStdString(); });
    m_asset = section.addRow(tr("Asset"), new QComboBox, tr("Which asset stands here"));
    m_form.bind(m_asset, tr("Set asset"), &Instance::asset);
    auto* variant = section.addRow(tr("Variant"), new NumberField,
                                   tr("In which way it breaks: 0 as its asset says, others with other random seeds"));
    variant->setRange(FieldRange::whole(0.0, kMostVariant));
    m_form.bind(
        variant, tr("Set variant"), [](const Instance& instance) { return static_cast<double>(instance.variant); },
        [](Instance& instance, double entered) {
            instance.variant = static_cast<std::uint32_t>(std::lround(entered));
        });
    m_editAsset = new QPushButton(tr("Edit asset"));
    m_editAsset->setToolTip(tr("Show the asset's shape and pattern"));
    m_editAsset->setAutoDefault(false);
    section.addWide(m_editAsset);
    addSwitch(section, tr("Hidden"), tr("Left out of the 3D view; it plays all the same"), tr("Switch hidden"),
              &Instance::isHidden);
    addSwitch(section, tr("Locked"), tr("Neither clicked nor moved in the 3D view"), tr("Switch locked"),
              &Instance::isLocked);
    connect(m_editAsset, &QPushButton::clicked, this, [this] { m_selection.setAsset(m_selection.asset()); });
}

void InstancePage::buildPlace(Section& section) {
    const QStringList axes{tr("x"), tr("y"), tr("z")};
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = section.addRow(tr("Position %1").arg(axes[axis]), new NumberField,
                                     tr("Where the middle of the asset's frame stands; y points up"));
        m_form.bind(
            field, tr("Move"), [axis](const Instance& instance) { return instance.pose.position[axis]; },
            [axis](Instance& instance, double entered) { instance.pose.position[axis] = entered; });
        m_position[static_cast<std::size_t>(axis)] = field;
    }
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = section.addRow(tr("Rotation %1").arg(axes[axis]), new NumberField,
                                     tr("Turns about the world's axes: first about x, then y, then z"));
        field->setFormat({QStringLiteral("°"), 0});
        field->setRange({.min = -36'000.0, .max = 36'000.0, .step = 1.0});
        m_form.bind(
            field, tr("Turn"), [this, axis](const Instance& instance) { return degreesOf(instance)[axis]; },
            [this, axis](Instance& instance, double entered) { turn(instance, axis, entered); });
    }
}

void InstancePage::buildStrength(Section& section) {
    auto* isOwn = new QCheckBox(tr("Own threshold"));
    isOwn->setToolTip(tr("Withstands more or less than its asset says"));
    section.addWide(isOwn);
    m_form.bind(
        isOwn, tr("Switch own threshold"), [](const Instance& instance) { return instance.threshold.has_value(); },
        [this](Instance& instance, bool isOn) {
            if (!isOn)
                instance.threshold.reset();
            else if (!instance.threshold)
                instance.threshold = assetThreshold(m_document.project(), instance);
        });
    m_threshold = section.addRow(tr("Threshold"), thresholdField(), tr("The impulse of a blow at which it breaks"));
    m_form.bind(
        m_threshold, tr("Set threshold"),
        [this](const Instance& instance) {
            return instance.threshold.value_or(assetThreshold(m_document.project(), instance));
        },
        [](Instance& instance, double entered) { instance.threshold = entered; });
    addSwitch(section, tr("Fixed"), tr("Held in place as if part of the ground, until it breaks"), tr("Switch fixed"),
              &Instance::isFixed);
}

void InstancePage::addSwitch(Section& section, const QString& label, const QString& hint, const QString& step,
                             bool Instance::*member) {
    auto* box = new QCheckBox(label);
    box->setToolTip(hint);
    section.addWide(box);
    m_form.bind(box, step, member);
}

Vec3 InstancePage::degreesOf(const Instance& instance) const {
    return instance.pose.orientation == m_turned ? m_typedDegrees : eulerDegrees(instance.pose.orientation);
}

void InstancePage::turn(Instance& instance, int axis, double degrees) {
    Vec3 turns = degreesOf(instance);
    turns[axis] = degrees;
    instance.pose.orientation = orientationOf(turns);
    m_turned = instance.pose.orientation;
    m_typedDegrees = turns;
}

void InstancePage::setUnits(const Units& units) {
    for (NumberField* field : m_position) field->setFormat(units.lengths());
}

void InstancePage::refresh() {
    std::vector<Choice> assets;
    for (const Asset& asset : m_document.project().assets) assets.push_back({asset.id, textOf(asset.name), {}});
    offer(*m_asset, assets);
    m_form.refresh();
    const std::vector<Instance> instances = chosen();
    const bool isOne = instances.size() == 1;
    m_instance->setTitle(isOne ? tr("Instance") : tr("%1 instances").arg(locale().toString(instances.size())));
    m_instance->setRowVisible(m_name, isOne);
    m_editAsset->setEnabled(m_asset->currentIndex() >= 0);
    m_threshold->setEnabled(std::ranges::all_of(instances, [](const Instance& i) { return i.threshold.has_value(); }));
}

}  // namespace rubble
