#include "editor/panels/models/LayerModel.h"

#include "editor/commands/AssetPatterns.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/widgets/Buttons.h"
#include "editor/widgets/appearance/LayerText.h"

#include <algorithm>

namespace rubble {

namespace {

auto find(Pattern& pattern, Id layer) { return std::ranges::find(pattern.layers, layer, &PatternLayer::id); }

/// Returns the layer that was inserted, or 0 if the lists differ otherwise.
Id addedLayer(const std::vector<Id>& before, const std::vector<Id>& after) {
    if (after.size() != before.size() + 1) return 0;
    const auto [rest, added] = std::ranges::mismatch(before, after);
    return std::equal(rest, before.end(), added + 1) ? *added : 0;
}

}  // namespace

const Pattern* findPattern(const Project& project, PatternRef ref) {
    const Asset* asset = findAsset(project, ref.asset);
    return asset && ref.index < patternCount(*asset) ? patternAt(*asset, ref.index) : nullptr;
}

Asset withPattern(const Project& project, PatternRef ref, Pattern pattern) {
    Asset asset = *findAsset(project, ref.asset);
    patternAt(asset, ref.index) = std::move(pattern);
    return asset;
}

LayerModel::LayerModel(Document& document, QObject* parent) : QAbstractListModel(parent), m_document(document) {}

void LayerModel::setPattern(PatternRef ref) {
    m_pattern = ref;
    refresh();
}

void LayerModel::setUnits(const Units& units) {
    m_units = units;
    refresh();
}

void LayerModel::refresh() {
    std::vector<Id> layers;
    if (const Pattern* pattern = findPattern(m_document.project(), m_pattern)) {
        for (const PatternLayer& layer : pattern->layers) layers.push_back(layer.id);
    }
    if (layers != m_layers) {
        const Id added = addedLayer(m_layers, layers);
        beginResetModel();
        m_layers = std::move(layers);
        endResetModel();
        if (added != 0) emit layerAdded(added);
    } else if (!m_layers.empty()) {
        emit dataChanged(index(0), index(rowCount() - 1));
    }
}

Id LayerModel::layerAt(int row) const { return row >= 0 && row < rowCount() ? m_layers[row] : 0; }

int LayerModel::rowOf(Id layer) const {
    const auto place = std::ranges::find(m_layers, layer);
    return place == m_layers.end() ? -1 : static_cast<int>(place - m_layers.begin());
}

void LayerModel::push(const QString& text, Pattern pattern) {
    m_document.push(modify(text, withPattern(m_document.project(), m_pattern, std::move(pattern))));
}

void LayerModel::move(Id layer, int by) {
    const int row = rowOf(layer);
    if (row < 0 || row + by < 0 || row + by >= rowCount()) return;
    Pattern pattern = *findPattern(m_document.project(), m_pattern);
    PatternLayer moved = *find(pattern, layer);
    pattern.layers.erase(find(pattern, layer));
    pattern.layers.insert(pattern.layers.begin() + row + by, std::move(moved));
    push(tr("Move Layer"), std::move(pattern));
}

void LayerModel::remove(Id layer) {
    if (rowOf(layer) < 0) return;
    Pattern pattern = *findPattern(m_document.project(), m_pattern);
    pattern.layers.erase(find(pattern, layer));
    push(tr("Delete Layer"), std::move(pattern));
}

Id LayerModel::duplicate(Id layer) {
    if (rowOf(layer) < 0) return 0;
    Edit edit{.text = tr("Duplicate Layer")};
    Pattern pattern = *findPattern(m_document.project(), m_pattern);
    PatternLayer copy = *find(pattern, layer);
    copy.id = edit.allocateId(m_document.project());
    copy.randomSeed = copy.id;  // a copy with the same random seed would repeat all seeds
    const Id id = copy.id;
    pattern.layers.insert(find(pattern, layer) + 1, std::move(copy));
    edit.replacements = {
        Replacement<Asset>{m_pattern.asset, withPattern(m_document.project(), m_pattern, std::move(pattern))}};
    return m_document.push(std::move(edit)) ? id : 0;
}

int LayerModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_layers.size());
}

QVariant LayerModel::data(const QModelIndex& index, int role) const {
    const Pattern* pattern = findPattern(m_document.project(), m_pattern);
    if (!index.isValid() || !pattern) return {};
    const auto layer = std::ranges::find(pattern->layers, layerAt(index.row()), &PatternLayer::id);
    if (layer == pattern->layers.end()) return {};
    switch (role) {
        case Qt::DisplayRole: return numberedLayerText(*layer, m_units);
        case Qt::DecorationRole: return iconNamed(kindOf(layer->parameters).icon);
        case Qt::CheckStateRole: return layer->isOn ? Qt::Checked : Qt::Unchecked;
        case Qt::ToolTipRole: return tr("Layer %1. Enabled layers are evaluated from top to bottom").arg(layer->id);
        default: return {};
    }
}

bool LayerModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::CheckStateRole || !index.isValid()) return false;
    const bool isOn = value.toInt() == Qt::Checked;
    Pattern pattern = *findPattern(m_document.project(), m_pattern);
    find(pattern, layerAt(index.row()))->isOn = isOn;
    push(isOn ? tr("Enable Layer") : tr("Disable Layer"), std::move(pattern));
    return true;
}

Qt::ItemFlags LayerModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::ItemIsDropEnabled;  // drop between rows only
    return QAbstractListModel::flags(index) | Qt::ItemIsUserCheckable | Qt::ItemIsDragEnabled;
}

bool LayerModel::moveRows(const QModelIndex&, int row, int count, const QModelIndex&, int before) {
    if (count != 1 || before == row || before == row + 1) return false;
    move(layerAt(row), (before > row ? before - 1 : before) - row);
    return true;
}

}  // namespace rubble

#include "moc_LayerModel.cpp"
