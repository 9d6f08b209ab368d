#pragma once

#include "editor/panels/models/EventModel.h"

#include <QTableView>

namespace rubble {

/// A sortable table of events. The menu of its header shows and hides columns.
class EventTable : public QTableView {
    Q_OBJECT
public:
    explicit EventTable(QWidget* parent = nullptr);

    /// Shows these events; `stepLength` in s. The selected event stays selected. A table at its end stays there.
    void setEvents(const std::vector<EventRef>& events, double stepLength);
    /// Shows the events after this step faint and in italics.
    void setDisplayedStep(std::uint64_t step) { m_model->setDisplayedStep(step); }
    void setMaterials(const std::vector<Material>& materials) { m_model->setMaterials(materials); }
    /// The selected event; null if none is.
    EventRef selectedEvent() const;

    /// The names of the hidden columns, which are not translated.
    QStringList hiddenColumns() const;
    void setHiddenColumns(const QStringList& names);
    static QStringList hiddenByDefault();

signals:
    void eventActivated(const rubble::EventRef& event);
    void eventSelected();

private:
    void addColumnMenu();
    void widenColumns();

    EventModel* m_model;
};

}  // namespace rubble
