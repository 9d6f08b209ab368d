#include "core/play/events/EventHistory.h"

#include <algorithm>
#include <iterator>

namespace rubble {
namespace {

bool isKept(const EventRecord& record) {
    return record.kind == EventKind::Impact || record.kind == EventKind::Bonds || record.kind == EventKind::Broken;
}

template <class Record>
std::span<const Record> recordsBetween(const std::vector<Record>& records, std::uint64_t first, std::uint64_t last) {
    const auto begin = std::ranges::lower_bound(records, first, {}, &Record::step);
    const auto end = std::ranges::upper_bound(records, last, {}, &Record::step);
    if (begin >= end) return {};
    return {begin, end};
}

/// Replaces the records from a step on.
template <class Record>
void replaceFrom(std::vector<Record>& records, std::uint64_t step, std::span<const Record> added) {
    std::erase_if(records, [step](const Record& one) { return one.step >= step; });
    records.insert(records.end(), added.begin(), added.end());
}

}  // namespace

void EventHistory::add(std::uint64_t step, std::span<const EventRecord> reported, std::span<const BlastRecord> blasts) {
    std::vector<EventRecord> added;
    std::ranges::copy_if(reported, std::back_inserter(added), isKept);
    const bool isKnown = step >= m_first && step <= m_last;
    const bool isSame =
        std::ranges::equal(added, between(step, step)) && std::ranges::equal(blasts, blastsBetween(step, step));
    if (isKnown && isSame) return;
    if (!isKnown && step != m_last + 1) {
        m_records.clear();
        m_blasts.clear();
        m_first = step;
    }
    replaceFrom(m_records, step, std::span<const EventRecord>(added));
    replaceFrom(m_blasts, step, blasts);
    m_last = step;
    if (m_records.size() <= m_mostRecords) return;
    // Half of them at once: each is moved once then, on average.
    m_first = m_records[m_records.size() - m_mostRecords / 2].step + 1;
    std::erase_if(m_records, [this](const EventRecord& one) { return one.step < m_first; });
}

void EventHistory::add(std::uint64_t step, const PlayEvents& events) {
    std::vector<BlastRecord> blasts;
    for (const TimedInput& input : events.inputs) {
        const auto* const shot = std::get_if<ShotInput>(&input.input);
        const auto* const blast = shot != nullptr ? std::get_if<Blast>(&shot->action) : nullptr;
        if (blast != nullptr) blasts.push_back({step, *blast});
    }
    add(step, events.report.records, blasts);
}

std::span<const EventRecord> EventHistory::between(std::uint64_t first, std::uint64_t last) const {
    return recordsBetween(m_records, first, last);
}

std::span<const BlastRecord> EventHistory::blastsBetween(std::uint64_t first, std::uint64_t last) const {
    return recordsBetween(m_blasts, first, last);
}

}  // namespace rubble
