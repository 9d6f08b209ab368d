#pragma once

#include "core/play/InstanceOverlaps.h"
#include "editor/document/Document.h"
#include "editor/document/Messages.h"

#include <QStringList>
#include <QThreadPool>
#include <QTimer>

namespace rubble {

/// Looks for instances that lie in each other or in the ground whenever a scene has come to rest, on a thread of its own, and
/// keeps the messages told of them: each with its depth, until it is so no more.
class OverlapWatch : public QObject {
    Q_OBJECT
public:
    OverlapWatch(const Document& document, Messages& messages, QObject* parent = nullptr);
    ~OverlapWatch() override;

    /// What was found last; it may be of a moment ago.
    const std::vector<InstanceOverlap>& overlaps() const { return m_overlaps; }
    /// All that the document holds now has been looked at.
    bool isCurrent() const { return !m_isLooking && !m_rest.isActive(); }

signals:
    void changed();

private:
    void look();
    void finish(std::vector<InstanceOverlap> overlaps);

    const Document& m_document;
    Messages& m_messages;
    QThreadPool m_thread;
    QTimer m_rest;
    bool m_isLooking = false;
    std::vector<InstanceOverlap> m_overlaps;
    QStringList m_told;
};

}  // namespace rubble
