#pragma once

#include "core/base/TaskContext.h"
#include "editor/document/Document.h"
#include "editor/document/Selection.h"

#include <QElapsedTimer>
#include <QThreadPool>
#include <QTimer>

#include <functional>
#include <memory>
#include <set>

namespace rubble {

/// Does a work for each asset of a document that waits for it, one after the other on a thread of its own, the asset at
/// hand first.
///
/// While an asset is being dragged, work that has begun is finished, then the newest state is worked on: so results follow
/// the hand however long they take. What has taken long already is cancelled instead. The result of an asset that is gone
/// is dropped.
class BakeQueue : public QObject {
    Q_OBJECT
public:
    /// Takes a result over; called in the queue's own thread. Empty where the work was cancelled.
    using Delivery = std::function<void()>;
    /// Called on the thread.
    using Work = std::function<Delivery(const TaskContext& task)>;
    /// Gives the work on an asset when its turn has come; called in the queue's own thread.
    using Preparation = std::function<Work(std::shared_ptr<const Asset> asset)>;
    /// When work begins on what is wanted.
    enum class Start {
        AtOnce,
        AfterRest,  // nothing was wanted for as long as the last work took: what keeps changing is left alone
    };

    BakeQueue(const Document& document, const Selection& selection, Start start, Preparation prepare,
              QObject* parent = nullptr);
    ~BakeQueue() override;

    bool isBusy() const { return m_running != 0; }
    void want(const std::set<Id>& assets);
    /// Stops what is being done and forgets what waits.
    void cancel();

signals:
    /// `asset` is being worked on; 0 where all is done.
    void progressed(rubble::Id asset, double fraction);

private:
    void startNext();
    TaskContext taskContext();
    void finish(Id asset, const Delivery& deliver);

    const Document& m_document;
    const Selection& m_selection;
    const Start m_start;
    const Preparation m_prepare;
    QThreadPool m_thread;
    QTimer m_rest;
    std::set<Id> m_waiting;
    Id m_running = 0;
    QElapsedTimer m_runningSince;
    qint64 m_lastMilliseconds = 0;
    CancelToken m_cancel;
};

}  // namespace rubble
