#include "editor/panels/FragmentModel.h"

#include "editor/panels/LocalNumber.h"

#include <QFont>
#include <QGuiApplication>
#include <QPalette>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kDigits = 4;      // that are shown; the tooltip has all
constexpr double kPale = 0.45;  // how much of its colour the text of a hidden fragment keeps

/// A fragment with what it is sorted by.
struct Key {
    double value = 0.0;
    double place = 0.0;  // in the tree of fragments: no two have the same
    std::uint32_t fragment = 0;
};

/// Between text and ground: not every palette's disabled text can be read.
QColor paleText() {
    const QPalette palette = QGuiApplication::palette();
    const QColor text = palette.color(QPalette::Text), ground = palette.color(QPalette::Base);
    const auto mixed = [](int a, int b) { return static_cast<int>(kPale * a + (1.0 - kPale) * b); };
    return {mixed(text.red(), ground.red()), mixed(text.green(), ground.green()), mixed(text.blue(), ground.blue())};
}

int alignmentOf(FragmentColumn column) {
    return static_cast<int>((column == FragmentColumn::Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
}

QString hintOf(FragmentColumn column) {
    switch (column) {
        case FragmentColumn::Name:
            return FragmentModel::tr(
                "The fragment's name: its asset, the seed it comes from, and the piece where the "
                "outline cuts a cell apart; one more part a level");
        case FragmentColumn::Area: return FragmentModel::tr("The area of its outline, seen along the depth");
        case FragmentColumn::Volume: return FragmentModel::tr("Its volume, with that of thin pieces given to it");
        case FragmentColumn::Mass: return FragmentModel::tr("Its volume times the density of the asset's material");
        case FragmentColumn::Aspect:
            return FragmentModel::tr(
                "How many times as long as wide its outline is: 1 for a square, large for a "
                "splinter");
        case FragmentColumn::Neighbours:
            return FragmentModel::tr("How many fragments it touches among those it was made with");
        case FragmentColumn::Level:
            return FragmentModel::tr("0 for a piece of the whole, 1 for a piece of such a piece");
        case FragmentColumn::Problems:
            return FragmentModel::tr("How many reasons there are to look at it; the list of problems tells more");
    }
    return {};
}

}  // namespace

void FragmentModel::setFigures(FragmentFigures figures) {
    beginResetModel();
    m_figures = std::move(figures);
    m_isHidden = fragmentsOf(m_hidden);
    arrange();
    endResetModel();
}

void FragmentModel::setDensity(double density) {
    if (density == m_figures.density()) return;
    beginResetModel();
    m_figures.setDensity(density);
    arrange();
    endResetModel();
}

void FragmentModel::setProblems(std::span<const Problem> problems) {
    beginResetModel();
    m_figures.setProblems(problems);
    arrange();
    endResetModel();
}

void FragmentModel::setFilter(FragmentFilter filter) {
    beginResetModel();
    m_filter = std::move(filter);
    arrange();
    endResetModel();
}

void FragmentModel::setUnits(const Units& units) {
    m_units = units;
    emit headerDataChanged(Qt::Horizontal, 0, kFragmentColumns - 1);
    if (!m_rows.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, kFragmentColumns - 1));
}

void FragmentModel::setHidden(const FragmentChoice& hidden) {
    m_hidden = hidden;
    m_isHidden = fragmentsOf(hidden);
    if (!m_rows.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, kFragmentColumns - 1));
}

FragmentSet FragmentModel::shownFragments() const {
    FragmentSet isShown(m_figures.count(), false);
    for (const std::uint32_t fragment : m_rows) isShown[fragment] = true;
    return isShown;
}

FragmentSet FragmentModel::fragmentsOf(const FragmentChoice& choice) const {
    return m_figures.bake() ? rubble::fragmentsOf(choice, *m_figures.bake()) : FragmentSet();
}

int FragmentModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int FragmentModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kFragmentColumns; }

QVariant FragmentModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const std::uint32_t fragment = fragmentAt(index.row());
    const auto column = FragmentColumn(index.column());
    switch (role) {
        case Qt::DisplayRole: return text(column, fragment);
        case Qt::ToolTipRole: return hint(column, fragment);
        case Qt::AccessibleTextRole: return nameOf(column) + ' ' + hint(column, fragment);
        case Qt::TextAlignmentRole: return alignmentOf(column);
        case Qt::ForegroundRole:
            if (!m_isHidden[fragment]) return {};
            return paleText();
        case Qt::FontRole: {
            if (!m_isHidden[fragment]) return {};
            QFont font;
            font.setItalic(true);  // pale alone is hard to see, and not at all among the chosen
            return font;
        }
        default: return {};
    }
}

QVariant FragmentModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    const auto column = FragmentColumn(section);
    const QString unit = formatOf(column, m_units).unit;
    switch (role) {
        case Qt::DisplayRole: return unit.isEmpty() ? nameOf(column) : tr("%1, %2").arg(nameOf(column), unit);
        case Qt::ToolTipRole: return hintOf(column);
        case Qt::TextAlignmentRole: return alignmentOf(column);
        default: return {};
    }
}

void FragmentModel::sort(int column, Qt::SortOrder order) {
    beginResetModel();
    m_sortColumn = FragmentColumn(std::clamp(column, 0, kFragmentColumns - 1));
    m_sortOrder = order;
    arrange();
    endResetModel();
}

void FragmentModel::arrange() {
    std::vector<Key> keys;
    for (std::uint32_t k = 0; k < m_figures.count(); ++k) {
        if (!m_filter.takes(m_figures, k)) continue;
        keys.push_back({m_figures.value(m_sortColumn, k), m_figures.value(FragmentColumn::Name, k), k});
    }
    const bool isAscending = m_sortOrder == Qt::AscendingOrder;
    std::ranges::sort(keys, [&](const Key& a, const Key& b) {
        if (a.value != b.value) return isAscending ? a.value < b.value : a.value > b.value;
        return a.place < b.place;
    });
    m_rows.clear();
    for (const Key& key : keys) m_rows.push_back(key.fragment);
}

QString FragmentModel::text(FragmentColumn column, std::uint32_t fragment) const {
    if (column == FragmentColumn::Name) return QString::fromStdString(m_figures.id(fragment));
    if (column == FragmentColumn::Problems && m_figures.value(column, fragment) == 0.0) return {};
    return roundedText(m_figures.value(column, fragment), kDigits, formatOf(column, m_units), QLocale());
}

QString FragmentModel::hint(FragmentColumn column, std::uint32_t fragment) const {
    if (column == FragmentColumn::Name) {
        const QString id = text(column, fragment);
        return m_isHidden[fragment] ? tr("%1, hidden").arg(id) : id;
    }
    if (column == FragmentColumn::Problems && m_figures.value(column, fragment) > 0.0) {
        return QString::fromStdString(m_figures.problemText(fragment));
    }
    const NumberFormat format = formatOf(column, m_units);
    return withUnit(exactText(m_figures.value(column, fragment), format, QLocale()), format);
}

}  // namespace rubble
