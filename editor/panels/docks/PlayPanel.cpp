#include "editor/panels/docks/PlayPanel.h"

#include "editor/commands/ProjectEdits.h"
#include "editor/document/ShownText.h"
#include "editor/panels/docks/EventFilterBar.h"
#include "editor/panels/docks/StepGraph.h"
#include "editor/widgets/appearance/EventAppearance.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

namespace rubble {

namespace {

constexpr int kNarrowWidth = 520;       // pixels
constexpr int kPaintMilliseconds = 66;  // between repaints of the graph: faster ones are unreadable

}  // namespace

PlayPanel::PlayPanel(Document& document, PlayController& controller, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_controller(controller),
      m_graph(new StepGraph),
      m_filter(new EventFilterBar),
      m_table(new EventTable),
      m_summary(new QLabel),
      m_foot(new QHBoxLayout) {
    makeRequirementActions();
    addContextMenu();
    auto* parts = new QSplitter(Qt::Horizontal);
    parts->addWidget(makeList());
    parts->addWidget(m_graph);
    parts->setStretchFactor(0, 1);
    parts->setStretchFactor(1, 0);
    parts->setChildrenCollapsible(false);
    m_graph->setMinimumWidth(1);  // in place of its hint: where there is no room for it, it is hidden
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(parts);
    connect(m_table, &EventTable::eventActivated, this, [this](const EventRef& event) {
        m_controller.seek(event->record.step);
        emit jumpRequested(event->record.point);
    });
    connect(m_table, &EventTable::eventSelected, this, &PlayPanel::refreshActions);
    connect(m_filter, &EventFilterBar::filterChanged, &controller, &PlayController::setEventFilter);
    connect(m_filter, &EventFilterBar::refused, this, &PlayPanel::refused);
    connect(&controller, &PlayController::frameChanged, this, &PlayPanel::refreshFrame);
    connect(&controller, &PlayController::eventsChanged, this, &PlayPanel::refreshEvents);
    connect(&controller, &PlayController::stateChanged, this, &PlayPanel::refreshEvents);
    connect(&document, &Document::changed, this, [this] {
        refreshMaterials();
        refreshActions();
    });
    refreshMaterials();
    refreshEvents();
    refreshActions();
}

/// The table between its filter, and its summary with buttons.
QWidget* PlayPanel::makeList() {
    auto* list = new QWidget;
    auto* rows = new QVBoxLayout(list);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(m_filter);
    rows->addWidget(m_table, 1);
    m_summary->setContentsMargins(6, 2, 6, 4);
    m_summary->setWordWrap(true);
    m_summary->setAccessibleName(tr("Summary"));
    m_summary->setObjectName("event-summary");
    m_foot->setContentsMargins(0, 0, 6, 2);
    m_foot->addWidget(m_summary, 1);
    for (QAction* action : m_requirements) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        m_foot->addWidget(button);
        m_requirementButtons << button;
    }
    rows->addLayout(m_foot);
    return list;
}

/// A narrow panel has no graph, and its buttons for requirements in the menu of the list only.
void PlayPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const bool isNarrow = width() < kNarrowWidth;
    m_graph->setHidden(isNarrow);
    for (QToolButton* button : m_requirementButtons) button->setHidden(isNarrow);
}

void PlayPanel::setExportActions(QAction* all, QAction* shown) {
    auto* button = new QToolButton;
    button->setDefaultAction(all);
    button->setPopupMode(QToolButton::MenuButtonPopup);
    button->addAction(shown);
    button->setObjectName("export-events");
    m_foot->addWidget(button);
    m_table->addActions({all, shown});
}

void PlayPanel::makeRequirementActions() {
    m_requirements = {
        makeRequirementAction("must-survive", tr("Must Survive"),
                              tr("Require that the asset survives the selected impact"), RequirementOutcome::Survives),
        makeRequirementAction("must-break", tr("Must Break"),
                              tr("Require that the asset breaks in the selected impact"), RequirementOutcome::Breaks)};
}

QAction* PlayPanel::makeRequirementAction(const char* name, const QString& text, const QString& hint,
                                          RequirementOutcome outcome) {
    auto* action = new QAction(text, this);
    action->setObjectName(name);
    action->setToolTip(hint);
    connect(action, &QAction::triggered, this, [this, outcome] { addRequirement(outcome); });
    return action;
}

const ImpactStrength* PlayPanel::selectedStrength() const {
    const EventRef event = m_table->selectedEvent();  // the table keeps it
    if (!event || !event->strength) return nullptr;
    const bool hasAsset = findAsset(m_document.project(), event->strength->asset) != nullptr;
    return hasAsset && event->strength->scale > 0.0 ? &*event->strength : nullptr;
}

