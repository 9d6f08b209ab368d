#pragma once

#include "editor/document/Document.h"
#include "editor/panels/Units.h"

#include <QAbstractItemModel>

#include <vector>

namespace rubble {

/// A document as a tree: its materials, its assets with the layers of their patterns below, and the scene with its
/// instances. It follows the document row by row, so that views keep what is unfolded and chosen.
class ProjectModel : public QAbstractItemModel {
    Q_OBJECT
public:
    /// What a row stands for.
    enum class Kind { Materials, Assets, Scene, Material, Asset, Layer, Instance };
    struct Node {
        Kind kind = Kind::Scene;
        Id id = 0;  // 0 for the three at the top
        bool operator==(const Node&) const = default;
    };

    /// Marks of an instance: true, false, or not valid for other rows. Setting one alters the instance.
    enum Role { kHiddenRole = Qt::UserRole, kLockedRole };

    explicit ProjectModel(Document& document, QObject* parent = nullptr);

    Node nodeAt(const QModelIndex& index) const;
    /// Not valid where the document holds no such thing.
    QModelIndex indexOf(Node node) const;
    /// The asset that an asset's or a layer's row belongs to; 0 for others.
    Id assetOf(Node node) const;
    void setUnits(const Units& units);

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    using QObject::parent;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    /// Renames, unless the name is refused; or marks.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// The first asset among them, which can be dragged into the 3D view.
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    QStringList mimeTypes() const override;

signals:
    /// A name was not taken.
    void refused(const QString& sentence);

private:
    void read();
    void take(const Changes& changes);
    void take(const Change& change);
    void insertRow(Kind group, Id id);
    void removeRow(Kind group, Id id);
    void followLayers(Id asset);
    std::vector<Id>& idsOf(Kind group);
    const std::vector<Id>& idsOf(Kind group) const;
    bool mark(Node node, int role, bool isOn);
    QString text(Node node) const;
    QString hint(Node node) const;
    QIcon icon(Node node) const;

    Document& m_document;
    Units m_units;
    std::vector<Id> m_materials;
    std::vector<Id> m_assets;
    std::vector<std::vector<Id>> m_layers;  // of each asset
    std::vector<Id> m_instances;
};

}  // namespace rubble
