#include "editor/panels/inspector/AssetPage.h"

#include "core/asset/strength/Threshold.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/commands/Renaming.h"
#include "editor/commands/Resizing.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/Buttons.h"
#include "editor/widgets/ProjectRange.h"
#include "editor/widgets/SliderField.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace rubble {

namespace {

constexpr Id kEntered = 1;  // sources of the threshold
constexpr Id kDerived = 2;

constexpr Id kBreakWhole = 0;  // ways to break
constexpr Id kBreakBonded = 1;
constexpr Id kBreakCut = 2;

Id wayToBreak(const Asset& asset) {
    if (asset.breakAs == BreakAs::Bonded) return kBreakBonded;
    return asset.cutAtImpact ? kBreakCut : kBreakWhole;
}

void setWayToBreak(Asset& asset, Id way) {
    asset.breakAs = way == kBreakBonded ? BreakAs::Bonded : BreakAs::Whole;
    if (way == kBreakWhole) asset.cutAtImpact.reset();
    if (way == kBreakCut && !asset.cutAtImpact) asset.cutAtImpact = CutAtImpact();
}

Id sourceOf(const Asset& asset) { return asset.contactTime ? kDerived : kEntered; }

bool isRectangle(const Ring& ring) {
    const Box2 box = boundsOf(ring);
    return ring.size() == 4 && std::ranges::all_of(ring, [&](Vec2 point) {
               return (point.x == box.min.x || point.x == box.max.x) && (point.y == box.min.y || point.y == box.max.y);
           });
}

}  // namespace

