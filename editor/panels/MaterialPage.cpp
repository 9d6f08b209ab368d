#include "editor/panels/MaterialPage.h"

#include "core/asset/Threshold.h"
#include "editor/commands/Renaming.h"
#include "editor/panels/Icons.h"
#include "editor/panels/LocalNumber.h"
#include "editor/panels/Section.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr double kLeastDensity = 10.0;      // kg/m^3, the slider's ends: foam ...
constexpr double kMostDensity = 20'000.0;   // ... and gold
constexpr double kLeastStrength = 1e4;      // Pa: crumbling mortar ...
constexpr double kMostStrength = 2e9;       // ... and hard steel
constexpr double kLeastToughness = 1e4;     // Pa·√m
constexpr double kMostToughness = 2e8;      // ductile steel
constexpr int kCrackDigits = 2;             // of a limit that follows from figures which scatter by half of them
constexpr double kMostUsualFriction = 1.5;  // the slider's end: rubber on stone

std::vector<Material> chosenMaterials(const Document& document, const Selection& selection) {
    const Material* material = findMaterial(document.project(), selection.material());
    return material ? std::vector{*material} : std::vector<Material>{};
}

/// A number that need not be told is shown as 0 where it is not.
double shown(const std::optional<double>& number) { return number.value_or(0.0); }
std::optional<double> entered(double number) { return number > 0.0 ? std::optional(number) : std::nullopt; }

QString textOf(const std::string& text) { return QString::fromStdString(text); }

}  // namespace

MaterialPage::MaterialPage(Document& document, const Selection& selection, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_form(
          document, [&] { return chosenMaterials(document, selection); }, pushOf<Material>(document)),
      m_section(new Section("material", tr("Material"), this)),
      m_crackLimit(new QLabel(this)),
      m_uses(new QLabel(this)) {
    auto* section = m_section;
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(section);
    layout->addStretch();

    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    m_form.setFault([&document](const Material& material) {
        return nameFault(document.project(), Part::Material, material.id, textOf(material.name));
    });
    auto* name = section->addRow(tr("Name"), new QLineEdit, tr("What the material is called, here and in exports"));
    m_form.bind(
        name, tr("Rename"), [](const Material& material) { return textOf(material.name); },
        [](Material& material, const QString& entered) { material.name = entered.trimmed().toStdString(); });

    auto* density = section->addRow(
        tr("Density"), new SliderField(FieldRange::aboveZero(), kLeastDensity, kMostDensity, SliderScale::Logarithmic),
        tr("Mass by volume; it makes fragments light or heavy"));
    density->setFormat({tr("kg/m³"), 0});
    m_form.bind(density, tr("Set density"), &Material::density);
    auto* friction =
        section->addRow(tr("Friction"), new SliderField(FieldRange{.min = 0.0, .step = 0.05}, 0.0, kMostUsualFriction),
                        tr("Coulomb's coefficient: 0 is ice without friction, 0.6 stone on stone"));
    m_form.bind(friction, tr("Set friction"), &Material::friction);
    auto* restitution = section->addRow(tr("Restitution"), new SliderField(FieldRange::zeroToOne(), 0.0, 1.0),
                                        tr("How much bodies bounce: 0 not at all, 1 as high as they fell from"));
    m_form.bind(restitution, tr("Set restitution"), &Material::restitution);
    bindStrength(*section);
    auto* outside = section->addRow(tr("Outside"), new ColourButton, tr("Colour of the surface of the whole"));
    m_form.bind(outside, tr("Set outside colour"), &Material::outside);
    auto* inside = section->addRow(tr("Inside"), new ColourButton, tr("Colour of the faces where it broke"));
    m_form.bind(inside, tr("Set inside colour"), &Material::inside);
    section->addRow(tr("Used by"), m_uses, tr("The assets that are made of this material"));
    m_uses->setWordWrap(true);
}

void MaterialPage::bindStrength(Section& section) {
    const auto add = [&](const QString& label, double from, double to, const QString& unit, const QString& hint,
                         const QString& step, std::optional<double> Material::*member) {
        auto* field =
            section.addRow(label, new SliderField(FieldRange::zeroOrAbove(), from, to, SliderScale::Logarithmic), hint);
        field->setFormat({unit, -6});
        m_form.bind(
            field, step, [member](const Material& material) { return shown(material.*member); },
            [member](Material& material, double number) { material.*member = entered(number); });
    };
    add(tr("Strength"), kLeastStrength, kMostStrength, tr("MPa"),
        tr("Tensile strength: thresholds of assets can follow from it; 0 where it is not known"),
        tr("Set tensile strength"), &Material::tensileStrength);
    add(tr("Toughness"), kLeastToughness, kMostToughness, tr("MPa√m"),
        tr("Fracture toughness: how well it withstands cracks; 0 where it is not known"), tr("Set fracture toughness"),
        &Material::fractureToughness);
    section.addRow(tr("Crack limit"), m_crackLimit,
                   tr("(toughness / strength)² / π: where scratches and cracks are deeper, toughness and not strength "
                      "decides; one four times as deep leaves half of the strength"));
}

void MaterialPage::setActions(const QList<QAction*>& actions) {
    for (QAction* action : actions) m_section->addWide(actionButton(action));
}

void MaterialPage::refresh() {
    m_form.refresh();
    const Material* material = findMaterial(m_document.project(), m_selection.material());
    const std::optional<double> limit = material != nullptr ? crackLimit(*material) : std::nullopt;
    const NumberFormat format{tr("mm"), 3};
    m_crackLimit->setText(limit ? withUnit(roundedText(*limit, kCrackDigits, format, locale()), format)
                                : tr("not known"));
    QStringList users;
    for (const Asset& asset : m_document.project().assets) {
        if (asset.material == m_selection.material()) users.append(textOf(asset.name));
    }
    m_uses->setText(users.isEmpty() ? tr("no asset") : users.join(", "));
}

}  // namespace rubble
