#include "core/io/play/StateArchive.h"

namespace rubble {

void StateReader::fail(const std::string& what) {
    if (m_fault) return;
    std::string place;
    for (const Place& one : m_place) {
        if (!place.empty()) place += '.';
        place += one.name;
        if (one.element != kNoElement) place += '[' + std::to_string(one.element) + ']';
    }
    m_fault = (place.empty() ? "The state" : place) + ' ' + what;
}

bool StateReader::copy(void* to, std::size_t size) {
    if (m_fault) return false;
    if (size > left()) {
        fail("is cut off");
        return false;
    }
    if (size > 0) std::memcpy(to, m_bytes.data() + m_at, size);
    m_at += size;
    return true;
}

std::size_t StateReader::readSize(std::size_t elementBytes) {
    std::uint64_t size = 0;
    if (!copy(&size, sizeof(size))) return 0;
    if (size <= left() / elementBytes) return size;
    fail("has " + std::to_string(size) + " elements, but " + std::to_string(left()) + " bytes follow");
    return 0;
}

}  // namespace rubble
