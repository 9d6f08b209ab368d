#include "editor/panels/docks/EventFilterBar.h"

#include "editor/document/ShownText.h"
#include "editor/widgets/Buttons.h"
#include "editor/widgets/ComboBox.h"
#include "editor/widgets/ElidedLabel.h"
#include "editor/widgets/ProjectRange.h"
#include "editor/widgets/appearance/EventAppearance.h"

#include <QBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kMinWidth = 640;  // pixels that all fields need side by side, with their label
constexpr int kSpacing = 4;

}  // namespace

EventFilterBar::EventFilterBar(QWidget* parent)
    : QWidget(parent),
      m_kinds(makeKinds()),
      m_text(new QLineEdit),
      m_energyLabel(new ElidedLabel(tr("Energy ≥"))),
      m_energy(new NumberField),
      m_material(new QComboBox),
      m_reset(panelButton({}, tr("Show All"), tr("Show all events"), this)),
      m_first(new QHBoxLayout),
      m_second(new QHBoxLayout) {
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(kSpacing, 2, kSpacing, 2);
    rows->setSpacing(kSpacing);
    for (QHBoxLayout* row : {m_first, m_second}) {
        row->setSpacing(kSpacing);
        rows->addLayout(row);
    }
    makeFields();
    m_first->addWidget(m_kinds);
    m_first->addWidget(m_text, 1);
    m_reset->setObjectName("event-show-all");
    m_reset->setEnabled(false);
    connect(m_reset, &QToolButton::clicked, this, [this] {
        setFilter({});
        emit filterChanged(m_filter);
    });
    arrange(false);
}

QWidget* EventFilterBar::makeKinds() {
    auto* kinds = new QWidget(this);
    auto* row = new QHBoxLayout(kinds);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    for (const EventKind kind : eventKinds()) row->addWidget(makeKind(kind));
    return kinds;
}

QToolButton* EventFilterBar::makeKind(EventKind kind) {
    QToolButton* button =
        panelButton(iconNameOf(kind), {}, tr("List events of this kind: %1").arg(pluralOf(kind)), this);
    button->setAccessibleName(pluralOf(kind));
    button->setObjectName(iconNameOf(kind));
    button->setCheckable(true);
    button->setChecked(true);
    connect(button, &QToolButton::toggled, this, [this, kind](bool isOn) {
        EventFilter filter = m_filter;
        filter.kinds[static_cast<std::size_t>(kind)] = isOn;
        change(filter);
    });
    m_toggles[static_cast<std::size_t>(kind)] = button;
    return button;
}

void EventFilterBar::makeFields() {
    addClearButton(*m_text);
    m_text->setPlaceholderText(tr("Body or asset"));
    m_text->setToolTip(tr("List only events of bodies whose names contain this text"));
    m_text->setStatusTip(m_text->toolTip());
    m_text->setAccessibleName(tr("Filter by Body"));
    m_text->setObjectName("event-text");
    m_text->addAction(iconNamed("filter"), QLineEdit::LeadingPosition)->setText(tr("Filter"));
    connect(m_text, &QLineEdit::textChanged, this, [this](const QString& text) {
        EventFilter filter = m_filter;
        filter.text = text.trimmed();
        change(filter);
    });
    m_energy->setFormat(Units::energies());
    m_energy->setRange(fieldRange(ProjectNumber::EventEnergy));
    m_energy->setHint(
        tr("List only events that took at least this energy; above 0, what settled and was removed is not "
           "listed, since it has none"));
    m_energy->setAccessibleName(tr("Least Energy"));
    m_energyLabel->setBuddy(m_energy);
    m_energyLabel->setToolTip(tr("List only events that took at least this energy"));
    m_energy->setObjectName("event-energy");
    connect(m_energy, &NumberField::refused, this, &EventFilterBar::refused);
    connect(m_energy, &NumberField::edited, this, [this](double energy) {
        EventFilter filter = m_filter;
        filter.leastEnergy = energy;
        change(filter);
    });
    m_material->setToolTip(tr("List only events of bodies of this material"));
    m_material->setStatusTip(m_material->toolTip());
    m_material->setAccessibleName(tr("Filter by Material"));
    m_material->setObjectName("event-material");
    setMaterials({});
    connect(m_material, &QComboBox::currentIndexChanged, this, [this] {
        EventFilter filter = m_filter;
        filter.material = m_material->currentData().toUInt();
        change(filter);
    });
}

void EventFilterBar::arrange(bool isNarrow) {
    m_isNarrow = isNarrow;
    const std::initializer_list<QWidget*> fields{m_energyLabel, m_energy, m_material, m_reset};
    for (QWidget* field : fields) (isNarrow ? m_second : m_first)->addWidget(field);
    m_second->setStretchFactor(m_material, 1);
}

void EventFilterBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (const bool isNarrow = width() < kMinWidth; isNarrow != m_isNarrow) arrange(isNarrow);
}

void EventFilterBar::change(const EventFilter& filter) {
    if (filter == m_filter) return;
    m_filter = filter;
    m_reset->setEnabled(filter.isActive());
    emit filterChanged(filter);
}

void EventFilterBar::setFilter(const EventFilter& filter) {
    m_filter = filter;
    m_reset->setEnabled(filter.isActive());
    for (std::size_t kind = 0; kind < kEventKinds; ++kind) {
        const QSignalBlocker blocker(m_toggles[kind]);
        m_toggles[kind]->setChecked(filter.kinds[kind]);
    }
    if (m_text->text().trimmed() != filter.text) {
        const QSignalBlocker blocker(m_text);
        m_text->setText(filter.text);
    }
    m_energy->setValue(filter.leastEnergy);
    const QSignalBlocker blocker(m_material);
    m_material->setCurrentIndex(std::max(0, m_material->findData(filter.material)));
}

void EventFilterBar::setMaterials(const std::vector<Material>& materials) {
    std::vector<ComboItem> items{{.text = tr("All materials")}};
    for (const Material& material : materials)
        items.push_back({material.id, nameText(material.name), material.outside});
    {
        const QSignalBlocker blocker(m_material);
        setItems(*m_material, items);
        m_material->setCurrentIndex(std::max(0, m_material->findData(m_filter.material)));
    }
    EventFilter filter = m_filter;
    filter.material = m_material->currentData().toUInt();
    change(filter);
}

}  // namespace rubble

#include "moc_EventFilterBar.cpp"
