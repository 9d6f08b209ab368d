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
    using TextMaker = std::function<Result<std::string>(const TaskContext& task)>;
    /// A file to write; of an empty path if the user cancels.
    struct OutputFile {
        QString path;
        EventsFormat format = EventsFormat::Csv;
    };

    void refresh();
    void exportAll();
    void exportShown();
    /// Asks for a file of one of these formats.
    OutputFile askForFile(const QString& title, const QList<EventsFormat>& formats);
    /// Writes a text to a file, and displays `message` with the file's name in place of %1.
    void write(const QString& path, const QString& message, const TextMaker& makeText);
    PlayController& controller() const;

    Views& m_views;
    QAction* m_exportAll;
    QAction* m_exportShown;
};

}  // namespace rubble