void PlayPanel::addRequirement(RequirementOutcome outcome) {
    const ImpactStrength* strength = selectedStrength();
    if (strength == nullptr) return;
    Asset changed = *findAsset(m_document.project(), strength->asset);
    changed.requirements.push_back(impulseRequirement(outcome, strength->impact / strength->scale));
    const QString message =
        tr("New requirement: \"%1\" %2. See the Strength dock.")
            .arg(nameText(changed.name), QString::fromStdString(requirementText(changed.requirements.back())));
    if (m_document.push(modify(tr("Add Requirement"), std::move(changed)))) emit statusMessage(message);
}

void PlayPanel::refreshActions() {
    for (QAction* action : m_requirements) action->setEnabled(selectedStrength() != nullptr);
    m_loop->setEnabled(m_table->selectedEvent() != nullptr);
}

void PlayPanel::addContextMenu() {
    m_loop = new QAction(tr("Loop Around This Event"), m_table);
    m_loop->setStatusTip(tr("Play half a second before and a second after this event again and again"));
    connect(m_loop, &QAction::triggered, this, [this] {
        const EventRef event = m_table->selectedEvent();
        if (!event) return;
        emit jumpRequested(event->record.point);
        m_controller.loopAround(event->record.step);
    });
    m_table->addActions(m_requirements);
    m_table->addAction(m_loop);
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void PlayPanel::refreshMaterials() {
    m_table->setMaterials(m_document.project().materials);
    m_filter->setMaterials(m_document.project().materials);
}

void PlayPanel::refreshFrame() {
    m_table->setDisplayedStep(displayedStep());
    refreshSummary();
    if (m_lastPaint.isValid() && m_lastPaint.elapsed() < kPaintMilliseconds) return;
    m_lastPaint.start();
    m_graph->setCosts(m_controller.costs(), PlayController::kShownCosts);
}

std::uint64_t PlayPanel::displayedStep() const {
    const std::optional<PlayFrame>& frame = m_controller.frame();
    return frame ? frame->step : 0;
}

void PlayPanel::refreshEvents() {
    m_table->setDisplayedStep(displayedStep());
    m_table->setEvents(m_controller.shownEvents(), m_controller.thread().stepLength());
    refreshSummary();
}

/// Counts what has broken up to the displayed step, and the events of the whole course.
void PlayPanel::refreshSummary() {
    if (!m_controller.isInPlay()) {
        m_summary->setText(tr("The simulation is stopped."));
        m_summary->setToolTip({});
        m_graph->setCosts({}, PlayController::kShownCosts);
        return;
    }
    const std::span<const EventRef> breaks = m_controller.events().breaks(displayedStep());
    const BreakCounts counts = countsOf(breaks);
    QStringList parts;
    if (counts.breaks > 0) parts << tr("Breaks: %L1").arg(counts.breaks);
    if (counts.fragments > 0) parts << tr("Fragments: %L1").arg(counts.fragments);
    if (counts.bonds > 0) parts << tr("Broken bonds: %L1").arg(counts.bonds);
    if (breaks.empty()) {
        parts << (m_controller.isFromStart() ? tr("Nothing has broken.")
                                             : tr("Nothing has broken since the loaded state."));
    }
    parts << countText();
    m_summary->setText(parts.join(QStringLiteral(" · ")));
    m_summary->setToolTip(sumsText());
}

/// "12 of 340 events shown", or that there are no more than can be listed.
QString PlayPanel::countText() const {
    const std::size_t all = m_controller.events().size(), shown = m_controller.shownEvents().size();
    QString text = m_controller.eventFilter().isActive() ? tr("%L1 of %L2 events shown").arg(shown).arg(all)
                                                         : tr("%Ln event(s)", nullptr, static_cast<int>(all));
    if (all >= kMaxLoggedEvents) text += tr("; the list is full, only breaks are added");
    return text;
}

/// What is counted and summed, but not listed.
QString PlayPanel::sumsText() const {
    QStringList lines{m_controller.isFromStart()
                          ? tr("What has broken up to the displayed time; events of the whole timeline.")
                          : tr("What has broken from the loaded state up to the displayed time; events of the whole "
                               "timeline.")};
    const EventCourse& events = m_controller.events();
    for (const EventKind kind : eventKinds()) {
        const OmittedEvents& omitted = events.omitted()[static_cast<std::size_t>(kind)];
        if (omitted.count == 0) continue;
        QString line = tr("Not listed, since they are weaker: %1: %L2").arg(pluralOf(kind)).arg(omitted.count);
        if (omitted.energy != 0.0)
            line = tr("%1, together %2").arg(line, localizedQuantity(QuantityKind::Energy, omitted.energy));
        lines << line;
    }
    if (events.restEnergy() != 0.0) {
        lines << tr("Friction, rolling and rattling took %1")
                     .arg(localizedQuantity(QuantityKind::Energy, events.restEnergy()));
    }
    return toolTipText(lines.join('\n'));
}

}  // namespace rubble

#include "moc_PlayPanel.cpp"
