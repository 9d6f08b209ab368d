#pragma once

#include "editor/document/Document.h"
#include "editor/widgets/numbers/Units.h"

#include <QAbstractListModel>

namespace rubble {

/// Names one of the patterns of an asset, by its index as in AssetPatterns.h.
struct PatternRef {
    Id asset = 0;
    std::size_t index = 0;
    bool operator==(const PatternRef&) const = default;
};

/// The pattern, or null if there is none.
const Pattern* findPattern(const Project& project, PatternRef ref);
/// A copy of the asset with that pattern replaced.
Asset withPattern(const Project& project, PatternRef ref, Pattern pattern);

/// The layers of a pattern in order of evaluation, with a check box that enables each.
class LayerModel : public QAbstractListModel {
    Q_OBJECT
public:
    explicit LayerModel(Document& document, QObject* parent = nullptr);

    void setPattern(PatternRef ref);
    PatternRef pattern() const { return m_pattern; }
    void setUnits(const Units& units);
    /// Reads the document again.
    void refresh();
    /// 0 if there is no such row.
    Id layerAt(int row) const;
    /// -1 if there is no such layer.
    int rowOf(Id layer) const;

    /// Moves a layer by a number of rows; negative: up.
    void move(Id layer, int by);
    void remove(Id layer);
    /// Inserts a copy after a layer and returns its id.
    Id duplicate(Id layer);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    /// Moves one layer before another as one undo step, for drag and drop.
    bool moveRows(const QModelIndex& from, int row, int count, const QModelIndex& to, int before) override;

signals:
    /// The pattern got one more layer: a new one, or one that undo or redo brought back.
    void layerAdded(Id layer);

private:
    void push(const QString& text, Pattern pattern);

    Document& m_document;
    Units m_units;
    PatternRef m_pattern;
    std::vector<Id> m_layers;
};

}  // namespace rubble
