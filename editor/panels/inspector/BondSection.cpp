#include "editor/panels/inspector/BondSection.h"

#include "core/asset/strength/BondStrength.h"
#include "core/asset/strength/Threshold.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/document/ShownText.h"
#include "editor/panels/inspector/PictureField.h"
#include "editor/widgets/ProjectRange.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace rubble {

namespace {

constexpr Id kEnteredImpulse = 1;  // sources of the impulse per area
constexpr Id kImpulseOfMaterial = 2;

constexpr double kMinFactorSlider = 0.1, kMaxFactorSlider = 10.0;

SliderField* factorField() {
    return new SliderField(fieldRange(ProjectNumber::BondStrength), kMinFactorSlider, kMaxFactorSlider,
                           SliderScale::Logarithmic);
}

}  // namespace

BondSection::BondSection(Document& document, const Selection& selection, QWidget* parent)
    : Section("bonds", tr("Bonds"), parent),
      m_document(document),
      m_selection(selection),
      m_form(
          document, [this] { return selected(); }, pushOf<Asset>(document)),
      m_cutNote(new QLabel(tr("The asset is not cut at the point of impact while it breaks as bonded."))) {
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    m_cutNote->setObjectName("cutNote");
    m_cutNote->setWordWrap(true);
    addWide(m_cutNote);
    buildImpulse();
    buildHits();
    buildSupport();
    m_heights = new HeightStrengthEditor(document);
    addWide(m_heights);
    connect(m_heights, &HeightStrengthEditor::refused, this, &BondSection::refused);
    buildPicture();
    addStrokeRow(BondBrush::Anchor, tr("Anchor brush"), tr("Remove all strokes of the anchor brush"),
                 tr("Clear Anchor Strokes"));
    addStrokeRow(BondBrush::Strength, tr("Strength brush"), tr("Remove all strokes of the strength brush"),
                 tr("Clear Strength Strokes"));
    addStrokeRow(BondBrush::NeverBreaks, tr("Never breaks"), tr("Remove all strokes that keep fragments from breaking"),
                 tr("Clear Never-Breaks Strokes"));
}

std::vector<Asset> BondSection::selected() const {
    const Asset* asset = findAsset(m_document.project(), m_selection.asset());
    return asset ? std::vector{*asset} : std::vector<Asset>{};
}

const Material& BondSection::materialOf(const Asset& asset) const {
    return *findMaterial(m_document.project(), asset.material);
}

template <class Control, class Number>
void BondSection::bindNumber(Control* control, const QString& text, Number Bonding::*member) {
    m_form.bind(
        control, text, [member](const Asset& asset) { return static_cast<double>(asset.bonding.*member); },
        [member](Asset& asset, double entered) { asset.bonding.*member = static_cast<Number>(entered); });
}

