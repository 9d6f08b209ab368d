#pragma once

#include "editor/BakeQueue.h"
#include "editor/document/Bakes.h"

namespace rubble {

/// Bakes a document's assets, in all variants that its instances use, whenever they change, and puts the results into Bakes. The window never waits for it.
///
/// Patterns, of the whole and inside the fragment that is seen, have a thread of their own and are there as soon as they can be; fragments,
/// which take several times as long, follow when the pattern has come to rest. A result never replaces that of a newer state.
class Baker : public QObject {
    Q_OBJECT
public:
    Baker(const Document& document, const Selection& selection, Bakes& bakes, QObject* parent = nullptr);

    bool isBusy() const { return m_patterns.isBusy() || m_fragments.isBusy(); }
    /// Stops what is being baked, and leaves what waits; until the next change nothing is baked.
    void cancel();

signals:
    /// `asset` is being baked; 0 where all is done.
    void progressed(rubble::Id asset, double fraction);

private:
    void take(const Changes& changes);
    void takeInside();
    void addUnbaked(std::set<Id>& wanted) const;

    const Document& m_document;
    const Selection& m_selection;
    Bakes& m_bakes;
    BakeQueue m_patterns;
    BakeQueue m_fragments;
};

}  // namespace rubble
