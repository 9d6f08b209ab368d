#include "editor/background/OverlapWatch.h"

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

constexpr int kOverlapDelayMilliseconds = 150;

Message messageOf(const InstanceOverlap& overlap, const Project& project) {
    Message message{.severity = Severity::Warning, .text = QString::fromStdString(sentenceOf(overlap, project))};
    message.instances = {overlap.first};
    if (overlap.second != 0) message.instances.push_back(overlap.second);
    return message;
}

}  // namespace

OverlapWatch::OverlapWatch(const Document& document, Messages& messages, QObject* parent)
    : QObject(parent), m_document(document), m_messages(messages) {
    m_delay.setSingleShot(true);
    m_delay.setInterval(kOverlapDelayMilliseconds);
    connect(&m_delay, &QTimer::timeout, this, &OverlapWatch::check);
    connect(&document, &Document::changed, this, [this](const Changes& changes) {
        const bool isOfScene =
            changes.touches(Part::Instance) || changes.touches(Part::Asset) || changes.touches(Part::Scene);
        if (isOfScene) m_delay.start();
    });
    connect(&m_job, &BackgroundJob::failed, this, [this](const QString& sentence) {
        m_reported.clear();
        m_messages.setOfScene({{.severity = Severity::Error, .text = sentence}});
    });
    m_delay.start();
}

void OverlapWatch::check() {
    if (m_job.isRunning()) return m_delay.start();
    m_job.start(
        [project = m_document.project()](const TaskContext&) {
            FoundOverlaps found;
            found.overlaps = instanceOverlaps(project, &found.isComplete);
            return found;
        },
        [this](FoundOverlaps found) { report(std::move(found)); });
}

void OverlapWatch::report(FoundOverlaps found) {
    std::vector<InstanceOverlap>& overlaps = found.overlaps;
    const Project& project = m_document.project();
    const auto isGone = [&](Id id) { return id != 0 && findInstance(project, id) == nullptr; };
    std::erase_if(overlaps,
                  [&](const InstanceOverlap& overlap) { return isGone(overlap.first) || isGone(overlap.second); });
    m_overlaps = std::move(overlaps);
    std::vector<Message> messages;
    for (std::size_t k = 0; k < std::min(m_overlaps.size(), kListedOverlaps); ++k) {
        messages.push_back(messageOf(m_overlaps[k], project));
    }
    if (m_overlaps.size() > kListedOverlaps) {
        const QString text = found.isComplete ? tr("Instances overlap in %1 more places.")
                                              : tr("Instances overlap in more than %1 more places.");
        messages.push_back({.severity = Severity::Warning, .text = text.arg(m_overlaps.size() - kListedOverlaps)});
    }
    // Compared by text, since names may have changed.
    if (std::ranges::equal(messages, m_reported, {}, &Message::text)) return;
    m_reported.clear();
    for (const Message& message : messages) m_reported.append(message.text);
    m_messages.setOfScene(std::move(messages));
    emit changed();
}

}  // namespace rubble

#include "moc_OverlapWatch.cpp"
