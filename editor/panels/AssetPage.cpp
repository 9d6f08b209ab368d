#include "editor/panels/AssetPage.h"

#include "core/asset/Threshold.h"
#include "editor/commands/Renaming.h"
#include "editor/commands/Resizing.h"
#include "editor/panels/Icons.h"
#include "editor/panels/ThresholdField.h"

#include <QLabel>
#include <QVBoxLayout>

namespace rubble {

namespace {

constexpr Id kTyped = 1;  // choices of where the threshold is from
constexpr Id kDerived = 2;
constexpr int kSummaryDigits = 4;

QString textOf(const std::string& text) { return QString::fromStdString(text); }

bool isRectangle(const Ring& ring) {
    const Box2 box = boundsOf(ring);
    return ring.size() == 4 && std::ranges::all_of(ring, [&](Vec2 point) {
               return (point.x == box.min.x || point.x == box.max.x) && (point.y == box.min.y || point.y == box.max.y);
           });
}

}  // namespace

AssetPage::AssetPage(Document& document, const Selection& selection, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_form(
          document, [this] { return chosen(); }, pushOf<Asset>(document)) {
    m_asset = new Section("asset", tr("Asset"), this);
    auto* shape = new Section("shape", tr("Shape"), this);
    m_shaping = new ShapingSection(document, selection, this);
    auto* pattern = new Section("pattern", tr("Pattern"), this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    for (Section* section : {m_asset, shape, static_cast<Section*>(m_shaping), pattern}) layout->addWidget(section);
    layout->addStretch();
    m_form.setFault([this](const Asset& value) { return faultOf(value); });
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    buildAsset(*m_asset);
    buildShape(*shape);
    m_pattern = new PatternEditor(document);
    pattern->addWide(m_pattern);
    connect(m_pattern, &PatternEditor::refused, this, &AssetPage::refused);
    connect(m_shaping, &ShapingSection::refused, this, &AssetPage::refused);
}

std::vector<Asset> AssetPage::chosen() const {
    const Asset* asset = findAsset(m_document.project(), m_selection.asset());
    return asset ? std::vector{*asset} : std::vector<Asset>{};
}

QString AssetPage::faultOf(const Asset& asset) const {
    const QString name = nameFault(m_document.project(), Part::Asset, asset.id, textOf(asset.name));
    if (!name.isEmpty()) return name;
    const Result<Prism> prism = validated(asset.prism);
    return prism ? QString() : textOf(prism.error().message);
}

void AssetPage::buildAsset(Section& section) {
    auto* name = section.addRow(tr("Name"), new QLineEdit, tr("What the asset is called, here and in exports"));
    m_form.bind(
        name, tr("Rename"), [](const Asset& asset) { return textOf(asset.name); },
        [](Asset& asset, const QString& entered) { asset.name = entered.trimmed().toStdString(); });
    m_material = section.addRow(tr("Material"), new QComboBox, tr("What the asset is made of"));
    m_form.bind(m_material, tr("Set material"), &Asset::material);
    buildThreshold(section);
    auto* scale = section.addRow(tr("Inside UVs"), new NumberField,
                                 tr("How often a texture repeats in a metre of the faces where it broke"));
    scale->setFormat({tr("per m"), 0});
    scale->setRange(FieldRange::aboveZero());
    m_form.bind(scale, tr("Set inside UV scale"), &Asset::insideUvScale);
    m_inside =
        section.addRow(tr("Inside"), new QComboBox,
                       tr("Of which material the faces look where it broke; it weighs what its own material weighs"));
    m_form.bind(m_inside, tr("Set inside material"), &Asset::insideMaterial);
}

void AssetPage::buildThreshold(Section& section) {
    m_threshold = section.addRow(tr("Threshold"), thresholdField(), tr("The impulse of a blow at which it breaks"));
    m_form.bind(
        m_threshold, tr("Set threshold"),
        [this](const Asset& asset) { return thresholdOf(m_document.project(), asset); },
        [](Asset& asset, double entered) { asset.threshold = entered; });
    auto* source =
        section.addRow(tr("From"), new QComboBox, tr("Whether the threshold is typed or follows from strength"));
    offer(*source, {{kTyped, tr("Typed"), {}}, {kDerived, tr("Derived from strength"), {}}});
    m_form.bind(
        source, tr("Set source of threshold"), [](const Asset& asset) { return asset.contactTime ? kDerived : kTyped; },
        [this](Asset& asset, Id chosen) {
            if (asset.contactTime && chosen == kDerived) return;
            asset.threshold = thresholdOf(m_document.project(), asset);  // typed from now on, it stays what it was
            asset.contactTime.reset();
            if (chosen == kDerived) asset.contactTime = kUsualContactTime;
        });
    m_contactTime =
        section.addRow(tr("Contact"), new NumberField,
                       tr("How long a blow presses: the threshold is strength × smallest section × this time"));
    m_contactTime->setFormat({tr("ms"), 3});
    m_contactTime->setRange(FieldRange::aboveZero());
    m_form.bind(
        m_contactTime, tr("Set contact time"),
        [](const Asset& asset) { return asset.contactTime.value_or(kUsualContactTime); },
        [](Asset& asset, double entered) { asset.contactTime = entered; });
    m_derivation = new QLabel;
    m_derivation->setObjectName("derivation");
    m_derivation->setWordWrap(true);
    section.addWide(m_derivation);
}

/// Whether the threshold can be typed, and how it follows where it cannot.
void AssetPage::showThreshold(const Asset& asset) {
    const Material& material = *findMaterial(m_document.project(), asset.material);
    const bool isDerived = derivedThreshold(asset, material).has_value();
    m_threshold->setEnabled(!isDerived);
    m_asset->setRowVisible(m_contactTime, asset.contactTime.has_value());
    m_derivation->setVisible(asset.contactTime.has_value());
    if (!asset.contactTime) return;
    const auto text = [&](double value, const NumberFormat& format) {
        return withUnit(roundedText(value, kSummaryDigits, format, locale()), format);
    };
    if (!isDerived) {
        return m_derivation->setText(
            tr("The material \"%1\" tells no strength: the typed threshold is in force.").arg(textOf(material.name)));
    }
    m_derivation->setText(
        tr("%1 × %2 × %3 = %4")
            .arg(text(*material.tensileStrength, {tr("MPa"), -6}), text(smallestSection(asset.prism), m_units.areas()),
                 text(*asset.contactTime, {tr("ms"), 3}), text(thresholdOf(asset, material), {tr("N·s"), 0})));
}

void AssetPage::setLibraryAction(QAction* action) { m_asset->addWide(actionButton(action)); }

void AssetPage::buildShape(Section& section) {
    m_summary = new QLabel;
    m_summary->setWordWrap(true);
    m_summary->setToolTip(tr("The outline, and what the whole weighs"));
    section.addWide(m_summary);
    const QStringList names{tr("Width"), tr("Height"), tr("Depth")};
    const QStringList hints{tr("Stretches the outline along x"), tr("Stretches the outline along y"),
                            tr("How thick the prism is, along z")};
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = section.addRow(names[axis], new NumberField, hints[axis]);
        field->setRange(FieldRange::aboveZero());
        m_form.bind(
            field, tr("Resize"), [axis](const Asset& asset) { return sizeOf(asset)[axis]; },
            [axis](Asset& asset, double entered) {
                Vec3 size = sizeOf(asset);
                size[axis] = entered;
                asset = resized(std::move(asset), size);
            });
        m_size[static_cast<std::size_t>(axis)] = field;
    }
    m_outline = new OutlineEditor(m_document);
    section.addWide(m_outline);
    connect(m_outline, &OutlineEditor::refused, this, &AssetPage::refused);
}

QString AssetPage::summary(const Asset& asset) const {
    const Polygon& outline = asset.prism.outline;
    const auto text = [&](double value, const NumberFormat& format) {
        return withUnit(roundedText(value, kSummaryDigits, format, locale()), format);
    };
    const double size = area(outline);
    const Material* material = findMaterial(m_document.project(), asset.material);
    const double mass = size * asset.prism.depth * (material ? material->density : 0.0);
    QString kind = isRectangle(outline.outer) ? tr("Rectangle") : tr("%1 points").arg(outline.outer.size());
    if (outline.outer.size() == 3) kind = tr("Triangle");
    if (outline.holes.size() == 1) kind = tr("%1, one hole").arg(kind);
    if (outline.holes.size() > 1) kind = tr("%1, %2 holes").arg(kind).arg(outline.holes.size());
    return tr("%1 · %2 · %3 · %4")
        .arg(kind, text(size, m_units.areas()), text(size * asset.prism.depth, m_units.volumes()),
             text(mass, {tr("kg"), 0}));
}

void AssetPage::setUnits(const Units& units) {
    m_units = units;
    for (NumberField* field : m_size) field->setFormat(units.lengths());
    m_outline->setUnits(units);
    m_shaping->setUnits(units);
    m_pattern->setUnits(units);
}

void AssetPage::refresh() {
    std::vector<Choice> materials;
    for (const Material& material : m_document.project().materials) {
        materials.push_back({material.id, textOf(material.name), material.outside});
    }
    offer(*m_material, materials);
    std::vector<Choice> insides{{0, tr("As the asset"), {}}};
    for (const Material& material : m_document.project().materials) {
        insides.push_back({material.id, textOf(material.name), material.inside});
    }
    offer(*m_inside, insides);
    m_form.refresh();
    const std::vector<Asset> assets = chosen();
    m_summary->setText(assets.empty() ? QString() : summary(assets.front()));
    if (!assets.empty()) showThreshold(assets.front());
    m_outline->refresh(m_selection.asset());
    m_shaping->refresh();
    m_pattern->refresh(m_selection.asset(), m_selection.inside());
}

}  // namespace rubble
