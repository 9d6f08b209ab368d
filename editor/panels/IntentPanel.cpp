#include "editor/panels/IntentPanel.h"

#include "core/asset/Threshold.h"
#include "core/fracture/SeedEdits.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/icons/Icon.h"
#include "editor/panels/IntervalBar.h"
#include "editor/panels/NumberField.h"
#include "editor/panels/Scrolled.h"
#include "editor/panels/Section.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

QString textOf(const std::string& text) { return QString::fromStdString(text); }

QString number(double value, const char* unit) { return QLocale().toString(value, 'g', 3) + ' ' + unit; }

const PieceSpeed& fastestOf(const SwapAudit& audit) {
    return audit.resting.speed > kCleanSpeed ? audit.resting : audit.lying;
}

}  // namespace

IntentPanel::IntentPanel(Document& document, const Selection& selection, const Bakes& bakes, AssetTrials& trials,
                         QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_bakes(bakes),
      m_trials(trials),
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
    rows->addWidget(makeIntents());
    rows->addWidget(makeAudit());
    rows->addStretch(1);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(scrolled(content));
    connect(&document, &Document::changed, this, &IntentPanel::fill);
    connect(&selection, &Selection::assetChanged, this, &IntentPanel::fill);
    connect(&bakes, &Bakes::changed, this, &IntentPanel::fill);
    connect(&trials, &AssetTrials::changed, this, &IntentPanel::showAudit);
    connect(&trials, &AssetTrials::said, this, &IntentPanel::refused);
    fill();
}

QWidget* IntentPanel::makeIntents() {
    auto* section = new Section("intents", tr("What it is to take"));
    m_rows = new QWidget;
    m_grid = new QGridLayout(m_rows);
    m_grid->setContentsMargins(0, 0, 0, 0);
    section->addWide(m_rows);
    auto* add = new QToolButton;
    add->setIcon(iconNamed("add"));
    add->setText(tr("Add Sentence"));
    add->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    add->setPopupMode(QToolButton::InstantPopup);
    add->setToolTip(tr("Say something that it is to survive, or to break by"));
    auto* menu = new QMenu(add);
    const std::pair<QString, Intent> kinds[] = {
        {tr("Survives a &drop"), {IntentOutcome::Survives, DropIntent{}}},
        {tr("&Breaks by a drop"), {IntentOutcome::Breaks, DropIntent{.height = 3.0}}},
        {tr("Survives being &hit"), {IntentOutcome::Survives, HitIntent{}}},
        {tr("Breaks when &it is hit"), {IntentOutcome::Breaks, HitIntent{.speed = 20.0}}}};
    for (const auto& [text, intent] : kinds) {
        connect(menu->addAction(text), &QAction::triggered, this, [this, added = intent] { addIntent(added); });
    }
    add->setMenu(menu);
    section->addWide(add);
    section->addWide(m_bar);
    m_verdict->setWordWrap(true);
    section->addWide(m_verdict);
    m_use = new QPushButton;
    m_use->setObjectName("use-threshold");
    m_use->setToolTip(tr("Take a threshold that fits all sentences, with room to either side"));
    connect(m_use, &QPushButton::clicked, this, &IntentPanel::useSuggested);
    section->addWide(m_use);
    return section;
}

QWidget* IntentPanel::makeAudit() {
    auto* section = new Section("audit", tr("Is its swap clean?"));
    m_audit = new QPushButton(tr("Audit Swap"));
    m_audit->setObjectName("audit-swap");
    m_audit->setToolTip(tr("Measure what happens when the whole is exchanged for its pieces and nothing pushes them"));
    connect(m_audit, &QPushButton::clicked, this, [this] { m_trials.audit(m_selection.asset()); });
    section->addWide(m_audit);
    m_auditText->setWordWrap(true);
    m_auditText->setTextInteractionFlags(Qt::TextSelectableByMouse);
    section->addWide(m_auditText);
    m_fix = new QPushButton;
    m_fix->setObjectName("fix-swap");
    m_fix->setToolTip(tr("Delete the seed of the piece that moves by itself, and audit again when it is baked"));
    connect(m_fix, &QPushButton::clicked, this, &IntentPanel::deleteFaultySeed);
    section->addWide(m_fix);
    return section;
}

const Asset* IntentPanel::asset() const { return findAsset(m_document.project(), m_selection.asset()); }

