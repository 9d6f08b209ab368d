#pragma once

#include "editor/document/Document.h"
#include "editor/panels/Units.h"

#include <QAbstractTableModel>

#include <functional>

namespace rubble {

/// The points of one ring of an asset's outline, a row each: x and y. A point that would make the outline cross itself,
/// or fault it otherwise, is refused with the fault's sentence.
class OutlineModel : public QAbstractTableModel {
    Q_OBJECT
public:
    explicit OutlineModel(Document& document, QObject* parent = nullptr);

    /// `ring` 0 is the outer one, k the k-th hole.
    void setRing(Id asset, std::size_t ring);
    std::size_t ring() const { return m_ring; }
    void setUnits(const Units& units);
    const Units& units() const { return m_units; }
    /// Reads the document again.
    void refresh();

    /// Adds a point in the middle of the edge behind a row.
    void insertAfter(int row);
    /// Takes points out; three must stay.
    void removePoints(std::vector<int> rows);
    /// Adds a small square hole in the middle of the outline, where there is room.
    bool addHole();
    /// Takes the hole that is shown out.
    void removeHole();

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    /// Qt::EditRole gives the coordinate as it is stored, m.
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

signals:
    void refused(const QString& sentence);

private:
    bool push(const QString& text, const std::function<void(Ring&)>& change);
    bool pushOutline(const QString& text, Polygon outline);
    const Asset* asset() const { return findAsset(m_document.project(), m_asset); }

    Document& m_document;
    Units m_units;
    Id m_asset = 0;
    std::size_t m_ring = 0;
    Ring m_points;  // as the view knows them
};

}  // namespace rubble
