#include "editor/panels/inspector/MaterialPage.h"

#include "core/asset/strength/Threshold.h"
#include "editor/commands/Renaming.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/Buttons.h"
#include "editor/widgets/ProjectRange.h"
#include "editor/widgets/Section.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr double kMinDensity = 10.0;      // kg/m³, what the sliders span: foam ...
constexpr double kMaxDensity = 20'000.0;  // ... and gold
constexpr double kMinStrength = 1e4;      // Pa: crumbling mortar ...
constexpr double kMaxStrength = 2e9;      // ... and hard steel
constexpr double kMinToughness = 1e4;     // Pa·√m
constexpr double kMaxToughness = 2e8;     // ductile steel
constexpr double kMinModulus = 1e7;       // Pa: rubber ...
constexpr double kMaxModulus = 1e12;      // ... and diamond
constexpr double kMaxFriction = 1.5;      // rubber on stone

std::vector<Material> selectedMaterials(const Document& document, const Selection& selection) {
    const Material* material = findMaterial(document.project(), selection.material());
    return material ? std::vector{*material} : std::vector<Material>{};
}

/// Unknown values are shown as 0.
double shown(const std::optional<double>& number) { return number.value_or(0.0); }
std::optional<double> entered(double number) { return number > 0.0 ? std::optional(number) : std::nullopt; }

}  // namespace

/// In the order of Finish.
std::vector<ComboItem> MaterialPage::finishItems() {
    const QStringList texts{tr("Plain"), tr("Brick"),   tr("Concrete"), tr("Glass"), tr("Ice"),
                            tr("Metal"), tr("Plaster"), tr("Stone"),    tr("Tiles"), tr("Wood")};
    std::vector<ComboItem> items;
    for (const QString& text : texts) items.push_back({.id = static_cast<Id>(items.size()), .text = text});
    return items;
}

MaterialPage::MaterialPage(Document& document, const Selection& selection, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_form(
          document, [&] { return selectedMaterials(document, selection); }, pushOf<Material>(document)),
      m_section(new Section("material", tr("Material"), this)),
      m_crackLimit(new QLabel(this)),
      m_uses(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_section);
    layout->addStretch();
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    m_form.setFault([&document](const Material& material) {
        return nameFault(document.project(), Part::Material, material.id, QString::fromStdString(material.name));
    });
    bindName(*m_section);
    bindDynamics(*m_section);
    bindStrength(*m_section);
    bindColours(*m_section);
    m_section->addRow(tr("Used by"), m_uses, tr("Assets made of this material"));
    m_uses->setWordWrap(true);
    m_uses->setTextFormat(Qt::PlainText);
}

void MaterialPage::bindName(Section& section) {
    auto* name = section.addRow(tr("Name"), new QLineEdit, tr("Name of the material, also in exports"));
    m_form.bind(
        name, tr("Rename"), [](const Material& material) { return QString::fromStdString(material.name); },
        [](Material& material, const QString& entered) { material.name = entered.trimmed().toStdString(); });
}

void MaterialPage::bindDynamics(Section& section) {
    auto* density = section.addRow(
        tr("Density"),
        new SliderField(fieldRange(ProjectNumber::Density), kMinDensity, kMaxDensity, SliderScale::Logarithmic),
        tr("Mass per volume"));
    density->setFormat(Units::densities());
    m_form.bind(density, tr("Set Density"), &Material::density);
    auto* friction =
        section.addRow(tr("Friction"), new SliderField(fieldRange(ProjectNumber::Friction, 0.05), 0.0, kMaxFriction),
                       tr("Coefficient of friction: 0 for none, 0.6 for stone on stone"));
    m_form.bind(friction, tr("Set Friction"), &Material::friction);
    auto* restitution =
        section.addRow(tr("Restitution"), new SliderField(fieldRange(ProjectNumber::Restitution, 0.05), 0.0, 1.0),
                       tr("Coefficient of restitution: 0 for no bounce, 1 for a bounce to full height"));
    m_form.bind(restitution, tr("Set Restitution"), &Material::restitution);
}

void MaterialPage::bindColours(Section& section) {
    auto* outside = section.addRow(tr("Outside"), new ColourButton, tr("Colour of the unbroken surface"));
    m_form.bind(outside, tr("Set Outside Colour"), &Material::outside);
    auto* inside = section.addRow(tr("Inside"), new ColourButton, tr("Colour of fracture surfaces"));
    m_form.bind(inside, tr("Set Inside Colour"), &Material::inside);
    auto* finish = section.addRow(tr("Finish"), new QComboBox,
                                  tr("What the surfaces look like beyond their colours, in pictures"));
    setItems(*finish, finishItems());
    m_form.bind(
        finish, tr("Set Finish"), [](const Material& material) { return static_cast<Id>(material.finish); },
        [](Material& material, Id entered) { material.finish = static_cast<Finish>(entered); });
    const FieldRange range = fieldRange(ProjectNumber::Opacity, 0.05);
    auto* opacity = section.addRow(tr("Opacity"), new SliderField(range, range.min, range.max),
                                   tr("Opacity of the surfaces: 1 for opaque, 0.3 for clear glass"));
    m_form.bind(opacity, tr("Set Opacity"), &Material::opacity);
}

void MaterialPage::bindStrength(Section& section) {
    const auto add = [&](const QString& label, double from, double to, const NumberFormat& unit, const QString& hint,
                         const QString& step, ProjectNumber number, std::optional<double> Material::*member) {
        auto* field = section.addRow(
            label, new SliderField(optionalFieldRange(number), from, to, SliderScale::Logarithmic), hint);
        field->setFormat(unit);
        m_form.bind(
            field, step, [member](const Material& material) { return shown(material.*member); },
            [member](Material& material, double value) { material.*member = entered(value); });
    };
    add(tr("Strength"), kMinStrength, kMaxStrength, Units::megapascals(),
        tr("Tensile strength, from which thresholds of assets can be derived; 0 if unknown"),
        tr("Set Tensile Strength"), ProjectNumber::TensileStrength, &Material::tensileStrength);
    add(tr("Toughness"), kMinToughness, kMaxToughness, Units::toughnesses(),
        tr("Fracture toughness, the resistance to crack growth; 0 if unknown"), tr("Set Fracture Toughness"),
        ProjectNumber::FractureToughness, &Material::fractureToughness);
    add(tr("Stiffness"), kMinModulus, kMaxModulus, Units::gigapascals(),
        tr("Young's modulus, with which derived thresholds of thick assets include their inertia; 0 if unknown"),
        tr("Set Young's Modulus"), ProjectNumber::YoungsModulus, &Material::youngsModulus);
    section.addRow(tr("Crack limit"), m_crackLimit,
                   tr("Crack depth (toughness / strength)² / π above which toughness, not strength, decides when the "
                      "material breaks"));
}

void MaterialPage::setActions(const QList<QAction*>& actions) {
    for (QAction* action : actions) m_section->addWide(actionButton(action));
}

void MaterialPage::refresh() {
    m_form.refresh();
    const Material* material = findMaterial(m_document.project(), m_selection.material());
    const std::optional<double> limit = material != nullptr ? transitionCrackLength(*material) : std::nullopt;
    m_crackLimit->setText(limit ? localizedQuantity(QuantityKind::Length, *limit, m_units, locale()) : tr("Unknown"));
    QStringList users;
    for (const Asset& asset : m_document.project().assets) {
        if (asset.material == m_selection.material()) users.append(nameText(asset.name));
    }
    m_uses->setText(users.isEmpty() ? tr("No asset") : users.join(", "));
}

}  // namespace rubble

#include "moc_MaterialPage.cpp"