void IntentPanel::fill() {
    const Asset* at = asset();
    m_title->setText(at != nullptr ? tr("<b>%1</b>").arg(textOf(at->name).toHtmlEscaped())
                                   : tr("No asset is at hand."));
    setEnabled(at != nullptr);
    m_suggested.reset();
    m_bar->setVisible(at != nullptr);
    if (at == nullptr) return;
    std::optional<ThresholdInterval> interval;
    const auto baked = m_bakes.find(at->id);
    if (baked && baked->bake && baked->asset->prism == at->prism) {
        if (const Result<PlayAsset> whole = playWhole(*at, baked->bake)) {
            const Result<ThresholdInterval> found = thresholdInterval(m_document.project(), *whole);
            if (found) interval = *found;
            m_verdict->setText(found ? QString() : textOf(found.error().message));
        }
    }
    fillRows(*at, interval ? &*interval : nullptr);
    const double threshold = thresholdOf(m_document.project(), *at);
    m_bar->setInterval(at->intents, interval.value_or(ThresholdInterval{}), threshold);
    if (interval) {
        const std::optional<std::string> conflict = conflictText(*at, *interval);
        m_suggested = interval->suggested();
        if (conflict) {
            m_verdict->setText(textOf(*conflict));
        } else if (at->intents.empty()) {
            m_verdict->setText(tr("Any threshold fits as long as nothing is asked of it."));
        } else {
            m_verdict->setText((interval->contains(threshold) ? tr("Its threshold fits: %1.")
                                                              : tr("Its threshold does not fit: it must be %1."))
                                   .arg(textOf(intervalText(*interval))));
        }
    }
    m_use->setVisible(m_suggested.has_value());
    if (m_suggested) m_use->setText(tr("Use %1").arg(textOf(impulseText(*m_suggested))));
    showAudit();
}

/// Two rows a sentence, made anew where they say something else: they are few.
void IntentPanel::fillRows(const Asset& asset, const ThresholdInterval* interval) {
    Shown shown{asset.id, asset.intents, interval != nullptr ? interval->impulses : std::vector<double>{}};
    if (shown == m_shown) return;
    m_shown = std::move(shown);
    while (QLayoutItem* item = m_grid->takeAt(0)) {
        if (item->widget() != nullptr) item->widget()->deleteLater();
        delete item;
    }
    for (std::size_t k = 0; k < asset.intents.size(); ++k) addRow(static_cast<int>(k), asset, k, interval);
    m_grid->setColumnStretch(2, 1);
    m_rows->setVisible(!asset.intents.empty());
}

void IntentPanel::addRow(int row, const Asset& asset, std::size_t index, const ThresholdInterval* interval) {
    const Intent& intent = asset.intents[index];
    auto* outcome = new QComboBox;
    outcome->addItems({tr("survives"), tr("breaks by")});
    outcome->setCurrentIndex(static_cast<int>(intent.outcome));
    outcome->setAccessibleName(tr("What it does"));
    connect(outcome, &QComboBox::activated, this, [this, index](int chosen) {
        change(tr("Change sentence"),
               [=](Asset& changed) { changed.intents[index].outcome = static_cast<IntentOutcome>(chosen); });
    });
    m_grid->addWidget(outcome, 2 * row, 0);
    const auto addField = [&](int column, double value, const QString& unit, const QString& name, auto set) {
        auto* field = new NumberField;
        field->setRange(FieldRange::aboveZero());
        field->setFormat({.unit = unit});
        field->setValue(value);
        field->setAccessibleName(name);
        field->setToolTip(name);
        connect(field, &NumberField::refused, this, &IntentPanel::refused);
        connect(
            field, &NumberField::edited, this,
            [this, index, set](double entered) {
                change(tr("Change sentence"), [=](Asset& changed) { set(changed.intents[index], entered); });
            },
            Qt::QueuedConnection);  // the row is made anew by it
        m_grid->addWidget(field, 2 * row + 1, column);
    };
    if (const auto* drop = std::get_if<DropIntent>(&intent.event)) {
        m_grid->addWidget(new QLabel(tr("a drop of")), 2 * row, 1);
        addField(0, drop->height, tr("m"), tr("Height"),
                 [](Intent& changed, double value) { std::get<DropIntent>(changed.event).height = value; });
    } else {
        const auto& hit = std::get<HitIntent>(intent.event);
        m_grid->addWidget(new QLabel(tr("a hit by")), 2 * row, 1);
        addField(0, hit.mass, tr("kg"), tr("Mass"),
                 [](Intent& changed, double value) { std::get<HitIntent>(changed.event).mass = value; });
        addField(1, hit.speed, tr("m/s"), tr("Speed"),
                 [](Intent& changed, double value) { std::get<HitIntent>(changed.event).speed = value; });
    }
    if (interval != nullptr) {
        auto* impulse = new QLabel(textOf(impulseText(interval->impulses[index])));
        impulse->setToolTip(tr("How hard that hits it"));
        impulse->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_grid->addWidget(impulse, 2 * row + 1, 2, 1, 2);
    }
    auto* remove = new QToolButton;
    remove->setIcon(iconNamed("remove"));
    remove->setAutoRaise(true);
    remove->setToolTip(tr("Take this sentence back"));
    remove->setAccessibleName(tr("Delete sentence"));
    connect(
        remove, &QToolButton::clicked, this,
        [this, index] {
            change(tr("Delete sentence"), [=](Asset& changed) {
                changed.intents.erase(changed.intents.begin() + static_cast<std::ptrdiff_t>(index));
            });
        },
        Qt::QueuedConnection);
    m_grid->addWidget(remove, 2 * row, 3);
}

