#pragma once

#include "editor/document/Document.h"
#include "editor/widgets/numbers/Units.h"

#include <QAbstractTableModel>

namespace rubble {

/// The bond strengths of an asset by height, ascending, as a table of heights and factors. An edit that would make two
/// heights the same is refused with a message.
class HeightStrengthModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Height, Factor, kColumns };

    explicit HeightStrengthModel(Document& document, QObject* parent = nullptr);

    void setAsset(Id asset);
    void setUnits(const Units& units);
    const Units& units() const { return m_units; }
    /// Reads the document again.
    void refresh();

    /// Inserts a strength between this row and the next; above the last, half way to the top of the outline. Returns
    /// its row, or -1 if there is no room.
    int insertAfter(int row);
    void removeStrengths(std::vector<int> rows);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    /// Qt::EditRole is the height in metres, or the factor.
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

signals:
    void refused(const QString& sentence);

private:
    NumberFormat formatOf(int column) const { return column == Height ? m_units.lengths() : NumberFormat{}; }
    const Asset* asset() const { return findAsset(m_document.project(), m_asset); }
    bool push(const QString& text, std::vector<HeightStrength> strengths);

    Document& m_document;
    Units m_units;
    Id m_asset = 0;
    std::vector<HeightStrength> m_strengths;  // as last shown
};

}  // namespace rubble
