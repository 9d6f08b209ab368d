#include "editor/document/Messages.h"

#include <utility>

namespace rubble {

namespace {

constexpr Id kSceneTopic = ~Id{0};  // no asset's

Severity severityOf(ReportCode code) {
    switch (code) {
        case ReportCode::SplitCell:
        case ReportCode::MergedPiece:
        case ReportCode::DroppedSeed:
        case ReportCode::Gap: return Severity::Note;
        case ReportCode::DuplicateSeed:
        case ReportCode::SeedWithoutCell:
        case ReportCode::ThinPiece:
        case ReportCode::LostOverride:
        case ReportCode::NoRoom:
        case ReportCode::LostPiece:
        case ReportCode::LooseCut:
        case ReportCode::VanishedPiece: return Severity::Warning;
    }
    return Severity::Warning;
}

/// The seed of the first level that a report is about. Those of deeper levels begin with their fragment's name.
std::optional<SeedId> seedOf(const Report& report, const Seeds& seeds) {
    const bool isOfLayer = report.code == ReportCode::LostOverride || report.code == ReportCode::DroppedSeed ||
                           report.code == ReportCode::LooseCut;
    if (isOfLayer) return SeedId{report.of, report.seed};
    const bool isOfDeeperLevel = report.message.starts_with("Fragment ");
    if (isOfDeeperLevel || report.seed >= seeds.ids.size()) return std::nullopt;
    return seeds.ids[report.seed];
}

}  // namespace

void Messages::add(Message message) {
    m_list.push_back(std::move(message));
    m_topics.push_back(0);
    emit changed();
}

void Messages::setOfBake(Id asset, std::vector<Message> messages) { replace(asset, std::move(messages)); }

void Messages::setOfScene(std::vector<Message> messages) { replace(kSceneTopic, std::move(messages)); }

void Messages::replace(Id topic, std::vector<Message> messages) {
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

std::vector<Message> messagesOf(const Bake& bake) {
    std::vector<Message> messages;
    for (const Report& report : bake.reports) {
        messages.push_back({.severity = severityOf(report.code),
                            .text = QString::fromStdString(report.message),
                            .asset = bake.asset,
                            .seed = seedOf(report, bake.breakings.front().seeds)});
    }
    return messages;
}

}  // namespace rubble
