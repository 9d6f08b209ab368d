#pragma once

#include "core/play/scene/InstanceOverlaps.h"
#include "editor/document/Document.h"
#include "editor/document/Messages.h"
#include "editor/document/jobs/BackgroundJob.h"

#include <QStringList>
#include <QTimer>

namespace rubble {

/// Finds instances that overlap each other or the ground, in the background, when the scene has not changed for a
/// moment, and keeps the messages about them up to date.
class OverlapWatch : public QObject {
    Q_OBJECT
public:
    OverlapWatch(const Document& document, Messages& messages, QObject* parent = nullptr);

    /// The last result; it may be slightly outdated.
    const std::vector<InstanceOverlap>& overlaps() const { return m_overlaps; }
    /// Whether the result is that of the current document.
    bool isCurrent() const { return !m_job.isRunning() && !m_delay.isActive(); }

signals:
    void changed();

private:
    void check();
    struct FoundOverlaps {
        std::vector<InstanceOverlap> overlaps;
        bool isComplete = true;
    };
    void report(FoundOverlaps found);

    const Document& m_document;
    Messages& m_messages;
    BackgroundJob m_job;
    QTimer m_delay;
    std::vector<InstanceOverlap> m_overlaps;
    QStringList m_reported;
};

}  // namespace rubble
