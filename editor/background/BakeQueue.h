#pragma once

#include "editor/document/Document.h"
#include "editor/document/Selection.h"
#include "editor/document/jobs/BackgroundJob.h"

#include <QElapsedTimer>
#include <QTimer>

#include <functional>
#include <memory>
#include <set>

namespace rubble {

/// Runs a function for each queued asset of a document, one after the other in the background, the active asset first.
///
/// If an asset changes while it is being worked on, a short run is finished and the newest state follows, so that
/// results keep appearing during a drag; a long run is cancelled. The result for a deleted asset is dropped.
class BakeQueue : public QObject {
    Q_OBJECT
public:
    /// Stores a result; called in the queue's thread. Empty if the work was cancelled.
    using Delivery = std::function<void()>;
    /// Called in the background.
    using Work = std::function<Delivery(const TaskContext& task)>;
    /// Prepares the work on an asset when it is about to start; called in the queue's thread.
    using Preparation = std::function<Work(std::shared_ptr<const Asset> asset)>;
    /// The time when the work on queued assets starts.
    enum class Start {
        Immediately,
        // once nothing was queued for as long as the last work took, at most 200 ms: not while an asset is dragged
        WhenIdle,
    };

    BakeQueue(const Document& document, const Selection& selection, Start start, Preparation prepare,
              QObject* parent = nullptr);

    bool isBusy() const { return m_job.isRunning(); }
    void add(const std::set<Id>& assets);
    /// Cancels the running work and clears the queue.
    void cancel();

signals:
    /// `asset` is being worked on; 0: the queue is empty.
    void progressed(rubble::Id asset, double fraction);

private:
    void startNext();
    void cancelRunning();
    void finish(const Delivery& deliver);

    const Document& m_document;
    const Selection& m_selection;
    const Start m_start;
    const Preparation m_prepare;
    BackgroundJob m_job;
    QTimer m_delay;
    std::set<Id> m_queued;
    Id m_asset = 0;  // being worked on
    QElapsedTimer m_runningSince;
    qint64 m_lastMilliseconds = 0;
};

}  // namespace rubble
