#pragma once

#include "core/play/scene/PlayMortar.h"
#include "editor/document/Bakes.h"
#include "editor/document/Document.h"
#include "editor/document/jobs/BackgroundJob.h"

#include <QTimer>

#include <vector>

namespace rubble {

/// Finds what the mortars of a document join, in the background, when neither the scene nor its bakes have changed for
/// a moment.
class MortarWatch : public QObject {
    Q_OBJECT
public:
    MortarWatch(const Document& document, const Bakes& bakes, QObject* parent = nullptr);

    /// The last joints of a mortar; they may be slightly outdated. Null: not known yet.
    const JoinedMortar* find(Id mortar) const;
    /// Whether the result is that of the current document. False while an asset is being baked.
    bool isCurrent() const { return m_isCurrent; }

signals:
    void changed();

private:
    void invalidate();
    void check();
    void set(std::vector<JoinedMortar> joined);

    const Document& m_document;
    const Bakes& m_bakes;
    BackgroundJob m_job;
    QTimer m_delay;
    std::vector<JoinedMortar> m_joined;
    bool m_isCurrent = false;
};

}  // namespace rubble
