#include "core/play/events/EventHistory.h"

#include <algorithm>
#include <iterator>

namespace rubble {
namespace {

bool isKept(const EventRecord& record) {
    return record.kind == EventKind::Impact || record.kind == EventKind::Bonds || record.kind == EventKind::Broken;
}

}  // namespace

void EventHistory::add(std::uint64_t step, std::span<const EventRecord> reported) {
    std::vector<EventRecord> added;
    std::ranges::copy_if(reported, std::back_inserter(added), isKept);
    const bool isKnown = step >= m_first && step <= m_last;
    if (isKnown && std::ranges::equal(added, between(step, step))) return;
    if (!isKnown && step != m_last + 1) {
        m_records.clear();
        m_first = step;
    }
    std::erase_if(m_records, [step](const EventRecord& one) { return one.step >= step; });
    m_records.insert(m_records.end(), std::make_move_iterator(added.begin()), std::make_move_iterator(added.end()));
    m_last = step;
    if (m_records.size() <= m_mostRecords) return;
    // Half of them at once: each is moved once then, on average.
    m_first = m_records[m_records.size() - m_mostRecords / 2].step + 1;
    std::erase_if(m_records, [this](const EventRecord& one) { return one.step < m_first; });
}

std::span<const EventRecord> EventHistory::between(std::uint64_t first, std::uint64_t last) const {
    const auto begin = std::ranges::lower_bound(m_records, first, {}, &EventRecord::step);
    const auto end = std::ranges::upper_bound(m_records, last, {}, &EventRecord::step);
    if (begin >= end) return {};
    return {begin, end};
}

}  // namespace rubble
