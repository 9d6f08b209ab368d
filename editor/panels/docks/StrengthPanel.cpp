#include "editor/panels/docks/StrengthPanel.h"

#include "core/asset/strength/BondStrength.h"
#include "core/asset/strength/Threshold.h"
#include "core/fracture/pattern/SeedEdits.h"
#include "core/play/analysis/RequirementImpulse.h"
#include "core/play/analysis/RequirementShot.h"
#include "editor/commands/InstanceEdits.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/document/ShownText.h"
#include "editor/panels/docks/IntervalBar.h"
#include "editor/panels/docks/RequirementPresets.h"
#include "editor/widgets/Buttons.h"
#include "editor/widgets/ComboBox.h"
#include "editor/widgets/NumberField.h"
#include "editor/widgets/ProjectRange.h"
#include "editor/widgets/Section.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "editor/widgets/numbers/NumberText.h"

#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

enum Column { kFirst, kSecond, kRest, kSelect, kPlay, kDelete, kColumns };

/// The first of the four grid rows of a requirement: outcome, event if the outcome has a number, the event's numbers,
/// figure.
int rowOf(std::size_t index) { return 4 * static_cast<int>(index); }

const FragmentSpeed& fastestOf(const SwapAudit& audit) {
    return audit.resting.speed > kCleanSpeed ? audit.resting : audit.lying;
}

}  // namespace

