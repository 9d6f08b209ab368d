#include "editor/panels/models/FragmentModel.h"

#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "editor/widgets/numbers/NumberText.h"

#include <QFont>
#include <QGuiApplication>
#include <QPalette>

namespace rubble {

namespace {

constexpr double kFadedTextOpacity = 0.45;  // of the text of a hidden fragment

/// A mix of text and background: the disabled text of some palettes is unreadable.
QColor fadedText() {
    const QPalette palette = QGuiApplication::palette();
    const QColor text = palette.color(QPalette::Text), ground = palette.color(QPalette::Base);
    const auto mixed = [](int a, int b) {
        return static_cast<int>(kFadedTextOpacity * a + (1.0 - kFadedTextOpacity) * b);
    };
    return {mixed(text.red(), ground.red()), mixed(text.green(), ground.green()), mixed(text.blue(), ground.blue())};
}

int alignmentOf(FragmentColumn column) {
    return static_cast<int>((column == FragmentColumn::Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
}

QString hintOf(FragmentColumn column) {
    switch (column) {
        case FragmentColumn::Name:
            return FragmentModel::tr(
                "Name of the fragment: asset and seed, with a further part where the outline cuts a cell apart "
                "and for each fracture level");
        case FragmentColumn::Area: return FragmentModel::tr("Area of the fragment's outline");
        case FragmentColumn::Volume:
            return FragmentModel::tr("Volume, including that of thin fragments merged into it");
        case FragmentColumn::Mass: return FragmentModel::tr("Volume times the density of the asset's material");
        case FragmentColumn::Aspect:
            return FragmentModel::tr(
                "Aspect ratio, length divided by width of the outline: 1 for a square, large for a splinter");
        case FragmentColumn::Neighbours:
            return FragmentModel::tr("Number of fragments of the same fracture that it touches");
        case FragmentColumn::Level:
            return FragmentModel::tr("Fracture level: 0 for fragments of the asset, 1 for their fragments");
        case FragmentColumn::Problems:
            return FragmentModel::tr("Number of problems with the fragment; the Problems dock lists them");
    }
    return {};
}

}  // namespace

void FragmentModel::setMetrics(FragmentMetrics metrics) {
    beginResetModel();
    m_metrics = std::move(metrics);
    m_isHidden = fragmentsOf(m_hidden);
    endResetModel();
}

void FragmentModel::setDensity(double density) {
    if (density == m_metrics.density()) return;
    beginResetModel();
    m_metrics.setDensity(density);
    endResetModel();
}

void FragmentModel::setProblems(std::span<const Diagnostic> problems) {
    beginResetModel();
    m_metrics.setProblems(problems);
    endResetModel();
}

void FragmentModel::reset() {
    beginResetModel();
    endResetModel();
}

void FragmentModel::setUnits(const Units& units) {
    m_units = units;
    emit headerDataChanged(Qt::Horizontal, 0, kFragmentColumns - 1);
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, kFragmentColumns - 1));
}

void FragmentModel::setHidden(const FragmentSelection& hidden) {
    m_hidden = hidden;
    m_isHidden = fragmentsOf(hidden);
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, kFragmentColumns - 1));
}

FragmentSet FragmentModel::fragmentsOf(const FragmentSelection& selection) const {
    return m_metrics.bake() ? rubble::fragmentsOf(selection, *m_metrics.bake()) : FragmentSet();
}

int FragmentModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_metrics.count());
}

int FragmentModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kFragmentColumns; }

QVariant FragmentModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const auto fragment = static_cast<std::uint32_t>(index.row());
    const auto column = FragmentColumn(index.column());
    switch (role) {
        case Qt::DisplayRole: return text(column, fragment);
        case Qt::ToolTipRole: return hint(column, fragment);
        case Qt::AccessibleTextRole: return nameOf(column) + ' ' + hint(column, fragment);
        case Qt::TextAlignmentRole: return alignmentOf(column);
        case Qt::ForegroundRole:
            if (!m_isHidden[fragment]) return {};
            return fadedText();
        case Qt::FontRole: {
            if (!m_isHidden[fragment]) return {};
            QFont font;
            font.setItalic(true);  // the faded colour is invisible on a selected row
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
        case Qt::DisplayRole: return unit.isEmpty() ? nameOf(column) : tr("%1 (%2)").arg(nameOf(column), unit);
        case Qt::ToolTipRole: return hintOf(column);
        case Qt::TextAlignmentRole: return alignmentOf(column);
        default: return {};
    }
}

QString FragmentModel::text(FragmentColumn column, std::uint32_t fragment) const {
    if (column == FragmentColumn::Name) return QString::fromStdString(m_metrics.id(fragment));
    if (column == FragmentColumn::Problems && m_metrics.value(column, fragment) == 0.0) return {};
    return roundedText(m_metrics.value(column, fragment), formatOf(column, m_units));
}

QString FragmentModel::hint(FragmentColumn column, std::uint32_t fragment) const {
    if (column == FragmentColumn::Name) {
        const QString id = text(column, fragment);
        return m_isHidden[fragment] ? tr("%1 (hidden)").arg(id) : id;
    }
    if (column == FragmentColumn::Problems && m_metrics.value(column, fragment) > 0.0) {
        return QString::fromStdString(m_metrics.problemText(fragment));
    }
    return roundedQuantity(m_metrics.value(column, fragment), formatOf(column, m_units));
}

}  // namespace rubble

#include "moc_FragmentModel.cpp"
