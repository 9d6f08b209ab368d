#include "editor/panels/models/BreakModel.h"

#include "editor/document/ShownText.h"
#include "editor/widgets/NumberText.h"

#include <array>

namespace rubble {

namespace {

bool isSame(const BreakRecord& a, const BreakRecord& b) {
    return a.step == b.step && a.name == b.name && a.impact == b.impact;
}

}  // namespace

void BreakModel::setBreaks(const std::vector<BreakRecord>& breaks, double stepLength) {
    m_stepLength = stepLength;
    const bool isExtended =
        breaks.size() >= m_breaks.size() && std::equal(m_breaks.begin(), m_breaks.end(), breaks.begin(), isSame);
    if (!isExtended) {
        beginResetModel();
        m_breaks = breaks;
        return endResetModel();
    }
    if (breaks.size() == m_breaks.size()) return;
    beginInsertRows({}, rowCount(), static_cast<int>(breaks.size()) - 1);
    m_breaks = breaks;
    endInsertRows();
}

int BreakModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_breaks.size());
}

int BreakModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant BreakModel::text(const BreakRecord& broken, int column) const {
    const QLocale locale;
    switch (column) {
        case kTime: return locale.toString(static_cast<double>(broken.step) * m_stepLength, 'f', 2);
        case kName: return nameText(broken.name);
        case kRatio: return tr("%1×").arg(roundedText(broken.ratio(), {}, locale));
        case kImpact: return roundedText(broken.impact, {}, locale);
        case kThreshold: return roundedText(broken.threshold, {}, locale);
        case kPieces: return locale.toString(broken.pieces);
        case kCost: return roundedText(broken.milliseconds, {}, locale);
        default: return {};
    }
}

QVariant BreakModel::data(const QModelIndex& index, int role) const {
    const BreakRecord& record = broken(index.row());
    if (role == Qt::DisplayRole) return text(record, index.column());
    if (role == Qt::TextAlignmentRole && index.column() != kName) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole) return tr("Double-click to go to the place and time of the break");
    return {};
}

QVariant BreakModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole && section != kName) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && section == kRatio) return tr("Impact divided by threshold");
    if (role != Qt::DisplayRole) return {};
    const std::array titles = {tr("Time (s)"),        tr("Body"),      tr("Ratio"),    tr("Impact (N·s)"),
                               tr("Threshold (N·s)"), tr("Fragments"), tr("Swap (ms)")};
    return titles[static_cast<std::size_t>(section)];
}

}  // namespace rubble

#include "moc_BreakModel.cpp"
