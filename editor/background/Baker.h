#pragma once

#include "editor/background/BakeQueue.h"
#include "editor/document/Bakes.h"

namespace rubble {

/// Bakes a document's assets in the background whenever they change, in all variants that its instances use, and stores
/// the results in Bakes.
///
/// Patterns, of the whole and of the entered fragment, have their own thread and are computed at once; fragments take
/// several times as long and follow when the pattern stops changing. A result never replaces that of a newer state.
class Baker : public QObject {
    Q_OBJECT
public:
    Baker(const Document& document, const Selection& selection, Bakes& bakes, QObject* parent = nullptr);

    bool isBusy() const { return m_patterns.isBusy() || m_fragments.isBusy(); }
    /// Cancels all baking until the next change.
    void cancel();

signals:
    /// `asset` is being baked; 0: all are done.
    void progressed(rubble::Id asset, double fraction);

private:
    void bakeChanged(const Changes& changes);
    void bakeEnteredFragment();
    void addUnbaked(std::set<Id>& stale) const;

    const Document& m_document;
    const Selection& m_selection;
    Bakes& m_bakes;
    BakeQueue m_patterns;
    BakeQueue m_fragments;
};

}  // namespace rubble
