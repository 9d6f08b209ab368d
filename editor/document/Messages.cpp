#include "editor/document/Messages.h"

#include <utility>

namespace rubble {

namespace {

constexpr Id kSceneTopic = ~Id{0};  // no asset has this id

}  // namespace

void Messages::add(Message message) {
    m_list.push_back(std::move(message));
    m_topics.push_back(0);
    emit changed();
}

void Messages::setOfBake(Id asset, std::vector<Message> messages) { replace(asset, std::move(messages)); }

void Messages::setOfScene(std::vector<Message> messages) {
    std::vector<QString> before, after;
    for (std::size_t k = 0; k < m_list.size(); ++k)
        if (m_topics[k] == kSceneTopic) before.push_back(m_list[k].text);
    for (const Message& message : messages) after.push_back(message.text);
    if (before != after) replace(kSceneTopic, std::move(messages));
}

void Messages::replace(Id topic, std::vector<Message> messages) {
    m_list.reserve(m_list.size() + messages.size());  // all or nothing where memory runs out
    m_topics.reserve(m_topics.size() + messages.size());
    std::size_t kept = 0;
    for (std::size_t k = 0; k < m_list.size(); ++k) {
        if (m_topics[k] == topic) continue;
        if (kept != k) {
            m_list[kept] = std::move(m_list[k]);
            m_topics[kept] = m_topics[k];
        }
        ++kept;
    }
    if (kept == m_list.size() && messages.empty()) return;
    m_list.resize(kept);
    m_topics.resize(kept);
    for (Message& message : messages) {
        m_list.push_back(std::move(message));
        m_topics.push_back(topic);
    }
    emit changed();
}

void Messages::clear() {
    m_list.clear();
    m_topics.clear();
    emit changed();
}

QString noteText(const Diagnostic& note, const Project& project) {
    const Asset* asset = findAsset(project, note.place.asset);
    const QString name = asset ? QString::fromStdString('"' + asset->name + "\": ") : QString();
    return name + QString::fromStdString(note.message);
}

std::vector<Message> messagesOf(const Bake& bake) {
    std::vector<Message> messages;
    for (const Diagnostic& report : bake.diagnostics) {
        messages.push_back({.severity = report.severity,
                            .text = QString::fromStdString(report.message),
                            .asset = bake.asset,
                            .seed = seedOf(report.place)});
    }
    return messages;
}

}  // namespace rubble

#include "moc_Messages.cpp"
