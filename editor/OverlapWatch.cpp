#include "editor/OverlapWatch.h"

#include <QMetaObject>

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

constexpr int kRestMilliseconds = 150;
constexpr std::size_t kMostTold = 100;  // beyond it the number tells enough

Message messageOf(const InstanceOverlap& overlap, const Project& project) {
    Message message{.severity = Severity::Warning, .text = QString::fromStdString(sentenceOf(overlap, project))};
    message.instances = {overlap.first};
    if (overlap.second != 0) message.instances.push_back(overlap.second);
    return message;
}

}  // namespace

OverlapWatch::OverlapWatch(const Document& document, Messages& messages, QObject* parent)
    : QObject(parent), m_document(document), m_messages(messages) {
    m_thread.setMaxThreadCount(1);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, &OverlapWatch::look);
    connect(&document, &Document::changed, this, [this](const Changes& changes) {
        const bool isOfScene =
            changes.touches(Part::Instance) || changes.touches(Part::Asset) || changes.touches(Part::Scene);
        if (isOfScene) m_rest.start();
    });
    m_rest.start();
}

OverlapWatch::~OverlapWatch() { m_thread.waitForDone(); }

void OverlapWatch::look() {
    if (m_isLooking) return m_rest.start();
    m_isLooking = true;
    m_thread.start([this, project = m_document.project()] {
        std::vector<InstanceOverlap> overlaps = instanceOverlaps(project);
        QMetaObject::invokeMethod(this, [this, overlaps = std::move(overlaps)] { finish(overlaps); });
    });
}

void OverlapWatch::finish(std::vector<InstanceOverlap> overlaps) {
    m_isLooking = false;
    const Project& project = m_document.project();
    const auto isGone = [&](Id id) {
        return id != 0 && std::ranges::find(project.instances, id, &Instance::id) == project.instances.end();
    };
    std::erase_if(overlaps, [&](const InstanceOverlap& one) { return isGone(one.first) || isGone(one.second); });
    m_overlaps = std::move(overlaps);
    std::vector<Message> messages;
    for (std::size_t k = 0; k < std::min(m_overlaps.size(), kMostTold); ++k) {
        messages.push_back(messageOf(m_overlaps[k], project));
    }
    if (m_overlaps.size() > kMostTold) {
        messages.push_back({.severity = Severity::Warning,
                            .text = tr("Instances overlap in %1 more places.").arg(m_overlaps.size() - kMostTold)});
    }
    // Names count: what was renamed is told anew.
    if (std::ranges::equal(messages, m_told, {}, &Message::text)) return;
    m_told.clear();
    for (const Message& message : messages) m_told.append(message.text);
    m_messages.setOfScene(std::move(messages));
    emit changed();
}

}  // namespace rubble
