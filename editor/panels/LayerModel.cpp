#include "editor/panels/LayerModel.h"

#include "editor/commands/PatternPlaces.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/panels/Icons.h"
#include "editor/panels/LayerText.h"

#include <algorithm>

namespace rubble {

namespace {

auto placeOf(Pattern& pattern, Id layer) { return std::ranges::find(pattern.layers, layer, &PatternLayer::id); }

}  // namespace

const Pattern* findPattern(const Project& project, PatternPlace place) {
    const Asset* asset = findAsset(project, place.asset);
    return asset && place.level < patternCount(*asset) ? patternAt(*asset, place.level) : nullptr;
}

Asset withPattern(const Project& project, PatternPlace place, Pattern pattern) {
    Asset asset = *findAsset(project, place.asset);
    patternAt(asset, place.level) = std::move(pattern);
    return asset;
}

LayerModel::LayerModel(Document& document, QObject* parent) : QAbstractListModel(parent), m_document(document) {}

void LayerModel::setPlace(PatternPlace place) {
    m_place = place;
    refresh();
}

void LayerModel::setUnits(const Units& units) {
    m_units = units;
    refresh();
}

void LayerModel::refresh() {
    std::vector<Id> layers;
    if (const Pattern* pattern = findPattern(m_document.project(), m_place)) {
        for (const PatternLayer& layer : pattern->layers) layers.push_back(layer.id);
    }
    if (layers != m_layers) {
        beginResetModel();
        m_layers = std::move(layers);
        endResetModel();
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
    m_document.push(altered(text, withPattern(m_document.project(), m_place, std::move(pattern))));
}

void LayerModel::move(Id layer, int by) {
    const int row = rowOf(layer);
    if (row < 0 || row + by < 0 || row + by >= rowCount()) return;
    Pattern pattern = *findPattern(m_document.project(), m_place);
    PatternLayer moved = *placeOf(pattern, layer);
    pattern.layers.erase(placeOf(pattern, layer));
    pattern.layers.insert(pattern.layers.begin() + row + by, std::move(moved));
    push(tr("Move layer"), std::move(pattern));
}

void LayerModel::remove(Id layer) {
    if (rowOf(layer) < 0) return;
    Pattern pattern = *findPattern(m_document.project(), m_place);
    pattern.layers.erase(placeOf(pattern, layer));
    push(tr("Delete layer"), std::move(pattern));
}

Id LayerModel::duplicate(Id layer) {
    if (rowOf(layer) < 0) return 0;
    Edit edit{.text = tr("Duplicate layer")};
    Pattern pattern = *findPattern(m_document.project(), m_place);
    PatternLayer copy = *placeOf(pattern, layer);
    copy.id = edit.takeId(m_document.project());
    copy.randomSeed = copy.id;  // the same seeds twice would be of no use
    const Id id = copy.id;
    pattern.layers.insert(placeOf(pattern, layer) + 1, std::move(copy));
    edit.swaps = {Swap<Asset>{m_place.asset, withPattern(m_document.project(), m_place, std::move(pattern))}};
    m_document.push(std::move(edit));
    return id;
}

int LayerModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_layers.size());
}

QVariant LayerModel::data(const QModelIndex& index, int role) const {
    const Pattern* pattern = findPattern(m_document.project(), m_place);
    if (!index.isValid() || !pattern) return {};
    const auto layer = std::ranges::find(pattern->layers, layerAt(index.row()), &PatternLayer::id);
    if (layer == pattern->layers.end()) return {};
    switch (role) {
        case Qt::DisplayRole: return layerText(*layer, m_units, {});
        case Qt::DecorationRole: return iconNamed(kindIconName(layer->parameters));
        case Qt::CheckStateRole: return layer->isOn ? Qt::Checked : Qt::Unchecked;
        case Qt::ToolTipRole: return tr("Layer %1. Ticked layers take part, from top to bottom").arg(layer->id);
        default: return {};
    }
}

bool LayerModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::CheckStateRole || !index.isValid()) return false;
    Pattern pattern = *findPattern(m_document.project(), m_place);
    placeOf(pattern, layerAt(index.row()))->isOn = value.toInt() == Qt::Checked;
    push(tr("Switch layer"), std::move(pattern));
    return true;
}

Qt::ItemFlags LayerModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::ItemIsDropEnabled;  // between rows, never onto one
    return QAbstractListModel::flags(index) | Qt::ItemIsUserCheckable | Qt::ItemIsDragEnabled;
}

bool LayerModel::moveRows(const QModelIndex&, int row, int count, const QModelIndex&, int before) {
    if (count != 1 || before == row || before == row + 1) return false;
    move(layerAt(row), (before > row ? before - 1 : before) - row);
    return true;
}

}  // namespace rubble
