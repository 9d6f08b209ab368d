#include "editor/panels/models/HeightStrengthModel.h"

#include "core/asset/project/AssetShape.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "editor/widgets/numbers/NumberText.h"

#include <algorithm>

namespace rubble {

HeightStrengthModel::HeightStrengthModel(Document& document, QObject* parent)
    : QAbstractTableModel(parent), m_document(document) {}

void HeightStrengthModel::setAsset(Id asset) {
    m_asset = asset;
    refresh();
}

void HeightStrengthModel::setUnits(const Units& units) {
    m_units = units;
    if (!m_strengths.empty()) emit dataChanged(index(0, Height), index(rowCount() - 1, Height));
    emit headerDataChanged(Qt::Horizontal, Height, Height);
}

void HeightStrengthModel::refresh() {
    const Asset* shown = asset();
    std::vector<HeightStrength> strengths = shown ? shown->bonding.heightStrengths : std::vector<HeightStrength>{};
    if (strengths.size() != m_strengths.size()) {
        beginResetModel();
        m_strengths = std::move(strengths);
        endResetModel();
    } else if (strengths != m_strengths) {
        m_strengths = std::move(strengths);
        emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
    }
}

bool HeightStrengthModel::push(const QString& text, std::vector<HeightStrength> strengths) {
    Asset changed = *asset();
    changed.bonding.heightStrengths = std::move(strengths);
    return m_document.push(modify(text, std::move(changed)));
}

int HeightStrengthModel::insertAfter(int row) {
    const Asset* shown = asset();
    if (!shown) return -1;
    std::vector<HeightStrength> strengths = m_strengths;
    const auto at = static_cast<std::size_t>(std::clamp(row + 1, 0, rowCount()));
    HeightStrength added;
    if (at > 0) {
        added = strengths[at - 1];
        const double top = sizeOf(*shown).y;
        const double next = at < strengths.size() ? strengths[at].height : std::max(top, 2.0 * added.height);
        added.height = (added.height + next) / 2.0;
    }
    const bool hasRoom = (at == 0 || strengths[at - 1].height < added.height) &&
                         (at == strengths.size() || added.height < strengths[at].height);
    if (!hasRoom) {
        emit refused(tr("There is no height between the two. Change one of them first."));
        return -1;
    }
    strengths.insert(strengths.begin() + static_cast<std::ptrdiff_t>(at), added);
    return push(tr("Add Bond Strength by Height"), std::move(strengths)) ? static_cast<int>(at) : -1;
}

void HeightStrengthModel::removeStrengths(std::vector<int> rows) {
    if (!asset() || rows.empty()) return;
    std::vector<HeightStrength> rest;
    for (int row = 0; row < rowCount(); ++row) {
        if (std::ranges::find(rows, row) == rows.end()) rest.push_back(m_strengths[static_cast<std::size_t>(row)]);
    }
    push(tr("Delete Bond Strength by Height"), std::move(rest));
}

int HeightStrengthModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_strengths.size());
}

int HeightStrengthModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant HeightStrengthModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const HeightStrength& strength = m_strengths[static_cast<std::size_t>(index.row())];
    const double value = index.column() == Height ? strength.height : strength.factor;
    const NumberFormat format = formatOf(index.column());
    switch (role) {
        case Qt::DisplayRole: return roundedText(value, format);
        case Qt::ToolTipRole:
            return tr("At a height of %1, bonds are %2 times as strong")
                .arg(withUnit(exactText(strength.height, formatOf(Height), {}), formatOf(Height)),
                     exactText(strength.factor, formatOf(Factor), {}));
        case Qt::EditRole: return value;
        case Qt::TextAlignmentRole: return QVariant(Qt::AlignRight | Qt::AlignVCenter);
        default: return {};
    }
}

bool HeightStrengthModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid() || !asset()) return false;
    std::vector<HeightStrength> strengths = m_strengths;
    HeightStrength& edited = strengths[static_cast<std::size_t>(index.row())];
    const double entered = value.toDouble();
    if (index.column() == Factor) {
        edited.factor = entered;
        return push(tr("Set Bond Strength by Height"), std::move(strengths));
    }
    if (edited.height == entered) return false;
    if (std::ranges::find(strengths, entered, &HeightStrength::height) != strengths.end()) {
        emit refused(tr("There is a strength at the height %1 already. Enter another height.")
                         .arg(roundedQuantity(entered, m_units.lengths())));
        return false;
    }
    edited.height = entered;
    std::ranges::sort(strengths, {}, &HeightStrength::height);
    return push(tr("Set Height of Bond Strength"), std::move(strengths));
}

QVariant HeightStrengthModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole || orientation == Qt::Vertical) return {};
    return section == Height ? QString("%1 (%2)").arg(tr("Height"), m_units.lengths().unit) : tr("Strength (×)");
}

Qt::ItemFlags HeightStrengthModel::flags(const QModelIndex& index) const {
    return QAbstractTableModel::flags(index) | Qt::ItemIsEditable;
}

}  // namespace rubble

#include "moc_HeightStrengthModel.cpp"
