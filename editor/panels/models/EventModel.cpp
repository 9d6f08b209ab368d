#include "editor/panels/models/EventModel.h"

#include "editor/document/ShownText.h"
#include "editor/play/EventText.h"
#include "editor/widgets/Icon.h"
#include "editor/widgets/appearance/EventAppearance.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "editor/widgets/numbers/NumberText.h"

#include <QFont>
#include <QGuiApplication>
#include <QPalette>

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>
#include <unordered_map>

namespace rubble {

namespace {

constexpr std::size_t kMaxInsertedSingly = 64;  // more are sorted in anew: each moves all rows after it

/// The order in which events are reported.
auto timeOf(const PlayEvent& event) {
    const EventRecord& record = event.record;
    return std::tuple(record.step, record.kind, record.body, record.other);
}

std::optional<double> known(double value) { return value > 0.0 ? std::optional(value) : std::nullopt; }

/// The number in a column; nothing where the event has none.
std::optional<double> valueOf(const PlayEvent& event, int column) {
    const EventRecord& record = event.record;
    switch (column) {
        case EventModel::kTime: return static_cast<double>(record.step);
        case EventModel::kRatio: return event.strength ? std::optional(event.strength->ratio()) : std::nullopt;
        case EventModel::kThreshold: return event.strength ? std::optional(event.strength->threshold) : std::nullopt;
        case EventModel::kImpulse: return known(record.impulse);
        case EventModel::kSpeed: return known(record.speed);
        case EventModel::kEnergy: return event.hasEnergy() ? std::optional(record.energy) : std::nullopt;
        case EventModel::kMass: return known(record.mass);
        case EventModel::kCount: return known(static_cast<double>(record.count));
        case EventModel::kCost:
            return event.record.kind == EventKind::Broken ? std::optional(event.milliseconds) : std::nullopt;
        default: return std::nullopt;
    }
}

QString quantityOf(QuantityKind kind, std::optional<double> value) {
    return value ? localizedQuantity(kind, *value) : QString();
}

/// Merged with the font of a view.
QFont italicFont() {
    QFont font;
    font.setItalic(true);
    return font;
}

int compared(const auto& a, const auto& b) {
    if (a == b) return 0;
    return a < b ? -1 : 1;
}

}  // namespace

void EventModel::setEvents(const std::vector<EventRef>& events, double stepLength) {
    m_stepLength = stepLength;
    const std::size_t common = std::min(events.size(), m_events.size());
    const bool isSame =
        std::equal(events.begin(), events.begin() + static_cast<std::ptrdiff_t>(common), m_events.begin());
    if (!isSame || (common < m_events.size() && !isInTime())) return reset(events);
    if (common < m_events.size()) {
        beginRemoveRows({}, static_cast<int>(common), rowCount() - 1);
        m_events.resize(common);
        m_rows.resize(common);
        endRemoveRows();
    }
    append(std::span(events).subspan(common));
}

void EventModel::append(std::span<const EventRef> events) {
    if (events.empty()) return;
    if (!isInTime() && events.size() > kMaxInsertedSingly) {
        std::vector<EventRef> all = m_events;
        all.insert(all.end(), events.begin(), events.end());
        return reset(all);
    }
    m_events.insert(m_events.end(), events.begin(), events.end());
    if (isInTime()) {
        beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(events.size()) - 1);
        m_rows.insert(m_rows.end(), events.begin(), events.end());
        return endInsertRows();
    }
    for (const EventRef& event : events) {
        const auto at = std::ranges::upper_bound(
            m_rows, event, [this](const EventRef& a, const EventRef& b) { return isBefore(*a, *b); });
        const int row = static_cast<int>(at - m_rows.begin());
        beginInsertRows({}, row, row);
        m_rows.insert(at, event);
        endInsertRows();
    }
}

void EventModel::reset(const std::vector<EventRef>& events) {
    beginResetModel();
    m_events = m_rows = events;
    sortRows();
    endResetModel();
}

void EventModel::setDisplayedStep(std::uint64_t step) {
    const auto after = [this](std::uint64_t shown) {
        return std::ranges::upper_bound(m_events, shown, {}, stepOfEvent);
    };
    const bool isSame = after(step) == after(m_displayedStep);
    m_displayedStep = step;
    if (!isSame) emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1), {Qt::ForegroundRole, Qt::FontRole});
}

void EventModel::setMaterials(const std::vector<Material>& materials) {
    std::map<Id, QString> names;
    for (const Material& material : materials) names[material.id] = nameText(material.name);
    if (names == m_materials) return;
    m_materials = std::move(names);
    if (rowCount() > 0) emit dataChanged(index(0, kMaterials), index(rowCount() - 1, kMaterials));
}

int EventModel::rowOf(const EventRef& event) const {
    const auto at = std::ranges::find(m_rows, event);
    return at == m_rows.end() ? -1 : static_cast<int>(at - m_rows.begin());
}

bool EventModel::isNumeric(int column) {
    return column != kKind && column != kBody && column != kOther && column != kMaterials;
}

int EventModel::compare(const PlayEvent& a, const PlayEvent& b) const {
    switch (m_column) {
        case kKind: return compared(a.record.kind, b.record.kind);
        case kBody: return compared(a.name, b.name);
        case kOther: return compared(a.otherName, b.otherName);
        case kMaterials: {
            const int first = compared(materialName(a.record.materials[0]), materialName(b.record.materials[0]));
            return first != 0 ? first
                              : compared(materialName(a.record.materials[1]), materialName(b.record.materials[1]));
        }
        default: return compared(valueOf(a, m_column), valueOf(b, m_column));
    }
}

bool EventModel::isBefore(const PlayEvent& a, const PlayEvent& b) const {
    const int order = compare(a, b);
    if (order != 0) return m_order == Qt::AscendingOrder ? order < 0 : order > 0;
    return timeOf(a) < timeOf(b);
}

