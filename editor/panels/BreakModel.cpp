#include "editor/panels/BreakModel.h"

#include <QLocale>

#include <array>

namespace rubble {

namespace {

bool isSame(const ToldBreak& a, const ToldBreak& b) {
    return a.step == b.step && a.name == b.name && a.impact == b.impact;
}

}  // namespace

void BreakModel::setBreaks(const std::vector<ToldBreak>& breaks, double stepLength) {
    m_stepLength = stepLength;
    const bool isLonger =
        breaks.size() >= m_breaks.size() && std::equal(m_breaks.begin(), m_breaks.end(), breaks.begin(), isSame);
    if (!isLonger) {
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

QVariant BreakModel::text(const ToldBreak& broken, int column) const {
    const QLocale locale;
    switch (column) {
        case kTime: return locale.toString(static_cast<double>(broken.step) * m_stepLength, 'f', 2);
        case kName: return QString::fromStdString(broken.name);
        case kRatio: return tr("%1×").arg(locale.toString(broken.ratio(), 'f', 2));
        case kImpact: return locale.toString(broken.impact, 'f', 0);
        case kThreshold: return locale.toString(broken.threshold, 'f', 0);
        case kPieces: return locale.toString(broken.pieces);
        case kCost: return locale.toString(broken.milliseconds, 'f', 3);
        default: return {};
    }
}

QVariant BreakModel::data(const QModelIndex& index, int role) const {
    const ToldBreak& told = broken(index.row());
    if (role == Qt::DisplayRole) return text(told, index.column());
    if (role == Qt::TextAlignmentRole && index.column() != kName) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole) return tr("Double click or Enter: go to the place and the moment");
    return {};
}

QVariant BreakModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole && section != kName) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && section == kRatio) return tr("Impact ÷ threshold");
    if (role != Qt::DisplayRole) return {};
    const std::array titles = {tr("Time, s"),        tr("What"),   tr("Ratio"),   tr("Impact, N·s"),
                               tr("Threshold, N·s"), tr("Pieces"), tr("Swap, ms")};
    return titles[static_cast<std::size_t>(section)];
}

}  // namespace rubble
