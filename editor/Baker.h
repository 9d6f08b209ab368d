#pragma once

#include "core/base/TaskContext.h"
#include "editor/document/Bakes.h"
#include "editor/document/Document.h"
#include "editor/document/Selection.h"

#include <QElapsedTimer>
#include <QThreadPool>

#include <optional>
#include <set>

namespace rubble {

/// Bakes a document's assets on a thread of its own whenever they change, the one at hand first, and puts the results into
/// Bakes. The window never waits for it.
///
/// While an asset is being dragged, a bake that has begun is finished and shown, then the newest state is baked: so the
/// cells follow the hand however long a bake takes. One that has taken long already is cancelled instead. A result never
/// replaces that of a newer state, and that of an asset which is gone is dropped.
class Baker : public QObject {
    Q_OBJECT
public:
    Baker(const Document& document, const Selection& selection, Bakes& bakes, QObject* parent = nullptr);
    ~Baker() override;

    bool isBusy() const { return m_running != 0; }
    /// Stops what is being baked, and leaves what waits; until the next change nothing is baked.
    void cancel();

signals:
    /// `asset` is being baked; 0 where all is done.
    void progressed(rubble::Id asset, double fraction);

private:
    void take(const Changes& changes);
    void want(Id asset);
    void startNext();
    void finish(Id asset, std::shared_ptr<const BakedAsset> result);

    const Document& m_document;
    const Selection& m_selection;
    Bakes& m_bakes;
    QThreadPool m_thread;
    std::set<Id> m_waiting;
    Id m_running = 0;
    QElapsedTimer m_runningSince;
    CancelToken m_cancel;
};

}  // namespace rubble