void EventModel::sortRows() {
    if (isInTime()) return;
    std::ranges::stable_sort(m_rows, [this](const EventRef& a, const EventRef& b) { return isBefore(*a, *b); });
}

void EventModel::sort(int column, Qt::SortOrder order) {
    if (column < 0 || (column == m_column && order == m_order)) return;
    emit layoutAboutToBeChanged({}, VerticalSortHint);
    const QModelIndexList before = persistentIndexList();
    std::unordered_map<const PlayEvent*, int> rows;  // of those, after the sort
    for (const QModelIndex& index : before) rows[event(index.row()).get()] = 0;
    std::vector<const PlayEvent*> kept;
    for (const QModelIndex& index : before) kept.push_back(event(index.row()).get());
    m_column = column;
    m_order = order;
    m_rows = m_events;
    sortRows();
    for (int row = 0; row < rowCount() && !rows.empty(); ++row) {
        if (const auto found = rows.find(event(row).get()); found != rows.end()) found->second = row;
    }
    QModelIndexList after;
    for (qsizetype k = 0; k < before.size(); ++k) {
        after << index(rows.at(kept[static_cast<std::size_t>(k)]), before[k].column());
    }
    changePersistentIndexList(before, after);
    emit layoutChanged({}, VerticalSortHint);
}

int EventModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int EventModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

/// Empty for none, and for one that is gone.
QString EventModel::materialName(Id id) const {
    const auto found = m_materials.find(id);
    return found == m_materials.end() ? QString() : found->second;
}

/// Each material once.
QString EventModel::materialsOf(const EventRecord& record) const {
    QStringList names;
    for (const Id id : record.materials) {
        const QString name = materialName(id);
        if (!name.isEmpty() && !names.contains(name)) names << name;
    }
    return names.join(QStringLiteral(", "));
}

QString EventModel::text(const PlayEvent& event, int column) const {
    const QLocale locale;
    const std::optional<double> value = valueOf(event, column);
    switch (column) {
        case kKind: return titleOf(event.record.kind);
        case kTime: return locale.toString(static_cast<double>(event.record.step) * m_stepLength, 'f', 2);
        case kBody: return nameText(event.name);
        case kOther: return nameText(event.otherName);
        case kRatio: return value ? tr("%1×").arg(roundedText(*value, {}, locale)) : QString();
        case kImpulse:
        case kThreshold: return quantityOf(QuantityKind::Impulse, value);
        case kSpeed: return quantityOf(QuantityKind::Speed, value);
        case kEnergy: return quantityOf(QuantityKind::Energy, value);
        case kMass: return quantityOf(QuantityKind::Mass, value);
        case kCount: return value ? locale.toString(event.record.count) : QString();
        case kMaterials: return materialsOf(event.record);
        case kCost: return value ? roundedQuantity(*value, {QStringLiteral("ms")}, locale) : QString();
        default: return {};
    }
}

QString EventModel::toolTip(const PlayEvent& event) const {
    QStringList lines{sentenceOf(event)};
    if (event.strength) {
        lines << tr("%1 took %2, %3× its threshold of %4")
                     .arg(nameText(event.strength->name),
                          localizedQuantity(QuantityKind::Impulse, event.strength->impact),
                          roundedText(event.strength->ratio(), {}),
                          localizedQuantity(QuantityKind::Impulse, event.strength->threshold));
    }
    if (event.record.step > m_displayedStep) lines << tr("Happens after the displayed time");
    if (!event.isReported) lines << tr("Listed for its threshold: its energy is not known, and it is not exported");
    lines << tr("Double-click to go to the place and time of the event");
    return toolTipText(lines.join('\n'));
}

QVariant EventModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const PlayEvent& shown = *event(index.row());
    if (role == Qt::DisplayRole) return text(shown, index.column());
    if (role == Qt::DecorationRole && index.column() == kKind) return iconNamed(iconNameOf(shown.record.kind));
    if (role == Qt::TextAlignmentRole && isNumeric(index.column())) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole) return toolTip(shown);
    const bool isLater = shown.record.step > m_displayedStep;
    if (role == Qt::ForegroundRole && (isLater || !shown.isReported))
        return QGuiApplication::palette().placeholderText();
    if (role == Qt::FontRole && isLater) return italicFont();
    return {};
}

QVariant EventModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole) {
        return QVariant((isNumeric(section) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    }
    const std::array<std::pair<QString, QString>, kColumns> texts = {{
        {tr("Event"), tr("What happened")},
        {tr("Time (s)"), tr("Simulated time")},
        {tr("Body"), tr("The body that it happened to, with the path of its fragment")},
        {tr("Other Body"), tr("The body that it touched")},
        {tr("Ratio"), tr("Impact divided by threshold: 1 breaks a body")},
        {tr("Impulse"), tr("Impulse along the normal of the contact")},
        {tr("Speed"), tr("Speed of the approach before the impact")},
        {tr("Energy"), tr("Mechanical energy that both bodies lost, or that the break took")},
        {tr("Mass"), tr("Mass of what came free, came to rest or was removed")},
        {tr("Fragments"), tr("Number of fragments that came free")},
        {tr("Materials"), tr("Materials of both bodies; of a break, of its outside and inside")},
        {tr("Threshold"), tr("Impulse that breaks the body")},
        {tr("Computed in"), tr("Computing time of the break")},
    }};
    const auto& [title, hint] = texts[static_cast<std::size_t>(section)];
    if (role == Qt::DisplayRole) return title;
    return role == Qt::ToolTipRole ? QVariant(hint) : QVariant();
}

}  // namespace rubble

#include "moc_EventModel.cpp"
