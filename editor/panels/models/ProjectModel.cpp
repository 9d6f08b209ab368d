#include "editor/panels/models/ProjectModel.h"

#include "editor/commands/AssetPatterns.h"
#include "editor/commands/InstanceEdits.h"
#include "editor/commands/Renaming.h"
#include "editor/document/DraggedAsset.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/Buttons.h"
#include "editor/widgets/ColourButton.h"
#include "editor/widgets/appearance/LayerText.h"

#include <algorithm>
#include <set>

namespace rubble {

namespace {

using Node = ProjectModel::Node;
using NodeKind = ProjectModel::Kind;

constexpr int kGroups = 3;      // top-level rows
constexpr int kKindShift = 32;  // of the kind in an index's internal id, above the element's id

quintptr packed(Node node) { return static_cast<quintptr>(node.kind) << kKindShift | node.id; }
Node unpacked(quintptr packed) { return {static_cast<NodeKind>(packed >> kKindShift), static_cast<Id>(packed)}; }

NodeKind groupOf(NodeKind kind) {
    switch (kind) {
        case NodeKind::Material: return NodeKind::Materials;
        case NodeKind::Asset: return NodeKind::Assets;
        default: return NodeKind::Scene;
    }
}

NodeKind kindIn(NodeKind group) {
    switch (group) {
        case NodeKind::Materials: return NodeKind::Material;
        case NodeKind::Assets: return NodeKind::Asset;
        default: return NodeKind::Instance;
    }
}

Part partOf(NodeKind kind) {
    switch (kind) {
        case NodeKind::Material: return Part::Material;
        case NodeKind::Asset: return Part::Asset;
        case NodeKind::Instance: return Part::Instance;
        default: return Part::Scene;
    }
}

bool isNamed(NodeKind kind) { return partOf(kind) != Part::Scene; }

/// Calls function(layer, pattern index) for all layers, in the order of AssetPatterns.h. A layer that a fragment
/// inherits from its level is visited once, with the level.
template <class Function>
void forEachLayer(const Asset& asset, const Function& function) {
    std::set<Id> seen;
    for (std::size_t index = 0; index < patternCount(asset); ++index) {
        const Pattern* pattern = patternAt(asset, index);
        if (!pattern) continue;
        for (const PatternLayer& layer : pattern->layers) {
            if (seen.insert(layer.id).second) function(layer, index);
        }
    }
}

std::vector<Id> layerIds(const Asset& asset) {
    std::vector<Id> ids;
    forEachLayer(asset, [&](const PatternLayer& layer, std::size_t) { ids.push_back(layer.id); });
    return ids;
}

template <class List>
int rowOf(const List& ids, Id id) {
    const auto place = std::ranges::find(ids, id);
    return place == ids.end() ? -1 : static_cast<int>(place - ids.begin());
}

QVariant flagOf(const Project& project, Node node, int role) {
    const Instance* instance = node.kind == NodeKind::Instance ? findInstance(project, node.id) : nullptr;
    if (!instance) return {};
    return role == ProjectModel::kHiddenRole ? instance->isHidden : instance->isLocked;
}

}  // namespace

ProjectModel::ProjectModel(Document& document, QObject* parent) : QAbstractItemModel(parent), m_document(document) {
    read();
    connect(&document, &Document::changed, this, qOverload<const Changes&>(&ProjectModel::apply));
}

void ProjectModel::read() {
    const Project& project = m_document.project();
    m_materials.clear();
    m_assets.clear();
    m_layers.clear();
    m_instances.clear();
    for (const Material& material : project.materials) m_materials.push_back(material.id);
    for (const Asset& asset : project.assets) {
        m_assets.push_back(asset.id);
        m_layers.push_back(layerIds(asset));
    }
    for (const Instance& instance : project.instances) m_instances.push_back(instance.id);
}

void ProjectModel::apply(const Changes& changes) {
    if (!changes.isEverything) {
        for (const Change& change : changes.list) apply(change);
        return;
    }
    beginResetModel();
    read();
    endResetModel();
}

void ProjectModel::apply(const Change& change) {
    Kind kind = Kind::Scene;
    switch (change.part) {
        case Part::Material: kind = Kind::Material; break;
        case Part::Asset: kind = Kind::Asset; break;
        case Part::Instance: kind = Kind::Instance; break;
        default: return;
    }
    switch (change.kind) {
        case ChangeKind::Added: return insertRow(groupOf(kind), change.id);
        case ChangeKind::Removed: return removeRow(groupOf(kind), change.id);
        case ChangeKind::Modified: break;
    }
    if (kind == Kind::Asset) updateLayers(change.id);
    const QModelIndex index = indexOf({kind, change.id});
    emit dataChanged(index, index);
}

const std::vector<Id>& ProjectModel::idsOf(Kind group) const {
    if (group == Kind::Materials) return m_materials;
    return group == Kind::Assets ? m_assets : m_instances;
}

std::vector<Id>& ProjectModel::idsOf(Kind group) {
    return const_cast<std::vector<Id>&>(std::as_const(*this).idsOf(group));
}

void ProjectModel::insertRow(Kind group, Id id) {
    std::vector<Id>& ids = idsOf(group);
    const auto row = static_cast<int>(std::ranges::lower_bound(ids, id) - ids.begin());
    beginInsertRows(indexOf({group, 0}), row, row);
    ids.insert(ids.begin() + row, id);
    if (group == Kind::Assets) {
        m_layers.insert(m_layers.begin() + row, layerIds(*findAsset(m_document.project(), id)));
    }
    endInsertRows();
}

void ProjectModel::removeRow(Kind group, Id id) {
    std::vector<Id>& ids = idsOf(group);
    const int row = rowOf(ids, id);
    beginRemoveRows(indexOf({group, 0}), row, row);
    ids.erase(ids.begin() + row);
    if (group == Kind::Assets) m_layers.erase(m_layers.begin() + row);
    endRemoveRows();
}

/// Removes, moves and inserts rows to match the asset's layers.
void ProjectModel::updateLayers(Id asset) {
    const QModelIndex parent = indexOf({Kind::Asset, asset});
    std::vector<Id>& layers = m_layers[parent.row()];
    const std::vector<Id> wanted = layerIds(*findAsset(m_document.project(), asset));
    for (int row = static_cast<int>(layers.size()) - 1; row >= 0; --row) {
        if (rowOf(wanted, layers[row]) >= 0) continue;
        beginRemoveRows(parent, row, row);
        layers.erase(layers.begin() + row);
        endRemoveRows();
    }
    for (int row = 0; row < static_cast<int>(wanted.size()); ++row) {
        const int from = rowOf(layers, wanted[row]);
        if (from == row) continue;
        if (from < 0) {
            beginInsertRows(parent, row, row);
            layers.insert(layers.begin() + row, wanted[row]);
            endInsertRows();
        } else {
            beginMoveRows(parent, from, from, parent, row);
            std::rotate(layers.begin() + row, layers.begin() + from, layers.begin() + from + 1);
            endMoveRows();
        }
    }
    if (!layers.empty()) {
        emit dataChanged(index(0, 0, parent), index(static_cast<int>(layers.size()) - 1, 0, parent));
    }
}

void ProjectModel::setUnits(const Units& units) {
    m_units = units;
    for (const Id asset : m_assets) updateLayers(asset);
}

ProjectModel::Node ProjectModel::nodeAt(const QModelIndex& index) const { return unpacked(index.internalId()); }

QModelIndex ProjectModel::indexOf(Node node) const {
    int row = static_cast<int>(node.kind);  // one of the groups
    if (isNamed(node.kind)) row = rowOf(idsOf(groupOf(node.kind)), node.id);
    if (node.kind == Kind::Layer) {
        for (const std::vector<Id>& layers : m_layers) {
            row = rowOf(layers, node.id);
            if (row >= 0) break;
        }
    }
    return row < 0 ? QModelIndex() : createIndex(row, 0, packed(node));
}

Id ProjectModel::assetOf(Node node) const {
    if (node.kind == Kind::Asset) return node.id;
    if (node.kind != Kind::Layer) return 0;
    const auto isIn = [&](const std::vector<Id>& layers) { return rowOf(layers, node.id) >= 0; };
    const auto place = std::ranges::find_if(m_layers, isIn);
    return place == m_layers.end() ? 0 : m_assets[place - m_layers.begin()];
}

QModelIndex ProjectModel::index(int row, int column, const QModelIndex& parent) const {
    if (column != 0 || row < 0 || row >= rowCount(parent)) return {};
    if (!parent.isValid()) return createIndex(row, 0, packed({static_cast<Kind>(row), 0}));
    const Node above = nodeAt(parent);
    if (above.kind == Kind::Asset) {
        return createIndex(row, 0, packed({Kind::Layer, m_layers[parent.row()][row]}));
    }
    return createIndex(row, 0, packed({kindIn(above.kind), idsOf(above.kind)[row]}));
}

QModelIndex ProjectModel::parent(const QModelIndex& index) const {
    if (!index.isValid()) return {};
    const Node node = nodeAt(index);
    if (node.kind == Kind::Layer) return indexOf({Kind::Asset, assetOf(node)});
    return isNamed(node.kind) ? indexOf({groupOf(node.kind), 0}) : QModelIndex();
}

int ProjectModel::rowCount(const QModelIndex& parent) const {
    if (!parent.isValid()) return kGroups;
    switch (nodeAt(parent).kind) {
        case Kind::Materials: return static_cast<int>(m_materials.size());
        case Kind::Assets: return static_cast<int>(m_assets.size());
        case Kind::Scene: return static_cast<int>(m_instances.size());
        case Kind::Asset: return static_cast<int>(m_layers[parent.row()].size());
        default: return 0;
    }
}

int ProjectModel::columnCount(const QModelIndex&) const { return 1; }

QString ProjectModel::name(Node node) const {
    return isNamed(node.kind) ? nameOf(m_document.project(), partOf(node.kind), node.id) : text(node);
}

QString ProjectModel::text(Node node) const {
    switch (node.kind) {
        case Kind::Materials: return tr("Materials");
        case Kind::Assets: return tr("Assets");
        case Kind::Scene: return tr("Scene");
        case Kind::Layer: break;
        default: return nameText(name(node).toStdString());
    }
    QString text;
    if (const Asset* asset = findAsset(m_document.project(), assetOf(node))) {
        forEachLayer(*asset, [&](const PatternLayer& layer, std::size_t pattern) {
            if (layer.id != node.id) return;
            text = numberedLayerText(layer, m_units);
            if (pattern > 0) {
                text = pattern <= asset->levels.size() ? tr("Level %1: %2").arg(pattern).arg(text)
                                                       : tr("%1: %2").arg(patternName(*asset, pattern), text);
            }
            if (!layer.isOn) text = tr("%1 (disabled)").arg(text);
        });
    }
    return text;
}

/// Begins with the text of the row, which may be elided there.
QString ProjectModel::hint(Node node) const {
    const Project& project = m_document.project();
    const auto assetName = [&](Id id) { return nameText(nameOf(project, Part::Asset, id).toStdString()); };
    switch (node.kind) {
        case Kind::Materials: return tr("Materials of the project");
        case Kind::Assets: return tr("Solids with their fracture patterns");
        case Kind::Scene: return tr("Ground, gravity and the placed instances");
        case Kind::Layer: return text(node) + '\n' + tr("Pattern layer of asset \"%1\"").arg(assetName(assetOf(node)));
        case Kind::Instance: {
            const Instance* instance = findInstance(project, node.id);
            return instance ? text(node) + '\n' + tr("Instance of asset \"%1\"").arg(assetName(instance->asset)) : "";
        }
        default: return text(node);
    }
}

QIcon ProjectModel::icon(Node node) const {
    switch (node.kind) {
        case Kind::Material: {
            const Material* material = findMaterial(m_document.project(), node.id);
            return material ? swatchIcon(material->outside) : QIcon();
        }
        case Kind::Materials: return iconNamed("material");
        case Kind::Assets:
        case Kind::Asset: return iconNamed("asset");
        case Kind::Scene: return iconNamed("scene");
        case Kind::Instance: return iconNamed("instance");
        case Kind::Layer: return iconNamed("layer");
    }
    return {};
}

QVariant ProjectModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const Node node = nodeAt(index);
    switch (role) {
        case Qt::DisplayRole: return text(node);
        case Qt::EditRole: return name(node);
        case Qt::ToolTipRole: return toolTipText(hint(node));
        case Qt::DecorationRole: return icon(node);
        case kHiddenRole:
        case kLockedRole: return flagOf(m_document.project(), node, role);
        default: return {};
    }
}

