#pragma once

#include "core/asset/project/Project.h"
#include "editor/play/PlayEvent.h"

#include <QAbstractTableModel>

#include <cstdint>
#include <limits>
#include <map>

namespace rubble {

/// Events of a play session as a table, which it sorts itself: 200,000 rows and more are appended to in a moment.
class EventModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column {
        kKind,
        kTime,
        kBody,
        kOther,
        kRatio,
        kImpulse,
        kSpeed,
        kEnergy,
        kMass,
        kCount,
        kMaterials,
        kThreshold,
        kCost,
        kColumns
    };

    using QAbstractTableModel::QAbstractTableModel;

    /// Shows these events, by ascending step; `stepLength` in s. Events that only follow those shown are inserted, and
    /// a rest that is gone is removed, without a reset of the model.
    void setEvents(const std::vector<EventRef>& events, double stepLength);
    /// Shows the events after this step faint and in italics; none at first.
    void setDisplayedStep(std::uint64_t step);
    /// Sets the materials, whose names are shown.
    void setMaterials(const std::vector<Material>& materials);
    const EventRef& event(int row) const { return m_rows[static_cast<std::size_t>(row)]; }
    /// The row of an event; -1 if it is not shown.
    int rowOf(const EventRef& event) const;
    /// Whether a column has numbers.
    static bool isNumeric(int column);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// Equal values are in order of time.
    void sort(int column, Qt::SortOrder order) override;

private:
    bool isInTime() const { return m_column == kTime && m_order == Qt::AscendingOrder; }
    bool isBefore(const PlayEvent& a, const PlayEvent& b) const;
    int compare(const PlayEvent& a, const PlayEvent& b) const;
    void sortRows();
    void append(std::span<const EventRef> events);
    void reset(const std::vector<EventRef>& events);
    QString materialName(Id id) const;
    QString materialsOf(const EventRecord& record) const;
    QString text(const PlayEvent& event, int column) const;
    QString toolTip(const PlayEvent& event) const;

    std::vector<EventRef> m_events;  // by time
    std::vector<EventRef> m_rows;    // the same as they are shown
    std::map<Id, QString> m_materials;
    int m_column = kTime;  // by which they are sorted
    Qt::SortOrder m_order = Qt::AscendingOrder;
    double m_stepLength = 1.0 / 60.0;
    std::uint64_t m_displayedStep = std::numeric_limits<std::uint64_t>::max();
};

}  // namespace rubble
