#pragma once

#include "editor/document/Document.h"
#include "editor/widgets/numbers/Units.h"

#include <QAbstractTableModel>

#include <functional>

namespace rubble {

/// The points of one ring of an asset's outline as a table of x and y. An edit that would make the outline invalid,
/// such as a self-intersection, is refused with a message.
class OutlineModel : public QAbstractTableModel {
    Q_OBJECT
public:
    explicit OutlineModel(Document& document, QObject* parent = nullptr);

    /// Ring 0 is the outer ring, ring k hole k - 1.
    void setRing(Id asset, std::size_t ring);
    std::size_t ring() const { return m_ring; }
    void setUnits(const Units& units);
    const Units& units() const { return m_units; }
    /// Reads the document again.
    void refresh();

    /// Inserts the midpoint of the edge from this row to the next.
    void insertAfter(int row);
    /// Deletes points; at least three must remain.
    void removePoints(std::vector<int> rows);
    /// Adds a small square hole at the outline's centroid. Returns false if there is no room.
    bool addHole();
    /// Deletes the hole that is shown.
    void removeHole();

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    /// Qt::EditRole is the coordinate in metres.
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

signals:
    void refused(const QString& sentence);

private:
    bool push(const QString& text, const std::function<void(Ring&)>& change);
    bool pushOutline(const QString& text, Polygon outline);
    /// Null if there is none, or it is a mesh.
    const Asset* asset() const {
        const Asset* found = findAsset(m_document.project(), m_asset);
        return found && found->isPrism() ? found : nullptr;
    }

    Document& m_document;
    Units m_units;
    Id m_asset = 0;
    std::size_t m_ring = 0;
    Ring m_points;  // as last shown
};

}  // namespace rubble
