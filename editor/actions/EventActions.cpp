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

QString csvFilter() { return EventActions::tr("Comma-separated values (*.csv)"); }
QString linesFilter() { return EventActions::tr("JSON lines (*.jsonl)"); }

bool isTold(const PlayEvent& event) { return event.isTold; }

}  // namespace

EventActions::EventActions(Views& views)
    : QObject(&views.window()),
      m_views(views),
      m_exportAll(makeAction(this, {"play-export-events", tr("Export Eve&nts…"),
                                    tr("Save all events of the timeline as CSV or JSON lines")})),
      m_exportShown(makeAction(this, {"play-export-shown-events", tr("Export Sho&wn Events…"),
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

QString EventActions::askForFile(const QString& title) {
    controller().pause();
    QFileDialog dialog(&m_views.window(), title);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    offerKinds(dialog, {{csvFilter(), "csv"}, {linesFilter(), "jsonl"}});
    suggestOutput(dialog, m_views.workspace().file(), ".csv");
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().first() : QString();
}

void EventActions::exportAll() {
    const QString path = askForFile(tr("Export Events"));
    if (path.isEmpty()) return;
    const EventCourse events = controller().events();
    std::size_t count = 0;
    for (const std::shared_ptr<const LoggedStep>& step : events.steps()) {
        count += static_cast<std::size_t>(std::ranges::count_if(step->events, isTold));
    }
    write(path, count, [&](EventsFormat format, const TaskContext& task) { return eventsText(events, format, task); });
}

void EventActions::exportShown() {
    const QString path = askForFile(tr("Export Shown Events"));
    if (path.isEmpty()) return;
    const std::vector<EventRef> events = controller().shownEvents();
    const auto count = std::ranges::count_if(events, [](const EventRef& event) { return isTold(*event); });
    write(path, static_cast<std::size_t>(count),
          [&](EventsFormat format, const TaskContext& task) { return eventsText(events, format, task); });
}

void EventActions::write(const QString& path, std::size_t count, const TextMaker& makeText) {
    TaskDialog task(tr("Exporting events…"), &m_views.window());
    const Status written = task.run<Status>([&](const TaskContext& context) -> Status {
        const std::filesystem::path file = toPath(path);
        const Result<std::string> text = makeText(eventsFormatOf(file), context);
        return text ? writeFileAtomically(file, *text) : Status(text.error());
    });
    if (written) {
        const QString message = tr("Exported %Ln event(s) to %1.", nullptr, static_cast<int>(count));
        return m_views.showStatus(message.arg(fileNameText(path)));
    }
    if (written.error().code != ErrorCode::Cancelled) showError(&m_views.window(), written.error());
}

}  // namespace rubble

#include "moc_EventActions.cpp"