StrengthPanel::StrengthPanel(Document& document, Selection& selection, const Bakes& bakes, SwapAuditRunner& audits,
                             QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_bakes(bakes),
      m_audits(audits),
      m_title(new QLabel),
      m_bar(new IntervalBar),
      m_verdict(new QLabel),
      m_auditText(new QLabel) {
    auto* content = new QWidget;
    auto* rows = new QVBoxLayout(content);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    m_title->setContentsMargins(8, 6, 8, 2);
    rows->addWidget(m_title);
    rows->addWidget(makeRequirements());
    rows->addWidget(makeAudit());
    rows->addStretch(1);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(verticalScrollArea(content));
    connect(&document, &Document::changed, this, &StrengthPanel::refresh);
    connect(&selection, &Selection::assetChanged, this, &StrengthPanel::refresh);
    connect(&selection, &Selection::instancesChanged, this, &StrengthPanel::refresh);
    connect(&bakes, &Bakes::changed, this, &StrengthPanel::refresh);
    connect(&audits, &SwapAuditRunner::changed, this, &StrengthPanel::refreshAudit);
    connect(&audits, &SwapAuditRunner::failed, this, &StrengthPanel::refused);
    refresh();
}

void StrengthPanel::setUnits(const Units& units) {
    m_units = units;
    refresh();
}

QWidget* StrengthPanel::makeRequirements() {
    auto* section = new Section("requirements", tr("Requirements"));
    m_rows = new QWidget;
    m_grid = new QGridLayout(m_rows);
    m_grid->setContentsMargins(0, 0, 0, 0);
    section->addWide(m_rows);
    section->addWide(makeAddButton());
    section->addWide(m_bar);
    m_verdict->setWordWrap(true);
    m_verdict->setTextFormat(Qt::PlainText);
    section->addWide(m_verdict);
    m_apply = new QPushButton;
    m_apply->setObjectName("set-threshold");
    m_apply->setToolTip(tr("Set a threshold that meets all requirements"));
    connect(m_apply, &QPushButton::clicked, this, &StrengthPanel::applySuggested);
    section->addWide(m_apply);
    return section;
}

QToolButton* StrengthPanel::makeAddButton() {
    auto* button = new QToolButton;
    button->setObjectName("add-requirement");
    button->setIcon(iconNamed("add"));
    button->setText(tr("Add Requirement"));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setToolTip(tr("Add an event that the asset must survive, break in, or get a limited hole in"));
    auto* menu = new QMenu(button);
    const std::pair<QString, RequirementOutcome> outcomes[] = {
        {tr("Must &Survive"), RequirementOutcome::Survives},
        {tr("Must &Break"), RequirementOutcome::Breaks},
        {tr("Must Get at Most a &Hole"), RequirementOutcome::HoleAtMost}};
    for (const auto& [text, outcome] : outcomes) {
        QMenu* events = menu->addMenu(text);
        events->setToolTipsVisible(true);
        for (const RequirementPreset& preset : requirementPresets()) {
            QAction* action = events->addAction(preset.name);
            action->setToolTip(assumptionDescription(preset.event, false));
            connect(action, &QAction::triggered, this,
                    [this, added = StrengthRequirement{outcome, preset.event}] { addRequirement(added); });
        }
    }
    button->setMenu(menu);
    return button;
}

QWidget* StrengthPanel::makeAudit() {
    auto* section = new Section("audit", tr("Break Stability"));
    m_audit = new QPushButton(tr("Check Break Stability"));
    m_audit->setObjectName("check-break-stability");
    m_audit->setToolTip(tr("Check that fragments stay at rest when they replace the asset"));
    connect(m_audit, &QPushButton::clicked, this, [this] { m_audits.audit(m_selection.asset()); });
    section->addWide(m_audit);
    m_auditText->setWordWrap(true);
    m_auditText->setTextInteractionFlags(Qt::TextSelectableByMouse);
    section->addWide(m_auditText);
    m_fix = new QPushButton;
    m_fix->setObjectName("fix-break-stability");
    m_fix->setToolTip(tr("Delete the seed of the fastest fragment"));
    connect(m_fix, &QPushButton::clicked, this, &StrengthPanel::deleteFaultySeed);
    section->addWide(m_fix);
    return section;
}

const Asset* StrengthPanel::asset() const { return findAsset(m_document.project(), m_selection.asset()); }

void StrengthPanel::refresh() {
    const Asset* shown = asset();
    m_title->setText(shown ? tr("<b>%1</b>").arg(nameText(shown->name).toHtmlEscaped()) : tr("No asset selected"));
    setEnabled(shown != nullptr);
    m_suggested.reset();
    m_whole.reset();
    m_bar->setVisible(shown != nullptr);
    if (!shown) return refreshAudit();
    std::optional<ThresholdInterval> interval;
    const auto baked = m_bakes.find(shown->id);
    if (baked && baked->bake && isSameShape(*baked->asset, *shown)) {
        if (Result<PlayAsset> whole = wholePlayAsset(*shown, baked->bake)) {
            m_whole = std::move(*whole);
            const Result<ThresholdInterval> found = intervalOf(*shown, baked->bake);
            if (found) interval = *found;
            m_verdict->setText(found ? QString() : QString::fromStdString(found.error().message));
        }
    }
    refreshRows(*shown, interval ? &*interval : nullptr);
    m_bar->setVisible(hasThreshold(m_document.project(), *shown));
    m_bar->setInterval(shown->requirements, interval.value_or(ThresholdInterval{}), strengthOf(*shown));
    if (interval) {
        m_suggested = interval->suggested();
        m_verdict->setText(verdict(*shown, *interval).replace("/m²", "/\u2060m²"));  // on one line
    }
    m_apply->setVisible(m_suggested.has_value());
    if (m_suggested) {
        m_apply->setText((interval->isPerArea ? tr("Set Impulse per Area to %1") : tr("Set Threshold to %1"))
                             .arg(shownStrength(*shown, *m_suggested)));
    }
    refreshAudit();
}

/// The threshold of an asset, N·s, or where it breaks along bonds its impulse per area, N·s/m².
double StrengthPanel::strengthOf(const Asset& asset) const {
    const Project& project = m_document.project();
    return hasThreshold(project, asset) ? thresholdOf(project, asset)
                                        : bondImpulseOf(asset, *findMaterial(project, asset.material));
}

QString StrengthPanel::shownStrength(const Asset& asset, double strength) const {
    const QString text = localizedQuantity(QuantityKind::Impulse, strength);
    return hasThreshold(m_document.project(), asset) ? text : text + tr("/m²");
}

Result<ThresholdInterval> StrengthPanel::intervalOf(const Asset& asset, const std::shared_ptr<const Bake>& bake) const {
    if (hasThreshold(m_document.project(), asset)) return thresholdInterval(m_document.project(), *m_whole);
    if (asset.requirements.empty()) return ThresholdInterval{.isPerArea = true};
    Result<std::shared_ptr<const PlayAsset>> ready = playAsset(asset, bake, {}, FindContacts::OnBreak);
    return ready ? bondInterval(m_document.project(), std::move(*ready)) : ready.error();
}

QString StrengthPanel::verdict(const Asset& asset, const ThresholdInterval& interval) const {
    if (const std::optional<std::string> conflict = conflictText(asset, interval))
        return QString::fromStdString(*conflict);
    const bool isPerArea = interval.isPerArea;
    if (asset.requirements.empty())
        return isPerArea ? tr("No requirements: any impulse per area is valid.")
                         : tr("No requirements: any threshold is valid.");
    const QString must = QString::fromStdString(intervalText(interval));
    if (interval.contains(strengthOf(asset)))
        return (isPerArea ? tr("The impulse per area is valid: %1.") : tr("The threshold is valid: %1.")).arg(must);
    return (isPerArea ? tr("The impulse per area is not valid: it must be %1.")
                      : tr("The threshold is not valid: it must be %1."))
        .arg(must);
}

/// Rebuilds the rows if what they show has changed.
void StrengthPanel::refreshRows(const Asset& asset, const ThresholdInterval* interval) {
    Shown shown{.asset = asset.id,
                .requirements = asset.requirements,
                .impulses = interval ? interval->impulses : std::vector<double>{},
                .threshold = strengthOf(asset),
                .units = m_units};
    for (const StrengthRequirement& requirement : asset.requirements) {
        shown.assumptions.append(assumption(asset, requirement));
        const Instance* tried = instanceToTry(m_document.project(), asset, requirement, selectedInstance());
        shown.tried.push_back(tried ? tried->id : 0);
    }
    if (shown == m_shown) return;
    m_shown = std::move(shown);
    while (QLayoutItem* item = m_grid->takeAt(0)) {
        if (item->widget()) item->widget()->deleteLater();
        delete item;
    }
    for (std::size_t k = 0; k < asset.requirements.size(); ++k) {
        addRow(k, asset.requirements[k]);
        addFigure(asset, k);
        addSelectButton(asset, k);
        addPlayButton(asset, k);
    }
    m_grid->setColumnStretch(kRest, 1);
    m_rows->setVisible(!asset.requirements.empty());
}

void StrengthPanel::addRow(std::size_t index, const StrengthRequirement& requirement) {
    addOutcomeBox(index, requirement.outcome);
    const int row = rowOf(index);
    const bool isHole = requirement.outcome == RequirementOutcome::HoleAtMost;
    const auto addLabel = [&](const QString& event, const QString& inEvent) {
        if (isHole) {
            m_grid->addWidget(new QLabel(inEvent), row + 1, kFirst, 1, kColumns);
        } else {
            m_grid->addWidget(new QLabel(event), row, kSecond, 1, 2);
        }
    };
    if (isHole) {
        addField(row, kSecond, index, ProjectNumber::ExpectedHole, requirement.hole, m_units.lengths(), tr("Hole"),
                 [](StrengthRequirement& changed, double to) { changed.hole = to; });
    }
    if (const auto* drop = std::get_if<DropRequirement>(&requirement.event)) {
        addLabel(tr("a drop of"), tr("in a drop of"));
        addField(row + 2, kFirst, index, ProjectNumber::DropHeight, drop->height, m_units.lengths(), tr("Height"),
                 [](StrengthRequirement& changed, double to) { std::get<DropRequirement>(changed.event).height = to; });
    } else if (const auto* impact = std::get_if<ImpulseRequirement>(&requirement.event)) {
        addLabel(tr("an impulse of"), tr("in an impulse of"));
        addField(
            row + 2, kFirst, index, ProjectNumber::Threshold, impact->impulse, Units::impulses(), tr("Impulse"),
            [](StrengthRequirement& changed, double to) { std::get<ImpulseRequirement>(changed.event).impulse = to; });
    } else {
        const auto& hit = std::get<HitRequirement>(requirement.event);
        addLabel(tr("an impact of"), tr("in an impact of"));
        addField(row + 2, kFirst, index, ProjectNumber::Mass, hit.mass, Units::masses(), tr("Mass"),
                 [](StrengthRequirement& changed, double to) { std::get<HitRequirement>(changed.event).mass = to; });
        addField(row + 2, kSecond, index, ProjectNumber::HitSpeed, hit.speed, Units::speeds(), tr("Speed"),
                 [](StrengthRequirement& changed, double to) { std::get<HitRequirement>(changed.event).speed = to; });
    }
    addDeleteButton(index);
}

void StrengthPanel::addOutcomeBox(std::size_t index, RequirementOutcome outcome) {
    QComboBox* box = comboBox({tr("Survives"), tr("Breaks in"), tr("Hole up to")},
                              tr("Whether the asset must survive, break, or lose no more than a hole of this width"));
    box->setCurrentIndex(static_cast<int>(outcome));
    box->setAccessibleName(tr("Outcome"));
    connect(box, &QComboBox::activated, this, [this, index](int row) {
        change(tr("Change Requirement"),
               [=](Asset& changed) { changed.requirements[index].outcome = static_cast<RequirementOutcome>(row); });
    });
    m_grid->addWidget(box, rowOf(index), kFirst);
}

/// Connections are queued, since each change rebuilds the rows.
void StrengthPanel::addField(int row, int column, std::size_t index, ProjectNumber number, double value,
                             const NumberFormat& format, const QString& name,
                             const std::function<void(StrengthRequirement& changed, double value)>& set) {
    auto* field = new NumberField;
    field->setRange(fieldRange(number));
    field->setFormat(format);
    field->setValue(value);
    field->setAccessibleName(name);
    field->setToolTip(name);
    connect(field, &NumberField::refused, this, &StrengthPanel::refused);
    const auto apply = [this, index, set](double entered) {
        change(tr("Change Requirement"), [=](Asset& changed) { set(changed.requirements[index], entered); });
    };
    connect(field, &NumberField::edited, this, apply, Qt::QueuedConnection);
    m_grid->addWidget(field, row, column);
}

/// What the figure assumes and, for a hit on an asset that is free to move, what is left of it at a corner.
QString StrengthPanel::assumption(const Asset& asset, const StrengthRequirement& requirement) const {
    if (std::holds_alternative<ImpulseRequirement>(requirement.event) && !hasThreshold(m_document.project(), asset))
        return tr("on the centre of the front");
    const AssetSupport support = supportOf(m_document.project(), asset, requirement);
    const QString text = assumptionText(requirement.event, support == AssetSupport::Fixed);
    const auto* hit = std::get_if<HitRequirement>(&requirement.event);
    if (!hit || !m_whole || support == AssetSupport::Fixed) return text;
    const double fraction = cornerFraction(m_document.project(), *m_whole, *hit, support);
    const long percent = std::lround(100.0 * fraction);
    return percent < 100 ? tr("%1; %L2\u00a0% of it at a corner").arg(text).arg(percent) : text;
}

/// The impulse of the event, its ratio to the threshold, and what they assume.
void StrengthPanel::addFigure(const Asset& asset, std::size_t index) {
    QString text = m_shown.assumptions[static_cast<int>(index)];
    if (!m_shown.impulses.empty() && std::isfinite(m_shown.impulses[index])) {
        const double impulse = m_shown.impulses[index];
        text =
            tr("%1 = %2×: %3").arg(shownStrength(asset, impulse), roundedText(impulse / m_shown.threshold, {}), text);
    }
    auto* label = new QLabel(text);
    const StrengthRequirement& requirement = asset.requirements[index];
    const bool isFixed = supportOf(m_document.project(), asset, requirement) == AssetSupport::Fixed;
    label->setToolTip(
        (hasThreshold(m_document.project(), asset)
             ? tr("The impulse on the asset and its ratio to the threshold: it breaks from 1× on.")
             : tr("The impulse per area at which a bond breaks, and its ratio to that of the asset: a bond "
                  "breaks from 1× on.")) +
        ' ' + assumptionDescription(requirement.event, isFixed));
    label->setWordWrap(true);
    m_grid->addWidget(label, rowOf(index) + 3, kFirst, 1, kColumns);
}

void StrengthPanel::addPlayButton(const Asset& asset, std::size_t index) {
    const RequirementEvent& event = asset.requirements[index].event;
    const Id tried = m_shown.tried[index];
    const bool needsInstance = !std::holds_alternative<DropRequirement>(event);
    QString tip = tr("Start the simulation with exactly this event");
    if (needsInstance && tried == 0) tip = tr("No instance of the asset in the scene can break");
    if (const Instance* instance = needsInstance ? findInstance(m_document.project(), tried) : nullptr) {
        tip = tr("Start the simulation with exactly this hit on \"%1\"").arg(nameText(instance->name));
        if (instance->threshold) {
            tip +=
                tr(", whose own threshold is %1").arg(localizedQuantity(QuantityKind::Impulse, *instance->threshold));
        }
    }
    QToolButton* button = panelButton("play-shot", tr("Play Event"), tip, m_rows);
    button->setObjectName("play-event");
    button->setEnabled(m_whole.has_value() && (!needsInstance || tried != 0));
    connect(
        button, &QToolButton::clicked, this, [this, index] { play(index); }, Qt::QueuedConnection);
    m_grid->addWidget(button, rowOf(index), kPlay);
}

Id StrengthPanel::selectedInstance() const {
    return m_selection.instances().empty() ? 0 : *m_selection.instances().begin();
}

void StrengthPanel::play(std::size_t index) {
    const Asset* played = asset();
    if (!played || !m_whole || index >= played->requirements.size()) return;
    const StrengthRequirement& requirement = played->requirements[index];
    const Instance* instance = findInstance(m_document.project(), m_shown.tried[index]);
    const Result<ShotAction> shot = requirementShot(m_document.project(), *m_whole, requirement, instance);
    if (!shot) return emit refused(QString::fromStdString(shot.error().message));
    const bool isDrop = std::holds_alternative<DropRequirement>(requirement.event);
    emit trialRequested({.name = shotNameOf(requirement.event).toStdString(), .action = *shot},
                        instance != nullptr && !isDrop ? instance->id : Id{0});
}

void StrengthPanel::addSelectButton(const Asset& asset, std::size_t index) {
    if (hasThreshold(m_document.project(), asset)) return;
    QToolButton* button = panelButton("select-neighbours", tr("Select What Comes Off"),
                                      tr("Select the fragments that come off in this event"), m_rows);
    button->setObjectName("select-lost");
    button->setEnabled(m_whole.has_value());
    connect(
        button, &QToolButton::clicked, this, [this, index] { selectLost(index); }, Qt::QueuedConnection);
    m_grid->addWidget(button, rowOf(index), kSelect);
}

void StrengthPanel::selectLost(std::size_t index) {
    const Asset* shown = asset();
    const auto baked = shown != nullptr ? m_bakes.find(shown->id) : nullptr;
    if (!baked || !baked->bake || !m_whole || index >= shown->requirements.size()) return;
    Result<std::shared_ptr<const PlayAsset>> ready = playAsset(*shown, baked->bake, {}, FindContacts::OnBreak);
    if (!ready) return emit refused(QString::fromStdString(ready.error().message));
    const Result<std::vector<std::uint32_t>> lost =
        fragmentsLost(m_document.project(), std::move(*ready), shown->requirements[index]);
    if (!lost) return emit refused(QString::fromStdString(lost.error().message));
    if (lost->empty()) emit refused(tr("Nothing comes off in this event."));
    FragmentSet set(baked->bake->fragmentCount());
    for (const std::uint32_t fragment : *lost) set[fragment] = true;
    m_selection.setFragments(selectionOf(set, *baked->bake));
}

void StrengthPanel::addDeleteButton(std::size_t index) {
    QToolButton* button = panelButton("remove", tr("Delete Requirement"), tr("Delete this requirement"), m_rows);
    const auto remove = [this, index] {
        change(tr("Delete Requirement"), [=](Asset& changed) {
            changed.requirements.erase(changed.requirements.begin() + static_cast<std::ptrdiff_t>(index));
        });
    };
    connect(button, &QToolButton::clicked, this, remove, Qt::QueuedConnection);
    m_grid->addWidget(button, rowOf(index), kDelete);
}

void StrengthPanel::change(const QString& text, const std::function<void(Asset&)>& change) {
    if (asset() == nullptr) return;
    Asset changed = *asset();
    change(changed);
    if (!m_document.push(modify(text, std::move(changed)))) refresh();
}

void StrengthPanel::addRequirement(const StrengthRequirement& requirement) {
    change(tr("Add Requirement"), [&](Asset& changed) { changed.requirements.push_back(requirement); });
}

void StrengthPanel::applySuggested() {
    if (!m_suggested) return;
    if (hasThreshold(m_document.project(), *asset())) {
        change(tr("Set Threshold"), [threshold = *m_suggested](Asset& changed) { enterThreshold(changed, threshold); });
    } else {
        change(tr("Set Impulse per Area"),
               [strength = *m_suggested](Asset& changed) { changed.bonding.impulsePerArea = strength; });
    }
}

void StrengthPanel::refreshAudit() {
    const SwapAudit* audit = asset() != nullptr ? m_audits.auditOf(asset()->id) : nullptr;
    m_audit->setEnabled(!m_audits.isPending());
    m_audit->setText(m_audits.isPending() ? tr("Checking…") : tr("Check Break Stability"));
    m_fix->setVisible(faultySeed().has_value());
    if (faultySeed()) m_fix->setText(tr("Delete Seed %1").arg(QString::fromStdString(faultySeed()->text())));
    if (const Error* error = asset() != nullptr ? m_audits.errorOf(asset()->id) : nullptr)
        return m_auditText->setText(QString::fromStdString(error->message).toHtmlEscaped());
    if (audit == nullptr) return m_auditText->setText(tr("Not checked since the last change"));
    QStringList lines{audit->isClean() ? tr("<b>Passed</b>") : tr("<b>Failed</b>")};
    for (const Diagnostic& diagnostic : audit->diagnostics) {
        if (diagnostic.severity != Severity::Note) lines << QString::fromStdString(diagnostic.message).toHtmlEscaped();
    }
    lines << tr("%Ln fragment(s), touching pairs: %L1, deepest overlap: %2", nullptr,
                static_cast<int>(audit->fragments))
                 .arg(audit->contacts)
                 .arg(localizedQuantity(QuantityKind::Length, audit->deepestOverlap, m_units));
    const QString floating = localizedQuantity(QuantityKind::Speed, audit->resting.speed);
    lines << (audit->lying.fragment.empty()
                  ? tr("Highest speed after %1 steps, floating: %2").arg(kAuditSteps).arg(floating)
                  : tr("Highest speed after %1 steps: floating %2, lying on the ground %3")
                        .arg(kAuditSteps)
                        .arg(floating, localizedQuantity(QuantityKind::Speed, audit->lying.speed)));
    if (!audit->exported.fragment.empty()) {
        const QString gap = localizedQuantity(QuantityKind::Length, audit->exported.gap, m_units);
        lines << (audit->exported.gap < kEngineGap
                      ? tr("Other engines: exported hulls are only %1 apart at fragment %2; set a gap")
                            .arg(gap, QString::fromStdString(audit->exported.fragment))
                      : tr("Other engines: exported hulls are at least %1 apart, so that fragments stay at rest")
                            .arg(gap));
    }
    lines << tr("Relative change in flight: mass %1, momentum %2, angular momentum %3, energy %4")
                 .arg(roundedText(audit->massDrift, {}), roundedText(audit->momentumDrift, {}),
                      roundedText(audit->angularDrift, {}), roundedText(audit->energyGain, {}));
    m_auditText->setText(lines.join("<br>"));
}

std::optional<SeedId> StrengthPanel::faultySeed() const {
    const SwapAudit* audit = asset() != nullptr ? m_audits.auditOf(asset()->id) : nullptr;
    const auto baked = asset() != nullptr ? m_bakes.findPattern(asset()->id) : nullptr;
    if (audit == nullptr || audit->isClean() || !baked) return std::nullopt;
    const std::optional<PieceName> name = pieceNameOf(childOnPath({}, fastestOf(*audit).place.path));
    if (!name || !name->cells.empty() || std::ranges::find(baked->seeds.ids, name->seed) == baked->seeds.ids.end()) {
        return std::nullopt;
    }
    return name->seed;
}

void StrengthPanel::deleteFaultySeed() {
    if (const std::optional<SeedId> seed = faultySeed()) {
        change(tr("Delete Seed"), [&](Asset& changed) { deleteSeed(changed.pattern, *seed); });
    }
}

}  // namespace rubble

#include "moc_StrengthPanel.cpp"