void BondSection::buildImpulse() {
    auto* source = addRow(tr("Bond strength"), new QComboBox,
                          tr("Enter the impulse per area, or derive it from the strength of the material"));
    source->addItem(tr("Entered"), kEnteredImpulse);
    source->addItem(tr("From material"), kImpulseOfMaterial);
    m_form.bind(
        source, tr("Set Source of Bond Strength"),
        [](const Asset& asset) { return asset.bonding.impulsePerArea ? kEnteredImpulse : kImpulseOfMaterial; },
        [this](Asset& asset, Id entered) {
            const double known = bondImpulseOf(asset, materialOf(asset));
            asset.bonding.impulsePerArea = entered == kEnteredImpulse ? std::optional(known) : std::nullopt;
        });
    m_impulse =
        addRow(tr("Impulse per area"),
               new SliderField(fieldRange(ProjectNumber::BondImpulse), 10.0, 100'000.0, SliderScale::Logarithmic),
               tr("Set the impulse that breaks a bond, by its area"));
    m_impulse->setFormat(Units::impulsesPerArea());
    m_form.bind(
        m_impulse, tr("Set Impulse per Area"),
        [this](const Asset& asset) { return bondImpulseOf(asset, materialOf(asset)); },
        [](Asset& asset, double entered) { asset.bonding.impulsePerArea = entered; });
    m_derivation = new QLabel;
    m_derivation->setObjectName("bondDerivation");
    m_derivation->setTextFormat(Qt::PlainText);
    m_derivation->setWordWrap(true);
    addWide(m_derivation);
}

void BondSection::buildHits() {
    m_radius = addRow(tr("Falloff radius"),
                      new SliderField(fieldRange(ProjectNumber::BondLoadRadius), 0.05, 5.0, SliderScale::Logarithmic),
                      tr("Limit the load of a hit to bonds within this distance"));
    bindNumber(m_radius, tr("Set Falloff Radius"), &Bonding::radius);
    auto* falloff = addRow(tr("Falloff curve"), new QComboBox,
                           tr("Set how the load of a hit decreases with the distance from its point"));
    falloff->addItem(tr("Constant"), static_cast<Id>(HitFalloff::Constant));
    falloff->addItem(tr("Linear"), static_cast<Id>(HitFalloff::Linear));
    falloff->addItem(tr("Smooth"), static_cast<Id>(HitFalloff::Smooth));
    m_form.bind(
        falloff, tr("Set Falloff Curve"), [](const Asset& asset) { return static_cast<Id>(asset.bonding.falloff); },
        [](Asset& asset, Id entered) { asset.bonding.falloff = static_cast<HitFalloff>(entered); });
    auto* damage =
        addRow(tr("Damage limit"), new SliderField(fieldRange(ProjectNumber::BondDamageFrom, 0.05), 0.05, 1.0),
               tr("Set the part of what a bond holds from which on a load weakens it"));
    damage->setFormat(Units::percents());
    bindNumber(damage, tr("Set Damage Limit"), &Bonding::damageFrom);
    addNote(
        tr("Bonds near a hit bear its load, less with the distance. One that bears more than it holds breaks; a load "
           "above the damage limit weakens it for the next hit."));
}

void BondSection::buildSupport() {
    m_span = addRow(tr("Maximum span"), new NumberField,
                    tr("Limit how far sideways of an anchor fragments are held, or enter 0 for any distance"));
    m_span->setRange(fieldRange(ProjectNumber::BondSpan));
    bindNumber(m_span, tr("Set Span"), &Bonding::span);
    auto* delay = addRow(tr("Collapse delay"), new NumberField,
                         tr("Set the time after which fragments that have lost their support break off"));
    delay->setFormat(Units::seconds());
    delay->setRange(fieldRange(ProjectNumber::BondCollapseDelay));
    bindNumber(delay, tr("Set Collapse Delay"), &Bonding::collapseDelay);
    auto* island =
        addRow(tr("Smallest island"), new SliderField(wholeFieldRange(ProjectNumber::BondMinimumIsland), 1, 20),
               tr("Let smaller groups of fragments fall apart"));
    bindNumber(island, tr("Set Smallest Island"), &Bonding::minimumIsland);
    addNote(
        tr("Fragments farther sideways of an anchor than the span come off. Fragments that come off together are an "
           "island; one with fewer falls apart."));
}

void BondSection::buildPicture() {
    m_picture = addRow(tr("Strength picture"), new PictureField,
                       tr("Multiply the strength of bonds by a greyscale picture, stretched to fit the outline"));
    m_picture->setClearable();
    connect(m_picture, &PictureField::refused, this, &BondSection::refused);
    connect(m_picture, &PictureField::reduced, this, &BondSection::refused);
    connect(m_picture, &PictureField::picked, this,
            [this](const PictureField::Picture& picture) { pushPicture(tr("Set Strength Picture"), picture); });
    connect(m_picture, &PictureField::cleared, this, [this] { pushPicture(tr("Clear Strength Picture"), nullptr); });
    m_pictureFactors = {addPictureFactor(tr("Darkest"), tr("Set the factor of strength where the picture is black"),
                                         tr("Set Darkest Strength"), &StrengthImage::darkest),
                        addPictureFactor(tr("Brightest"), tr("Set the factor of strength where the picture is white"),
                                         tr("Set Brightest Strength"), &StrengthImage::brightest)};
}

SliderField* BondSection::addPictureFactor(const QString& label, const QString& hint, const QString& text,
                                           double StrengthImage::*member) {
    auto* field = addRow(label, factorField(), hint);
    m_form.bind(
        field, text,
        [member](const Asset& asset) { return asset.bonding.strengthImage.value_or(StrengthImage{}).*member; },
        [member](Asset& asset, double entered) {
            if (asset.bonding.strengthImage) *asset.bonding.strengthImage.*member = entered;
        });
    return field;
}

/// Without a picture, its factors go, too.
void BondSection::pushPicture(const QString& text, const std::shared_ptr<const GreyImage>& picture) {
    for (Asset asset : selected()) {
        std::optional<StrengthImage>& strength = asset.bonding.strengthImage;
        if (!picture) {
            strength.reset();
        } else {
            if (!strength) strength.emplace();
            strength->image = picture;
        }
        m_document.push(modify(text, std::move(asset)));
    }
}

void BondSection::addStrokeRow(BondBrush brush, const QString& label, const QString& hint, const QString& text) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    const StrokeRow added{brush, new QLabel, new QPushButton(tr("Clear"))};
    layout->addWidget(added.count, 1);
    layout->addWidget(added.clear);
    addRow(label, row, tr("Number of strokes painted over the fragments"));
    added.clear->setAutoDefault(false);
    added.clear->setToolTip(hint);
    added.clear->setStatusTip(hint);
    added.clear->setAccessibleName(text);
    connect(added.clear, &QPushButton::clicked, this, [this, brush, text] {
        for (Asset asset : selected()) {
            std::erase_if(asset.bonding.strokes, [brush](const BondStroke& stroke) { return stroke.brush == brush; });
            m_document.push(modify(text, std::move(asset)));
        }
    });
    m_strokes.push_back(added);
}

