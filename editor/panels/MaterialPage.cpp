#include "editor/panels/MaterialPage.h"

#include "editor/commands/Renaming.h"
#include "editor/panels/Section.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr double kLeastDensity = 10.0;      // kg/m^3, the slider's ends: foam ...
constexpr double kMostDensity = 20'000.0;   // ... and gold
constexpr double kMostUsualFriction = 1.5;  // the slider's end: rubber on stone

std::vector<Material> chosenMaterials(const Document& document, const Selection& selection) {
    const Material* material = findMaterial(document.project(), selection.material());
    return material ? std::vector{*material} : std::vector<Material>{};
}

QString textOf(const std::string& text) { return QString::fromStdString(text); }

}  // namespace

MaterialPage::MaterialPage(Document& document, const Selection& selection, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_form(
          document, [&] { return chosenMaterials(document, selection); }, pushOf<Material>(document)),
      m_uses(new QLabel(this)) {
    auto* section = new Section("material", tr("Material"), this);
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
    auto* outside = section->addRow(tr("Outside"), new ColourButton, tr("Colour of the surface of the whole"));
    m_form.bind(outside, tr("Set outside colour"), &Material::outside);
    auto* inside = section->addRow(tr("Inside"), new ColourButton, tr("Colour of the faces where it broke"));
    m_form.bind(inside, tr("Set inside colour"), &Material::inside);
    section->addRow(tr("Used by"), m_uses, tr("The assets that are made of this material"));
    m_uses->setWordWrap(true);
}

void MaterialPage::refresh() {
    m_form.refresh();
    QStringList users;
    for (const Asset& asset : m_document.project().assets) {
        if (asset.material == m_selection.material()) users.append(textOf(asset.name));
    }
    m_uses->setText(users.isEmpty() ? tr("no asset") : users.join(", "));
}

}  // namespace rubble
