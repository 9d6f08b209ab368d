#include "editor/panels/ToolsPanel.h"

#include "editor/panels/NumberField.h"
#include "editor/panels/Scrolled.h"
#include "editor/panels/Section.h"

#include <QComboBox>
#include <QVBoxLayout>

namespace rubble {

namespace {

struct Preset {
    ProjectileKind kind;
    Vec3 size;    // m
    double mass;  // kg
};

/// What a kind of projectile is when it is chosen: of concrete, steel and wood.
Preset presetOf(ProjectileKind kind) {
    switch (kind) {
        case ProjectileKind::Ball: return {kind, Vec3(0.4), 260.0};
        case ProjectileKind::Plank: return {kind, {0.25, 0.06, 2.5}, 25.0};
        default: return {kind, Vec3(0.6), 200.0};
    }
}

}  // namespace

ToolsPanel::ToolsPanel(const Document& document, PlayController& controller, QWidget* parent)
    : QWidget(parent), m_document(document), m_controller(controller), m_kind(new QComboBox) {
    auto* content = new QWidget;
    auto* rows = new QVBoxLayout(content);
    rows->setContentsMargins(0, 0, 0, 0);
    m_throw = new Section("throw", tr("Throw (F)"));
    addThrow(*m_throw);
    rows->addWidget(m_throw);
    auto* hammer = new Section("hammer", tr("Hammer (H)"));
    addField(*hammer, tr("Impulse"), tr("How hard a blow is"), tr("N·s"),
             [](PlayTools& tools) -> double& { return tools.blow; });
    rows->addWidget(hammer);
    auto* blast = new Section("blast", tr("Blast (X)"));
    addField(*blast, tr("Impulse"), tr("What a blast gives to each square metre that is turned to it, at 1 m"),
             tr("N·s"), [](PlayTools& tools) -> double& { return tools.blast.impulse; });
    addField(*blast, tr("Radius"), tr("How far a blast reaches"), tr("m"),
             [](PlayTools& tools) -> double& { return tools.blast.radius; });
    rows->addWidget(blast);
    auto* grip = new Section("grip", tr("Grab (drag)"));
    addField(*grip, tr("Force"), tr("How strong the hand is that drags things about"), tr("N"),
             [](PlayTools& tools) -> double& { return tools.grip; });
    rows->addWidget(grip);
    rows->addStretch(1);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(scrolled(content));
    connect(&document, &Document::changed, this, &ToolsPanel::offerAssets);
    connect(&controller, &PlayController::toolsChanged, this, &ToolsPanel::show);
    offerAssets();
}

void ToolsPanel::addThrow(Section& section) {
    section.addRow(tr("What"), m_kind, tr("What is thrown"));
    m_kind->setObjectName("projectile");
    connect(m_kind, &QComboBox::activated, this, &ToolsPanel::takeKind);
    const std::array labels{tr("Width"), tr("Height"), tr("Length")};
    for (int axis = 0; axis < 3; ++axis) {
        m_sizes << addField(section, labels[static_cast<std::size_t>(axis)], tr("The size of what is thrown"), tr("m"),
                            [axis](PlayTools& tools) -> double& { return tools.thrown.size[axis]; });
    }
    m_mass = addField(section, tr("Mass"), tr("How heavy what is thrown is"), tr("kg"),
                      [](PlayTools& tools) -> double& { return tools.thrown.mass; });
    addField(section, tr("Full speed"),
             tr("How fast it flies when F was held for a second; after a tap at a fifth of it"), tr("m/s"),
             [](PlayTools& tools) -> double& { return tools.thrown.speed; });
}

NumberField* ToolsPanel::addField(Section& section, const QString& label, const QString& hint, const QString& unit,
                                  const std::function<double&(PlayTools&)>& member) {
    auto* field = new NumberField;
    field->setRange(FieldRange::aboveZero());
    field->setFormat({.unit = unit});
    section.addRow(label, field, hint);
    connect(field, &NumberField::edited, this, [this, member](double value) {
        PlayTools tools = m_controller.tools();
        member(tools) = value;
        m_controller.setTools(tools);
    });
    connect(field, &NumberField::refused, this, &ToolsPanel::refused);
    m_fields.push_back({field, member});
    return field;
}

void ToolsPanel::setUnits(const Units& units) {
    for (NumberField* field : m_sizes) field->setFormat(units.lengths());
}

/// The three plain kinds, then the project's assets.
void ToolsPanel::offerAssets() {
    std::vector<std::pair<Id, std::string>> assets;
    for (const Asset& asset : m_document.project().assets) assets.emplace_back(asset.id, asset.name);
    if (m_kind->count() > 0 && assets == m_offered) return;
    m_offered = std::move(assets);
    m_kind->clear();
    m_kind->addItems({tr("Box"), tr("Ball"), tr("Plank")});
    for (const auto& [id, name] : m_offered) m_kind->addItem(QString::fromStdString(name), id);
    PlayTools tools = m_controller.tools();
    if (tools.thrown.kind == ProjectileKind::Asset && !findAsset(m_document.project(), tools.thrown.asset)) {
        tools.thrown.kind = ProjectileKind::Box;
        m_controller.setTools(tools);
    }
    show();
}

void ToolsPanel::takeKind(int index) {
    PlayTools tools = m_controller.tools();
    if (index < static_cast<int>(ProjectileKind::Asset)) {
        const Preset preset = presetOf(static_cast<ProjectileKind>(index));
        tools.thrown.kind = preset.kind;
        tools.thrown.size = preset.size;
        tools.thrown.mass = preset.mass;
    } else {
        tools.thrown.kind = ProjectileKind::Asset;
        tools.thrown.asset = m_kind->itemData(index).toUInt();
    }
    m_controller.setTools(tools);
}

void ToolsPanel::show() {
    PlayTools tools = m_controller.tools();
    const bool isAsset = tools.thrown.kind == ProjectileKind::Asset;
    m_kind->setCurrentIndex(isAsset ? m_kind->findData(tools.thrown.asset) : static_cast<int>(tools.thrown.kind));
    for (const auto& [field, member] : m_fields) field->setValue(member(tools));
    for (NumberField* field : m_sizes) {
        const bool isDiameter = tools.thrown.kind == ProjectileKind::Ball && field != m_sizes.front();
        m_throw->setRowVisible(field, !isAsset && !isDiameter);
    }
    m_throw->setRowVisible(m_mass, !isAsset);
}

}  // namespace rubble
