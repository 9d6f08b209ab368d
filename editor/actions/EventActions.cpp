#include "editor/actions/EventActions.h"

#include "core/io/system/AtomicFile.h"
#include "editor/dialogs/MessageBoxes.h"
#include "editor/dialogs/OutputPath.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"
#include "editor/play/EventExport.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/widgets/TaskDialog.h"
#include "editor/workspace/Workspace.h"

#include <QFileDialog>
#include <QMainWindow>

#include <algorithm>

namespace rubble {

namespace {

FileKind kindOf(EventsFormat format) {
    switch (format) {
        case EventsFormat::Stream: return {EventActions::tr("JSON lines (*.jsonl)"), "jsonl"};
        case EventsFormat::JsonLines: return {EventActions::tr("JSON lines of version 1 (*.jsonl)"), "jsonl"};
        case EventsFormat::Csv: return {EventActions::tr("Comma-separated values (*.csv)"), "csv"};
    }
    return {};
}

QString countMessage(std::size_t count) {
    return EventActions::tr("Exported %Ln event(s) to %1.", nullptr, static_cast<int>(count));
}

bool isReported(const PlayEvent& event) { return event.isReported; }

}  // namespace

EventActions::EventActions(Views& views)
    : QObject(&views.window()),
      m_views(views),
      m_exportAll(makeAction(this, {"play-export-events", tr("Export Eve&nts…"),
                                    tr("Save all events of the timeline as CSV or JSON lines")})),
      m_exportShown(makeAction(this, {"play-export-shown-events", tr("Export S&hown Events…"),
                                      tr("Save the events that the filter shows as CSV or JSON lines")})) {
    connect(m_exportAll, &QAction::triggered, this, &EventActions::exportAll);
    connect(m_exportShown, &QAction::triggered, this, &EventActions::exportShown);
    connect(&controller(), &PlayController::eventsChanged, this, &EventActions::refresh);
    connect(&controller(), &PlayController::stateChanged, this, &EventActions::refresh);
    views.setEventActions(m_exportAll, m_exportShown);
    refresh();
}

PlayController& EventActions::controller() const { return m_views.workspace().play(); }

void EventActions::refresh() {
    const bool isShown = controller().hasSession();
    m_exportAll->setEnabled(isShown && !controller().events().steps().empty());
    m_exportShown->setEnabled(isShown && controller().eventFilter().isActive() && !controller().shownEvents().empty());
}

EventActions::OutputFile EventActions::askForFile(const QString& title, const QList<EventsFormat>& formats) {
    controller().pause();
    QFileDialog dialog(&m_views.window(), title);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    QList<FileKind> kinds;
    for (const EventsFormat format : formats) kinds.append(kindOf(format));
    offerKinds(dialog, kinds);
    suggestOutput(dialog, m_views.workspace().file(), '.' + kinds.front().suffix);
    QStringList suffixes;
    for (const FileKind& kind : kinds) suffixes.append('.' + kind.suffix);
    const QString path = askForOutput(dialog, m_views.workspace().file(), suffixes);
    if (path.isEmpty()) return {};
    // The name decides; of formats with the same, the filter.
    const bool isCsv = eventsFormatOf(toPath(path)) == EventsFormat::Csv;
    if (isCsv) return {path, EventsFormat::Csv};
    const bool isFirstVersion = dialog.selectedNameFilter() == kindOf(EventsFormat::JsonLines).filter;
    const bool hasStream = formats.contains(EventsFormat::Stream);
    return {path, isFirstVersion || !hasStream ? EventsFormat::JsonLines : EventsFormat::Stream};
}

void EventActions::exportAll() {
    const OutputFile file =
        askForFile(tr("Export Events"), {EventsFormat::Csv, EventsFormat::Stream, EventsFormat::JsonLines});
    if (file.path.isEmpty()) return;
    if (file.format == EventsFormat::Stream) {
        return controller().requestScript([this, path = file.path](const PlayScript& script) {
            const std::shared_ptr<const PlayScene> scene = controller().scene();
            write(path, tr("Exported the events to %1."),
                  [&](const TaskContext& task) { return eventsText(scene, script, task); });
        });
    }
    const EventCourse events = controller().events();
    std::size_t count = 0;
    for (const std::shared_ptr<const LoggedStep>& step : events.steps()) {
        count += static_cast<std::size_t>(std::ranges::count_if(step->events, isReported));
    }
    write(file.path, countMessage(count),
          [&](const TaskContext& task) { return eventsText(events, file.format, task); });
}

void EventActions::exportShown() {
    const OutputFile file = askForFile(tr("Export Shown Events"), {EventsFormat::Csv, EventsFormat::JsonLines});
    if (file.path.isEmpty()) return;
    const std::vector<EventRef> events = controller().shownEvents();
    const auto count = std::ranges::count_if(events, [](const EventRef& event) { return isReported(*event); });
    write(file.path, countMessage(static_cast<std::size_t>(count)),
          [&](const TaskContext& task) { return eventsText(events, file.format, task); });
}

void EventActions::write(const QString& path, const QString& message, const TextMaker& makeText) {
    TaskDialog task(tr("Exporting events…"), &m_views.window());
    const Status written = task.run<Status>([&](const TaskContext& context) -> Status {
        const Result<std::string> text = makeText(context);
        return text ? writeFileAtomically(toPath(path), *text) : Status(text.error());
    });
    if (written) return m_views.showStatus(message.arg(fileNameText(path)));
    if (written.error().code != ErrorCode::Cancelled) showError(&m_views.window(), written.error());
}

}  // namespace rubble

#include "moc_EventActions.cpp"