/// Shows where a derived impulse comes from, or lets it be typed.
void BondSection::showImpulse(const Asset& asset) {
    const Material& material = materialOf(asset);
    const bool isDerived = !asset.bonding.impulsePerArea;
    const bool isKnown = !isDerived || derivedBondImpulse(asset, material).has_value();
    m_impulse->setEnabled(!isDerived);
    setRowVisible(m_impulse, isKnown);
    m_derivation->setVisible(isDerived);
    if (!isDerived) return;
    if (!isKnown) {
        return m_derivation->setText(tr("Material \"%1\" has no strength. Enter its strength, or the impulse per area.")
                                         .arg(nameText(material.name)));
    }
    m_derivation->setText(
        tr("%1 follows from the strength %2 and the contact time %3.")
            .arg(roundedQuantity(*derivedBondImpulse(asset, material), Units::impulsesPerArea(), locale()),
                 localizedQuantity(QuantityKind::Pressure, *material.tensileStrength, m_units, locale()),
                 localizedQuantity(QuantityKind::Time, asset.contactTime.value_or(kDefaultContactTime), m_units,
                                   locale())));
}

void BondSection::showPicture(const Asset& asset) {
    const std::optional<StrengthImage>& strength = asset.bonding.strengthImage;
    m_picture->setPicture(strength ? strength->image : nullptr);
    for (SliderField* factor : m_pictureFactors) setRowVisible(factor, strength && strength->image);
}

void BondSection::showStrokes(const Asset& asset) {
    for (const StrokeRow& row : m_strokes) {
        const auto count = std::ranges::count(asset.bonding.strokes, row.brush, &BondStroke::brush);
        row.count->setText(count == 0 ? tr("None") : tr("%Ln stroke(s)", nullptr, static_cast<int>(count)));
        row.clear->setEnabled(count > 0);
    }
}

void BondSection::setUnits(const Units& units) {
    m_units = units;
    m_radius->setFormat(units.lengths());
    m_span->setFormat(units.lengths());
    m_heights->setUnits(units);
}

void BondSection::refresh() {
    const std::vector<Asset> assets = selected();
    const bool isBonded = !assets.empty() && assets[0].breakAs == BreakAs::Bonded;
    setVisible(isBonded);
    if (!isBonded) return;
    m_form.refresh();
    m_cutNote->setVisible(assets[0].cutAtImpact.has_value());
    showImpulse(assets[0]);
    m_heights->refresh(m_selection.asset());
    showPicture(assets[0]);
    showStrokes(assets[0]);
}

}  // namespace rubble

#include "moc_BondSection.cpp"
