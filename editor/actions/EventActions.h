#pragma once

#include "core/base/TaskContext.h"
#include "core/io/play/EventsFile.h"

#include <QObject>

#include <functional>

class QAction;

namespace rubble {

class PlayController;
class Views;

/// The actions that export the events of the simulation, in the Play menu and in the Play dock.
class EventActions : public QObject {
    Q_OBJECT
public:
    explicit EventActions(Views& views);

    QList<QAction*> actions() const { return {m_exportAll, m_exportShown}; }

private:
    using TextMaker = std::function<Result<std::string>(EventsFormat format, const TaskContext& task)>;

    void refresh();
    void exportAll();
    void exportShown();
    /// Asks for a file; empty if the user cancels.
    QString askForFile(const QString& title);
    /// Writes the text with this number of events to a file.
    void write(const QString& path, std::size_t count, const TextMaker& makeText);
    PlayController& controller() const;

    Views& m_views;
    QAction* m_exportAll;
    QAction* m_exportShown;
};

}  // namespace rubble
