#pragma once

#include "editor/document/Document.h"
#include "editor/panels/Units.h"

#include <QAbstractListModel>

namespace rubble {

/// Where a pattern stands: that of an asset's whole (level 0), of one of its levels, or of a fragment: see PatternPlaces.h.
struct PatternPlace {
    Id asset = 0;
    std::size_t level = 0;
    bool operator==(const PatternPlace&) const = default;
};

/// The pattern at a place, or null.
const Pattern* findPattern(const Project& project, PatternPlace place);
/// A copy of the asset with another pattern there.
Asset withPattern(const Project& project, PatternPlace place, Pattern pattern);

/// The layers of a pattern, in the order they are carried out; ticked where they are on.
class LayerModel : public QAbstractListModel {
    Q_OBJECT
public:
    explicit LayerModel(Document& document, QObject* parent = nullptr);

    void setPlace(PatternPlace place);
    PatternPlace place() const { return m_place; }
    void setUnits(const Units& units);
    /// Reads the document again.
    void refresh();
    /// 0 where there is no such row.
    Id layerAt(int row) const;
    /// -1 where there is no such layer.
    int rowOf(Id layer) const;

    /// Moves a layer up or down by rows.
    void move(Id layer, int by);
    void remove(Id layer);
    /// Adds a copy behind a layer and gives its id.
    Id duplicate(Id layer);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    /// What a drag in a view does: one layer goes in front of another, as one step.
    bool moveRows(const QModelIndex& from, int row, int count, const QModelIndex& to, int before) override;

private:
    void push(const QString& text, Pattern pattern);

    Document& m_document;
    Units m_units;
    PatternPlace m_place;
    std::vector<Id> m_layers;
};

}  // namespace rubble