bool ProjectModel::setFlag(Node node, int role, bool isOn) {
    const Instance* instance = node.kind == Kind::Instance ? findInstance(m_document.project(), node.id) : nullptr;
    if (!instance) return false;
    Instance changed = *instance;
    (role == kHiddenRole ? changed.isHidden : changed.isLocked) = isOn;
    const QString text = role == kHiddenRole ? (isOn ? tr("Hide Instance") : tr("Show Instance"))
                                             : (isOn ? tr("Lock Instance") : tr("Unlock Instance"));
    return m_document.push(modify(text, std::move(changed)));
}

bool ProjectModel::acceptsName(const QModelIndex& index, const QString& name) {
    const Node node = nodeAt(index);
    const QString fault = nameFault(m_document.project(), partOf(node.kind), node.id, name);
    if (!fault.isEmpty()) emit refused(fault);
    return fault.isEmpty();
}

bool ProjectModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (index.isValid() && (role == kHiddenRole || role == kLockedRole)) {
        return setFlag(nodeAt(index), role, value.toBool());
    }
    if (role != Qt::EditRole || !index.isValid()) return false;
    if (!acceptsName(index, value.toString())) return false;
    const Node node = nodeAt(index);
    return m_document.push(renameElement(m_document.project(), partOf(node.kind), node.id, value.toString()));
}

Qt::ItemFlags ProjectModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::NoItemFlags;
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    flags.setFlag(Qt::ItemIsDragEnabled, nodeAt(index).kind == Kind::Asset);
    return isNamed(nodeAt(index).kind) ? flags | Qt::ItemIsEditable : flags;
}

QMimeData* ProjectModel::mimeData(const QModelIndexList& indexes) const {
    for (const QModelIndex& index : indexes) {
        const Node node = nodeAt(index);
        if (node.kind == Kind::Asset) return mimeDataOf(node.id);
    }
    return nullptr;
}

QStringList ProjectModel::mimeTypes() const { return {kAssetMimeType}; }

}  // namespace rubble

#include "moc_ProjectModel.cpp"
