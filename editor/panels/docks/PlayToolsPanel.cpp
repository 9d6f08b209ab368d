#include "editor/panels/docks/PlayToolsPanel.h"

#include "editor/document/ShownText.h"
#include "editor/widgets/NumberField.h"
#include "editor/widgets/ProjectRange.h"
#include "editor/widgets/Section.h"

#include <QCheckBox>
#include <QComboBox>
#include <QVBoxLayout>

namespace rubble {

namespace {

struct Preset {
    ProjectileKind kind;
    Vec3 size;    // m
    double mass;  // kg
};

/// The size and mass of a kind: a cast-iron box, a steel ball, a wooden plank.
Preset presetOf(ProjectileKind kind) {
    switch (kind) {
        case ProjectileKind::Ball: return {kind, Vec3(0.4), 260.0};
        case ProjectileKind::Plank: return {kind, {0.25, 0.06, 2.5}, 25.0};
        default: return {kind, Vec3(0.6), 1500.0};
    }
}

}  // namespace

PlayToolsPanel::PlayToolsPanel(const Document& document, PlayController& controller, QWidget* parent)
    : QWidget(parent), m_document(document), m_controller(controller), m_kind(new QComboBox) {
    auto* content = new QWidget;
    auto* rows = new QVBoxLayout(content);
    rows->setContentsMargins(0, 0, 0, 0);
    m_throw = new Section("throw", tr("Throw (F)"));
    addThrow(*m_throw);
    rows->addWidget(m_throw);
    m_hammer = new Section("hammer", tr("Hammer (H)"));
    addHammer(*m_hammer);
    rows->addWidget(m_hammer);
    auto* blast = new Section("blast", tr("Blast (X)"));
    addField(*blast, tr("Impulse"), tr("Impulse per square metre at the centre, falling to 0 at the radius"),
             Units::impulsesPerArea(), ProjectNumber::BlastImpulse,
             [](PlayToolSettings& tools) -> double& { return tools.blast.impulse; });
    m_lengths << addField(*blast, tr("Radius"), tr("Radius of the blast"), Units().lengths(),
                          ProjectNumber::BlastRadius,
                          [](PlayToolSettings& tools) -> double& { return tools.blast.radius; });
    rows->addWidget(blast);
    auto* grip = new Section("grip", tr("Grab (drag)"));
    addField(*grip, tr("Force"), tr("Maximum force on a grabbed body"), Units::forces(), ProjectNumber::GrabForce,
             [](PlayToolSettings& tools) -> double& { return tools.grabForce; });
    rows->addWidget(grip);
    rows->addStretch(1);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(verticalScrollArea(content));
    connect(&document, &Document::changed, this, &PlayToolsPanel::refreshAssets);
    connect(&controller, &PlayController::toolSettingsChanged, this, &PlayToolsPanel::refresh);
    refreshAssets();
}

void PlayToolsPanel::addThrow(Section& section) {
    section.addRow(tr("Projectile"), m_kind, tr("Body to throw"));
    m_kind->setObjectName("projectile");
    connect(m_kind, &QComboBox::activated, this, &PlayToolsPanel::applyKind);
    const std::array labels{tr("Width"), tr("Height"), tr("Length")};
    for (int axis = 0; axis < 3; ++axis) {
        m_sizes << addField(section, labels[static_cast<std::size_t>(axis)], tr("Size of the projectile"),
                            Units().lengths(), ProjectNumber::ProjectileSize,
                            [axis](PlayToolSettings& tools) -> double& { return tools.projectile.size[axis]; });
    }
    m_mass = addField(section, tr("Mass"), tr("Mass of the projectile"), Units::masses(), ProjectNumber::Mass,
                      [](PlayToolSettings& tools) -> double& { return tools.projectile.mass; });
    addSpeed(section);
    m_throwsOnClick = new QCheckBox(tr("Throw on Click"));
    m_throwsOnClick->setObjectName("throwOnClick");
    m_throwsOnClick->setToolTip(tr("Throw where you click, instead of selecting what is there"));
    m_throwsOnClick->setStatusTip(m_throwsOnClick->toolTip());
    section.addWide(m_throwsOnClick);
    connect(m_throwsOnClick, &QCheckBox::clicked, this, [this](bool isOn) {
        PlayToolSettings tools = m_controller.toolSettings();
        tools.throwsOnClick = isOn;
        m_controller.setToolSettings(tools);
    });
}

void PlayToolsPanel::addSpeed(Section& section) {
    m_isSpeedAutomatic = new QCheckBox(tr("Automatic Speed"));
    m_isSpeedAutomatic->setObjectName("automaticSpeed");
    m_isSpeedAutomatic->setToolTip(tr("Throw so fast that a tap of F reaches the target quickly"));
    m_isSpeedAutomatic->setStatusTip(m_isSpeedAutomatic->toolTip());
    section.addWide(m_isSpeedAutomatic);
    connect(m_isSpeedAutomatic, &QCheckBox::clicked, this, [this](bool isOn) {
        PlayToolSettings tools = m_controller.toolSettings();
        tools.isSpeedAutomatic = isOn;
        m_controller.setToolSettings(tools);
    });
    m_speed = addField(section, tr("Speed"), tr("Speed of a tapped throw; holding F for a second gives 2.5 times it"),
                       Units::speeds(), ProjectNumber::ProjectileSpeed,
                       [](PlayToolSettings& tools) -> double& { return tools.projectile.speed; });
}

void PlayToolsPanel::addHammer(Section& section) {
    addField(section, tr("Impulse"), tr("Impulse of a blow"), Units::impulses(), ProjectNumber::HammerBlow,
             [](PlayToolSettings& tools) -> double& { return tools.hammerImpulse; });
    m_isRadiusAutomatic = new QCheckBox(tr("Automatic Radius"));
    m_isRadiusAutomatic->setObjectName("automaticRadius");
    m_isRadiusAutomatic->setToolTip(tr("Strike with a head as large as a steel ball of its mass"));
    m_isRadiusAutomatic->setStatusTip(m_isRadiusAutomatic->toolTip());
    section.addWide(m_isRadiusAutomatic);
    connect(m_isRadiusAutomatic, &QCheckBox::clicked, this, [this](bool isOn) {
        PlayToolSettings tools = m_controller.toolSettings();
        tools.isHammerRadiusAutomatic = isOn;
        m_controller.setToolSettings(tools);
    });
    m_hammerRadius =
        addField(section, tr("Head Radius"), tr("Radius of the patch that a blow strikes"), Units().lengths(),
                 ProjectNumber::HammerRadius, [](PlayToolSettings& tools) -> double& { return tools.hammerRadius; });
    m_lengths << m_hammerRadius;
}

NumberField* PlayToolsPanel::addField(Section& section, const QString& label, const QString& hint,
                                      const NumberFormat& format, ProjectNumber number,
                                      const std::function<double&(PlayToolSettings&)>& member) {
    auto* field = new NumberField;
    field->setRange(fieldRange(number));
    field->setFormat(format);
    section.addRow(label, field, hint);
    connect(field, &NumberField::edited, this, [this, member](double value) {
        PlayToolSettings tools = m_controller.toolSettings();
        member(tools) = value;
        m_controller.setToolSettings(tools);
    });
    connect(field, &NumberField::refused, this, &PlayToolsPanel::refused);
    m_fields.push_back({field, member});
    return field;
}

void PlayToolsPanel::setUnits(const Units& units) {
    for (NumberField* field : m_lengths + m_sizes) field->setFormat(units.lengths());
}

/// Lists the three basic shapes, then the project's assets.
void PlayToolsPanel::refreshAssets() {
    std::vector<std::pair<Id, std::string>> assets;
    for (const Asset& asset : m_document.project().assets) assets.emplace_back(asset.id, asset.name);
    if (m_kind->count() > 0 && assets == m_assets) return;
    m_assets = std::move(assets);
    m_kind->clear();
    m_kind->addItems({tr("Box"), tr("Ball"), tr("Plank")});
    for (const auto& [id, name] : m_assets) m_kind->addItem(nameText(name), id);
    PlayToolSettings tools = m_controller.toolSettings();
    if (tools.projectile.kind == ProjectileKind::Asset && !findAsset(m_document.project(), tools.projectile.asset)) {
        tools.projectile.kind = ProjectileKind::Box;
        m_controller.setToolSettings(tools);
    }
    refresh();
}

void PlayToolsPanel::applyKind(int index) {
    PlayToolSettings tools = m_controller.toolSettings();
    if (index < static_cast<int>(ProjectileKind::Asset)) {
        const Preset preset = presetOf(static_cast<ProjectileKind>(index));
        tools.projectile.kind = preset.kind;
        tools.projectile.size = preset.size;
        tools.projectile.mass = preset.mass;
    } else {
        tools.projectile.kind = ProjectileKind::Asset;
        tools.projectile.asset = m_kind->itemData(index).toUInt();
    }
    m_controller.setToolSettings(tools);
}

void PlayToolsPanel::refresh() {
    PlayToolSettings tools = m_controller.toolSettings();
    const bool isAsset = tools.projectile.kind == ProjectileKind::Asset;
    m_kind->setCurrentIndex(isAsset ? m_kind->findData(tools.projectile.asset)
                                    : static_cast<int>(tools.projectile.kind));
    for (const auto& [field, member] : m_fields) field->setValue(member(tools));
    const bool isBall = tools.projectile.kind == ProjectileKind::Ball;
    m_throw->setRowLabel(m_sizes.front(), isBall ? tr("Diameter") : tr("Width"));
    for (NumberField* field : m_sizes) m_throw->setRowVisible(field, !isAsset && (!isBall || field == m_sizes.front()));
    m_throw->setRowVisible(m_mass, !isAsset);
    m_isSpeedAutomatic->setChecked(tools.isSpeedAutomatic);
    m_throw->setRowVisible(m_speed, !tools.isSpeedAutomatic);
    m_throwsOnClick->setChecked(tools.throwsOnClick);
    m_isRadiusAutomatic->setChecked(tools.isHammerRadiusAutomatic);
    m_hammer->setRowVisible(m_hammerRadius, !tools.isHammerRadiusAutomatic);
}

}  // namespace rubble

#include "moc_PlayToolsPanel.cpp"