AssetPage::AssetPage(Document& document, Selection& selection, const Bakes& bakes, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_form(
          document, [this] { return selected(); }, pushOf<Asset>(document)) {
    m_asset = new Section("asset", tr("Asset"), this);
    auto* shape = new Section("shape", tr("Shape"), this);
    m_bonds = new BondSection(document, selection, this);
    m_clusters = new ClusterSection(document, selection, bakes, this);
    m_fragments = new FragmentSection(document, selection, bakes, this);
    m_shaping = new ShapingSection(document, selection, this);
    auto* pattern = new Section("pattern", tr("Pattern"), this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    for (Section* section : {m_asset, static_cast<Section*>(m_fragments), static_cast<Section*>(m_bonds),
                             static_cast<Section*>(m_clusters), shape, static_cast<Section*>(m_shaping), pattern})
        layout->addWidget(section);
    layout->addStretch();
    m_form.setFault([this](const Asset& value) { return faultOf(value); });
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    buildAsset(*m_asset);
    buildShape(*shape);
    m_pattern = new PatternEditor(document);
    pattern->addWide(m_pattern);
    connect(m_pattern, &PatternEditor::refused, this, &AssetPage::refused);
    connect(m_bonds, &BondSection::refused, this, &AssetPage::refused);
    connect(m_clusters, &ClusterSection::refused, this, &AssetPage::refused);
    connect(m_fragments, &FragmentSection::refused, this, &AssetPage::refused);
    connect(m_shaping, &ShapingSection::refused, this, &AssetPage::refused);
}

std::vector<Asset> AssetPage::selected() const {
    const Asset* asset = findAsset(m_document.project(), m_selection.asset());
    return asset ? std::vector{*asset} : std::vector<Asset>{};
}

QString AssetPage::faultOf(const Asset& asset) const {
    const QString name = nameFault(m_document.project(), Part::Asset, asset.id, QString::fromStdString(asset.name));
    if (!name.isEmpty()) return name;
    if (!asset.isPrism()) return {};
    const Result<Prism> prism = validated(asset.prism());
    return prism ? QString() : QString::fromStdString(prism.error().message);
}

void AssetPage::buildAsset(Section& section) {
    auto* name = section.addRow(tr("Name"), new QLineEdit, tr("Name of the asset, also in exports"));
    m_form.bind(
        name, tr("Rename"), [](const Asset& asset) { return QString::fromStdString(asset.name); },
        [](Asset& asset, const QString& entered) { asset.name = entered.trimmed().toStdString(); });
    m_material = section.addRow(tr("Material"), new QComboBox, tr("Material of the asset"));
    m_form.bind(m_material, tr("Set Material"), &Asset::material);
    buildBreakAs(section);
    buildThreshold(section);
    auto* scale =
        section.addRow(tr("Inside UV scale"), new NumberField, tr("Texture repeats per metre on fracture surfaces"));
    scale->setFormat(Units::perMetre());
    scale->setRange(fieldRange(ProjectNumber::InsideUvScale));
    m_form.bind(scale, tr("Set Inside UV Scale"), &Asset::insideUvScale);
    m_inside = section.addRow(tr("Inside material"), new QComboBox,
                              tr("Material shown on fracture surfaces; the mass follows from the asset's material"));
    m_form.bind(m_inside, tr("Set Inside Material"), &Asset::insideMaterial);
    m_texture =
        section.addRow(tr("Texture"), createTexture(), tr("Image of the outside, times the colour of the material"));
}

/// The name of the texture, and a button that removes it.
QWidget* AssetPage::createTexture() {
    auto* row = new QWidget;
    auto* layout = new QVBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    m_textureText = new QLabel;
    m_textureText->setObjectName("texture");
    m_textureText->setTextFormat(Qt::PlainText);
    m_textureText->setWordWrap(true);
    auto* remove = new QPushButton(tr("Remove Texture"));
    remove->setObjectName("removeTexture");
    remove->setAutoDefault(false);
    remove->setToolTip(tr("Show the outside in the colour of the material alone"));
    remove->setStatusTip(remove->toolTip());
    layout->addWidget(m_textureText);
    layout->addWidget(remove, 0, Qt::AlignLeft);
    connect(remove, &QPushButton::clicked, this, [this] {
        for (Asset asset : selected()) {
            asset.texture.reset();
            m_document.push(modify(tr("Remove Texture"), std::move(asset)));
        }
    });
    return row;
}

void AssetPage::showTexture(const Asset& asset) {
    m_asset->setRowVisible(m_texture, asset.texture.has_value());
    if (asset.texture) m_textureText->setText(QString::fromStdString(textureText(*asset.texture)));
}

void AssetPage::buildThreshold(Section& section) {
    m_threshold = section.addRow(tr("Threshold"), thresholdField(), tr("Impulse at which the asset breaks"));
    m_form.bind(
        m_threshold, tr("Set Threshold"),
        [this](const Asset& asset) { return thresholdOf(m_document.project(), asset); },
        [](Asset& asset, double entered) { asset.threshold = entered; });
    m_sources = section.addRow(tr("Source"), new QComboBox,
                               tr("Whether the threshold is entered or derived from the strength"));
    setItems(*m_sources, {{kEntered, tr("Entered"), {}}, {kDerived, tr("Derived from strength"), {}}});
    m_form.bind(m_sources, tr("Set Threshold Source"), sourceOf, [this](Asset& asset, Id source) {
        if (source == sourceOf(asset)) return;
        enterThreshold(asset, thresholdOf(m_document.project(), asset));  // keeps its value when it becomes entered
        if (source == kDerived) deriveThreshold(asset);
    });
    m_contactTime = section.addRow(tr("Contact time"), new NumberField,
                                   tr("Duration of an impact; the longer it is, the larger the impulse that breaks"));
    m_contactTime->setFormat(Units::milliseconds());
    m_contactTime->setRange(fieldRange(ProjectNumber::ContactTime));
    m_form.bind(
        m_contactTime, tr("Set Contact Time"),
        [](const Asset& asset) { return asset.contactTime.value_or(kDefaultContactTime); },
        [](Asset& asset, double entered) { asset.contactTime = entered; });
    m_derivation = new QLabel;
    m_derivation->setTextFormat(Qt::PlainText);
    m_derivation->setObjectName("derivation");
    m_derivation->setWordWrap(true);
    section.addWide(m_derivation);
}

void AssetPage::buildBreakAs(Section& section) {
    auto* breakAs = section.addRow(tr("Break as"), new QComboBox,
                                   tr("Set whether a hit breaks the asset into all of its fragments, only bonds "
                                      "between them, or cuts it anew"));
    breakAs->addItem(tr("Whole"), kBreakWhole);
    breakAs->addItem(tr("Bonded"), kBreakBonded);
    breakAs->addItem(tr("Cut where hit"), kBreakCut);
    m_form.bind(breakAs, tr("Set How It Breaks"), wayToBreak, setWayToBreak);
    m_breakNote = section.addNote();
    m_breakNote->setObjectName("breakNote");
    m_cutFragments = section.addRow(tr("Cut fragments"),
                                    new SliderField(wholeFieldRange(ProjectNumber::ImpactFragments), 10.0, 200.0),
                                    tr("Number of fragments into which a hit cuts the asset"));
    m_form.bind(
        m_cutFragments, tr("Set Fragments of Cut"),
        [](const Asset& asset) { return static_cast<double>(asset.cutAtImpact.value_or(CutAtImpact()).fragments); },
        [](Asset& asset, double entered) {
            if (asset.cutAtImpact) asset.cutAtImpact->fragments = static_cast<std::uint32_t>(entered);
        });
    m_cutRadius = section.addRow(
        tr("Cut radius"),
        new SliderField(fieldRange(ProjectNumber::ImpactFalloffRadius), 0.05, 2.0, SliderScale::Logarithmic),
        tr("Distance from the hit within which half of the fragments lie"));
    m_form.bind(
        m_cutRadius, tr("Set Radius of Cut"),
        [](const Asset& asset) { return asset.cutAtImpact.value_or(CutAtImpact()).falloffRadius; },
        [](Asset& asset, double entered) {
            if (asset.cutAtImpact) asset.cutAtImpact->falloffRadius = entered;
        });
}

/// Says how the asset breaks, and shows what belongs to it.
void AssetPage::showWayToBreak(const Asset& asset) {
    const Id way = wayToBreak(asset);
    m_breakNote->setText(way == kBreakBonded ? tr("A hit breaks the bonds near it. What is no longer held comes off.")
                         : way == kBreakCut
                             ? tr("A hit that reaches the threshold cuts it into cells around the point of impact, not "
                                  "along the pattern. Exports have the fragments of the pattern.")
                             : tr("A hit that reaches the threshold breaks it into all of its fragments at once."));
    for (QWidget* field : {m_cutFragments, m_cutRadius}) m_asset->setRowVisible(field, way == kBreakCut);
}

/// Shows the formula of a derived threshold, or lets the threshold be typed. Bonds have strengths instead, which follow
/// from the contact time unless they are entered.
void AssetPage::showThreshold(const Asset& asset) {
    const bool isBonded = asset.breakAs == BreakAs::Bonded;
    m_asset->setRowVisible(m_threshold, !isBonded);
    m_asset->setRowVisible(m_sources, !isBonded);
    if (isBonded) {
        m_derivation->hide();
        return m_asset->setRowVisible(m_contactTime, !asset.bonding.impulsePerArea);
    }
    const Material& material = *findMaterial(m_document.project(), asset.material);
    const bool isDerived = derivedThreshold(asset, material).has_value();
    m_threshold->setEnabled(!isDerived);
    m_asset->setRowVisible(m_contactTime, asset.contactTime.has_value());
    const auto text = [&](QuantityKind kind, double value) {
        return localizedQuantity(kind, value, m_units, locale());
    };
    if (!asset.contactTime) {
        Asset derived = asset;
        deriveThreshold(derived);
        const std::optional<double> other = derivedThreshold(derived, material);
        m_derivation->setVisible(other.has_value());
        if (other) m_derivation->setText(tr("From its strength: %1").arg(text(QuantityKind::Impulse, *other)));
        return;
    }
    m_derivation->setVisible(true);
    if (!isDerived) {
        return m_derivation->setText(
            tr("Material \"%1\" has no strength, so the entered threshold is used. Enter its strength.")
                .arg(nameText(material.name)));
    }
    const QString strength = text(QuantityKind::Pressure, *material.tensileStrength);
    const QString threshold = text(QuantityKind::Impulse, thresholdOf(asset, material));
    const BendingStrength bending = *bendingStrength(asset, material);
    const QString sentence =
        bending.isByInertia
            ? tr("%1 follows from the strength %2, the thickness %3 and a load of %4, as the asset's inertia gives it.")
            : tr("%1 follows from the strength %2, the thickness %3 and a load of %4, as the contact time gives it.");
    m_derivation->setToolTip(
        tr("Threshold = strength × thickness² × duration ÷ %1").arg(locale().toString(kBendingRatio)));
    m_derivation->setText(sentence.arg(threshold, strength, text(QuantityKind::Length, bending.thickness),
                                       text(QuantityKind::Time, bending.duration)));
}

void AssetPage::setLibraryAction(QAction* action) { m_asset->addWide(actionButton(action)); }

void AssetPage::buildShape(Section& section) {
    m_summary = new QLabel;
    m_summary->setWordWrap(true);
    m_summary->setToolTip(tr("Outline, area, volume and mass of the unbroken asset"));
    section.addWide(m_summary);
    const QStringList names{tr("Width"), tr("Height"), tr("Depth")};
    const QStringList hints{tr("Size of the outline along x"), tr("Size of the outline along y"),
                            tr("Thickness of the prism along z")};
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = section.addRow(names[axis], new NumberField, hints[axis]);
        field->setRange(fieldRange(axis == 2 ? ProjectNumber::PrismDepth : ProjectNumber::OutlineSize));
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
    const Material* material = findMaterial(m_document.project(), asset.material);
    if (const ClosedMesh* mesh = asset.mesh()) {
        return tr("%1 · %2 · %3")
            .arg(tr("%Ln triangle(s)", nullptr, static_cast<int>(mesh->mesh.triangles.size())),
                 roundedQuantity(mesh->mass.volume, m_units.volumes(), locale()),
                 localizedQuantity(QuantityKind::Mass, mesh->mass.volume * (material ? material->density : 0.0),
                                   m_units, locale()));
    }
    const Polygon& outline = asset.prism().outline;
    const double size = area(outline);
    const double mass = size * asset.prism().depth * (material ? material->density : 0.0);
    QString kind = isRectangle(outline.outer) ? tr("Rectangle")
                                              : tr("%Ln point(s)", nullptr, static_cast<int>(outline.outer.size()));
    if (outline.outer.size() == 3) kind = tr("Triangle");
    if (!outline.holes.empty()) kind += ", " + tr("%Ln hole(s)", nullptr, static_cast<int>(outline.holes.size()));
    return tr("%1 · %2 · %3 · %4")
        .arg(kind, roundedQuantity(size, m_units.areas(), locale()),
             roundedQuantity(size * asset.prism().depth, m_units.volumes(), locale()),
             localizedQuantity(QuantityKind::Mass, mass, m_units, locale()));
}

void AssetPage::setUnits(const Units& units) {
    m_units = units;
    for (NumberField* field : m_size) field->setFormat(units.lengths());
    m_cutRadius->setFormat(units.lengths());
    m_bonds->setUnits(units);
    m_outline->setUnits(units);
    m_shaping->setUnits(units);
    m_pattern->setUnits(units);
}

void AssetPage::refresh() {
    std::vector<ComboItem> materials;
    for (const Material& material : m_document.project().materials) {
        materials.push_back({material.id, nameText(material.name), material.outside});
    }
    setItems(*m_material, materials);
    std::vector<ComboItem> insides{{0, tr("Same as Asset"), {}}};
    for (const Material& material : m_document.project().materials) {
        insides.push_back({material.id, nameText(material.name), material.inside});
    }
    setItems(*m_inside, insides);
    m_form.refresh();
    const std::vector<Asset> assets = selected();
    m_summary->setText(assets.empty() ? QString() : summary(assets.front()));
    if (!assets.empty()) {
        showWayToBreak(assets.front());
        showThreshold(assets.front());
        showTexture(assets.front());
    }
    m_outline->refresh(m_selection.asset());
    const Asset* shown = findAsset(m_document.project(), m_selection.asset());
    m_outline->setVisible(shown && shown->isPrism());
    m_fragments->refresh();
    m_bonds->refresh();
    m_clusters->refresh();
    m_shaping->refresh();
    m_pattern->refresh(m_selection.asset(), m_selection.enteredFragment());
}

}  // namespace rubble

#include "moc_AssetPage.cpp"
