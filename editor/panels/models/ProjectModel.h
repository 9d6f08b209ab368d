#pragma once

#include "editor/document/Document.h"
#include "editor/widgets/numbers/Units.h"

#include <QAbstractItemModel>

#include <vector>

namespace rubble {

/// A project as a tree: materials, assets with the layers of their patterns, and the scene with its instances. Changes
/// insert and remove single rows, so that views keep their expanded and selected rows.
class ProjectModel : public QAbstractItemModel {
    Q_OBJECT
public:
    /// The kinds of rows.
    enum class Kind { Materials, Assets, Scene, Material, Asset, Layer, Instance };
    struct Node {
        Kind kind = Kind::Scene;
        Id id = 0;  // 0 for the three top-level rows
        bool operator==(const Node&) const = default;
    };

    /// The flags of an instance as bool; invalid for other rows. Setting one changes the instance.
    enum Role { kHiddenRole = Qt::UserRole, kLockedRole };

    explicit ProjectModel(Document& document, QObject* parent = nullptr);

    Node nodeAt(const QModelIndex& index) const;
    /// Invalid if the project has no such element.
    QModelIndex indexOf(Node node) const;
    /// The asset of an asset's or a layer's row; 0 for other rows.
    Id assetOf(Node node) const;
    void setUnits(const Units& units);

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    using QObject::parent;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    /// Whether the element can have this name; emits `refused` if not.
    bool acceptsName(const QModelIndex& index, const QString& name);
    /// Renames the element, or sets a flag of an instance.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// The first asset among the rows, for dragging into the 3D view.
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    QStringList mimeTypes() const override;

signals:
    /// A name was refused.
    void refused(const QString& sentence);

private:
    void read();
    void apply(const Changes& changes);
    void apply(const Change& change);
    void insertRow(Kind group, Id id);
    void removeRow(Kind group, Id id);
    void updateLayers(Id asset);
    std::vector<Id>& idsOf(Kind group);
    const std::vector<Id>& idsOf(Kind group) const;
    bool setFlag(Node node, int role, bool isOn);
    QString name(Node node) const;
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
