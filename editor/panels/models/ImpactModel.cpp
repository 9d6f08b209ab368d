#include "editor/panels/models/ImpactModel.h"

#include "editor/document/ShownText.h"
#include "editor/widgets/numbers/NumberText.h"

#include <QGuiApplication>
#include <QPalette>

#include <array>

namespace rubble {

namespace {

bool isSame(const ImpactRecord& a, const ImpactRecord& b) {
    return a.step == b.step && a.name == b.name && a.impact == b.impact;
}

}  // namespace

void ImpactModel::setImpacts(const std::vector<ImpactRecord>& impacts, double stepLength) {
    m_stepLength = stepLength;
    const bool isExtended =
        impacts.size() >= m_impacts.size() && std::equal(m_impacts.begin(), m_impacts.end(), impacts.begin(), isSame);
    if (!isExtended) {
        beginResetModel();
        m_impacts = impacts;
        return endResetModel();
    }
    if (impacts.size() == m_impacts.size()) return;
    beginInsertRows({}, rowCount(), static_cast<int>(impacts.size()) - 1);
    m_impacts = impacts;
    endInsertRows();
}

int ImpactModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_impacts.size());
}

int ImpactModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant ImpactModel::text(const ImpactRecord& record, int column) const {
    const QLocale locale;
    switch (column) {
        case kTime: return locale.toString(static_cast<double>(record.step) * m_stepLength, 'f', 2);
        case kName: return nameText(record.name);
        case kRatio: return tr("%1×").arg(roundedText(record.ratio(), {}, locale));
        case kImpact: return roundedText(record.impact, {}, locale);
        case kThreshold: return roundedText(record.threshold, {}, locale);
        case kFragments: return record.isBreak() ? locale.toString(record.fragmentCount) : tr("intact");
        case kCost: return record.isBreak() ? roundedText(record.milliseconds, {}, locale) : QString();
        default: return {};
    }
}

QVariant ImpactModel::data(const QModelIndex& index, int role) const {
    const ImpactRecord& record = impact(index.row());
    if (role == Qt::DisplayRole) return text(record, index.column());
    if (role == Qt::TextAlignmentRole && index.column() != kName) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole) return tr("Double-click to go to the place and time of the impact");
    if (role == Qt::ForegroundRole && !record.isBreak()) return QGuiApplication::palette().placeholderText();
    return {};
}

QVariant ImpactModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole && section != kName) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && section == kRatio) return tr("Impact divided by threshold");
    if (role != Qt::DisplayRole) return {};
    const std::array titles = {tr("Time (s)"),        tr("Body"),      tr("Ratio"),           tr("Impact (N·s)"),
                               tr("Threshold (N·s)"), tr("Fragments"), tr("Computed in (ms)")};
    return titles[static_cast<std::size_t>(section)];
}

}  // namespace rubble

#include "moc_ImpactModel.cpp"