void IntentPanel::change(const QString& text, const std::function<void(Asset&)>& change) {
    if (asset() == nullptr) return;
    Asset changed = *asset();
    change(changed);
    m_document.push(altered(text, std::move(changed)));
}

void IntentPanel::addIntent(const Intent& intent) {
    change(tr("Add sentence"), [&](Asset& changed) { changed.intents.push_back(intent); });
}

void IntentPanel::useSuggested() {
    if (!m_suggested) return;
    change(tr("Set threshold"), [threshold = *m_suggested](Asset& changed) {
        changed.threshold = threshold;
        changed.contactTime.reset();  // typed from now on
    });
}

void IntentPanel::showAudit() {
    const SwapAudit* audit = asset() != nullptr ? m_trials.auditOf(asset()->id) : nullptr;
    m_audit->setEnabled(!m_trials.isBusy());
    m_audit->setText(m_trials.isBusy() ? tr("Auditing…") : tr("Audit Swap"));
    m_fix->setVisible(faultySeed().has_value());
    if (faultySeed()) m_fix->setText(tr("Delete Seed %1").arg(textOf(faultySeed()->text())));
    if (audit == nullptr) {
        return m_auditText->setText(tr("Not audited as it is now."));
    }
    QStringList lines{audit->isClean() ? tr("<b>Clean.</b>") : tr("<b>Not clean.</b>")};
    for (const std::string& fault : audit->faults) lines << textOf(fault).toHtmlEscaped();
    lines << tr("%L1 pieces, %L2 pairs that touch, deepest overlap %3")
                 .arg(audit->pieces)
                 .arg(audit->contacts)
                 .arg(number(1e3 * audit->deepestOverlap, "mm"));
    lines << tr("Fastest after %1 steps: at rest %2, lying %3")
                 .arg(kAuditSteps)
                 .arg(number(1e3 * audit->resting.speed, "mm/s"), number(1e3 * audit->lying.speed, "mm/s"));
    lines << tr("In flight: mass %1, momentum %2, spin %3, energy %4")
                 .arg(number(audit->massDrift, ""), number(audit->momentumDrift, ""), number(audit->angularDrift, ""),
                      number(audit->energyGain, ""));
    m_auditText->setText(lines.join("<br>"));
}

std::optional<SeedId> IntentPanel::faultySeed() const {
    const SwapAudit* audit = asset() != nullptr ? m_trials.auditOf(asset()->id) : nullptr;
    const auto baked = asset() != nullptr ? m_bakes.findPattern(asset()->id) : nullptr;
    if (audit == nullptr || audit->isClean() || !baked) return std::nullopt;
    const std::string& piece = fastestOf(*audit).piece;
    const std::string seed = piece.substr(piece.find('/') + 1);  // asset/layer.index, perhaps with more behind it
    for (const SeedId id : baked->seeds.ids) {
        if (seed == id.text() || seed.starts_with(id.text() + '.') || seed.starts_with(id.text() + '/')) return id;
    }
    return std::nullopt;
}

void IntentPanel::deleteFaultySeed() {
    if (const std::optional<SeedId> seed = faultySeed()) {
        change(tr("Delete seed"), [&](Asset& changed) { deleteSeed(changed.pattern, *seed); });
    }
}

}  // namespace rubble
